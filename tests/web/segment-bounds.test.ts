import createCircumball, { type CircumballModule } from 'circumball';
import { beforeAll, describe, expect, it } from 'vitest';
import { Ancestry } from '../../web/src/replay/ancestry.ts';
import { NONE } from '../../web/src/replay/event.ts';
import { distance3, point3 } from '../../web/src/replay/geometry3.ts';
import { nearestInSpace } from '../../web/src/replay/nearest.ts';
import { Protection } from '../../web/src/replay/protection.ts';
import { Replay } from '../../web/src/replay/replay.ts';
import { segmentBounds, stepAt } from '../../web/src/replay/segment-bounds.ts';
import { countsAt, StepCounts } from '../../web/src/replay/step-counts.ts';
import { bands } from '../../web/src/replay/timeline.ts';
import { Label, VertexKind } from '../../web/src/shared/types.ts';
import { examples } from '../../web/src/store/examples.ts';
import { type SpaceRun, spaceRun } from './space-run.ts';

let core: CircumballModule;
let run: SpaceRun;
beforeAll(async () => {
  core = await createCircumball();
  run = spaceRun(core, 'pyramid.json');
});

/** For each bound that is stated at a position, whether it holds on all live subsegments. */
function boundsAt({ trace, text }: SpaceRun, position: number): Map<string, boolean> {
  const replay = new Replay(trace);
  replay.seek(position);
  const state = replay.state();
  const ends: number[] = [];
  for (let i = 0; i < state.liveSubsegmentCount; i++) {
    const n = state.liveSubsegments[i]!;
    for (const k of [0, 1]) ends.push(...point3(state.coordinates, state.subsegments[3 * n + k]!));
  }
  const answer = core.subsegmentSizes(text, Float64Array.from(ends));
  expect(answer.error).toBe('');
  const found = new Map<string, boolean>();
  for (let i = 0; i < state.liveSubsegmentCount; i++) {
    const [a, b] = [ends.slice(6 * i, 6 * i + 3), ends.slice(6 * i + 3, 6 * i + 6)];
    const sizes = {
      length: distance3(a as never, b as never),
      fs1: answer.fs1.radius[i]!,
      lfs1: answer.lfs1.radius[i]!,
      lfs: answer.lfs.radius[i]!,
    };
    for (const { theorem, holds } of segmentBounds(trace, position, sizes))
      found.set(theorem, (found.get(theorem) ?? true) && holds);
  }
  return found;
}

describe('what is proved of |s|', () => {
  it('is stated after the step that it speaks of, and holds for every subsegment', () => {
    const stated = bands(run.trace).map((band) => [
      band.name,
      [...boundsAt(run, band.end).entries()],
    ]);
    expect(stated).toEqual([
      ['0', []],
      ['1a', [['Theorem 4.1', true]]],
      [
        '1b',
        [
          ['Lemma 4.5', true],
          ['Lemma 4.9', true],
        ],
      ],
      [
        '2a',
        [
          ['Lemma 4.11', true],
          ['Lemma 4.10', true],
        ],
      ],
      [
        '2b',
        [
          ['Theorem 4.1', true],
          ['Theorem 4.2', true],
        ],
      ],
    ]);
  });

  it('holds below throughout steps 1b, 2a and 2b', () => {
    const start = bands(run.trace).find((b) => b.name === '1b')!.start;
    const { eventCount } = run.trace;
    for (let i = 1; i < 12; i++) {
      const found = boundsAt(run, Math.round(start + ((eventCount - start) * i) / 12));
      expect([...found.values()]).not.toContain(false);
      expect(found.size).toBeGreaterThan(0);
    }
  });

  it('is not claimed where it does not hold', () => {
    const { eventCount } = run.trace;
    const sizes = { length: 1, fs1: 0.5, lfs1: 0.5, lfs: 0.5 };
    const [below, above] = segmentBounds(run.trace, eventCount, sizes);
    expect([below!.holds, above!.holds]).toEqual([true, false]);
    const tiny = segmentBounds(run.trace, eventCount, { ...sizes, length: 0.01 });
    expect(tiny.map((b) => b.holds)).toEqual([false, true]);
    const alone = { length: 1, fs1: Infinity, lfs1: Infinity, lfs: Infinity };
    expect(segmentBounds(run.trace, eventCount, alone).every((b) => b.holds)).toBe(true);
  });

  it('knows the step of a position and whether it has ended there', () => {
    for (const band of bands(run.trace)) {
      expect(stepAt(run.trace, band.end)).toEqual({ name: band.name, ended: true });
      if (band.end - band.start > 1)
        expect(stepAt(run.trace, band.end - 1)).toEqual({ name: band.name, ended: false });
      expect(stepAt(run.trace, band.start + 1).name).toBe(band.name);
    }
  });
});

describe('counts by step', () => {
  it('are those of the replayed mesh', () => {
    const counter = new StepCounts(run.trace);
    const replay = new Replay(run.trace);
    for (let i = 0; i <= 20; i++) {
      const position = Math.round((i * run.trace.eventCount) / 20);
      replay.seek(position);
      const state = replay.state();
      const { facets } = state;
      let vertices = 0;
      for (let v = 0; v < state.vertexCount; v++) if (state.vertexBorn[v]! < position) vertices++;
      let triangles = 0;
      for (let k = 0; k < facets!.liveCount; k++)
        if (facets!.label[facets!.live[k]!] !== Label.outside) triangles++;
      const counts = { vertices, subsegments: state.liveSubsegmentCount, triangles };
      expect(countsAt(run.trace, position)).toEqual(counts);
      const rows = counter.at(position);
      expect(rows.at(-1)).toMatchObject(counts);
      for (const [k, row] of rows.slice(0, -1).entries())
        expect(row).toMatchObject({
          ended: true,
          ...countsAt(run.trace, bands(run.trace)[k]!.end),
        });
    }
  });

  it('Table 4.1: the wheel has as many vertices as the thesis counts, up to step 2a', () => {
    const example = examples.find((e) => e.id === 'wheel')!;
    const { vertices, source } = example.reference!;
    expect(source).toBe('Table 4.1');
    const wheel = spaceRun(core, example.files[0]!, { maxVertices: 2060 });
    const rows = new StepCounts(wheel.trace).at(wheel.trace.eventCount);
    for (const name of ['0', '1a', '1b', '2a'])
      expect([name, rows.find((r) => r.name === name)?.vertices]).toEqual([name, vertices[name]]);
  });
});

describe('vertices in space', () => {
  it('descend from older vertices, and from witnesses outside of their face', () => {
    const { trace } = run;
    const ancestry = new Ancestry(trace, new Protection(trace));
    const kinds = new Set<string>();
    for (let v = 0; v < trace.vertexCount; v++) {
      const cause = ancestry.cause(v);
      kinds.add(cause.kind);
      if (cause.parent !== NONE)
        expect(trace.vertexBorn.at(cause.parent)).toBeLessThan(trace.vertexBorn.at(v));
      if (trace.vertexKind.data[v] === VertexKind.inFace) {
        expect(cause.kind).toBe('nearer');
        expect(cause.parent).not.toBe(NONE);
      }
      for (const { vertex, parent } of ancestry.chain(v))
        expect(trace.vertexBorn.at(parent)).toBeLessThan(trace.vertexBorn.at(vertex));
    }
    expect([...kinds].sort()).toEqual(['division', 'input', 'nearer', 'third']);
  });

  it('N(q) is the distance to the nearest other vertex that is there', () => {
    const replay = new Replay(run.trace);
    const middle = Math.floor(run.trace.eventCount / 2);
    replay.seek(middle);
    const state = replay.state();
    const { distance, vertex } = nearestInSpace(state, 3);
    expect(vertex).not.toBe(3);
    const at = point3(state.coordinates, 3);
    for (let w = 0; w < state.vertexCount; w++) {
      if (w === 3 || state.vertexBorn[w]! >= middle) continue;
      expect(distance3(at, point3(state.coordinates, w))).toBeGreaterThanOrEqual(distance);
    }
  });
});
