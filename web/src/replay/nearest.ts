import type { MeshState } from '../shared/types.ts';
import { distance, point } from './geometry.ts';
import { distance3, point3 } from './geometry3.ts';

/**
 * N(q) of the first `count` vertices at the moment of a state: the distance to the nearest other vertex, which in a Delaunay
 * triangulation is a neighbor. Infinite for a vertex that is not there, or alone. O(triangles); without triangles (all vertices on
 * a line) O(count n).
 */
export function nearestNeighbors(state: MeshState, count: number): Float64Array {
  const nearest = new Float64Array(count).fill(Number.POSITIVE_INFINITY);
  const xy = state.coordinates;
  const join = (a: number, b: number) => {
    if (a >= count && b >= count) return;
    const d = distance(point(xy, a), point(xy, b));
    if (a < count && d < nearest[a]!) nearest[a] = d;
    if (b < count && d < nearest[b]!) nearest[b] = d;
  };
  for (let i = 0; i < state.liveCellCount; i++) {
    const n = 3 * state.liveCells[i]!;
    const [a, b, c] = [state.cells[n]!, state.cells[n + 1]!, state.cells[n + 2]!];
    join(a, b);
    join(b, c);
    join(c, a);
  }
  if (state.liveCellCount > 0) return nearest;
  const isAlive = (v: number) => state.vertexBorn[v]! < state.position;
  for (let a = 0; a < count; a++) {
    for (let b = 0; b < state.vertexCount; b++) {
      if (a !== b && isAlive(a) && isAlive(b)) join(a, b);
    }
  }
  return nearest;
}

/** N(q) of one vertex. O(triangles), or O(n) without triangles. */
export function nearestNeighbor(state: MeshState, v: number): number {
  let nearest = Number.POSITIVE_INFINITY;
  const xy = state.coordinates;
  const look = (w: number) => {
    if (w !== v) nearest = Math.min(nearest, distance(point(xy, v), point(xy, w)));
  };
  for (let i = 0; i < state.liveCellCount; i++) {
    const corners = state.cells.subarray(3 * state.liveCells[i]!, 3 * state.liveCells[i]! + 3);
    if (corners.includes(v)) corners.forEach(look);
  }
  if (state.liveCellCount === 0) {
    for (let w = 0; w < state.vertexCount; w++) if (state.vertexBorn[w]! < state.position) look(w);
  }
  return nearest;
}

/** N(q) of one vertex in space, and the vertex that is so near; infinite and -1 for one that is alone. O(n). */
export function nearestInSpace(state: MeshState, v: number): { distance: number; vertex: number } {
  const at = point3(state.coordinates, v);
  let nearest = { distance: Number.POSITIVE_INFINITY, vertex: -1 };
  for (let w = 0; w < state.vertexCount; w++) {
    if (w === v || !(state.vertexBorn[w]! < state.position)) continue;
    const d = distance3(at, point3(state.coordinates, w));
    if (d < nearest.distance) nearest = { distance: d, vertex: w };
  }
  return nearest;
}
