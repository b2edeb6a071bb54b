import type { JumpTarget } from '../replay/timeline.ts';

/** What the transport drives: a position that is set, stepped, jumped and played. */
export abstract class Clock {
  position = $state(0);
  playing = $state(false);
  /** The last position that there is now; it grows while the core is at work. */
  abstract readonly length: number;

  private frame = 0;
  private last = 0;
  private due = 0;

  /** `speed`: moments a second. */
  constructor(private readonly speed: () => number) {}

  abstract seek(position: number): void;
  /** False where there is none. */
  abstract jump(target: JumpTarget, forward: boolean): boolean;
  /** Is there a run to play? */
  protected abstract readonly ready: boolean;
  /** More may come. */
  protected abstract readonly growing: boolean;
  /** How long the moment after a position is worth looking at (replay/timeline.ts). */
  protected abstract cost(position: number): number;

  step(by: number): void {
    this.pause();
    this.seek(this.position + by);
  }

  toggle(): void {
    if (this.playing) this.pause();
    else this.play();
  }

  play(): void {
    if (!this.ready || this.playing) return;
    if (this.position >= this.length && !this.growing) this.seek(0);
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
    if (!this.playing || !this.ready) return;
    // After a long frame (a hidden tab) the film goes on; it does not race to catch up.
    this.due += (Math.min(now - this.last, 250) / 1000) * this.speed();
    this.last = now;
    let goal = this.position;
    const end = this.length;
    while (goal < end) {
      const cost = this.cost(goal);
      if (this.due < cost) break;
      this.due -= cost;
      goal++;
    }
    if (goal !== this.position) this.seek(goal);
    if (goal >= end) {
      this.due = 0;
      if (!this.growing) {
        this.playing = false;
        return;
      }
    }
    this.frame = requestAnimationFrame(this.tick);
  };
}
