import { type MeshMeasures, measureMesh } from '../replay/measure.ts';
import type { Pane } from '../store/pane.svelte.ts';

/** How long numbers beside a film stand still: they are read, not raced. */
const EVERY_MS = 150;

/** Counts and angles of a pane's mesh at its playhead; while it plays, a few times a second. Null: there is no run. */
export function measured(pane: () => Pane, tau: () => number = () => 0) {
  let position = $state(0);
  let waiting: ReturnType<typeof setTimeout> | undefined;
  $effect(() => {
    const { playback, run } = pane();
    void playback.position;
    void run.trace;
    waiting ??= setTimeout(() => {
      waiting = undefined;
      position = pane().playback.position;
    }, EVERY_MS);
  });
  $effect(() => () => clearTimeout(waiting));
  const current = $derived.by<(MeshMeasures & { vertices: number; refused: number }) | null>(() => {
    void position;
    const { run, playback } = pane();
    const { trace } = run;
    if (!trace || !playback.replay || !playback.angles) return null;
    const at = playback.replay.position;
    return {
      ...measureMesh(trace, playback.replay.state(), playback.angles, tau()),
      vertices: trace.insertedBefore.at(at),
      refused: trace.refusedBefore.at(at),
    };
  });
  return {
    get current() {
      return current;
    },
  };
}
