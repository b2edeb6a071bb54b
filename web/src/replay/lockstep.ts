import { GrowU32 } from './grow.ts';
import { bands, type JumpTarget, jump } from './timeline.ts';
import type { Trace } from './trace.ts';

/**
 * Two traces on one timeline, in step with each other. A tick of it is a position in each.
 *   'vertices'  At every tick both have inserted the same number of vertices, until one of them has ended. Between two
 *               insertions the one with fewer events waits, so that both insert at the same tick; every event of
 *               either is at some tick.
 *   'steps'     Steps of the same name begin together; within them both have done the same share of what they do in them.
 *   'share'     Both begin and end together: at every tick the same share of the events of each has happened.
 */
export const paces = ['vertices', 'steps', 'share'] as const;
export type Pace = (typeof paces)[number];

export type Side = 0 | 1;

export class Lockstep {
  /** By 'vertices': cell k goes from the k-th insertion to the next one (or to the end), and here is where it begins. */
  private readonly ticks = new GrowU32();
  private readonly starts: readonly [GrowU32, GrowU32] = [new GrowU32(), new GrowU32()];
  /** Ends of the last cell that is known. */
  private total = 0;
  private readonly ends: [number, number] = [0, 0];
  private complete = false;

  constructor(
    private readonly traces: readonly [Trace, Trace],
    readonly pace: Pace,
  ) {}

  /** Takes account of what the traces have grown by; `ended`: they grow no further. */
  extend(ended: readonly [boolean, boolean]): void {
    if (this.pace === 'steps') this.takeSteps();
    if (this.pace !== 'vertices' || this.complete) return;
    for (;;) {
      const a = this.nextEnd(0, ended[0]);
      const b = this.nextEnd(1, ended[1]);
      if (a === null || b === null) return; // not known yet
      const longest = Math.max(a - this.ends[0], b - this.ends[1]);
      if (longest === 0) {
        this.complete = ended[0] && ended[1];
        return;
      }
      this.ticks.push(this.total);
      this.starts[0].push(this.ends[0]);
      this.starts[1].push(this.ends[1]);
      this.total += longest;
      this.ends[0] = a;
      this.ends[1] = b;
    }
  }

  get length(): number {
    if (this.pace !== 'share') return this.total;
    return Math.max(this.traces[0].eventCount, this.traces[1].eventCount);
  }

  /** Where both stand at a tick. */
  at(tick: number): [number, number] {
    const t = Math.max(0, Math.min(tick, this.length));
    if (this.pace === 'share') {
      const of = (i: Side) =>
        this.length === 0 ? 0 : Math.round((t * this.traces[i].eventCount) / this.length);
      return [of(0), of(1)];
    }
    if (t >= this.total) return [this.ends[0], this.ends[1]];
    const cell = last(this.ticks, (start) => start <= t);
    const into = t - this.ticks.at(cell);
    if (this.pace === 'steps') return [this.part(0, cell, into), this.part(1, cell, into)];
    return [this.place(0, cell, into), this.place(1, cell, into)];
  }

  /** The first tick at which one of them stands at a position (or beyond, where that is not known yet). */
  tickOf(side: Side, position: number): number {
    let low = 0;
    let high = this.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.at(middle)[side] >= position) high = middle;
      else low = middle + 1;
    }
    return low;
  }

  /** The next tick, of either side, at which something of a sort has just happened; backwards, the one before. */
  jump(tick: number, target: JumpTarget, forward: boolean): number | null {
    const here = this.at(tick);
    const found: number[] = [];
    for (const side of [0, 1] as const) {
      const trace = this.traces[side];
      // Who waits stands at what has happened some ticks ago: backwards that counts.
      let from = here[side];
      let goal = jump(trace, from, target, forward);
      if (!forward && tick > this.tickOf(side, from) && from < trace.eventCount) {
        from += 1;
        goal = jump(trace, from, target, false);
      } else if (!forward && tick > this.tickOf(side, from) && happened(trace, from, target)) {
        goal = from;
      }
      if (goal === null) continue;
      const at = this.tickOf(side, goal);
      if (this.at(at)[side] === goal && (forward ? at > tick : at < tick)) found.push(at);
    }
    if (found.length === 0) return null;
    return forward ? Math.min(...found) : Math.max(...found);
  }

  /** The end of the next cell in a trace; null while more may come that belongs to it. */
  private nextEnd(side: Side, ended: boolean): number | null {
    const trace = this.traces[side];
    const from = this.ends[side];
    const next = jump(trace, from, 'insertion', true);
    if (next !== null) return next;
    return ended ? trace.eventCount : null;
  }

  /** By 'steps': cells begin where steps do that both have. The last one grows as long as the traces do. */
  private takeSteps(): void {
    const [a, b] = this.traces.map((t) => bands(t)) as [Bands, Bands];
    const isShared = (name: string) =>
      this.traces.every((t) => t.steps.filter((n) => n === name).length === 1);
    const starts = (list: Bands) => list.filter((band) => isShared(band.name));
    const [of0, of1] = [starts(a), starts(b)];
    this.ticks.length = this.starts[0].length = this.starts[1].length = 0;
    this.total = 0;
    let from: [number, number] = [0, 0];
    const cells = Math.min(of0.length, of1.length);
    for (let k = 0; k <= cells; k++) {
      const to: [number, number] = [
        of0[k]?.start ?? this.traces[0].eventCount,
        of1[k]?.start ?? this.traces[1].eventCount,
      ];
      const isLast = k === cells;
      if (isLast || (of0[k]!.name === of1[k]!.name && (to[0] > from[0] || to[1] > from[1]))) {
        this.ticks.push(this.total);
        this.starts[0].push(from[0]);
        this.starts[1].push(from[1]);
        this.total += Math.max(to[0] - from[0], to[1] - from[1]);
        from = to;
      }
    }
    this.ends[0] = from[0];
    this.ends[1] = from[1];
  }

  /** By 'steps': the same share of the cell on each side. */
  private part(side: Side, cell: number, into: number): number {
    const isLast = cell + 1 === this.ticks.length;
    const start = this.starts[side].at(cell);
    const end = isLast ? this.ends[side] : this.starts[side].at(cell + 1);
    const size = (isLast ? this.total : this.ticks.at(cell + 1)) - this.ticks.at(cell);
    return start + Math.round((into * (end - start)) / size);
  }

  private place(side: Side, cell: number, into: number): number {
    const start = this.starts[side].at(cell);
    const isLast = cell + 1 === this.ticks.length;
    const end = isLast ? this.ends[side] : this.starts[side].at(cell + 1);
    const tickEnd = isLast ? this.total : this.ticks.at(cell + 1);
    const trace = this.traces[side];
    const inserts = trace.insertedBefore.at(end) > trace.insertedBefore.at(start);
    // Towards an insertion the wait comes first, so that both arrive together; after the last one it comes at the end.
    const wait = inserts ? tickEnd - this.ticks.at(cell) - (end - start) : 0;
    return Math.min(end, start + Math.max(0, into - wait));
  }
}

type Bands = ReturnType<typeof bands>;

/** Is the event that made this position of the sort? */
function happened(trace: Trace, position: number, target: JumpTarget): boolean {
  return position > 0 && jump(trace, position - 1, target, true) === position;
}

/** The last index whose entry, of an ascending list, is as asked. */
function last(list: GrowU32, isSo: (entry: number) => boolean): number {
  let low = 0;
  let high = list.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (isSo(list.at(middle))) low = middle;
    else high = middle - 1;
  }
  return low;
}
