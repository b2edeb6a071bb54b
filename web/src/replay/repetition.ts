import type { Bounds, Point } from '../shared/types.ts';
import { Kind, NONE, Reason } from './event.ts';
import { distance, point } from './geometry.ts';
import type { Trace } from './trace.ts';

/**
 * Refinement that does not end, as seen in its trace: at an input vertex, the limit vertex, the end subsegments are split in
 * the same order again and again, each time smaller by the same factor, and for the same reasons (docs/non-termination.md).
 * All of it happens so near to that vertex that nothing else of the input is there: segments that meet in a point look alike
 * at every size, so what has come again will come again.
 */
export interface Repetition {
  readonly vertex: number; // the limit vertex
  readonly at: Point;
  readonly factor: number; // size of a cycle in that of the one before: less than 1
  readonly cycles: number; // whole ones that were seen
  readonly exhausted: boolean; // the last ones are as small as double precision tells apart
  readonly free: number; // nearer than this nothing of the input is there but the segments at the vertex
  /** Positions at which the cycles begin, right after their first split; one more for the end of the last one. */
  readonly starts: readonly number[];
  /** Insertion radius of that split, for each of `starts`. */
  readonly radii: readonly number[];
  readonly segments: readonly number[]; // input segments whose ends are split, ascending
  readonly splits: number; // of end subsegments, in a cycle
  readonly midpoints: number; // insertions that come again in each cycle, by kind
  readonly circumcenters: number;
  /** Around the end subsegments before their splits in the first cycle. */
  readonly bounds: Bounds;
  /** Where every single split already leaves the lengths at the vertex smaller by one factor (the corner turned or mirrored). */
  readonly each: number | null;
}

/** Fewer cycles may be chance. */
const LEAST_CYCLES = 3;
/** Vertices are rounded; a cycle is alike to the one before within this part of its size. */
const ALIKE = 1e-6;
/** A new vertex is off by a few units in the last place of the coordinates of the vertex it is near to. */
const ROUNDING = 16 * Number.EPSILON;
/** Below so many roundings shapes are noise, and what is left may happen to be acceptable. */
const EXHAUSTED = 1e4;
const LONGEST_PERIOD = 96;
/** A run that does not end does so in the last part of its trace. */
const MOST_EVENTS = 400_000;
/** What happens around the end subsegments takes some cycles until it repeats, too. */
const STEADY_CYCLES = 12;
/** Insertions of a cycle that are looked at; those elsewhere are in between. */
const MOST_INSERTIONS = 600;

/** A split of an end subsegment. */
interface Pulse {
  readonly event: number;
  readonly segment: number;
  readonly place: Point; // of the new vertex, seen from the input vertex
  readonly length: number; // from the input vertex to the new vertex
  readonly radius: number;
  /** The vertex that encroached, or the circumcenter that yielded, seen from the input vertex; null: not told. */
  readonly cause: Point | null;
}

/** All repetitions that were still going on when the trace ended, that of most cycles first. O(events). */
export function findRepetitions(trace: Trace): Repetition[] {
  const found: Repetition[] = [];
  for (const [vertex, all] of endSplits(trace)) {
    if (all.length <= LEAST_CYCLES) continue;
    // Towards a small feature sizes shrink by a half again and again, too; they do no more once they are as small as it is.
    const free = freeRadius(trace, vertex);
    const pulses = all.filter((p) => p.length < free);
    const at = point(trace.coordinates.data, vertex);
    const slack = ROUNDING * Math.max(Math.abs(at[0]), Math.abs(at[1]));
    const stretch = periodicStretch(pulses, slack);
    if (stretch) found.push(account(trace, vertex, free, slack, pulses, stretch));
  }
  return found.sort((a, b) => b.cycles - a.cycles || a.vertex - b.vertex);
}

/** Can a trace hold splits down to the end of double precision? A quick look. */
export function reachesPrecision(trace: Trace): boolean {
  let magnitude = 0;
  let least = Number.POSITIVE_INFINITY;
  for (let v = 0; v < trace.vertexCount; v++) {
    const [x, y] = point(trace.coordinates.data, v);
    magnitude = Math.max(magnitude, Math.abs(x), Math.abs(y));
    const radius = trace.vertexRadius.data[v]!;
    if (v >= trace.input.vertexCount && radius > 0) least = Math.min(least, radius);
  }
  return least < 100 * EXHAUSTED * ROUNDING * magnitude;
}

function endSplits(trace: Trace): Map<number, Pulse[]> {
  const pulses = new Map<number, Pulse[]>();
  const causes = new Map<number, Point | null>();
  const keyOf = (a: number, b: number) => Math.min(a, b) * 2 ** 26 + Math.max(a, b);
  const xy = trace.coordinates.data;
  const inputs = trace.input.vertexCount;
  for (let i = Math.max(0, trace.eventCount - MOST_EVENTS); i < trace.eventCount; i++) {
    const kind = trace.kind(i);
    if (kind !== Kind.queued && kind !== Kind.yielded && kind !== Kind.inserted) continue;
    const e = trace.event(i);
    if (kind === Kind.yielded) causes.set(keyOf(...e.other), e.at);
    if (e.dimension !== 1 || e.simplex.length !== 2) continue;
    const [a, b] = e.simplex as [number, number];
    const key = keyOf(a, b);
    if (kind === Kind.queued && e.reason !== Reason.yieldedTo)
      causes.set(key, e.subject === NONE ? null : point(xy, e.subject));
    if (kind !== Kind.inserted || e.center !== NONE || e.segment === NONE) continue;
    const cause = causes.get(key) ?? null;
    causes.delete(key);
    for (const v of [a, b]) {
      if (v >= inputs) continue;
      const q = point(xy, v);
      const list = pulses.get(v) ?? [];
      pulses.set(v, list);
      list.push({
        event: i,
        segment: e.segment,
        place: [e.at[0] - q[0], e.at[1] - q[1]],
        length: distance(e.at, q),
        radius: e.value,
        cause: cause && [cause[0] - q[0], cause[1] - q[1]],
      });
    }
  }
  return pulses;
}

/** Distance from an input vertex to the nearest other vertex or segment of the input that it does not belong to. O(input). */
function freeRadius(trace: Trace, vertex: number): number {
  const xy = trace.coordinates.data;
  const q = point(xy, vertex);
  let least = Number.POSITIVE_INFINITY;
  for (let v = 0; v < trace.input.vertexCount; v++)
    if (v !== vertex) least = Math.min(least, distance(q, point(xy, v)));
  for (const [a, b] of trace.input.segments)
    if (a !== vertex && b !== vertex)
      least = Math.min(least, distanceToSegment(q, point(xy, a), point(xy, b)));
  return least;
}

function distanceToSegment(p: Point, a: Point, b: Point): number {
  const ux = b[0] - a[0];
  const uy = b[1] - a[1];
  const length2 = ux * ux + uy * uy;
  const t = length2 > 0 ? ((p[0] - a[0]) * ux + (p[1] - a[1]) * uy) / length2 : 0;
  const s = Math.max(0, Math.min(1, t));
  return distance(p, [a[0] + s * ux, a[1] + s * uy]);
}

interface Stretch {
  readonly from: number; // first and last pulse
  readonly to: number;
  readonly period: number; // pulses
  readonly factor: number;
}

/**
 * The shortest period with which the pulses repeat, up to the last ones: a limit refuses one and lets another pass, and at
 * the end of double precision lengths are noise. `slack`: rounding of a coordinate at the vertex.
 */
function periodicStretch(pulses: readonly Pulse[], slack: number): Stretch | null {
  const most = Math.min(LONGEST_PERIOD, Math.floor(pulses.length / (LEAST_CYCLES + 1)));
  for (let period = 1; period <= most; period++) {
    const tail = Math.max(2 * period, pulses.length >> 2);
    for (let end = pulses.length - 1; end >= LEAST_CYCLES * period; end--) {
      // The factor is measured where rounding is far below a length.
      if (slack > 0.1 * ALIKE * pulses[end]!.length) continue;
      const factor = pulses[end]!.length / pulses[end - period]!.length;
      if (!(factor < 1 - ALIKE)) continue;
      const isAlike = (i: number) => comesAgain(pulses[i - period]!, pulses[i]!, factor, slack);
      let from = end;
      while (from >= period && isAlike(from)) from--;
      from += 1 - period;
      if (end - from < LEAST_CYCLES * period) continue;
      let to = end;
      while (to + 1 < pulses.length && isAlike(to + 1)) to++;
      if (to >= pulses.length - 1 - tail) return { from, to, period, factor: powerOfTwo(factor) };
      break; // it came to an end by itself
    }
  }
  return null;
}

/** Midpoints halve: where a factor is measured near a power of two it is one. */
function powerOfTwo(factor: number): number {
  const power = 2 ** Math.round(Math.log2(factor));
  return close(factor, power) ? power : factor;
}

function comesAgain(before: Pulse, now: Pulse, factor: number, slack: number): boolean {
  if (before.segment !== now.segment) return false;
  if (!close(now.length, factor * before.length, slack)) return false;
  if (!close(now.radius, factor * before.radius, slack)) return false;
  if (!before.cause || !now.cause) return before.cause === now.cause;
  const goal: Point = [factor * before.cause[0], factor * before.cause[1]];
  return distance(now.cause, goal) <= ALIKE * now.length + slack;
}

function close(x: number, y: number, slack = 0): boolean {
  return Math.abs(x - y) <= ALIKE * Math.abs(y) + slack;
}

function account(
  trace: Trace,
  vertex: number,
  free: number,
  slack: number,
  pulses: readonly Pulse[],
  { from, to, period, factor }: Stretch,
): Repetition {
  const at = point(trace.coordinates.data, vertex);
  const heads: Pulse[] = [];
  // Where shapes are noise nothing can be seen to come again.
  for (let i = from; i <= to; i += period)
    if (heads.length <= LEAST_CYCLES || pulses[i]!.length > EXHAUSTED * slack)
      heads.push(pulses[i]!);
  const cycles = heads.length - 1;
  const lastCycle = pulses.slice(to - period + 1, to + 1);
  const steady = Math.max(0, Math.min(cycles - 2, STEADY_CYCLES));
  const again = insertionsThatComeAgain(trace, at, heads.slice(steady, steady + 3), factor);
  const middle = from + steady * period;
  const ratio = pulses[middle + 1]!.length / pulses[middle]!.length;
  const isEven = lastCycle.every((_, i) =>
    close(pulses[middle + i + 1]!.length, ratio * pulses[middle + i]!.length),
  );
  return {
    vertex,
    at,
    factor,
    cycles,
    exhausted: pulses[to]!.length < EXHAUSTED * slack,
    free,
    starts: heads.map((p) => p.event + 1),
    radii: heads.map((p) => p.radius),
    segments: [...new Set(lastCycle.map((p) => p.segment))].sort((a, b) => a - b),
    splits: period,
    midpoints: again.midpoints,
    circumcenters: again.circumcenters,
    bounds: boundsAround(at, pulses.slice(from, from + period)),
    each: isEven && period > 1 ? ratio : null,
  };
}

/** Midpoints lie half way to the ends. */
function boundsAround(q: Point, cycle: readonly Pulse[]): Bounds {
  const xs = [q[0], ...cycle.map(({ place }) => q[0] + 2 * place[0])];
  const ys = [q[1], ...cycle.map(({ place }) => q[1] + 2 * place[1])];
  return {
    minX: Math.min(...xs),
    minY: Math.min(...ys),
    maxX: Math.max(...xs),
    maxY: Math.max(...ys),
  };
}

/** Of the insertions of a cycle, those that the next cycle repeats at its own size about the limit vertex. */
function insertionsThatComeAgain(
  trace: Trace,
  q: Point,
  heads: readonly Pulse[],
  factor: number,
): { midpoints: number; circumcenters: number } {
  const counts = { midpoints: 0, circumcenters: 0 };
  const [first, second, third] = heads;
  if (!first || !second || !third) return counts;
  const within = (from: number, to: number) => {
    const list: { dimension: number; at: Point }[] = [];
    for (let i = from; i < to && list.length < MOST_INSERTIONS; i++) {
      if (trace.kind(i) !== Kind.inserted) continue;
      const e = trace.event(i);
      list.push({ dimension: e.dimension, at: [e.at[0] - q[0], e.at[1] - q[1]] });
    }
    return list;
  };
  const later = within(second.event, third.event);
  for (const { dimension, at } of within(first.event, second.event)) {
    const goal: Point = [factor * at[0], factor * at[1]];
    const slack = 10 * ALIKE * Math.hypot(goal[0], goal[1]);
    if (!later.some((x) => x.dimension === dimension && distance(x.at, goal) <= slack)) continue;
    if (dimension === 1) counts.midpoints++;
    else counts.circumcenters++;
  }
  return counts;
}
