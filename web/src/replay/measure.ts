import { Label, type MeshState } from '../shared/types.ts';
import { angles, circumcircle, distance, point } from './geometry.ts';
import type { Trace } from './trace.ts';

/** Angles of the triangles inside the domain, in bins of 5 degrees. */
export const BIN_DEGREES = 5;
export const BINS = 180 / BIN_DEGREES;

export interface Histogram {
  readonly bins: Uint32Array; // angles in each bin
  readonly triangles: number; // counted
  readonly minAngle: number; // degrees; NaN without triangles
  readonly maxAngle: number;
}

/** Angles of every triangle that ever lived, measured when first asked for. */
export class AngleCache {
  private values = new Float32Array(0);

  constructor(private readonly trace: Trace) {}

  /** Three angles in degrees, at the vertices in the order of `Trace.triangles`. */
  of(n: number): [number, number, number] {
    if (3 * n + 2 >= this.values.length) {
      const next = new Float32Array(3 * Math.max(this.trace.triangleCount, n + 1)).fill(-1);
      next.set(this.values);
      this.values = next;
    }
    if (this.values[3 * n]! < 0) {
      const t = this.trace.triangles.data;
      const xy = this.trace.coordinates.data;
      const three = angles(
        point(xy, t[3 * n]!),
        point(xy, t[3 * n + 1]!),
        point(xy, t[3 * n + 2]!),
      );
      this.values.set(three, 3 * n);
    }
    return [this.values[3 * n]!, this.values[3 * n + 1]!, this.values[3 * n + 2]!];
  }
}

export function histogram(state: MeshState, cache: AngleCache): Histogram {
  const bins = new Uint32Array(BINS);
  let minAngle = Number.POSITIVE_INFINITY;
  let maxAngle = Number.NEGATIVE_INFINITY;
  let triangles = 0;
  for (let i = 0; i < state.liveTriangleCount; i++) {
    const n = state.liveTriangles[i]!;
    if (state.triangleLabel[n] === Label.outside) continue;
    triangles++;
    for (const a of cache.of(n)) {
      bins[Math.min(BINS - 1, Math.floor(a / BIN_DEGREES))]!++;
      if (a < minAngle) minAngle = a;
      if (a > maxAngle) maxAngle = a;
    }
  }
  return triangles > 0
    ? { bins, triangles, minAngle, maxAngle }
    : { bins, triangles, minAngle: Number.NaN, maxAngle: Number.NaN };
}

export interface MeshMeasures {
  readonly triangles: number; // inside the domain
  readonly minAngle: number; // degrees; NaN without triangles
  readonly maxAngle: number;
  readonly bad: number; // with a radius-edge ratio above tau; 0 if tau is 0
}

/** O(live triangles). */
export function measureMesh(
  trace: Trace,
  state: MeshState,
  cache: AngleCache,
  tau: number,
): MeshMeasures {
  const { triangles, minAngle, maxAngle } = histogram(state, cache);
  let bad = 0;
  if (tau > 0.5) {
    // Angles are kept in single precision: where they come near the bound the ratio itself decides.
    const near = (Math.asin(1 / (2 * tau)) * 180) / Math.PI + 0.01;
    for (let i = 0; i < state.liveTriangleCount; i++) {
      const n = state.liveTriangles[i]!;
      if (state.triangleLabel[n] === Label.outside || Math.min(...cache.of(n)) > near) continue;
      if (measureTriangle(trace, n).radiusEdge > tau) bad++;
    }
  }
  return { triangles, minAngle, maxAngle, bad };
}

/** The triangles with an angle in a bin: what the picture stresses when a bar is pointed at. */
export function trianglesInBin(state: MeshState, cache: AngleCache, bin: number): Set<number> {
  const found = new Set<number>();
  for (let i = 0; i < state.liveTriangleCount; i++) {
    const n = state.liveTriangles[i]!;
    if (state.triangleLabel[n] === Label.outside) continue;
    if (cache.of(n).some((a) => Math.min(BINS - 1, Math.floor(a / BIN_DEGREES)) === bin))
      found.add(n);
  }
  return found;
}

export interface TriangleMeasures {
  readonly minAngle: number;
  readonly maxAngle: number;
  readonly circumradius: number;
  readonly shortestEdge: number;
  readonly radiusEdge: number;
}

export function measureTriangle(trace: Trace, n: number): TriangleMeasures {
  const t = trace.triangles.data;
  const xy = trace.coordinates.data;
  const a = point(xy, t[3 * n]!);
  const b = point(xy, t[3 * n + 1]!);
  const c = point(xy, t[3 * n + 2]!);
  const three = angles(a, b, c);
  const shortestEdge = Math.min(distance(a, b), distance(b, c), distance(c, a));
  const circumradius = circumcircle(a, b, c)?.radius ?? Number.POSITIVE_INFINITY;
  return {
    minAngle: Math.min(...three),
    maxAngle: Math.max(...three),
    circumradius,
    shortestEdge,
    radiusEdge: circumradius / shortestEdge,
  };
}

/**
 * The smallest angle in degrees that an algorithm with these checks promises; null where it promises none.
 * RE <= tau means every angle >= asin(1 / (2 tau)).
 */
export function angleBound(checks: readonly string[], tau: number): number | null {
  if (checks.includes('min-angle')) return 30; // Chew's first algorithm
  if (!checks.includes('radius-edge') || !(tau > 0.5)) return null;
  return (Math.asin(1 / (2 * tau)) * 180) / Math.PI;
}
