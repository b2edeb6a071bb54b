import { AngleCache } from '../replay/measure.ts';
import { momentAt } from '../replay/moment.ts';
import { Replay } from '../replay/replay.ts';
import { type JumpTarget, jump, weight } from '../replay/timeline.ts';
import type { Trace } from '../replay/trace.ts';
import type { MeshChange, Moment } from '../shared/types.ts';
import type { RunStore } from './run.svelte.ts';

/** The playhead: where in the trace the picture stands, and how it moves. */
export class PlaybackStore {
  position = $state(0);
  playing = $state(false);
  /** Set when the last move was a single event: the picture may show the change in motion. */
  lastChange: MeshChange | null = null;

  replay = $state.raw<Replay | null>(null);
  angles = $state.raw<AngleCache | null>(null);
  readonly length = $derived.by(() => {
    void this.run.traceVersion;
    return this.run.trace?.eventCount ?? 0;
  });
  readonly moment = $derived.by<Moment | null>(() => {
    return this.replay && this.run.trace ? momentAt(this.replay, this.position) : null;
  });

  private frame = 0;
  private last = 0;
  private due = 0;

  constructor(
    private readonly run: RunStore,
    private readonly speed: () => number,
  ) {}

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

  step(by: number): void {
    this.pause();
    this.seek(this.position + by);
  }

  /** False where there is none. */
  jump(target: JumpTarget, forward: boolean): boolean {
    if (!this.run.trace) return false;
    const goal = jump(this.run.trace, this.position, target, forward);
    this.pause();
    if (goal === null) return false;
    this.seek(goal);
    return true;
  }

  toggle(): void {
    if (this.playing) this.pause();
    else this.play();
  }

  play(): void {
    if (!this.replay || this.playing) return;
    if (this.position >= this.length && !this.run.busy) this.seek(0);
    this.playing = true;
    this.last = performance.now();
    this.due = 0;
    this.frame = requestAnimationFrame(this.tick);
  }

  pause(): void {
    this.playing = false;
    cancelAnimationFrame(this.frame);
  }

  private readonly tick = (now: number): void => {
    if (!this.playing || !this.run.trace) return;
    // After a long frame (a hidden tab) the film goes on; it does not race to catch up.
    this.due += (Math.min(now - this.last, 250) / 1000) * this.speed();
    this.last = now;
    let goal = this.position;
    const end = this.run.trace.eventCount;
    while (goal < end) {
      const cost = weight(this.run.trace.kind(goal));
      if (this.due < cost) break;
      this.due -= cost;
      goal++;
    }
    if (goal !== this.position) this.seek(goal);
    if (goal >= end) {
      this.due = 0;
      if (!this.run.busy) {
        this.playing = false;
        return;
      }
    }
    this.frame = requestAnimationFrame(this.tick);
  };
}
