/** Which live cells lie side by side: found once for a state, asked for every place of the clip plane. */

import type { MeshState } from '../shared/types';

/** Neighbor i of the cell at place p of the live list is at place `neighbors[4 p + i]`; NOBODY: the facet is of the hull. */
export interface Adjacency {
  readonly count: number;
  readonly neighbors: Uint32Array;
}

export const NOBODY = 0xffffffff;

/** Facets of a positively oriented cell, each counter-clockwise from without: opposite to its first vertex, second, … */
export const cellFacets = [
  [1, 2, 3],
  [0, 3, 2],
  [0, 1, 3],
  [0, 2, 1],
] as const;

/**
 * O(live cells): facets are chained by their smallest vertex in a table of heads, as many as there are vertices, and found again by the
 * two others; a vertex has some 30 facets that it is the smallest vertex of, fewer of them open at a time.
 */
export function adjacencyOf(state: MeshState): Adjacency {
  const { cells, liveCells, liveCellCount: count } = state;
  const neighbors = new Uint32Array(4 * count).fill(NOBODY);
  const head = new Int32Array(state.vertexCount).fill(-1);
  const next = new Int32Array(4 * count);
  const middle = new Uint32Array(4 * count);
  const largest = new Uint32Array(4 * count);
  for (let p = 0; p < count; p++) {
    const at = 4 * liveCells[p]!;
    for (let i = 0; i < 4; i++) {
      const [j, k, l] = cellFacets[i]!;
      let a = cells[at + j]!;
      let b = cells[at + k]!;
      let c = cells[at + l]!;
      if (a > b) [a, b] = [b, a];
      if (b > c) [b, c] = [c, b];
      if (a > b) [a, b] = [b, a];
      const facet = 4 * p + i;
      let before = -1;
      let open = head[a]!;
      while (open >= 0 && (middle[open] !== b || largest[open] !== c)) {
        before = open;
        open = next[open]!;
      }
      if (open < 0) {
        middle[facet] = b;
        largest[facet] = c;
        next[facet] = head[a]!;
        head[a] = facet;
        continue;
      }
      // A facet has two sides: when both are found it is closed.
      if (before < 0) head[a] = next[open]!;
      else next[before] = next[open]!;
      neighbors[facet] = open >>> 2;
      neighbors[open] = p;
    }
  }
  return { count, neighbors };
}
