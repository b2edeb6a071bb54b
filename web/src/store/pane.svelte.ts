import type { CoreClient } from '../core/client.ts';
import { collarRegionAt } from '../replay/collar-region.ts';
import { circumball, point3 } from '../replay/geometry3.ts';
import { findRepetitions, reachesPrecision } from '../replay/repetition.ts';
import { stoppersOf } from '../replay/stoppers.ts';
import type { Hit, Picture } from '../shared/types.ts';
import type { SpaceHit, SpacePicture } from '../space/types.ts';
import { OverlayStore } from './overlays.svelte.ts';
import { ParameterStore } from './parameters.svelte.ts';
import { PlaybackStore } from './playback.svelte.ts';
import { RunStore } from './run.svelte.ts';

/** One run and how it is watched: its parameters, its playhead, its picture and what is picked in it. The page has one; two while comparing. */
export class Pane {
  readonly run: RunStore;
  readonly playback: PlaybackStore;
  readonly overlays: OverlayStore;
  readonly parameters = new ParameterStore();
  picked = $state.raw<Hit | null>(null);
  picture = $state.raw<Picture | null>(null);
  /** The same of a run in space: a pane shows one of the two pictures. */
  spacePicked = $state.raw<SpaceHit | null>(null);
  spacePicture = $state.raw<SpacePicture | null>(null);

  /** Why the run would not have ended, where a limit (or the end of double precision) stopped it and that can be seen. */
  readonly repetition = $derived.by(() => {
    const { busy, phase, trace } = this.run;
    if (!trace || busy || trace.dimension === 3) return null;
    if (phase !== 'complete') return findRepetitions(trace)[0] ?? null;
    if (!reachesPrecision(trace)) return null;
    return findRepetitions(trace).find((r) => r.exhausted) ?? null;
  });

  /** Of a picked tetrahedron: its ball, and the collar simplices that stop it (thesis, Theorem 6.11). Null without protection. */
  readonly stops = $derived.by(() => {
    const { replay, position } = this.playback;
    const cell = this.spacePicked?.cell ?? null;
    void position;
    if (cell === null || !replay?.trace.protecting?.lives.count) return null;
    const { trace } = replay;
    const vertices = trace.cells.data.subarray(4 * cell, 4 * cell + 4);
    const ball = circumball(Array.from(vertices, (v) => point3(trace.coordinates.data, v)));
    if (!ball) return null;
    const state = replay.state();
    return { ball, stoppers: stoppersOf(state, collarRegionAt(trace, state), ball.center) };
  });

  constructor(
    readonly core: CoreClient,
    speed: () => number,
  ) {
    this.run = new RunStore(core);
    this.playback = new PlaybackStore(this.run, speed);
    this.overlays = new OverlayStore(this.run, this.playback, () => this.picked);
  }

  /** What was computed is no longer about the input. */
  discard(): void {
    this.playback.unload();
    this.run.discard();
    this.unpick();
  }

  unpick(): void {
    this.picked = null;
    this.spacePicked = null;
  }
}
