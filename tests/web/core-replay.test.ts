import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import createCircumball, { type CircumballModule } from 'circumball';
import { beforeAll, describe, expect, it } from 'vitest';
import { complexFromJson, complexToText } from '../../web/src/core/complex-json.ts';
import { canonical } from '../../web/src/replay/lives.ts';
import { momentAt } from '../../web/src/replay/moment.ts';
import { Replay } from '../../web/src/replay/replay.ts';
import { Trace } from '../../web/src/replay/trace.ts';
import { Label } from '../../web/src/shared/types.ts';
import { exampleFiles } from './core-run.ts';
import { random } from './small-trace.ts';

/** The page draws nothing but the replayed trace: it must be the mesh of the core, for every example and algorithm. */

const folder = fileURLToPath(new URL('../../examples/', import.meta.url));

let core: CircumballModule;
beforeAll(async () => {
  core = await createCircumball();
});

function run(file: string, algorithm: string, slice: number) {
  const bytes = new Uint8Array(readFileSync(folder + file));
  const complex = complexFromJson(core.read([{ name: file, bytes }]).complex);
  const options = JSON.stringify({ algorithm, maxVertices: 3000 });
  const answer = core.start(complexToText(complex), options);
  expect(answer.error).toBe('');
  const trace = new Trace({ vertexCount: complex.vertices.length, segments: complex.segments });
  for (;;) {
    const progress = core.advance(answer.run, slice, 0);
    const chunk = core.takeTrace(answer.run);
    trace.append(chunk.events, chunk.simplices, chunk.steps);
    if (progress.status !== 'running')
      return { trace, handle: answer.run, status: progress.status };
  }
}

function liveInside(replay: Replay): string[] {
  const s = replay.state();
  const names: string[] = [];
  for (let i = 0; i < s.liveCellCount; i++) {
    const n = s.liveCells[i]!;
    if (s.cellLabel[n] !== Label.outside) {
      names.push(s.cells.subarray(3 * n, 3 * n + 3).join());
    }
  }
  return names.sort();
}

describe.each(exampleFiles)('%s', (file) => {
  it.each(['delaunay', 'ruppert', 'chew'])('replays to the mesh of %s', (algorithm) => {
    const { trace, handle, status } = run(file, algorithm, 100);
    const mesh = core.mesh(handle)!;
    const replay = new Replay(trace);
    replay.seek(trace.eventCount);

    const cells: string[] = [];
    for (let i = 0; i < mesh.cells.length; i += 3) {
      cells.push(canonical(mesh.cells[i]!, mesh.cells[i + 1]!, mesh.cells[i + 2]!).join());
    }
    expect(liveInside(replay)).toEqual(cells.sort());
    for (let v = 0; v < trace.vertexCount; v++) {
      expect(Object.is(trace.coordinates.data[2 * v], mesh.vertices[2 * v])).toBe(true);
      expect(Object.is(trace.coordinates.data[2 * v + 1], mesh.vertices[2 * v + 1])).toBe(true);
    }
    if (status === 'complete') expect(trace.queue.at(trace.eventCount, 1).length).toBe(0);

    const state = replay.state();
    const pieces = Array.from(state.liveSubsegments.subarray(0, state.liveSubsegmentCount), (n) => {
      const [a, b] = state.subsegments.subarray(3 * n, 3 * n + 2);
      return a! < b! ? `${a},${b}` : `${b},${a}`;
    });
    const edges: string[] = [];
    for (let i = 0; i < mesh.edges.length; i += 3) {
      const [a, b, s] = mesh.edges.subarray(i, i + 3);
      if (s !== 0xffffffff) edges.push(a! < b! ? `${a},${b}` : `${b},${a}`);
    }
    // Delaunay does not enforce segments: there the mesh lists only those that happen to be edges.
    const missing = edges.filter((e) => !pieces.includes(e));
    expect(missing).toEqual([]);
    core.release(handle);
  });

  it('comes to the same state by seeking anywhere as by playing, with a sentence for each moment', () => {
    const { trace, handle } = run(file, 'ruppert', 1);
    core.release(handle);
    const player = new Replay(trace);
    const seeker = new Replay(trace);
    const next = random(11);
    let p = 0;
    while (p < trace.eventCount) {
      p = Math.min(trace.eventCount, p + 1 + Math.floor((next() * trace.eventCount) / 12));
      player.seek(p);
      seeker.seek(Math.floor(next() * trace.eventCount));
      seeker.seek(p);
      expect(liveInside(seeker)).toEqual(liveInside(player));
      const moment = momentAt(seeker, p)!;
      expect(moment.sentence).toMatch(/^[A-Z0-9].*\.$/);
      if (moment.witness !== null) expect(trace.vertexBorn.at(moment.witness)).toBeLessThan(p);
    }
  });
});
