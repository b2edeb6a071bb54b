import type { Point3 } from '../shared/types.ts';

/** Geometry of space for drawing and for the numbers beside it; nothing is decided with it. */

export interface Ball3 {
  readonly center: Point3;
  readonly radius: number;
}

export function point3(coordinates: Float64Array, v: number): Point3 {
  return [coordinates[3 * v]!, coordinates[3 * v + 1]!, coordinates[3 * v + 2]!];
}

export function minus(a: Point3, b: Point3): Point3 {
  return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
}

export function plus(a: Point3, b: Point3, factor = 1): Point3 {
  return [a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]];
}

export function dot(a: Point3, b: Point3): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

export function cross(a: Point3, b: Point3): Point3 {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

export function length3(a: Point3): number {
  return Math.hypot(a[0], a[1], a[2]);
}

export function distance3(a: Point3, b: Point3): number {
  return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/** Of no points: the origin. */
export function centroid(points: readonly Point3[]): Point3 {
  let sum: Point3 = [0, 0, 0];
  for (const p of points) sum = plus(sum, p, 1 / points.length);
  return sum;
}

/**
 * The smallest ball with all corners of a simplex on its sphere: diametral, equatorial or circumscribed by the number of corners.
 * Null for a flat simplex. Relative to the first corner, so that offset coordinates lose nothing.
 */
export function circumball(corners: readonly Point3[]): Ball3 | null {
  const [a, b, c, d] = corners;
  if (!a || !b) return null;
  const u = minus(b, a);
  if (!c) return { center: plus(a, u, 0.5), radius: length3(u) / 2 };
  const v = minus(c, a);
  const normal = cross(u, v);
  const u2 = dot(u, u);
  const v2 = dot(v, v);
  let offset: Point3;
  if (!d) {
    const size = 2 * dot(normal, normal);
    if (!(size > 0)) return null;
    // Shewchuk, Lecture Notes on Geometric Robustness: (u x v) x (|v|^2 u - |u|^2 v) / (2 |u x v|^2).
    const across = cross(normal, minus(scaled(u, v2), scaled(v, u2)));
    offset = scaled(across, 1 / size);
  } else {
    const w = minus(d, a);
    const volume = 2 * dot(normal, w);
    if (volume === 0) return null;
    const sum = plus(
      plus(scaled(cross(v, w), u2), scaled(cross(w, u), v2)),
      scaled(normal, dot(w, w)),
    );
    offset = scaled(sum, 1 / volume);
  }
  const radius = length3(offset);
  return Number.isFinite(radius) ? { center: plus(a, offset), radius } : null;
}

/** Two opposite corners of the box about a ball. */
export function extremesOf({ center, radius }: Ball3): Point3[] {
  const reach: Point3 = [radius, radius, radius];
  return [plus(center, reach), plus(center, reach, -1)];
}

export function scaled(a: Point3, factor: number): Point3 {
  return [a[0] * factor, a[1] * factor, a[2] * factor];
}

/** The pairs of facets of a tetrahedron: between the facets opposite i and j lies the edge of the other two corners. */
const pairs = [
  [0, 1],
  [0, 2],
  [0, 3],
  [1, 2],
  [1, 3],
  [2, 3],
] as const;

/** The six dihedral angles in degrees; NaN for a flat tetrahedron. */
export function dihedralAngles(a: Point3, b: Point3, c: Point3, d: Point3): number[] {
  // Inward normals of the facets opposite to the corners, whatever the orientation.
  const sign = dot(cross(minus(b, a), minus(c, a)), minus(d, a)) > 0 ? 1 : -1;
  const normals = [
    cross(minus(d, b), minus(c, b)),
    cross(minus(c, a), minus(d, a)),
    cross(minus(d, a), minus(b, a)),
    cross(minus(b, a), minus(c, a)),
  ].map((n) => scaled(n, sign));
  return pairs.map(([i, j]) => {
    const p = normals[i]!;
    const q = normals[j]!;
    // Between inward normals lies the supplement.
    return (Math.atan2(length3(cross(p, q)), -dot(p, q)) * 180) / Math.PI;
  });
}

export function volume(a: Point3, b: Point3, c: Point3, d: Point3): number {
  return Math.abs(dot(cross(minus(b, a), minus(c, a)), minus(d, a))) / 6;
}

export function shortestEdge(corners: readonly Point3[]): number {
  let shortest = Number.POSITIVE_INFINITY;
  for (const [i, p] of corners.entries()) {
    for (const q of corners.slice(i + 1)) shortest = Math.min(shortest, distance3(p, q));
  }
  return shortest;
}
