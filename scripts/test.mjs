// npm test: everything that must hold, in the order of what fails soonest. Prints one line for each part and, last,
// how much passed and failed. `npm test -- native web` runs only the named parts.
import { existsSync, mkdirSync, writeFileSync } from 'node:fs';
import { cpus } from 'node:os';
import { join } from 'node:path';
import { compareFingerprints } from './fingerprints.mjs';
import { biome, clangFormat } from './format.mjs';
import { buildModule, checkNode, installModules, node, root, run, setup, vite } from './lib.mjs';

const jobs = String(Math.max(1, cpus().length));
const logs = join(root, 'build/logs');
const total = { passed: 0, failed: 0 };

/** Runs commands one after the other, until one fails; their output together. */
async function sequence(...commands) {
  let output = '';
  for (const [program, ...args] of commands) {
    const result = await run(program, args, { capture: true });
    output += result.output;
    if (result.code !== 0) return { code: result.code, output };
  }
  return { code: 0, output };
}

const sum = (text, pattern) =>
  [...text.matchAll(pattern)].reduce((count, match) => count + Number(match[1]), 0);

/** Counts of a ctest run with GoogleTest in it: each entry that is not GoogleTest's counts as one. */
function countCtest({ code, output }) {
  const passed = sum(output, /\[ {2}PASSED {2}\] (\d+) tests?\./g);
  const failed = sum(output, /\[ {2}FAILED {2}\] (\d+) tests?, listed below/g);
  const other = (output.match(/^\d+\/\d+ Test +#\d+: (?!test_)\S+ .*Passed/gm) ?? []).length;
  return { passed: passed + other, failed: code === 0 ? 0 : Math.max(1, failed) };
}

/** Counts of Vitest and Playwright: "Tests  12 passed | 1 failed (13)"; "12 passed". */
function countWeb(line) {
  return ({ code, output }) => {
    // biome-ignore lint/suspicious/noControlCharactersInRegex: colors are control characters
    const plain = output.replace(/\x1b\[[0-9;]*m/g, '');
    const lines = plain.match(line)?.join('\n') ?? '';
    const failed = sum(lines, /(\d+) failed/g);
    return { passed: sum(lines, /(\d+) passed/g), failed: code === 0 ? 0 : Math.max(1, failed) };
  };
}

const countOne = ({ code }) => ({ passed: code === 0 ? 1 : 0, failed: code === 0 ? 0 : 1 });

const build = (preset, ...targets) => [
  ['cmake', '--preset', preset],
  [
    'cmake',
    '--build',
    '--preset',
    preset,
    '-j',
    jobs,
    ...targets.flatMap((t) => ['--target', t]),
    ...['--', '-k', '0'], // every error at once, not the first
  ],
];
const ctest = (preset) => ['ctest', '--preset', preset, '--verbose', '-j', jobs];

const parts = [
  ['format', 'C++ formatted', () => clangFormat(true), countOne],
  ['format', 'TypeScript formatted and linted', () => biome(true), countOne],
  ['native', 'native tests', () => sequence(...build('native'), ctest('native')), countCtest],
  ['wasm', 'the same in WebAssembly', () => sequence(...build('wasm'), ctest('wasm')), countCtest],
  [
    'same',
    'same mesh with GCC, Clang, in Debug and in WebAssembly',
    async () => {
      const built = await sequence(
        ...build('native', 'circumball_cli'),
        ...build('wasm', 'circumball_cli'),
        ...build('clang', 'circumball_cli'),
        ...build('debug', 'circumball_cli'),
      );
      return built.code === 0 ? compareFingerprints() : built;
    },
    ({ code, passed = 0, failed = 0 }) => ({
      passed,
      failed: code === 0 ? 0 : Math.max(1, failed),
    }),
  ],
  [
    'web',
    'page logic, contract of the module, command',
    async () => {
      const built = await sequence(
        ...build('native', 'circumball_cli'),
        ...build('wasm', 'circumball_cli'),
        ...build('wasm', 'circumball_core'),
      );
      if (built.code !== 0) return built;
      return sequence([node, 'node_modules/vitest/vitest.mjs', 'run']);
    },
    countWeb(/^ *Tests .*$/gm),
  ],
  [
    'web',
    'types of the page',
    () =>
      sequence([
        node,
        'node_modules/svelte-check/bin/svelte-check',
        '--tsconfig',
        './tsconfig.json',
      ]),
    countOne,
  ],
  [
    'e2e',
    'the site builds',
    async () => {
      await buildModule();
      return sequence([node, vite, 'build', '--config', 'web/vite.config.ts']);
    },
    countOne,
  ],
  [
    'e2e',
    'the page, used in Chromium',
    () => sequence([node, 'node_modules/@playwright/test/cli.js', 'test']),
    countWeb(/^ *\d+ (passed|failed).*$/gm),
  ],
];

checkNode();
await setup('test');
await installModules();
mkdirSync(logs, { recursive: true });
const wanted = process.argv.slice(2);
const unknown = wanted.filter((name) => !parts.some(([group]) => group === name));
if (unknown.length > 0) {
  console.error(`no such part: ${unknown.join(', ')}`);
  process.exit(2);
}
for (const [index, [group, title, action, count]] of parts.entries()) {
  if (wanted.length > 0 && !wanted.includes(group)) continue;
  const began = Date.now();
  const result = await action();
  const { passed, failed } = count(result);
  const log = join(logs, `${index + 1}-${group}.log`);
  writeFileSync(log, result.output);
  total.passed += passed;
  total.failed += failed;
  // A part that ran nothing has shown nothing.
  const empty = passed + failed === 0;
  if (empty) total.failed += 1;
  const seconds = ((Date.now() - began) / 1000).toFixed(0);
  const verdict = failed > 0 || empty ? 'FAILED' : 'ok';
  console.log(`${verdict.padEnd(6)} ${title}: ${passed} passed, ${failed} failed (${seconds} s)`);
  if (failed > 0 || empty) {
    const lines = result.output.split('\n').filter((line) => !/^\[\d+\/\d+\] \w+ing /.test(line));
    console.log(
      lines
        .slice(-150)
        .map((line) => line.slice(0, 300))
        .join('\n'),
    );
    if (existsSync(log)) console.log(`all of it: ${log}`);
  }
}
console.log(`\n${total.passed} passed, ${total.failed} failed`);
process.exit(total.failed === 0 ? 0 : 1);
