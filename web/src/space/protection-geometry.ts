/** Where protecting elements lie: true arcs, and patches that look outwards. */

import { cross, distance3, dot, minus, plus, point3, scaled } from '../replay/geometry3';
import { type Complex3, type MeshState, type Point3, Protecting } from '../shared/types';

/** Pieces that an arc is drawn in: an angle of 9 degrees for a quarter turn. */
export const ARC_PIECES = 10;

/**
 * Points on the arc from a to b about `center`, less than half a turn, with both ends. Where the ends are not equally far from the
 * center (vertices are rounded) the radius changes evenly from one to the other.
 */
export function arcPoints(center: Point3, a: Point3, b: Point3, pieces = ARC_PIECES): Point3[] {
  const [u, v] = [minus(a, center), minus(b, center)];
  const [ru, rv] = [Math.hypot(...u), Math.hypot(...v)];
  const angle = Math.atan2(Math.hypot(...cross(u, v)), dot(u, v));
  const sine = Math.sin(angle);
  const points: Point3[] = [];
  for (let i = 0; i <= pieces; i++) {
    const t = i / pieces;
    if (i === 0 || i === pieces || !(sine > 1e-9)) {
      points.push(i === 0 ? a : i === pieces ? b : plus(a, minus(b, a), t));
      continue;
    }
    const [p, q] = [Math.sin((1 - t) * angle) / sine, Math.sin(t * angle) / sine];
    const radius = ru + (rv - ru) * t;
    points.push(plus(plus(center, u, (p * radius) / ru), v, (q * radius) / rv));
  }
  return points;
}

/** The point of the line through p and q that is nearest to x. */
export function footOn(p: Point3, q: Point3, x: Point3): Point3 {
  const d = minus(q, p);
  const length2 = dot(d, d);
  return length2 > 0 ? plus(p, d, dot(minus(x, p), d) / length2) : p;
}

export type PlaceOf = (v: number) => Point3;

/** The points of a curve: two of a straight one. `record`: a, b, c, carrier. */
export function curvePoints(
  kind: number,
  record: ArrayLike<number>,
  at: PlaceOf,
  complex: Complex3 | null,
): Point3[] {
  const [a, b] = [at(record[0]!), at(record[1]!)];
  if (kind === Protecting.collarArc) return arcPoints(at(record[2]!), a, b);
  if (kind !== Protecting.ringArc) return [a, b];
  // The ring at the tip of an end segment lies where sphere and tube meet: not about the tip itself, but on the axis.
  const axis = axisOf(complex, record[3]!);
  return arcPoints(axis ? footOn(...axis, a) : at(record[2]!), a, b);
}

/** The corners of a patch, counter-clockwise as seen from outside of its sphere or tube. */
export function patchCorners(
  kind: number,
  record: ArrayLike<number>,
  at: PlaceOf,
  complex: Complex3 | null,
): readonly [Point3, Point3, Point3] {
  const [a, b, c] = [at(record[0]!), at(record[1]!), at(record[2]!)];
  const middle = scaled(plus(plus(a, b), c), 1 / 3);
  const axis = kind === Protecting.tubePatch ? axisOf(complex, record[3]!) : null;
  const center =
    kind === Protecting.spherePatch ? at(record[3]!) : axis ? footOn(...axis, middle) : middle;
  const outward = dot(cross(minus(b, a), minus(c, a)), minus(middle, center)) >= 0;
  return outward ? [a, b, c] : [a, c, b];
}

/** Mean length of the chords of ring arcs; infinite without any. */
export function arcSpacing({ protection, coordinates }: MeshState): number {
  let sum = 0;
  let count = 0;
  for (let i = 0; protection && i < protection.liveCount; i++) {
    const n = protection.live[i]!;
    if (protection.kind[n] !== Protecting.ringArc) continue;
    const [a, b] = [protection.elements[4 * n]!, protection.elements[4 * n + 1]!];
    sum += distance3(point3(coordinates, a), point3(coordinates, b));
    count++;
  }
  return count > 0 ? sum / count : Number.POSITIVE_INFINITY;
}

function axisOf(complex: Complex3 | null, segment: number): [Point3, Point3] | null {
  const ends = complex?.segments[segment];
  const [p, q] = ends ? [complex!.vertices[ends[0]], complex!.vertices[ends[1]]] : [];
  return p && q ? [p, q] : null;
}
