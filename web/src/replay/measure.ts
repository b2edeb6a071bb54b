import { Label, type MeshState, type Point3 } from '../shared/types.ts';
import { angles, circumcircle, distance, point } from './geometry.ts';
import { circumball, dihedralAngles, point3, shortestEdge, volume } from './geometry3.ts';
import type { Trace } from './trace.ts';

/** Angles of the cells inside the domain (of triangles; dihedral ones of tetrahedra), in bins of 5 degrees. */
export const BIN_DEGREES = 5;
export const BINS = 180 / BIN_DEGREES;

export interface Histogram {
  readonly bins: Uint32Array; // angles in each bin
  readonly cells: number; // counted
  readonly minAngle: number; // degrees; NaN without cells
  readonly maxAngle: number;
}

/** Angles of every cell that ever lived, measured when first asked for: three of a triangle, six of a tetrahedron. */
export class AngleCache {
  private values = new Float32Array(0);
  private readonly each: number;

  constructor(private readonly trace: Trace) {
    this.each = trace.dimension === 2 ? 3 : 6;
  }

  /** In degrees; those of a triangle at the vertices in the order of `Trace.cells`. Not to be kept. */
  of(n: number): Float32Array {
    const { each, trace } = this;
    if (each * (n + 1) > this.values.length) {
      const next = new Float32Array(each * Math.max(trace.cellCount, n + 1)).fill(-1);
      next.set(this.values);
      this.values = next;
    }
    if (this.values[each * n]! < 0) this.values.set(anglesOf(trace, n), each * n);
    return this.values.subarray(each * n, each * (n + 1));
  }
}

function anglesOf(trace: Trace, n: number): readonly number[] {
  const t = trace.cells.data;
  const at = trace.coordinates.data;
  if (trace.dimension === 2)
    return angles(point(at, t[3 * n]!), point(at, t[3 * n + 1]!), point(at, t[3 * n + 2]!));
  return dihedralAngles(...cornersOf(trace, n));
}

function cornersOf(trace: Trace, n: number): [Point3, Point3, Point3, Point3] {
  const t = trace.cells.data;
  const at = trace.coordinates.data;
  return [0, 1, 2, 3].map((k) => point3(at, t[4 * n + k]!)) as [Point3, Point3, Point3, Point3];
}

type LiveCells = Pick<MeshState, 'liveCells' | 'liveCellCount' | 'cellLabel'>;

export function histogram(state: LiveCells, cache: AngleCache): Histogram {
  const bins = new Uint32Array(BINS);
  let minAngle = Number.POSITIVE_INFINITY;
  let maxAngle = Number.NEGATIVE_INFINITY;
  let cells = 0;
  for (let i = 0; i < state.liveCellCount; i++) {
    const n = state.liveCells[i]!;
    if (state.cellLabel[n] === Label.outside) continue;
    cells++;
    for (const a of cache.of(n)) {
      bins[Math.min(BINS - 1, Math.floor(a / BIN_DEGREES))]!++;
      if (a < minAngle) minAngle = a;
      if (a > maxAngle) maxAngle = a;
    }
  }
  return cells > 0
    ? { bins, cells, minAngle, maxAngle }
    : { bins, cells, minAngle: Number.NaN, maxAngle: Number.NaN };
}

/** The cells at a position of the trace, wherever its replay is. O(cells ever born). */
export function cellsAt(trace: Trace, position: number): LiveCells {
  const born = trace.cellBorn.data;
  const died = trace.cellDied.data;
  const liveCells = new Uint32Array(trace.cellCount);
  let liveCellCount = 0;
  for (let n = 0; n < trace.cellCount; n++)
    if (born[n]! < position && position <= died[n]!) liveCells[liveCellCount++] = n;
  return { liveCells, liveCellCount, cellLabel: trace.cellLabel.data };
}

/** Cells inside the domain with an angle below a bound in degrees: of tetrahedra, slivers. */
export function countBelow(state: LiveCells, cache: AngleCache, degrees: number): number {
  let count = 0;
  for (let i = 0; i < state.liveCellCount; i++) {
    const n = state.liveCells[i]!;
    if (state.cellLabel[n] !== Label.outside && Math.min(...cache.of(n)) < degrees) count++;
  }
  return count;
}

export interface MeshMeasures {
  readonly cells: number; // inside the domain
  readonly minAngle: number; // degrees; NaN without cells
  readonly maxAngle: number;
  readonly bad: number; // with a radius-edge ratio above tau; 0 if tau is 0
}

/** O(live cells). */
export function measureMesh(
  trace: Trace,
  state: MeshState,
  cache: AngleCache,
  tau: number,
): MeshMeasures {
  const { cells, minAngle, maxAngle } = histogram(state, cache);
  let bad = 0;
  if (tau > 0.5) {
    // Angles are kept in single precision: where they come near the bound the ratio itself decides.
    const near = (Math.asin(1 / (2 * tau)) * 180) / Math.PI + 0.01;
    for (let i = 0; i < state.liveCellCount; i++) {
      const n = state.liveCells[i]!;
      if (state.cellLabel[n] === Label.outside) continue;
      if (trace.dimension === 3) {
        if (measureTetrahedron(trace, n).radiusEdge > tau) bad++;
      } else if (Math.min(...cache.of(n)) <= near && measureTriangle(trace, n).radiusEdge > tau) {
        bad++;
      }
    }
  }
  return { cells, minAngle, maxAngle, bad };
}

/** The cells with an angle in a bin: what the picture stresses when a bar is pointed at. */
export function cellsInBin(state: MeshState, cache: AngleCache, bin: number): Set<number> {
  const found = new Set<number>();
  for (let i = 0; i < state.liveCellCount; i++) {
    const n = state.liveCells[i]!;
    if (state.cellLabel[n] === Label.outside) continue;
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
  const t = trace.cells.data;
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

export interface TetrahedronMeasures {
  readonly angles: readonly number[]; // six dihedral ones, degrees
  readonly circumradius: number;
  readonly shortestEdge: number;
  readonly radiusEdge: number;
  readonly volume: number;
}

export function measureTetrahedron(trace: Trace, n: number): TetrahedronMeasures {
  const corners = cornersOf(trace, n);
  const circumradius = circumball(corners)?.radius ?? Number.POSITIVE_INFINITY;
  const shortest = shortestEdge(corners);
  return {
    angles: dihedralAngles(...corners),
    circumradius,
    shortestEdge: shortest,
    radiusEdge: circumradius / shortest,
    volume: volume(...corners),
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
