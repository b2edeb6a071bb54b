import { between, fitView, zoomAbout } from '../picture/view.ts';
import type { Repetition } from '../replay/repetition.ts';
import type { Picture, View } from '../shared/types.ts';
import type { App } from './app.svelte.ts';

/** Of a cycle at six moments a second. */
const CYCLE_SECONDS = 3;
const FLIGHT_SECONDS = 0.7;
/** How much wider than the first cycle the view is: what that brings about happens around it. */
const SURROUNDINGS = 1.6;

/**
 * The zoom that repeats itself: towards the limit vertex of a run that does not end, by exactly the shrink factor in each
 * cycle, while the playhead runs through the cycle. After a cycle the picture looks like before; after the last one that was
 * seen it begins again at the first. Whoever moves the picture or the playhead takes over.
 */
export class RepetitionZoom {
  running = $state(false);
  /** Cycles since the first one; fractions of one while it runs. */
  cycle = $state(0);

  private frame = 0;
  private last = 0;
  /** The view at the start, until the first cycle is reached. */
  private flight: { from: View; done: number } | null = null;
  /** What this zoom set last: anything else is somebody's hand. */
  private set: { view: View; position: number } | null = null;

  constructor(private readonly app: App) {}

  get magnification(): number {
    const factor = this.app.repeating?.repetition?.factor ?? 1;
    return factor ** -this.cycle;
  }

  toggle(): void {
    if (this.running) this.stop();
    else if (this.app.settings.reducedMotion) this.step(1);
    else this.start();
  }

  start(): void {
    const at = this.subject();
    if (!at || this.running) return;
    this.app.clock.pause();
    if (this.cycle >= at.repetition.cycles) this.cycle = 0;
    // Goes on where it was stopped; else it flies there.
    const here = at.picture.getView();
    this.flight = this.isUntouched(at.picture) ? null : { from: here, done: 0 };
    this.running = true;
    this.last = performance.now();
    this.set = null;
    this.frame = requestAnimationFrame(this.tick);
  }

  stop(): void {
    this.running = false;
    cancelAnimationFrame(this.frame);
  }

  /** To the beginning of another cycle, at once. Beyond the last one the first comes again. */
  step(by: 1 | -1): void {
    const at = this.subject();
    if (!at) return;
    this.stop();
    this.app.clock.pause();
    const { cycles } = at.repetition;
    const here = by > 0 ? Math.floor(this.cycle) : Math.ceil(this.cycle);
    const goal = this.isUntouched(at.picture) ? here + by : here;
    this.cycle = goal > cycles ? 0 : goal < 0 ? cycles : goal;
    this.show(at);
  }

  reset(): void {
    this.stop();
    this.cycle = 0;
    this.set = null;
  }

  private subject(): { repetition: Repetition; picture: Picture; side: 0 | 1 } | null {
    const pane = this.app.repeating;
    if (!pane?.repetition || !pane.picture) return null;
    const side = pane === this.app.first ? 0 : 1;
    return { repetition: pane.repetition, picture: pane.picture, side };
  }

  private isUntouched(picture: Picture): boolean {
    return this.set?.view === picture.getView() && this.set.position === this.app.clock.position;
  }

  private readonly tick = (now: number): void => {
    const at = this.subject();
    if (!at || (this.set && !this.isUntouched(at.picture)) || this.app.mode !== 'watch') {
      this.stop();
      return;
    }
    const seconds = Math.min(now - this.last, 250) / 1000;
    this.last = now;
    if (this.flight) {
      this.flight.done += seconds / FLIGHT_SECONDS;
      if (this.flight.done >= 1) this.flight = null;
    } else {
      const speed = Math.min(4, Math.max(0.25, this.app.settings.speed / 6));
      this.cycle += (seconds * speed) / CYCLE_SECONDS;
      if (this.cycle >= at.repetition.cycles) this.cycle -= at.repetition.cycles;
    }
    this.show(at);
    this.frame = requestAnimationFrame(this.tick);
  };

  private show({ repetition, picture, side }: NonNullable<ReturnType<RepetitionZoom['subject']>>) {
    const { starts, at, factor, bounds, cycles } = repetition;
    const { clock, comparison } = this.app;
    const k = Math.min(Math.floor(this.cycle), cycles - 1);
    const position = Math.round(starts[k]! + (this.cycle - k) * (starts[k + 1]! - starts[k]!));
    const common = clock === comparison.clock ? comparison.clock.lockstep : null;
    clock.seek(common ? common.tickOf(side, position) : position);
    const { clientWidth: width, clientHeight: height } = picture.canvas;
    // The limit vertex may be at the lower end of the input, where the legend is.
    const insets = { left: 56, top: 8, right: 8, bottom: width < 500 ? 8 : 80 };
    const base = zoomAbout(fitView(bounds, { width, height }, insets), at, 1 / SURROUNDINGS);
    const goal = zoomAbout(base, at, factor ** -this.cycle);
    const { flight } = this;
    const eased = flight ? flight.done * flight.done * (3 - 2 * flight.done) : 1;
    picture.setView(flight ? between(flight.from, goal, eased) : goal);
    this.set = { view: picture.getView(), position: clock.position };
  }
}
