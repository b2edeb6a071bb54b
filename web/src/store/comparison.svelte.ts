import { CoreClient, type CoreLoss } from '../core/client.ts';
import type { ComparisonOptions } from '../link/link.ts';
import { Lockstep, type Pace } from '../replay/lockstep.ts';
import { type JumpTarget, weight } from '../replay/timeline.ts';
import { Clock } from './clock.svelte.ts';
import { Pane } from './pane.svelte.ts';

/** One timeline for two runs: a position is a tick of their lockstep. */
class CommonClock extends Clock {
  constructor(
    private readonly comparison: Comparison,
    speed: () => number,
  ) {
    super(speed);
  }

  readonly lockstep = $derived.by(() => {
    const { first, second, pace } = this.comparison;
    const a = first.run.trace;
    const b = second?.run.trace;
    return a && b ? new Lockstep([a, b], pace) : null;
  });
  readonly length = $derived.by(() => {
    const { first, second } = this.comparison;
    void first.run.traceVersion;
    void second?.run.traceVersion;
    this.lockstep?.extend([!first.run.busy, !second?.run.busy]);
    return this.lockstep?.length ?? 0;
  });

  seek(position: number): void {
    const { first, second } = this.comparison;
    if (!this.lockstep || !second) return;
    const goal = Math.max(0, Math.min(Math.round(position), this.length));
    const [a, b] = this.lockstep.at(goal);
    // Who waits is left alone: its last change is not taken back.
    if (a !== first.playback.position) first.playback.seek(a);
    if (b !== second.playback.position) second.playback.seek(b);
    this.position = goal;
  }

  jump(target: JumpTarget, forward: boolean): boolean {
    this.pause();
    const goal = this.lockstep?.jump(this.position, target, forward) ?? null;
    if (goal === null) return false;
    this.seek(goal);
    return true;
  }

  protected get ready(): boolean {
    return this.lockstep !== null;
  }

  protected get growing(): boolean {
    const { first, second } = this.comparison;
    return first.run.busy || second?.run.busy === true;
  }

  /** As long as the slower of the two events that a tick takes. */
  protected cost(position: number): number {
    const { first, second } = this.comparison;
    const traces = [first.run.trace!, second!.run.trace!] as const;
    const here = this.lockstep!.at(position);
    const next = this.lockstep!.at(position + 1);
    const costs = traces.map((t, i) => (next[i]! > here[i]! ? weight(t.kind(next[i]! - 1)) : 0));
    return Math.max(0.1, ...costs);
  }
}

/**
 * The same input under a second algorithm, in step with the first. The second run has a worker of its own, so that neither
 * waits for the other; it is ended with the comparison.
 */
export class Comparison {
  second = $state.raw<Pane | null>(null);
  pace = $state<Pace>('vertices');
  readonly clock: CommonClock;

  constructor(
    readonly first: Pane,
    private readonly speed: () => number,
    private readonly onLoss: (loss: CoreLoss) => void,
  ) {
    this.clock = new CommonClock(this, speed);
  }

  open({ options, pace }: Pick<ComparisonOptions, 'options' | 'pace'>): Pane {
    this.close();
    const second = new Pane(new CoreClient(this.onLoss), this.speed);
    second.parameters.adopt(options);
    this.second = second;
    this.pace = pace;
    this.first.playback.pause();
    return second;
  }

  /** Leaves nothing behind: worker, trace and picture of the second run are gone. */
  close(): void {
    const { second } = this;
    if (!second) return;
    this.clock.pause();
    this.clock.position = 0;
    this.second = null;
    second.discard();
    second.core.dispose();
  }

  /** The first tick at which the first run stands where it stands now. */
  join(): void {
    const { lockstep, length } = this.clock;
    if (lockstep && length > 0) this.clock.seek(lockstep.tickOf(0, this.first.playback.position));
  }

  /** Has a run nothing to do at this tick, as the other one has more to do between two insertions? */
  isWaiting(pane: Pane): boolean {
    const { lockstep, position } = this.clock;
    if (!lockstep || this.pace !== 'vertices' || position === 0) return false;
    const side = pane === this.first ? 0 : 1;
    return lockstep.at(position)[side] === lockstep.at(position - 1)[side];
  }

  /** Both go on from the vertices (or the share) at which the first one stands. */
  setPace(pace: Pace): void {
    this.clock.pause();
    this.pace = pace;
    this.join();
  }
}
