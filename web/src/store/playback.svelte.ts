import { AngleCache } from '../replay/measure.ts';
import { momentAt } from '../replay/moment.ts';
import { Replay } from '../replay/replay.ts';
import { type JumpTarget, jump, weight } from '../replay/timeline.ts';
import type { Trace } from '../replay/trace.ts';
import type { MeshChange, Moment, Moment3 } from '../shared/types.ts';
import { Clock } from './clock.svelte.ts';
import type { RunStore } from './run.svelte.ts';

/** The playhead of one run: where in the trace the picture stands, and how it moves. */
export class PlaybackStore extends Clock {
  /** Set when the last move was a single event: the picture may show the change in motion. */
  lastChange: MeshChange | null = null;

  replay = $state.raw<Replay | null>(null);
  angles = $state.raw<AngleCache | null>(null);
  readonly length = $derived.by(() => {
    void this.run.traceVersion;
    return this.run.trace?.eventCount ?? 0;
  });
  readonly moment = $derived.by<Moment | Moment3 | null>(() => {
    return this.replay && this.run.trace ? momentAt(this.replay, this.position) : null;
  });

  constructor(
    private readonly run: RunStore,
    speed: () => number,
  ) {
    super(speed);
  }

  /** Takes up a new trace, at its start. */
  load(trace: Trace): void {
    this.pause();
    this.replay = new Replay(trace);
    this.angles = new AngleCache(trace);
    this.lastChange = null;
    this.position = 0;
  }

  unload(): void {
    this.pause();
    this.replay = null;
    this.angles = null;
    this.position = 0;
  }

  seek(position: number): void {
    if (!this.replay || !this.run.trace) return;
    const goal = Math.max(0, Math.min(Math.round(position), this.run.trace.eventCount));
    const from = this.position;
    this.lastChange =
      goal === from + 1
        ? this.replay.change(from, true)
        : goal === from - 1
          ? this.replay.change(goal, false)
          : null;
    this.replay.seek(goal);
    this.position = goal;
  }

  jump(target: JumpTarget, forward: boolean): boolean {
    if (!this.run.trace) return false;
    const goal = jump(this.run.trace, this.position, target, forward);
    this.pause();
    if (goal === null) return false;
    this.seek(goal);
    return true;
  }

  protected get ready(): boolean {
    return this.replay !== null && this.run.trace !== null;
  }

  protected get growing(): boolean {
    return this.run.busy;
  }

  protected cost(position: number): number {
    return weight(this.run.trace!.kind(position));
  }
}
