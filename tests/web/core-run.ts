import { readdirSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import type { CircumballModule } from 'circumball';
import { complexFromJson, complexToText } from '../../web/src/core/complex-json.ts';
import { Trace } from '../../web/src/replay/trace.ts';
import type { Complex2 } from '../../web/src/shared/types.ts';

/** Runs of the core on the examples, replayed as the page replays them. */

const folder = fileURLToPath(new URL('../../examples/', import.meta.url));

const index = JSON.parse(readFileSync(`${folder}index.json`, 'utf8')) as {
  file: string;
  dimension?: number;
}[];
const listed = new Set(index.filter((e) => e.dimension === 3).map((e) => e.file));
/** Not all examples are in the gallery; those in the project's own format say their dimension at once. */
const isOfSpace = (file: string) =>
  listed.has(file) ||
  /^.{0,60}"dimension": *3/s.test(readFileSync(folder + file, { encoding: 'utf8' }));

/** Those of the plane. */
export const exampleFiles = readdirSync(folder).filter(
  (f) => /\.(json|poly|svg|obj)$/.test(f) && f !== 'index.json' && !isOfSpace(f),
);

export function readExample(core: CircumballModule, file: string): Complex2 {
  const bytes = new Uint8Array(readFileSync(folder + file));
  return complexFromJson(core.read([{ name: file, bytes }]).complex);
}

/** The whole trace of a run, which is released; `tau` as the core took it. */
export function traceOf(core: CircumballModule, complex: Complex2, options: object) {
  const start = core.start(complexToText(complex), JSON.stringify(options));
  if (!start.ok) throw new Error(start.error);
  const trace = new Trace({ vertexCount: complex.vertices.length, segments: complex.segments });
  for (;;) {
    const progress = core.advance(start.run, 0, 0);
    const chunk = core.takeTrace(start.run);
    trace.append(chunk.events, chunk.simplices, chunk.steps);
    if (progress.status === 'running') continue;
    core.release(start.run);
    return { trace, tau: start.tau, status: progress.status };
  }
}

export function lfsOf(
  core: CircumballModule,
  complex: Complex2,
  points: Float64Array,
): Float64Array {
  const answer = core.featureSizes(complexToText(complex), points);
  if (!answer.ok) throw new Error(answer.error);
  return answer.lfs;
}
