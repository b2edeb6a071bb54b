import { Label, type MeshState, NEVER, Protecting } from '../shared/types.ts';
import { Kind, NONE } from './event.ts';
import { SimplexTable } from './simplex-table.ts';
import type { Trace } from './trace.ts';

/** The triangles of faces that lie between the collars and what they protect (thesis, Table 6.1), at one position. */
export interface CollarRegion {
  /** 1 for each facet, by number, that belongs to a collar. */
  readonly holds: Uint8Array;
  readonly facets: readonly number[]; // their numbers
}

export const noRegion: CollarRegion = { holds: new Uint8Array(0), facets: [] };

/** The same, whole. O(live triangles of faces). */
export function collarRegion(trace: Trace, state: MeshState): CollarRegion {
  const facets = [...collarFacets(trace, state, null).values()].flat();
  const holds = new Uint8Array(state.facets?.count ?? 0);
  for (const n of facets) holds[n] = 1;
  return { holds, facets };
}

/**
 * By face, or by those of some faces. As the core tells them apart: from the pieces of segments that are protected, and the input vertices
 * that arcs are about, over all edges but pieces of segments, collar segments and arcs. A face in which one of these is no edge (yet) is
 * left out, and so is one in which collars are still drawn.
 */
function collarFacets(
  trace: Trace,
  state: MeshState,
  only: ReadonlySet<number> | null,
): Map<number, number[]> {
  const { facets: all, protection } = state;
  const byFace = new Map<number, number[]>();
  if (!all || !protection || protection.liveCount === 0) return byFace;
  const facets = only ? partOf(all, only) : all;
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
    if (only && !only.has(carrier)) continue;
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
  const stack: number[] = [];
  const add = (i: number) => {
    const n = facets.live[i]!;
    if (holds[n] || facets.label[n] === Label.outside) return;
    holds[n] = 1;
    const face = facets.triangles[4 * n + 3]!;
    const found = byFace.get(face);
    if (found) found.push(n);
    else byFace.set(face, [n]);
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
  return byFace;
}

/** The live triangles of some faces alone. */
function partOf(facets: Facets, faces: ReadonlySet<number>): Facets {
  const { live, liveCount, triangles } = facets;
  const part = live.slice(0, liveCount).filter((n) => faces.has(triangles[4 * n + 3]!));
  return { ...facets, live: part, liveCount: part.length };
}

type Facets = NonNullable<MeshState['facets']>;

type Four = [number, number, number, number];

/** Which triangle of the same face lies beside each edge, by place in the list of the live ones; -1: none. */
function adjacencyOf(facets: Facets): {
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
    if (end === NEVER) return notYet;
    if (born >= end) break;
    last.set(lives.vertices.at(4 * n + 3), born);
  }
  if (end === NEVER) return notYet;
  drawings.set(trace, last);
  return last;
}

const notYet: ReadonlyMap<number, number> = new Map();
const drawings = new WeakMap<Trace, ReadonlyMap<number, number>>();
/** What was asked about last, by face: only faces that changed since then are looked at anew. */
class KeptRegion {
  private position = -1;
  private byFace = new Map<number, number[]>();
  private region = noRegion;

  constructor(private readonly trace: Trace) {}

  at(state: MeshState): CollarRegion {
    const { trace } = this;
    const faces = this.changedSince(state.position);
    this.position = state.position;
    if (faces?.size === 0) return this.region;
    const found = collarFacets(trace, state, faces);
    if (faces === null) this.byFace = found;
    else
      for (const face of faces) {
        const list = found.get(face);
        if (list) this.byFace.set(face, list);
        else this.byFace.delete(face);
      }
    const facets = [...this.byFace.values()].flat();
    const holds = new Uint8Array(state.facets?.count ?? 0);
    for (const n of facets) holds[n] = 1;
    this.region = { holds, facets };
    return this.region;
  }

  /** The faces that events on the way change; null: all may have changed. */
  private changedSince(position: number): Set<number> | null {
    const { trace } = this;
    const [from, to] = [Math.min(this.position, position), Math.max(this.position, position)];
    if (from < 0 || to - from > FAR || drawnBy(trace) !== this.drawn) {
      this.drawn = drawnBy(trace);
      return null;
    }
    const faces = new Set<number>();
    for (let i = from; i < to; i++) {
      const kind = trace.kind(i);
      if (kind === Kind.faceChanged) faces.add(trace.event(i).subject);
      if (kind !== Kind.protection || !trace.protecting) continue;
      const { died, born } = trace.protecting.lives.changed(i);
      for (const n of [...died, ...born]) {
        const element = trace.protecting.element(n);
        if (element.kind === Protecting.subsegment) return null;
        if (element.kind <= Protecting.collarArc) faces.add(element.carrier);
      }
    }
    return faces;
  }
  private drawn: ReadonlyMap<number, number> | null = null;
}

/** Farther than this, everything is looked at. */
const FAR = 300;

const regions = new WeakMap<Trace, KeptRegion>();

/** The same as `collarRegion`, kept from one position to the next. */
export function collarRegionAt(trace: Trace, state: MeshState): CollarRegion {
  let kept = regions.get(trace);
  if (!kept) {
    kept = new KeptRegion(trace);
    regions.set(trace, kept);
  }
  return kept.at(state);
}
