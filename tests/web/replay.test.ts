import { describe, expect, it } from 'vitest';
import { Kind } from '../../web/src/replay/event.ts';
import { AngleCache, cellsInBin, histogram } from '../../web/src/replay/measure.ts';
import { momentAt } from '../../web/src/replay/moment.ts';
import { Replay } from '../../web/src/replay/replay.ts';
import { Trace } from '../../web/src/replay/trace.ts';
import { VertexKind } from '../../web/src/shared/types.ts';
import {
  encode,
  liveAfter,
  random,
  randomDrafts,
  squareDrafts,
  squareTrace,
} from './small-trace.ts';

function live(replay: Replay): string[] {
  const { liveCells, liveCellCount, cells } = replay.state();
  return Array.from(liveCells.subarray(0, liveCellCount), (n) =>
    cells.subarray(3 * n, 3 * n + 3).join(),
  ).sort();
}

describe('replay of a long trace', () => {
  const drafts = randomDrafts(400, 7);
  const trace = new Trace({ vertexCount: 0, segments: [] });
  const { events, simplices } = encode(drafts);
  trace.append(events, simplices, ['0']);

  it('rebuilds the mesh at every position, stepping forwards', () => {
    const replay = new Replay(trace);
    for (let p = 0; p <= drafts.length; p += 1) {
      replay.seek(p);
      if (p % 37 === 0 || p === drafts.length) expect(live(replay)).toEqual(liveAfter(drafts, p));
    }
  });

  it('rebuilds the mesh at every position, stepping backwards', () => {
    const replay = new Replay(trace);
    replay.seek(drafts.length);
    for (let p = drafts.length; p >= 0; p--) {
      replay.seek(p);
      if (p % 41 === 0) expect(live(replay)).toEqual(liveAfter(drafts, p));
    }
  });

  it('comes to the same mesh by any way of seeking', () => {
    const replay = new Replay(trace);
    const next = random(3);
    for (let i = 0; i < 60; i++) {
      const p = Math.floor(next() * (drafts.length + 1));
      replay.seek(p);
      expect(live(replay)).toEqual(liveAfter(drafts, p));
    }
  });

  it('does not care in which pieces the trace arrives', () => {
    const pieces = new Trace({ vertexCount: 0, segments: [] });
    const replay = new Replay(pieces);
    for (let i = 0; i < drafts.length; i += 13) {
      const part = encode(drafts.slice(i, i + 13));
      pieces.append(part.events, part.simplices, ['0']);
      replay.seek(pieces.eventCount - 5);
      expect(live(replay)).toEqual(liveAfter(drafts, Math.max(0, pieces.eventCount - 5)));
    }
  });

  it('tells what an event changed, and the reverse when it is taken back', () => {
    const replay = new Replay(trace);
    const i = drafts.length - 1;
    const forward = replay.change(i, true)!;
    const backward = replay.change(i, false)!;
    expect(forward.born.length).toBe(drafts[i]!.born!.length);
    expect(forward.died.length).toBe(drafts[i]!.dead!.length);
    expect(backward.born).toEqual(forward.died);
    expect(backward.died).toEqual(forward.born);
    expect(forward.vertex).toBe(drafts[i]!.subject);
  });
});

describe('replay of the square', () => {
  const trace = squareTrace();
  const replay = new Replay(trace);

  it('knows the kinds and steps of vertices', () => {
    expect(Array.from(trace.vertexKind.data.subarray(0, 5))).toEqual([
      VertexKind.input,
      VertexKind.input,
      VertexKind.input,
      VertexKind.input,
      VertexKind.onSegment,
    ]);
    expect(trace.vertexStep.data[4]).toBe(1);
  });

  it('splits a subsegment with its vertex, and joins it again on the way back', () => {
    const pieces = () => {
      const s = replay.state();
      return Array.from(s.liveSubsegments.subarray(0, s.liveSubsegmentCount), (n) =>
        s.subsegments.subarray(3 * n, 3 * n + 3).join(),
      );
    };
    replay.seek(14);
    expect(pieces()).toEqual(['1,2,1', '2,3,2', '3,0,3', '0,4,0', '4,1,0']);
    replay.seek(13);
    expect(pieces()).toEqual(['0,1,0', '1,2,1', '2,3,2', '3,0,3']);
  });

  it('keeps the queue: segments first, the triangle that yielded before those that wait', () => {
    const names = (p: number) =>
      trace.queue.at(p, 9).events.map((e) => trace.event(e).simplex.join());
    expect(names(8)).toEqual([]);
    expect(names(10)).toEqual(['0,1,2', '0,2,3']);
    expect(names(11)).toEqual(['0,2,3']); // 0,1,2 was popped and proposed
    expect(names(13)).toEqual(['0,1', '0,1,2', '0,2,3']);
    expect(names(14)).toEqual(['0,2,3']); // 0,1,2 died with the split
    expect(names(15)).toEqual([]);
  });

  it('draws every moment with its simplex, ball, ghost and arrow', () => {
    const yielding = momentAt(replay, 11)!;
    expect(yielding).toMatchObject({
      kind: 'yielded',
      rule: 'action',
      simplex: [0, 1, 2],
      ghost: [0.5, 0.5],
      yieldTo: [0, 1],
    });
    expect(yielding.ball!.center).toEqual([0.5, 0.5]);
    expect(yielding.ball!.radius).toBeCloseTo(Math.SQRT1_2);
    expect(momentAt(replay, 14)).toMatchObject({ kind: 'inserted', rule: 'action', vertex: 4 });
    expect(momentAt(replay, 15)).toMatchObject({ kind: 'refused', rule: 'safety' });
    expect(momentAt(replay, 0)).toBeNull();
  });

  it('says what happened and why at every moment', () => {
    for (let p = 1; p <= trace.eventCount; p++) {
      expect(momentAt(replay, p)!.sentence).toMatch(/^[A-Z0-9].*\.$/);
    }
    expect(momentAt(replay, 14)!.sentence).toContain('midpoint of subsegment 0–1 of segment 0');
    expect(momentAt(replay, 15)!.sentence).toContain('its circumcenter lies outside the domain');
  });

  it('measures the angles of the live triangles', () => {
    replay.seek(6);
    const cache = new AngleCache(trace);
    const h = histogram(replay.state(), cache);
    expect(h.cells).toBe(2);
    expect(h.minAngle).toBeCloseTo(45, 4);
    expect(h.maxAngle).toBeCloseTo(90, 4);
    expect(h.bins.reduce((a, b) => a + b)).toBe(6);
    const right = h.bins.findLastIndex((n) => n > 0);
    expect(cellsInBin(replay.state(), cache, right).size).toBe(2);
  });

  it('rejects a trace whose dead never lived', () => {
    const bad = encode([{ kind: Kind.inserted, subject: 0, dead: [[1, 2, 3, 0]], born: [] }]);
    const broken = new Trace({ vertexCount: 0, segments: [] });
    expect(() => broken.append(bad.events, bad.simplices, [])).toThrow(/never lived/);
  });

  it('has as many events as were written', () => {
    expect(trace.eventCount).toBe(squareDrafts.length);
  });
});
