import { describe, expect, it } from 'vitest';
import { Kind, Reason } from '../../web/src/replay/event.ts';
import { Lockstep, type Side } from '../../web/src/replay/lockstep.ts';
import { jump } from '../../web/src/replay/timeline.ts';
import { Trace } from '../../web/src/replay/trace.ts';
import { type Draft, encode, random } from './small-trace.ts';

/** A trace of insertions with other events between them: `gaps[k]` before the k-th, the last one after all. */
function traceOf(gaps: readonly number[]): Trace {
  const trace = new Trace({ vertexCount: gaps.length - 1, segments: [] });
  append(trace, gaps, 0);
  return trace;
}

function append(trace: Trace, gaps: readonly number[], first: number): void {
  const drafts: Draft[] = [];
  for (const [k, gap] of gaps.entries()) {
    for (let i = 0; i < gap; i++)
      drafts.push({
        kind: i % 3 === 2 ? Kind.refused : Kind.dropped,
        dimension: 2,
        simplex: [0, 1, 2],
      });
    if (k === gaps.length - 1) break;
    drafts.push({
      kind: Kind.inserted,
      reason: Reason.input,
      subject: first + k,
      at: [k, k * k],
      dead: [],
      born: [],
    });
  }
  const { events, simplices } = encode(drafts);
  trace.append(events, simplices, ['0']);
}

const gaps = (next: () => number, n: number) =>
  Array.from({ length: n }, () => Math.floor(next() * 4));
const inserted = (trace: Trace, position: number) => trace.insertedBefore.at(position);

describe('two runs in step', () => {
  const next = random(3);
  for (const [n, m] of [
    [12, 12],
    [5, 17],
    [20, 3],
    [1, 6],
  ] as const) {
    const a = traceOf(gaps(next, n));
    const b = traceOf(gaps(next, m));
    const traces = [a, b] as const;
    for (const pace of ['vertices', 'share'] as const) {
      const both = new Lockstep(traces, pace);
      both.extend([true, true]);

      it(`(${n}, ${m}; ${pace}) go from the start of each to the end of each, never back`, () => {
        expect(both.at(0)).toEqual([0, 0]);
        expect(both.at(both.length)).toEqual([a.eventCount, b.eventCount]);
        for (let t = 1; t <= both.length; t++)
          for (const side of [0, 1] as const) {
            const by = both.at(t)[side] - both.at(t - 1)[side];
            expect(by === 0 || by === 1).toBe(true); // so every event has its tick
          }
      });

      it(`(${n}, ${m}; ${pace}) a tick is found again by the position of either`, () => {
        for (const side of [0, 1] as const)
          for (let p = 0; p <= traces[side].eventCount; p++) {
            const tick = both.tickOf(side, p);
            expect(both.at(tick)[side]).toBe(p);
            if (tick > 0) expect(both.at(tick - 1)[side]).toBeLessThan(p);
          }
      });

      it(`(${n}, ${m}; ${pace}) jumps visit every insertion of either, forwards and backwards`, () => {
        const ticks = new Set<number>();
        for (const side of [0, 1] as const)
          for (const t of insertionTicks(both, traces[side], side)) ticks.add(t);
        const all = [...ticks].sort((x, y) => x - y);
        const there: number[] = [];
        for (
          let t = both.jump(0, 'insertion', true);
          t !== null;
          t = both.jump(t, 'insertion', true)
        )
          there.push(t);
        expect(there).toEqual(all);
        const back: number[] = [];
        let t = both.jump(both.length, 'insertion', false);
        for (; t !== null; t = both.jump(t, 'insertion', false)) back.push(t);
        expect(back.reverse()).toEqual(all.filter((x) => x < both.length));
      });
    }

    it(`(${n}, ${m}) stand at the same number of vertices at every tick until one has ended`, () => {
      const both = new Lockstep(traces, 'vertices');
      both.extend([true, true]);
      const least = Math.min(inserted(a, a.eventCount), inserted(b, b.eventCount));
      for (let t = 0; t <= both.length; t++) {
        const [p, q] = both.at(t);
        const counts = [inserted(a, p), inserted(b, q)];
        if (Math.min(...counts) < least) expect(counts[0]).toBe(counts[1]);
        else expect(Math.min(...counts)).toBe(least);
      }
    });
  }

  it('are the same timeline whether the traces are whole or still grow', () => {
    const parts = [gaps(next, 9), gaps(next, 7)] as const;
    const whole = new Trace({ vertexCount: 14, segments: [] });
    const growing = new Trace({ vertexCount: 14, segments: [] });
    const other = traceOf(gaps(next, 11));
    append(whole, parts[0], 0);
    append(whole, parts[1], 8);
    const late = new Lockstep([growing, other], 'vertices');
    late.extend([false, true]);
    expect(late.length).toBe(0);
    append(growing, parts[0], 0);
    late.extend([false, true]);
    const known = late.length;
    expect(known).toBeGreaterThan(0);
    const before = Array.from({ length: known }, (_, t) => late.at(t));
    append(growing, parts[1], 8);
    late.extend([true, true]);
    const direct = new Lockstep([whole, other], 'vertices');
    direct.extend([true, true]);
    expect(late.length).toBe(direct.length);
    for (let t = 0; t <= late.length; t++) expect(late.at(t)).toEqual(direct.at(t));
    expect(before).toEqual(Array.from({ length: known }, (_, t) => direct.at(t)));
  });
});

function insertionTicks(both: Lockstep, trace: Trace, side: Side): number[] {
  const ticks: number[] = [];
  for (let p = jump(trace, 0, 'insertion', true); p !== null; p = jump(trace, p, 'insertion', true))
    ticks.push(both.tickOf(side, p));
  return ticks;
}

describe('two runs in step by steps', () => {
  /** A step of a name, and so many events in it. */
  const run = (steps: readonly (readonly [string, number])[]): Trace => {
    const trace = new Trace({ vertexCount: 0, segments: [] });
    const drafts = steps.flatMap(([, count], step): Draft[] => [
      { kind: Kind.stepBegan, step },
      ...Array.from({ length: count - 1 }, () => ({
        kind: Kind.stepEnded,
        step,
        other: [0, 0] as const,
      })),
    ]);
    const { events, simplices } = encode(drafts as Draft[]);
    trace.append(
      events,
      simplices,
      steps.map(([name]) => name),
    );
    return trace;
  };
  const a = run([
    ['0', 10],
    ['2b', 40],
    ['2c', 7],
    ['3', 20],
  ]);
  const b = run([
    ['0', 10],
    ['2b', 5],
    ['rings', 9],
    ['3', 60],
  ]);
  const both = new Lockstep([a, b], 'steps');
  both.extend([true, true]);

  it('begin steps of the same name together', () => {
    const begun = (tick: number) => both.at(tick);
    const ticks = Array.from({ length: both.length + 1 }, (_, t) => t);
    for (const [inA, inB] of [
      [10, 10],
      [57, 24],
      [77, 84],
    ] as const)
      expect(ticks.some((t) => begun(t)[0] === inA && begun(t)[1] === inB)).toBe(true);
  });

  it('never go back, and end together', () => {
    expect(both.at(0)).toEqual([0, 0]);
    for (let t = 1; t <= both.length; t++)
      for (const side of [0, 1] as const)
        expect(both.at(t)[side]).toBeGreaterThanOrEqual(both.at(t - 1)[side]);
    expect(both.at(both.length)).toEqual([a.eventCount, b.eventCount]);
  });
});
