/** Where segments meet that do not share a vertex there: decided exactly, placed in doubles. */

import type { Point } from '../shared/types';
import { orientation } from './orientation';

export type Meeting =
  | { readonly kind: 'crossing'; readonly at: Point } // interiors cross
  | { readonly kind: 'touch'; readonly end: 0 | 1 | 2 | 3 } // end a, b, c or d lies inside the other segment
  | { readonly kind: 'overlap'; readonly ends: readonly (0 | 1 | 2 | 3)[] }; // collinear: ends inside the other

type Ends = readonly [Point, Point];

const same = (p: Point, q: Point) => p[0] === q[0] && p[1] === q[1];

/** Strictly between a and b, for a point on their line. */
function between(p: Point, a: Point, b: Point): boolean {
  if (same(p, a) || same(p, b)) return false;
  return a[0] !== b[0]
    ? p[0] > Math.min(a[0], b[0]) && p[0] < Math.max(a[0], b[0])
    : p[1] > Math.min(a[1], b[1]) && p[1] < Math.max(a[1], b[1]);
}

/** How segments ab and cd meet in the interior of at least one; null if they do not. */
export function meet([a, b]: Ends, [c, d]: Ends): Meeting | null {
  if (
    Math.max(a[0], b[0]) < Math.min(c[0], d[0]) ||
    Math.max(c[0], d[0]) < Math.min(a[0], b[0]) ||
    Math.max(a[1], b[1]) < Math.min(c[1], d[1]) ||
    Math.max(c[1], d[1]) < Math.min(a[1], b[1])
  ) {
    return null;
  }
  const abc = orientation(a, b, c);
  const abd = orientation(a, b, d);
  const cda = orientation(c, d, a);
  const cdb = orientation(c, d, b);
  if (abc === 0 && abd === 0) {
    const ends: (0 | 1 | 2 | 3)[] = [];
    if (between(a, c, d)) ends.push(0);
    if (between(b, c, d)) ends.push(1);
    if (between(c, a, b)) ends.push(2);
    if (between(d, a, b)) ends.push(3);
    return ends.length > 0 ? { kind: 'overlap', ends } : null;
  }
  if (abc !== 0 && abd !== 0 && cda !== 0 && cdb !== 0) {
    return abc !== abd && cda !== cdb ? { kind: 'crossing', at: crossingPoint(a, b, c, d) } : null;
  }
  if (cda === 0 && between(a, c, d)) return { kind: 'touch', end: 0 };
  if (cdb === 0 && between(b, c, d)) return { kind: 'touch', end: 1 };
  if (abc === 0 && between(c, a, b)) return { kind: 'touch', end: 2 };
  if (abd === 0 && between(d, a, b)) return { kind: 'touch', end: 3 };
  return null;
}

/** Relative to a; some ulps off, as any point that is rounded to doubles. */
function crossingPoint(a: Point, b: Point, c: Point, d: Point): Point {
  const rx = b[0] - a[0];
  const ry = b[1] - a[1];
  const sx = d[0] - c[0];
  const sy = d[1] - c[1];
  const t = ((c[0] - a[0]) * sy - (c[1] - a[1]) * sx) / (rx * sy - ry * sx);
  return [a[0] + t * rx, a[1] + t * ry];
}

export interface Pair {
  readonly i: number;
  readonly j: number;
  readonly meeting: Meeting;
}

/** All meetings of a list of segments, by a sweep over x; missing ends are skipped. */
export function findMeetings(segments: readonly (Ends | null)[]): Pair[] {
  const order: number[] = [];
  segments.forEach((s, i) => {
    if (s?.flat().every(Number.isFinite)) order.push(i);
  });
  const low = (i: number) => Math.min(segments[i]![0][0], segments[i]![1][0]);
  const high = (i: number) => Math.max(segments[i]![0][0], segments[i]![1][0]);
  order.sort((i, j) => low(i) - low(j) || i - j);
  const pairs: Pair[] = [];
  let active: number[] = [];
  for (const j of order) {
    const from = low(j);
    active = active.filter((i) => high(i) >= from);
    for (const i of active) {
      const [p, q] = i < j ? [i, j] : [j, i];
      const meeting = meet(segments[p]!, segments[q]!);
      if (meeting) pairs.push({ i: p, j: q, meeting });
    }
    active.push(j);
  }
  return pairs.sort((p, q) => p.i - q.i || p.j - q.j);
}
