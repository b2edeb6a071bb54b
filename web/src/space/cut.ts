/** Tetrahedra as what is seen of them: the facets of their union, whole or cut by a plane, or each cell by itself. */

import { SimplexTable } from '../replay/simplex-table';
import { Label, type MeshState, type Point3 } from '../shared/types';
import type { Plane } from './view';

/** Triangles with the number of the cell that each belongs to, and which of its edges are edges of the mesh (bits 1, 2, 4; CAP). */
export interface Cut {
  count: number;
  corners: Float64Array; // 9 numbers a triangle
  cells: Uint32Array;
  edges: Uint8Array;
}

export interface CutOptions {
  readonly outside: boolean; // cells outside the domain, too
  readonly only: ReadonlySet<number> | null; // these cells alone, whatever the plane says
  readonly plane: Plane | null;
  /** Cells that meet the plane are cut; else they are kept whole, or left out, by their centroids. */
  readonly exact: boolean;
  readonly shrink: number; // 0 to 1: towards the centroids
}

/** Facets of a positively oriented cell, each counter-clockwise from without: opposite to its first vertex, second, … */
const facets = [
  [1, 2, 3],
  [0, 3, 2],
  [0, 1, 3],
  [0, 2, 1],
] as const;

const ALL_EDGES = 7;
/** Lies in the plane: it is not to be cut once more. */
export const CAP = 8;

/** Reuses `into`. O(live cells). */
export function cutCells(state: MeshState, options: CutOptions, into: Cut = noCut()): Cut {
  const { plane, exact, only, shrink } = options;
  into.count = 0;
  const shown: number[] = [];
  for (let i = 0; i < state.liveCellCount; i++) {
    const n = state.liveCells[i]!;
    if (only ? !only.has(n) : !options.outside && state.cellLabel[n] === Label.outside) continue;
    shown.push(n);
  }
  const cut = plane && !only ? plane : null;
  const isWhole = shrink > 0;
  const boundary = new SimplexTable();
  const corners: Float64Array = new Float64Array(12);
  const depths = new Float64Array(4);
  const candidates: number[] = []; // facets that may be of the boundary: 4 n + k
  for (const n of shown) {
    placeCorners(state, n, shrink, corners);
    const side = cut ? sideOf(corners, cut, exact, depths) : 'kept';
    if (side === 'gone') continue;
    if (side === 'met') cap(corners, depths, n, into);
    for (let k = 0; k < 4; k++) {
      if (isWhole) {
        pushFacet(corners, k, n, into);
        continue;
      }
      const [a, b, c] = sorted(state, n, k);
      // A facet of two cells that are both seen is inside.
      if (boundary.take(a, b, c) < 0) {
        boundary.set(a, b, c, candidates.length);
        candidates.push(4 * n + k);
      }
    }
  }
  for (const [i, facet] of candidates.entries()) {
    const n = facet >>> 2;
    const k = facet & 3;
    const [a, b, c] = sorted(state, n, k);
    if (boundary.get(a, b, c) !== i) continue;
    placeCorners(state, n, 0, corners);
    pushFacet(corners, k, n, into);
  }
  return into;
}

export function noCut(): Cut {
  return {
    count: 0,
    corners: new Float64Array(0),
    cells: new Uint32Array(0),
    edges: new Uint8Array(0),
  };
}

function placeCorners(state: MeshState, n: number, shrink: number, out: Float64Array): void {
  for (let i = 0; i < 4; i++) {
    const v = state.cells[4 * n + i]!;
    for (let k = 0; k < 3; k++) out[3 * i + k] = state.coordinates[3 * v + k]!;
  }
  if (shrink === 0) return;
  for (let k = 0; k < 3; k++) {
    const middle = (out[k]! + out[3 + k]! + out[6 + k]! + out[9 + k]!) / 4;
    for (let i = 0; i < 4; i++) out[3 * i + k]! += (middle - out[3 * i + k]!) * shrink;
  }
}

/** `depths`: how far the corners are beyond the plane. */
function sideOf(
  corners: Float64Array,
  { normal, offset }: Plane,
  exact: boolean,
  depths: Float64Array,
): 'kept' | 'gone' | 'met' {
  let beyond = 0;
  let sum = 0;
  for (let i = 0; i < 4; i++) {
    const d =
      normal[0] * corners[3 * i]! +
      normal[1] * corners[3 * i + 1]! +
      normal[2] * corners[3 * i + 2]! -
      offset;
    depths[i] = d;
    sum += d;
    if (d > 0) beyond++;
  }
  if (!exact) return sum > 0 ? 'gone' : 'kept';
  return beyond === 0 ? 'kept' : beyond === 4 ? 'gone' : 'met';
}

/** Where the plane cuts a cell: a triangle or a quadrilateral. */
function cap(corners: Float64Array, depths: Float64Array, n: number, into: Cut): void {
  const kept = [0, 1, 2, 3].filter((i) => depths[i]! <= 0);
  const gone = [0, 1, 2, 3].filter((i) => depths[i]! > 0);
  const crossing = (i: number, j: number): Point3 => {
    const t = depths[i]! / (depths[i]! - depths[j]!);
    const at = (k: number) => corners[3 * i + k]! + (corners[3 * j + k]! - corners[3 * i + k]!) * t;
    return [at(0), at(1), at(2)];
  };
  if (kept.length === 2) {
    const [i, j] = kept as [number, number];
    const [k, l] = gone as [number, number];
    const p = [crossing(i, k), crossing(i, l), crossing(j, l), crossing(j, k)] as const;
    // The diagonal of the quadrilateral is no edge.
    push(p[0], p[1], p[2], n, CAP + 1 + 4, into);
    push(p[0], p[2], p[3], n, CAP + 1 + 2, into);
    return;
  }
  const alone = kept.length === 1 ? kept[0]! : gone[0]!;
  const others = kept.length === 1 ? gone : kept;
  const [p, q, r] = others.map((i) => crossing(alone, i)) as [Point3, Point3, Point3];
  push(p, q, r, n, CAP + ALL_EDGES, into);
}

function pushFacet(corners: Float64Array, k: number, n: number, into: Cut): void {
  const at = (i: number): Point3 => [corners[3 * i]!, corners[3 * i + 1]!, corners[3 * i + 2]!];
  const [a, b, c] = facets[k]!;
  push(at(a), at(b), at(c), n, ALL_EDGES, into);
}

function push(a: Point3, b: Point3, c: Point3, n: number, edges: number, into: Cut): void {
  const row = into.count++;
  if (row === into.cells.length) grow(into);
  into.corners.set(a, 9 * row);
  into.corners.set(b, 9 * row + 3);
  into.corners.set(c, 9 * row + 6);
  into.cells[row] = n;
  into.edges[row] = edges;
}

function grow(cut: Cut): void {
  const size = Math.max(256, 2 * cut.cells.length);
  const corners = new Float64Array(9 * size);
  corners.set(cut.corners);
  const cells = new Uint32Array(size);
  cells.set(cut.cells);
  const edges = new Uint8Array(size);
  edges.set(cut.edges);
  Object.assign(cut, { corners, cells, edges });
}

function sorted(state: MeshState, n: number, k: number): [number, number, number] {
  const [i, j, l] = facets[k]!;
  let a = state.cells[4 * n + i]!;
  let b = state.cells[4 * n + j]!;
  let c = state.cells[4 * n + l]!;
  if (a > b) [a, b] = [b, a];
  if (b > c) [b, c] = [c, b];
  if (a > b) [a, b] = [b, a];
  return [a, b, c];
}
