/** Clipping to an axis-parallel box, in double precision. */

import type { Bounds, Point } from '../shared/types';

/**
 * The part of segment ab in the box, or null (Liang and Barsky, "A new concept and method for line clipping", 1984).
 * Ends that lie inside are returned as they are, bit for bit.
 */
export function clipSegment(a: Point, b: Point, box: Bounds): readonly [Point, Point] | null {
  let t0 = 0;
  let t1 = 1;
  const dx = b[0] - a[0];
  const dy = b[1] - a[1];
  const p = [-dx, dx, -dy, dy];
  const q = [a[0] - box.minX, box.maxX - a[0], a[1] - box.minY, box.maxY - a[1]];
  for (let i = 0; i < 4; ++i) {
    const pi = p[i]!;
    const qi = q[i]!;
    if (pi === 0) {
      if (qi < 0) return null;
      continue;
    }
    const t = qi / pi;
    if (pi < 0) {
      if (t > t1) return null;
      if (t > t0) t0 = t;
    } else {
      if (t < t0) return null;
      if (t < t1) t1 = t;
    }
  }
  // The end from which the cut is nearer is the base: the other may be a billion times farther away.
  return [
    t0 > 0 ? [a[0] + t0 * dx, a[1] + t0 * dy] : a,
    t1 < 1
      ? t1 > 0.5
        ? [b[0] - (1 - t1) * dx, b[1] - (1 - t1) * dy]
        : [a[0] + t1 * dx, a[1] + t1 * dy]
      : b,
  ];
}

/** The part of a convex polygon in the box: convex, possibly empty (Sutherland and Hodgman 1974). */
export function clipPolygon(polygon: readonly Point[], box: Bounds): readonly Point[] {
  let current = polygon;
  for (let side = 0; side < 4 && current.length > 0; ++side) {
    const axis = side >> 1;
    const upper = (side & 1) === 1;
    const bound = axis === 0 ? (upper ? box.maxX : box.minX) : upper ? box.maxY : box.minY;
    const inside = (p: Point) => (upper ? p[axis as 0 | 1] <= bound : p[axis as 0 | 1] >= bound);
    const next: Point[] = [];
    for (let i = 0; i < current.length; ++i) {
      const p = current[i]!;
      const q = current[(i + 1) % current.length]!;
      if (inside(p)) next.push(p);
      if (inside(p) !== inside(q)) next.push(cut(p, q, axis as 0 | 1, bound));
    }
    current = next;
  }
  return current;
}

function cut(p: Point, q: Point, axis: 0 | 1, bound: number): Point {
  const other = axis === 0 ? 1 : 0;
  const t = (bound - p[axis]) / (q[axis] - p[axis]);
  const value =
    t > 0.5 ? q[other] - (1 - t) * (q[other] - p[other]) : p[other] + t * (q[other] - p[other]);
  return axis === 0 ? [bound, value] : [value, bound];
}
