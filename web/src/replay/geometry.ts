import type { Point } from '../shared/types.ts';

/** Geometry for drawing and for the numbers beside it; nothing is decided with it. */

export function point(coordinates: Float64Array, v: number): Point {
  return [coordinates[2 * v]!, coordinates[2 * v + 1]!];
}

export function distance(a: Point, b: Point): number {
  return Math.hypot(a[0] - b[0], a[1] - b[1]);
}

export function midpoint(a: Point, b: Point): Point {
  return [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
}

/** Circumcenter and radius; null for a flat triangle. Relative to a, so that offset coordinates lose nothing. */
export function circumcircle(
  a: Point,
  b: Point,
  c: Point,
): { center: Point; radius: number } | null {
  const bx = b[0] - a[0];
  const by = b[1] - a[1];
  const cx = c[0] - a[0];
  const cy = c[1] - a[1];
  const d = 2 * (bx * cy - by * cx);
  if (d === 0) return null;
  const b2 = bx * bx + by * by;
  const c2 = cx * cx + cy * cy;
  const ux = (cy * b2 - by * c2) / d;
  const uy = (bx * c2 - cx * b2) / d;
  return { center: [a[0] + ux, a[1] + uy], radius: Math.hypot(ux, uy) };
}

/** The three angles in degrees, at a, b, c. */
export function angles(a: Point, b: Point, c: Point): [number, number, number] {
  const at = (p: Point, q: Point, r: Point) => {
    const ux = q[0] - p[0];
    const uy = q[1] - p[1];
    const vx = r[0] - p[0];
    const vy = r[1] - p[1];
    return (Math.abs(Math.atan2(ux * vy - uy * vx, ux * vx + uy * vy)) * 180) / Math.PI;
  };
  return [at(a, b, c), at(b, c, a), at(c, a, b)];
}

export function signedArea(a: Point, b: Point, c: Point): number {
  return ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
}
