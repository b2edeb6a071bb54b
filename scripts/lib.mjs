// What the scripts share: where things are, running programs, and making what is out of date.
import { spawn } from 'node:child_process';
import { existsSync, readdirSync, statSync, utimesSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

export const root = fileURLToPath(new URL('..', import.meta.url));
export const node = process.execPath;
export const vite = join(root, 'node_modules/vite/bin/vite.js');

/** The oldest Node that Vite runs on; Debian 12's own is older. */
const oldestNode = [20, 19];

export function checkNode() {
  const [major, minor] = process.versions.node.split('.').map(Number);
  if (major > oldestNode[0] || (major === oldestNode[0] && minor >= oldestNode[1])) return;
  console.error(
    `Node ${oldestNode.join('.')} or newer is needed; this is ${process.versions.node}.`,
  );
  process.exit(1);
}

/** Runs a program; resolves to { code, output }. `capture` keeps its output instead of showing it. */
export function run(program, args, { capture = false, env = {}, cwd = root } = {}) {
  return new Promise((resolve) => {
    const child = spawn(program, args, {
      cwd,
      env: { ...process.env, ...env },
      stdio: capture ? ['ignore', 'pipe', 'pipe'] : 'inherit',
    });
    const chunks = [];
    child.stdout?.on('data', (chunk) => chunks.push(chunk));
    child.stderr?.on('data', (chunk) => chunks.push(chunk));
    child.on('error', (error) => resolve({ code: 127, output: `${program}: ${error.message}\n` }));
    child.on('close', (code, signal) => {
      resolve({ code: signal ? 128 : code, output: Buffer.concat(chunks).toString() });
    });
  });
}

/** Runs a program and ends this one if it fails. */
export async function must(program, args, options) {
  const { code, output } = await run(program, args, options);
  if (code === 0) return output;
  if (options?.capture) process.stderr.write(output);
  console.error(`failed: ${[program, ...args].join(' ')}`);
  process.exit(1);
}

/** Installs missing Debian packages: level build, test or bench. */
export const setup = (level) => must('bash', ['scripts/setup.sh', level]);

const modified = (path) => (existsSync(path) ? statSync(path).mtimeMs : 0);

/** Installs the npm packages of the lock file if they are missing or older than it. */
export async function installModules() {
  const lock = modified(join(root, 'package-lock.json'));
  const installed = join(root, 'node_modules/.package-lock.json');
  if (modified(installed) >= lock) return;
  console.log('Installing the npm packages of package-lock.json');
  // Not `npm ci`: it refuses the lock where a registry lacks the optional packages of other platforms. This installs
  // what the lock says, too, and leaves the lock alone.
  await must('npm', ['install', '--no-save', '--no-audit', '--no-fund']);
  const now = new Date();
  utimesSync(installed, now, now);
}

/** The newest modification of the files under some paths. */
function newest(paths) {
  let time = 0;
  for (const path of paths) {
    const full = join(root, path);
    time = Math.max(time, modified(full));
    if (!statSync(full).isDirectory()) continue;
    for (const name of readdirSync(full, { recursive: true })) {
      time = Math.max(time, modified(join(full, name)));
    }
  }
  return time;
}

/** Builds the module of the page if its sources are newer. */
export async function buildModule() {
  const sources = [
    'CMakeLists.txt',
    'CMakePresets.json',
    'cmake',
    'lib/include',
    'lib/src',
    'wasm',
  ];
  const module = join(root, 'build/wasm/web/circumball-core.wasm');
  if (modified(module) > newest(sources)) return;
  console.log('Building the WebAssembly module');
  await must('cmake', ['--preset', 'wasm'], { capture: true });
  await must('cmake', ['--build', '--preset', 'wasm', '--target', 'circumball_core']);
  const now = new Date();
  utimesSync(module, now, now); // a source may be newer and yet change nothing
}
