// A mesh is the same bit for bit: the command built with GCC, with Clang, in Debug and for WebAssembly must print the
// same fingerprint for every example and every algorithm.
import { mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { cpus, tmpdir } from 'node:os';
import { join } from 'node:path';
import { node, root, run } from './lib.mjs';

/** How to run each build of the command; the first is what the others are compared with. */
const commands = {
  'native (GCC, Release)': ['build/native/circumball'],
  WebAssembly: [node, 'build/wasm/circumball.mjs'],
  'Clang, Release': ['build/clang/circumball'],
  'GCC, Debug': ['build/debug/circumball'],
};

/** Examples that do not end by design (Ruppert on acute input) are compared where this limit stops them. */
const maxVertices = { 2: '3000', 3: '6000' };

const inputs = () =>
  readdirSync(join(root, 'examples'), { recursive: true })
    .filter(
      (name) =>
        /\.(poly|json|obj|off|ply|stl|svg|geojson)$/.test(name) && !/(^|\/)index\.json$/.test(name),
    )
    .sort()
    .map((name) => join('examples', name));

async function fingerprint([program, ...args], input, algorithm, dimension, report) {
  const mesh = ['mesh', input, '--algorithm', algorithm, '--max-vertices', maxVertices[dimension]];
  const { code, output } = await run(
    program,
    [...args, ...mesh, '--quiet', '--no-progress', '--report', report],
    { capture: true },
  );
  if (code !== 0 && code !== 4) return { code, text: `exit ${code}: ${output.trim()}` };
  const { fingerprint: print, status, mesh: measures } = JSON.parse(readFileSync(report, 'utf8'));
  return { code, text: `exit ${code}, ${status}, ${print}, ${measures.vertices} vertices` };
}

/** Calls `action` for all items, as many at once as there are processors; results in the items' order. */
async function inParallel(items, action) {
  const results = new Array(items.length);
  let next = 0;
  const worker = async () => {
    while (next < items.length) {
      const i = next++;
      results[i] = await action(items[i], i);
    }
  };
  await Promise.all(cpus().map(worker));
  return results;
}

/** Resolves to { code, output, passed, failed }: one comparison for each example and algorithm. */
export async function compareFingerprints() {
  const folder = mkdtempSync(join(tmpdir(), 'circumball-'));
  const first = Object.values(commands)[0];
  const listed = await run(first[0], ['list', '--json'], { capture: true });
  if (listed.code !== 0) return { code: 1, output: listed.output };
  const algorithms = JSON.parse(listed.output);
  const compared = [];
  for (const input of inputs()) {
    const checked = await run(first[0], ['check', input], { capture: true });
    if (checked.code !== 0) continue; // examples of bad input have tests of their own
    for (const { id, dimension } of algorithms) {
      if (checked.output.includes(`dimension ${dimension}`))
        compared.push({ input, id, dimension });
    }
  }
  const runs = compared.flatMap((what) =>
    Object.values(commands).map((command) => ({ ...what, command })),
  );
  const printed = await inParallel(runs, ({ command, input, id, dimension }, i) =>
    fingerprint(command, input, id, dimension, join(folder, `${i}.json`)),
  );
  rmSync(folder, { recursive: true });
  const result = { code: 0, output: '', passed: 0, failed: 0 };
  const builds = Object.keys(commands);
  compared.forEach(({ input, id }, at) => {
    const texts = printed.slice(at * builds.length, (at + 1) * builds.length).map((p) => p.text);
    const same = texts.every((text) => text === texts[0]);
    result[same ? 'passed' : 'failed'] += 1;
    result.output += `${same ? 'same' : 'DIFFERENT'} ${input} ${id}: ${texts[0]}\n`;
    if (!same) {
      builds.forEach((name, i) => {
        result.output += `    ${name}: ${texts[i]}\n`;
      });
    }
  });
  result.code = result.failed === 0 && result.passed > 0 ? 0 : 1;
  return result;
}

if (import.meta.filename === process.argv[1]) {
  const { code, output, passed, failed } = await compareFingerprints();
  console.log(`${output}${passed} same, ${failed} different`);
  process.exit(code);
}
