import { NEVER } from '../shared/types.ts';
import { Kind, NONE, Reason, type TraceEvent } from './event.ts';
import { GrowF64, GrowU8, GrowU32 } from './grow.ts';
import { ascending, type Record4 } from './lives.ts';
import { SimplexTable } from './simplex-table.ts';

/** What waits in the queue at a position: how many, and the events that queued the first of them, in priority order. */
export interface QueueView {
  readonly length: number;
  readonly segments: number; // how many of them are subsegments
  readonly events: readonly number[];
}

/**
 * How triangles are ordered: by birth (Ruppert), or the largest value first (Chew), subsegments before them. Or (feature sizes in
 * space) triangles first, then subsegments by length, which a function of the event that queued them gives.
 */
export type QueueOrder = 'birth' | 'value' | ((event: number) => number);

/**
 * Who waited in the queue, and from when to when: entries with the interval in which they waited, as in Trace.
 * An entry leaves when its simplex is popped (dropped, refused, yielded, inserted) or, a triangle, dies. A simplex that
 * is queued while it waits keeps its place.
 */
export class QueueHistory {
  private readonly queuedBy = new GrowU32();
  private readonly dimension = new GrowU8(); // of the simplex
  private readonly isReturned = new GrowU8();
  private readonly value = new GrowF64();
  private readonly left = new GrowU32();
  private readonly waiting = new SimplexTable();

  record(event: TraceEvent): void {
    if (event.simplex.length === 0) return;
    if (event.kind !== Kind.queued && !isPop(event.kind)) return;
    const [a, b, c, d] = key(event.simplex);
    if (event.kind === Kind.queued) {
      if (this.waiting.get(a, b, c, d) >= 0) return;
      const number = this.queuedBy.length;
      this.waiting.set4(a, b, c, d, number);
      this.queuedBy.push(event.index);
      this.dimension.push(event.dimension);
      this.isReturned.push(event.reason === Reason.returned ? 1 : 0);
      this.value.set(number, event.value);
      this.left.push(NEVER);
    } else {
      this.leave([a, b, c, d], event.index);
    }
  }

  /** A cell died by an insertion. */
  died(simplex: readonly number[], event: number): void {
    this.leave(key(simplex), event);
  }

  /** O(entries ever queued before the position). */
  at(position: number, most: number, order: QueueOrder = 'birth'): QueueView {
    const segments: number[] = [];
    const returned: number[] = [];
    const triangles: number[] = [];
    for (let i = 0; i < this.queuedBy.length; i++) {
      if (this.queuedBy.at(i) >= position) break;
      if (position > this.left.at(i)) continue;
      if (this.dimension.data[i] === 1) segments.push(i);
      else if (this.isReturned.data[i] && order === 'birth') returned.push(i);
      else triangles.push(i);
    }
    // In space triangles of faces go before tetrahedra.
    triangles.sort((i, j) => this.dimension.data[i]! - this.dimension.data[j]! || i - j);
    if (order === 'value')
      triangles.sort((i, j) => this.value.data[j]! - this.value.data[i]! || i - j);
    returned.reverse(); // who came back last stands at the head
    const isByLength = typeof order === 'function';
    if (isByLength) {
      const lengths = new Map(segments.map((i) => [i, order(this.queuedBy.at(i))]));
      segments.sort((i, j) => lengths.get(j)! - lengths.get(i)! || i - j);
    }
    const all = isByLength
      ? returned.concat(triangles, segments)
      : segments.concat(returned, triangles);
    return {
      length: all.length,
      segments: segments.length,
      events: all.slice(0, most).map((i) => this.queuedBy.at(i)),
    };
  }

  private leave([a, b, c, d]: Readonly<Record4>, event: number): void {
    const number = this.waiting.take(a, b, c, d);
    if (number >= 0) this.left.data[number] = event;
  }
}

function isPop(kind: number): boolean {
  return (
    kind === Kind.dropped ||
    kind === Kind.refused ||
    kind === Kind.yielded ||
    kind === Kind.inserted
  );
}

function key(simplex: readonly number[]): Record4 {
  const [a, b, c, d] = simplex as [number, number, number, number];
  if (simplex.length === 4) return ascending(a, b, c, d);
  if (simplex.length === 2) return [Math.min(a, b), Math.max(a, b), NONE, NONE];
  if (simplex.length === 1) return [a, NONE, NONE, NONE];
  const low = Math.min(a, b, c);
  const high = Math.max(a, b, c);
  return [low, a === low || a === high ? (b === low || b === high ? c : b) : a, high, NONE];
}
