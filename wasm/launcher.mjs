#!/usr/bin/env node
// The command under Node: the same arguments, files and exit codes as the native one.
//
// A WebAssembly program keeps its thread busy, so that Node would notice Ctrl-C only at its end. The command therefore
// runs in a worker; this thread counts interrupts in shared memory, where the command looks (lib/cli/interrupt.cpp).
import { createRequire } from 'node:module';
import { fileURLToPath } from 'node:url';
import { isMainThread, Worker, workerData } from 'node:worker_threads';

if (isMainThread) {
  const interrupts = new Int32Array(new SharedArrayBuffer(4));
  const worker = new Worker(fileURLToPath(import.meta.url), {
    argv: process.argv.slice(2),
    workerData: interrupts,
    stdin: false,
    resourceLimits: { stackSizeMb: 8 },
  });
  process.on('SIGINT', () => {
    if (Atomics.add(interrupts, 0, 1) > 0) process.exit(130); // the second one ends it at once
  });
  worker.on('error', (error) => {
    console.error(`error: ${error.message}`);
    process.exitCode = 3;
  });
  worker.on('exit', (code) => {
    process.exitCode ||= code;
  });
} else {
  globalThis.circumballInterrupts = workerData;
  createRequire(import.meta.url)('./circumball-cli.cjs');
}
