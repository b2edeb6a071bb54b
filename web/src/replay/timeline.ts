import { Kind } from './event.ts';
import type { GrowU32 } from './grow.ts';
import type { Trace } from './trace.ts';

/** What the strip below the picture shows: bands for the steps, densities, and where to jump. */

export interface Band {
  readonly step: number;
  readonly name: string;
  readonly start: number; // position
  readonly end: number;
}

export function bands(trace: Trace): Band[] {
  return trace.stepStarts.map(({ step, event }, i) => ({
    step,
    name: trace.steps[step] ?? String(step),
    start: event,
    end: trace.stepStarts[i + 1]?.event ?? trace.eventCount,
  }));
}

export interface Density {
  readonly inserted: Float32Array; // share of the bucket's events, 0 … 1
  readonly refused: Float32Array;
  readonly yielded: Float32Array;
}

/**
 * Shares of each kind among the events that fall into each of `buckets` equal parts of the strip. `at`: where in the trace a
 * place of the strip is, if the strip is that of two runs and `length` long.
 */
export function density(
  trace: Trace,
  buckets: number,
  length: number = trace.eventCount,
  at: (place: number) => number = (place) => place,
): Density {
  const end = trace.eventCount;
  const edges = Array.from({ length: buckets + 1 }, (_, b) =>
    Math.min(end, at(Math.floor((b * length) / buckets))),
  );
  const share = (before: GrowU32) => {
    const out = new Float32Array(buckets);
    for (let b = 0; b < buckets; b++) {
      const from = edges[b]!;
      const to = Math.max(from + (length === end ? 1 : 0), edges[b + 1]!);
      if (from >= end || to <= from) continue;
      out[b] = (before.at(Math.min(to, end)) - before.at(from)) / (to - from);
    }
    return out;
  };
  return {
    inserted: share(trace.insertedBefore),
    refused: share(trace.refusedBefore),
    yielded: share(trace.yieldedBefore),
  };
}

export type JumpTarget = 'insertion' | 'refusal' | 'yield' | 'step';

/**
 * The position right after the next event of a sort beyond `position` (or, backwards, before it): the moment that shows it.
 * Null if there is none.
 */
export function jump(
  trace: Trace,
  position: number,
  target: JumpTarget,
  forward: boolean,
): number | null {
  if (target === 'step') return jumpStep(trace, position, forward);
  const before =
    target === 'insertion'
      ? trace.insertedBefore
      : target === 'refusal'
        ? trace.refusedBefore
        : trace.yieldedBefore;
  const here = before.at(position);
  if (forward) {
    if (before.at(trace.eventCount) === here) return null;
    return firstWith(before, here + 1, trace.eventCount);
  }
  // The event that made this position does not count: leave it.
  const standing = position > 0 && before.at(position) > before.at(position - 1);
  const goal = standing ? here - 1 : here;
  return goal > 0 ? firstWith(before, goal, trace.eventCount) : null;
}

/** Smallest position with at least `count` events before it. */
function firstWith(before: GrowU32, count: number, length: number): number {
  let low = 0;
  let high = length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (before.at(middle) >= count) high = middle;
    else low = middle + 1;
  }
  return low;
}

function jumpStep(trace: Trace, position: number, forward: boolean): number | null {
  const ends = bands(trace).map((band) => band.end);
  if (forward) return ends.find((end) => end > position) ?? null;
  const before = ends.filter((end) => end < position);
  return before.at(-1) ?? (position > 0 ? 0 : null);
}

export interface StepCounts {
  readonly name: string;
  readonly inserted: number;
  readonly refused: number;
  readonly yielded: number;
  readonly vertices: number; // when the step ended (or now, in the step at hand)
}

/** Counts by step, up to a position. */
export function countsByStep(trace: Trace, position: number): StepCounts[] {
  const rows: StepCounts[] = [];
  for (const band of bands(trace)) {
    if (band.start >= position && rows.length > 0) break;
    const end = Math.min(band.end, position);
    const between = (c: GrowU32) => c.at(end) - c.at(Math.min(band.start, end));
    rows.push({
      name: band.name,
      inserted: between(trace.insertedBefore),
      refused: between(trace.refusedBefore),
      yielded: between(trace.yieldedBefore),
      vertices: trace.insertedBefore.at(end),
    });
  }
  return rows;
}

/** How long a moment is worth looking at, in units of the playing speed: bookkeeping passes quicker than what changes the mesh. */
export function weight(kind: number): number {
  switch (kind) {
    case Kind.inserted:
    case Kind.refused:
    case Kind.yielded:
    case Kind.limit:
      return 1;
    case Kind.queued:
      return 0.4;
    case Kind.dropped:
      return 0.2;
    default:
      return 0.5;
  }
}
