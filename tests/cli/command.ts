// The command, natively and in WebAssembly: the same tests run on both.
import { spawn, spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const built = (path: string) => fileURLToPath(new URL(`../../build/${path}`, import.meta.url));

export const commands: [string, string[]][] = [
  ['native', [built('native/circumball')]],
  ['WebAssembly', [process.execPath, built('wasm/circumball.mjs')]],
];

export interface Outcome {
  code: number | null;
  out: string;
  err: string;
}

/** A folder of its own, and the command run in it. */
export class Bench {
  readonly folder = mkdtempSync(join(tmpdir(), 'circumball-'));
  constructor(private readonly command: string[]) {}

  run(...args: string[]): Outcome {
    const [program, ...first] = this.command;
    const result = spawnSync(program!, [...first, ...args], {
      cwd: this.folder,
      encoding: 'utf8',
      maxBuffer: 1 << 28,
    });
    return { code: result.status, out: result.stdout, err: result.stderr };
  }

  /** Starts the command and presses Ctrl-C once it has run for a while. */
  interrupt(milliseconds: number, ...args: string[]): Promise<Outcome> {
    const [program, ...first] = this.command;
    const child = spawn(program!, [...first, ...args], { cwd: this.folder });
    const outcome: Outcome = { code: null, out: '', err: '' };
    child.stdout.on('data', (chunk) => {
      outcome.out += chunk;
    });
    child.stderr.on('data', (chunk) => {
      outcome.err += chunk;
    });
    setTimeout(() => child.kill('SIGINT'), milliseconds);
    return new Promise((resolve) => {
      child.on('close', (code) => resolve({ ...outcome, code }));
    });
  }

  write(name: string, text: string) {
    writeFileSync(join(this.folder, name), text);
    return name;
  }
  text(name: string) {
    return readFileSync(join(this.folder, name), 'utf8');
  }
  // biome-ignore lint/suspicious/noExplicitAny: tests look into JSON of any shape
  json(name: string): any {
    return JSON.parse(this.text(name));
  }
  remove() {
    rmSync(this.folder, { recursive: true });
  }
}

export const square = `4 2 0 1
1 0 0 1
2 1 0 1
3 1 1 1
4 0 1 1
4 1
1 1 2 5
2 2 3 5
3 3 4 5
4 4 1 5
0
`;
export const crossing = `4 2 0 0
1 0 0
2 1 0
3 1 1
4 0 1
2 0
1 1 3
2 2 4
0
`;
