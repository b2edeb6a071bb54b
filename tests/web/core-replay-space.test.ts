import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import createCircumball, { type CircumballModule } from 'circumball';
import { beforeAll, describe, expect, it } from 'vitest';
import { complexToText, inputFromJson } from '../../web/src/core/complex-json.ts';
import { Kind, NONE } from '../../web/src/replay/event.ts';
import { ascending } from '../../web/src/replay/lives.ts';
import { momentAt } from '../../web/src/replay/moment.ts';
import { Replay } from '../../web/src/replay/replay.ts';
import { Trace } from '../../web/src/replay/trace.ts';
import { Label, type Moment3 } from '../../web/src/shared/types.ts';
import { examples } from '../../web/src/store/examples.ts';

/** The page draws nothing but the replayed trace: in space, too, it must be the mesh of the core. */

const folder = fileURLToPath(new URL('../../examples/', import.meta.url));
const spatial = examples.filter((e) => e.dimension === 3);

let core: CircumballModule;
beforeAll(async () => {
  core = await createCircumball();
});

function run(file: string, options: object) {
  const bytes = new Uint8Array(readFileSync(folder + file));
  const complex = inputFromJson(core.read([{ name: file, bytes }]).complex);
  const answer = core.start(complexToText(complex), JSON.stringify(options));
  expect(answer.error).toBe('');
  const { length: vertexCount } = complex.vertices;
  const trace = new Trace({ dimension: 3, vertexCount, segments: complex.segments });
  for (;;) {
    const progress = core.advance(answer.run, 50, 0);
    const chunk = core.takeTrace(answer.run);
    trace.append(chunk.events, chunk.simplices, chunk.steps);
    if (progress.status !== 'running') return { trace, handle: answer.run, complex };
  }
}

const cellName = (list: Uint32Array, n: number) =>
  ascending(list[4 * n]!, list[4 * n + 1]!, list[4 * n + 2]!, list[4 * n + 3]!).join();

describe.each(spatial.map((e) => [e.id, e] as const))('%s', (_, example) => {
  it('replays to the mesh of the core, bit for bit', () => {
    const { trace, handle } = run(example.files[0]!, { ...example.options, maxVertices: 3000 });
    const mesh = core.mesh(handle)!;
    const replay = new Replay(trace);
    replay.seek(trace.eventCount);
    const state = replay.state();

    const live = Array.from(state.liveCells.subarray(0, state.liveCellCount))
      .filter((n) => state.cellLabel[n] !== Label.outside)
      .map((n) => cellName(state.cells, n));
    const cells = Array.from({ length: mesh.cells.length / 4 }, (_, n) => cellName(mesh.cells, n));
    expect(live.sort()).toEqual(cells.sort());
    for (let i = 0; i < 3 * trace.vertexCount; i++)
      expect(Object.is(trace.coordinates.data[i], mesh.vertices[i])).toBe(true);

    const name = (a: number, b: number) => (a < b ? `${a},${b}` : `${b},${a}`);
    const pieces = Array.from(state.liveSubsegments.subarray(0, state.liveSubsegmentCount), (n) =>
      name(state.subsegments[3 * n]!, state.subsegments[3 * n + 1]!),
    );
    const known = new Set(pieces);
    expect(known.size).toBe(pieces.length);
    for (let i = 0; i < mesh.edges.length; i += 3)
      expect(known.has(name(mesh.edges[i]!, mesh.edges[i + 1]!))).toBe(true);
  });

  it('says what happens at every kind of moment', () => {
    const { trace } = run(example.files[0]!, { ...example.options, maxVertices: 1500 });
    const replay = new Replay(trace);
    const seen = new Set<string>();
    for (let p = 1; p <= trace.eventCount; p++) {
      const kind = `${trace.kind(p - 1)} ${trace.reason(p - 1)}`;
      if (seen.has(kind)) continue;
      seen.add(kind);
      const moment = momentAt(replay, p) as Moment3;
      expect(moment.sentence).toMatch(/^[A-Z0-9“].*\.$/);
      expect(moment.sentence).not.toMatch(/undefined|NaN|4294967295/);
      // A moment that names a near witness draws the ball that it lies in.
      if (moment.near !== null) expect(moment.ball).not.toBeNull();
    }
  });

  it('gives every face a triangulation of its own that covers it', () => {
    const { trace, complex } = run(example.files[0]!, { ...example.options, maxVertices: 3000 });
    const faces = 'faces' in complex ? complex.faces.length : 0;
    const replay = new Replay(trace);
    replay.seek(trace.eventCount);
    const { facets } = replay.state();
    const hasFaces = Array.from({ length: trace.eventCount }, (_, i) => trace.kind(i)).includes(
      Kind.faceChanged,
    );
    if (!hasFaces || !facets) return; // an algorithm that keeps none
    const seen = new Set<number>();
    for (let i = 0; i < facets.liveCount; i++) {
      const n = facets.live[i]!;
      expect(facets.triangles[4 * n + 3]).not.toBe(NONE);
      if (facets.label[n] === Label.inside) seen.add(facets.triangles[4 * n + 3]!);
    }
    for (let f = 0; f < faces; f++) expect(seen.has(f)).toBe(true);
  });
});
