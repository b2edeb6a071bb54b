import { Label, type MeshState, NEVER, Protecting } from '../shared/types.ts';
import { NONE } from './event.ts';
import { SimplexTable } from './simplex-table.ts';
import type { Trace } from './trace.ts';

/** The triangles of faces that lie between the collars and what they protect (thesis, Table 6.1), at one position. */
export interface CollarRegion {
  /** 1 for each facet, by number, that belongs to a collar. */
  readonly holds: Uint8Array;
  readonly facets: readonly number[]; // their numbers
}

export const noRegion: CollarRegion = { holds: new Uint8Array(0), facets: [] };

/**
 * As the core tells them apart: from the pieces of segments that are protected, and the input vertices that arcs are about, over all
 * edges but pieces of segments, collar segments and arcs. A face in which one of these is no edge (yet) is left out, and so is one in
 * which collars are still drawn. O(live triangles of faces).
 */
export function collarRegion(trace: Trace, state: MeshState): CollarRegion {
  const { facets, protection } = state;
  if (!facets || !protection || protection.liveCount === 0) return noRegion;
  const drawn = drawnBy(trace);
  const { neighbors, edges } = adjacencyOf(facets);
  const barriers = new SimplexTable(); // by ends and face; pieces of segments without one
  const centers = new SimplexTable(); // by vertex and face
  const protectedPieces = new SimplexTable();
  const isOpen = new Set<number>(); // faces whose collars are not all edges
  for (let i = 0; i < protection.liveCount; i++) {
    const n = protection.live[i]!;
    const [a, b, c, carrier] = protection.elements.subarray(4 * n, 4 * n + 4) as unknown as Four;
    const [low, high] = [Math.min(a, b), Math.max(a, b)];
    const kind = protection.kind[n];
    if (kind === Protecting.subsegment) protectedPieces.set(low, high, NONE, 1);
    if (kind !== Protecting.collarSegment && kind !== Protecting.collarArc) continue;
    barriers.set(low, high, carrier, 1);
    if (kind === Protecting.collarArc) centers.set(c, carrier, NONE, 1);
    if (edges.get(low, high, carrier) < 0) isOpen.add(carrier);
  }
  for (let i = 0; i < state.liveSubsegmentCount; i++) {
    const n = 3 * state.liveSubsegments[i]!;
    const [a, b] = [state.subsegments[n]!, state.subsegments[n + 1]!];
    barriers.set(Math.min(a, b), Math.max(a, b), NONE, 1);
  }
  const holds = new Uint8Array(facets.count);
  const found: number[] = [];
  const stack: number[] = [];
  const add = (i: number) => {
    const n = facets.live[i]!;
    if (holds[n] || facets.label[n] === Label.outside) return;
    holds[n] = 1;
    found.push(n);
    stack.push(i);
  };
  const corners = (i: number) => {
    const n = 4 * facets.live[i]!;
    return facets.triangles.subarray(n, n + 4) as unknown as Four;
  };
  for (let i = 0; i < facets.liveCount; i++) {
    const t = corners(i);
    if (isOpen.has(t[3]) || !(state.position > (drawn.get(t[3]) ?? NEVER))) continue;
    for (let k = 0; k < 3; k++) {
      const [a, b] = [t[k]!, t[(k + 1) % 3]!];
      if (
        centers.get(a, t[3], NONE) > 0 ||
        protectedPieces.get(Math.min(a, b), Math.max(a, b), NONE) > 0
      )
        add(i);
    }
  }
  for (let i = stack.pop(); i !== undefined; i = stack.pop()) {
    const t = corners(i);
    for (let k = 0; k < 3; k++) {
      const beside = neighbors[3 * i + k]!;
      const [low, high] = [Math.min(t[k]!, t[(k + 1) % 3]!), Math.max(t[k]!, t[(k + 1) % 3]!)];
      if (beside < 0 || barriers.get(low, high, t[3]) > 0 || barriers.get(low, high, NONE) > 0)
        continue;
      add(beside);
    }
  }
  return { holds, facets: found };
}

type Four = [number, number, number, number];

/** Which triangle of the same face lies beside each edge, by place in the list of the live ones; -1: none. */
function adjacencyOf(facets: NonNullable<MeshState['facets']>): {
  neighbors: Int32Array;
  edges: SimplexTable;
} {
  const neighbors = new Int32Array(3 * facets.liveCount).fill(-1);
  const edges = new SimplexTable(); // the first half of each edge
  for (let i = 0; i < facets.liveCount; i++) {
    const n = 4 * facets.live[i]!;
    const face = facets.triangles[n + 3]!;
    for (let k = 0; k < 3; k++) {
      const a = facets.triangles[n + k]!;
      const b = facets.triangles[n + ((k + 1) % 3)]!;
      const [low, high] = [Math.min(a, b), Math.max(a, b)];
      const first = edges.get(low, high, face);
      if (first < 0) {
        edges.set(low, high, face, 3 * i + k);
      } else {
        neighbors[3 * i + k] = Math.floor(first / 3);
        neighbors[first] = i;
      }
    }
  }
  return { neighbors, edges };
}

/** By face, the last event of the step that draws the collars which draws in it; nothing before all of that step is known. */
function drawnBy(trace: Trace): ReadonlyMap<number, number> {
  const known = drawings.get(trace);
  if (known) return known;
  const last = new Map<number, number>();
  const lives = trace.protecting?.lives;
  let end = NEVER;
  for (let n = 0; lives && n < lives.count; n++) {
    const kind = lives.label.data[n];
    if (kind !== Protecting.collarSegment && kind !== Protecting.collarArc) continue;
    const born = lives.born.at(n);
    if (end === NEVER) end = trace.stepStarts.find((s) => s.event > born)?.event ?? NEVER;
    if (end === NEVER) return new Map();
    if (born >= end) break;
    last.set(lives.vertices.at(4 * n + 3), born);
  }
  if (end !== NEVER) drawings.set(trace, last);
  return last;
}

const drawings = new WeakMap<Trace, ReadonlyMap<number, number>>();
const regions = new WeakMap<Trace, { position: number; region: CollarRegion }>();

/** The same, kept for the position that was asked about last. */
export function collarRegionAt(trace: Trace, state: MeshState): CollarRegion {
  const last = regions.get(trace);
  if (last?.position === state.position) return last.region;
  const region = collarRegion(trace, state);
  regions.set(trace, { position: state.position, region });
  return region;
}
