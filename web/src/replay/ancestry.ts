import type { AncestryLink } from '../shared/overlay-facts.ts';
import { Kind, NONE, Reason, type TraceEvent } from './event.ts';
import { distance, point } from './geometry.ts';
import { distance3, point3 } from './geometry3.ts';
import { GrowU32 } from './grow.ts';
import { ascending, canonical, type Record4 } from './lives.ts';
import type { Protection } from './protection.ts';
import { SimplexTable } from './simplex-table.ts';
import type { Trace } from './trace.ts';

/**
 * Why a vertex had to be inserted, as the proof of Theorem 2.2 tells it: its three cases lead from a vertex to an older one, its
 * parent, and so in the end to the input. `parent` is a vertex, NONE where the chain ends.
 */
export type Cause =
  | { readonly kind: 'input' | 'box'; readonly parent: typeof NONE }
  /** A point that divides a segment by a rule about its length alone: nothing in the mesh caused it. */
  | { readonly kind: 'division'; readonly parent: typeof NONE; readonly segment: number }
  /** Step 1a in space: a third of the way from an input vertex to its nearest neighbor. */
  | { readonly kind: 'third'; readonly parent: typeof NONE; readonly segment: number }
  /** At distance d of the acute input vertex that it protects. */
  | { readonly kind: 'protection'; readonly parent: number }
  /** Case 1: a vertex encroached upon the subsegment or arc (or was a witness in its diametral disk). */
  | { readonly kind: 'encroached'; readonly parent: number; readonly split: readonly number[] }
  /** Case 3: the circumcenter of `triangle` yielded to the subsegment; its parent as in case 2. */
  | {
      readonly kind: 'yielded';
      readonly parent: number;
      readonly triangle: readonly number[];
      readonly edge: readonly [number, number];
    }
  /** In space (chapter 4): a witness was too near to an end of the subsegment, or a vertex to a corner of a face's triangle. */
  | { readonly kind: 'nearer'; readonly parent: number; readonly split: readonly number[] }
  /** The subsegment was no edge of the triangulation: the younger of its ends. */
  | { readonly kind: 'missing'; readonly parent: number; readonly split: readonly number[] }
  /** Case 2: the younger vertex of the shortest edge of the triangle that was split. */
  | {
      readonly kind: 'triangle';
      readonly parent: number;
      readonly triangle: readonly number[];
      readonly edge: readonly [number, number];
    };

/** Longer than any that was met; chains get younger to older, so they end anyway. */
const MOST_LINKS = 10_000;

/** Finds the cause of each vertex in a trace: read once, event by event, as it grows. */
export class Ancestry {
  /** Event that queued the simplex whose split made the vertex; NONE if nothing queued it. */
  private readonly queuedBy = new GrowU32();
  private readonly latest = new SimplexTable();
  private next = 0;

  constructor(
    private readonly trace: Trace,
    private readonly protection: Protection,
  ) {}

  cause(v: number): Cause {
    this.update();
    const { trace } = this;
    const birth = trace.event(trace.vertexBorn.at(v));
    switch (birth.reason) {
      case Reason.input:
        return { kind: 'input', parent: NONE };
      case Reason.box:
        return { kind: 'box', parent: NONE };
      case Reason.division:
      case Reason.equalLength:
        return { kind: 'division', parent: NONE, segment: birth.segment };
      case Reason.third:
        return { kind: 'third', parent: NONE, segment: birth.segment };
      case Reason.collar:
      case Reason.circle:
        return { kind: 'protection', parent: this.protection.centerOf(v) };
    }
    const index = this.queuedBy.at(v);
    const queued = index === NONE ? null : trace.event(index);
    if (queued && isNear(queued))
      return { kind: 'nearer', parent: queued.subject, split: birth.simplex };
    if (birth.dimension >= 2) {
      const edge = this.shortestEdge(birth.simplex);
      return { kind: 'triangle', parent: edge[1], triangle: birth.simplex, edge };
    }
    if (queued?.reason === Reason.yieldedTo && index > 0) {
      // The loop records who yielded right before it queues what was yielded to.
      const proposer = trace.event(index - 1);
      if (proposer.kind === Kind.yielded && proposer.simplex.length === 3) {
        const edge = this.shortestEdge(proposer.simplex);
        return { kind: 'yielded', parent: edge[1], triangle: proposer.simplex, edge };
      }
    }
    if (queued && hasWitness(queued)) {
      return { kind: 'encroached', parent: queued.subject, split: birth.simplex };
    }
    return { kind: 'missing', parent: this.byAge(birth.simplex)[1], split: birth.simplex };
  }

  /** From a vertex back to the input. */
  chain(v: number): AncestryLink[] {
    const links: AncestryLink[] = [];
    let vertex = v;
    while (links.length < MOST_LINKS) {
      const { parent } = this.cause(vertex);
      if (parent === NONE) break;
      links.push({ vertex, parent });
      vertex = parent;
    }
    return links;
  }

  private update(): void {
    const { trace } = this;
    for (; this.next < trace.eventCount; this.next++) {
      const kind = trace.kind(this.next);
      if (kind !== Kind.queued && kind !== Kind.inserted) continue;
      const e = trace.event(this.next);
      const [a, b, c, d] = key(e);
      if (kind === Kind.inserted) {
        while (this.queuedBy.length <= e.subject) this.queuedBy.push(NONE);
        const index = e.dimension > 0 ? this.latest.take(a, b, c, d) : -1;
        if (index >= 0) this.queuedBy.data[e.subject] = index;
      } else if (e.reason !== Reason.returned) {
        this.latest.set4(a, b, c, d, this.next);
      }
    }
  }

  /** The older vertex first. */
  private byAge(vertices: readonly number[]): [number, number] {
    const born = this.trace.vertexBorn;
    const [a, b] = vertices as readonly [number, number];
    return born.at(a) <= born.at(b) ? [a, b] : [b, a];
  }

  private shortestEdge(simplex: readonly number[]): [number, number] {
    const { coordinates, dimension } = this.trace;
    const xyz = coordinates.data;
    const length = ([p, q]: readonly [number, number]) =>
      dimension === 3
        ? distance3(point3(xyz, p), point3(xyz, q))
        : distance(point(xyz, p), point(xyz, q));
    // Sides of a triangle in their order: of two that are equally long the first is meant.
    const edges: [number, number][] = simplex.flatMap((a, i) =>
      simplex.slice(i + 1).map((b): [number, number] => [a, b]),
    );
    if (edges.length === 3) edges.splice(1, 2, edges[2]!, edges[1]!);
    edges.sort((e, f) => length(e) - length(f));
    return this.byAge(edges[0]!);
  }
}

/** One name for a simplex, whatever the order in which events give its vertices. */
function key(e: TraceEvent): Record4 {
  const [a, b, c, d] = e.simplex;
  if (e.simplex.length === 4) return ascending(a!, b!, c!, d!);
  if (e.simplex.length === 3) return [...canonical(a!, b!, c!), NONE];
  if (e.simplex.length < 2) return [NONE, NONE, NONE, NONE];
  return [Math.min(a!, b!), Math.max(a!, b!), NONE, NONE];
}

function isNear(e: TraceEvent): boolean {
  const { nearWitness, nearLocalWitness, nearVertex } = Reason;
  const reasons: number[] = [nearWitness, nearLocalWitness, nearVertex];
  return reasons.includes(e.reason) && e.subject !== NONE;
}

function hasWitness(e: TraceEvent): boolean {
  return (
    e.subject !== NONE &&
    (e.reason === Reason.encroached || e.reason === Reason.witness || e.reason === Reason.tooLong)
  );
}
