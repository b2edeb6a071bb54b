import { NEVER } from '../shared/types.ts';
import { Kind, NONE, type TraceEvent } from './event.ts';
import { GrowU8, GrowU32 } from './grow.ts';
import { SimplexTable } from './simplex-table.ts';

/** What waits in the queue at a position: how many, and the events that queued the first of them, in priority order. */
export interface QueueView {
  readonly length: number;
  readonly segments: number; // how many of them are subsegments
  readonly events: readonly number[];
}

/**
 * Who waited in the queue, and from when to when: entries with the interval in which they waited, as in Trace.
 * An entry leaves when its simplex is popped (dropped, refused, yielded, inserted), or is replaced when the same simplex
 * is queued again for another reason.
 */
export class QueueHistory {
  private readonly queuedBy = new GrowU32();
  private readonly dimension = new GrowU8();
  private readonly left = new GrowU32();
  private readonly waiting = new SimplexTable();

  record(event: TraceEvent): void {
    if (event.simplex.length === 0) return;
    const isQueued = event.kind === Kind.queued;
    if (!isQueued && !isPop(event.kind)) return;
    const [a, b, c] = key(event);
    const before = this.waiting.take(a, b, c);
    if (before >= 0) this.left.data[before] = event.index;
    if (!isQueued) return;
    this.waiting.set(a, b, c, this.queuedBy.length);
    this.queuedBy.push(event.index);
    this.dimension.push(event.dimension);
    this.left.push(NEVER);
  }

  /** O(entries ever queued before the position). Segments come before triangles, then order of birth. */
  at(position: number, most: number): QueueView {
    const segments: number[] = [];
    const triangles: number[] = [];
    for (let i = 0; i < this.queuedBy.length; i++) {
      const event = this.queuedBy.at(i);
      if (event >= position) break;
      if (position > this.left.at(i)) continue;
      (this.dimension.data[i] === 1 ? segments : triangles).push(event);
    }
    return {
      length: segments.length + triangles.length,
      segments: segments.length,
      events: segments.slice(0, most).concat(triangles.slice(0, Math.max(0, most - segments.length))),
    };
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

function key(event: TraceEvent): [number, number, number] {
  const [a, b, c] = event.simplex;
  if (event.simplex.length === 2) return [Math.min(a!, b!), Math.max(a!, b!), NONE];
  if (event.simplex.length === 1) return [a!, NONE, NONE];
  const sorted = [a!, b!, c!].sort((x, y) => x - y);
  return [sorted[0]!, sorted[1]!, sorted[2]!];
}
