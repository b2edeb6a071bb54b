/** Tetrahedra as what is seen of them: the facets of their union, whole or cut by a plane, or each cell by itself. */

import { Label, type MeshState, type Point3 } from '../shared/types';
import { type Adjacency, adjacencyOf, cellFacets, NOBODY } from './adjacency';
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
  readonly peel?: number; // so many layers of cells are taken off the boundary
}

const ALL_EDGES = 7;
/** Lies in the plane: it is not to be cut once more. */
export const CAP = 8;

enum Side {
  hidden = 0,
  met = 1, // by the plane
  kept = 2,
}

/** Reuses `into`. O(live cells). `adjacency`: of the state, if it is at hand. */
export function cutCells(
  state: MeshState,
  options: CutOptions,
  into: Cut = noCut(),
  adjacency: Adjacency | null = null,
): Cut {
  const { plane, exact, only, shrink } = options;
  const cut = only ? null : plane;
  const count = state.liveCellCount;
  const isWhole = shrink > 0;
  const peel = only ? 0 : (options.peel ?? 0);
  const beside = isWhole && peel === 0 ? null : (adjacency ?? adjacencyOf(state)).neighbors;
  const layers = peel > 0 ? layersOf(state, beside!, options.outside) : null;
  const sides = new Uint8Array(count);
  const corners = new Float64Array(12);
  const depths = new Float64Array(4);
  into.count = 0;
  for (let p = 0; p < count; p++) {
    const n = state.liveCells[p]!;
    if (only ? !only.has(n) : !options.outside && state.cellLabel[n] === Label.outside) continue;
    if (layers && layers[p]! <= peel) continue;
    if (!cut) {
      sides[p] = Side.kept;
      continue;
    }
    placeCorners(state, n, shrink, corners);
    sides[p] = sideOf(corners, cut, exact, depths);
    if (sides[p] === Side.met) cap(corners, depths, n, into);
  }
  const neighbors = isWhole ? null : beside;
  for (let p = 0; p < count; p++) {
    if (sides[p] === Side.hidden) continue;
    const n = state.liveCells[p]!;
    let isPlaced = false;
    for (let k = 0; k < 4; k++) {
      // A facet of two cells that are both seen is inside.
      const neighbor = neighbors ? neighbors[4 * p + k]! : NOBODY;
      if (neighbor !== NOBODY && sides[neighbor] !== Side.hidden) continue;
      if (!isPlaced) placeCorners(state, n, shrink, corners);
      isPlaced = true;
      pushFacet(corners, k, n, into);
    }
  }
  return into;
}

/**
 * How deep each cell lies, by place in the list of the live ones: 1 at the boundary, one more than the least of its neighbors inside.
 * Cells that are not seen are 0.
 */
export function layersOf(
  state: MeshState,
  neighbors: Adjacency['neighbors'],
  outside: boolean,
): Uint32Array {
  const { liveCells, liveCellCount: count, cellLabel } = state;
  const layers = new Uint32Array(count);
  const isSeen = (p: number) => outside || cellLabel[liveCells[p]!] !== Label.outside;
  let front: number[] = [];
  for (let p = 0; p < count; p++) {
    if (!isSeen(p)) continue;
    for (let k = 0; k < 4; k++) {
      const q = neighbors[4 * p + k]!;
      if (layers[p] === 0 && (q === NOBODY || !isSeen(q))) {
        layers[p] = 1;
        front.push(p);
      }
    }
  }
  for (let layer = 2; front.length > 0; layer++) {
    const next: number[] = [];
    for (const p of front)
      for (let k = 0; k < 4; k++) {
        const q = neighbors[4 * p + k]!;
        if (q === NOBODY || layers[q] !== 0 || !isSeen(q)) continue;
        layers[q] = layer;
        next.push(q);
      }
    front = next;
  }
  return layers;
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
): Side {
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
  if (!exact) return sum > 0 ? Side.hidden : Side.kept;
  return beyond === 0 ? Side.kept : beyond === 4 ? Side.hidden : Side.met;
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
  const row = into.count++;
  if (row === into.cells.length) grow(into);
  const facet = cellFacets[k]!;
  for (let i = 0; i < 3; i++) {
    const from = 3 * facet[i]!;
    const to = 9 * row + 3 * i;
    into.corners[to] = corners[from]!;
    into.corners[to + 1] = corners[from + 1]!;
    into.corners[to + 2] = corners[from + 2]!;
  }
  into.cells[row] = n;
  into.edges[row] = ALL_EDGES;
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
