import { untrack } from 'svelte';
import { unitSquare } from '../numerics/meshes.ts';
import { boundsOf } from '../picture/view.ts';
import type { View } from '../shared/types.ts';
import type { App } from './app.svelte.ts';

/** Keeps what is measured on the mesh at hand up to date. To be called while a component initializes. */
export function watchNumerics(app: App): void {
  const { numerics } = app;

  // A function of the list follows the input; one's own stays where it was written.
  $effect(() => {
    const { complex } = app.doc;
    const { function: id, family } = numerics;
    const chosen = app.hello?.functions.find((f) => f.id === id);
    void family;
    if (chosen && (complex.vertices.length > 0 || family))
      untrack(() => numerics.choose(chosen, complex));
  });

  // Another input: what was studied is about the one before.
  $effect(() => {
    void app.doc.complex;
    untrack(() => {
      if (numerics.study.plan?.varied === 'size') numerics.study.clear();
      if (!numerics.family) numerics.still = null;
      numerics.forget();
    });
  });

  // Who steps or plays wants to see the run.
  let position = app.clock.position;
  $effect(() => {
    if (app.clock.position === position) return;
    position = app.clock.position;
    untrack(() => {
      if (numerics.still && !numerics.study.busy) numerics.leave();
    });
  });

  $effect(() => {
    if (!app.measures) return;
    const { expression, method, norm, family } = numerics;
    const { playback, run } = app.pane;
    void [method, norm, playback.position, run.traceVersion];
    const { replay } = playback;
    if (expression.trim() === '') return;
    untrack(() => {
      if (numerics.study.shown !== null) app.showStudyStep(numerics.study.shown);
      else if (family) numerics.measureFamily(family, app.familyTitle(family));
      else if (run.trace && replay) numerics.measureRun(replay.state());
    });
  });

  // A family lies on the unit square, wherever the input is: the view goes there and comes back.
  let before: View | null = null;
  $effect(() => {
    const { picture } = app.first;
    const elsewhere = app.still?.elsewhere ?? false;
    if (!picture) return;
    if (elsewhere && !before) {
      before = picture.getView();
      picture.fit(boundsOf(unitSquare.vertices) ?? undefined);
    } else if (!elsewhere && before) {
      picture.setView(before);
      before = null;
    }
  });
}
