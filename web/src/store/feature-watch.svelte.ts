import { untrack } from 'svelte';
import type { App } from './app.svelte.ts';

/** Keeps what the overlays show of feature sizes up to date. To be called while a component initializes. */
export function watchFeatures(app: App): void {
  const { features, settings } = app;
  $effect(() => {
    const complex = app.featureComplex;
    untrack(() => features.setComplex(complex));
  });
  $effect(() => {
    const { picture } = app.first;
    void features.complex;
    if (!picture || !settings.overlays.featureSize) {
      untrack(() => features.unwatch());
      return;
    }
    const measure = () => untrack(() => features.watch(picture));
    measure();
    return picture.onViewChange(measure);
  });
  $effect(() => {
    if (settings.overlays.featureSize) return;
    untrack(() => features.pin(null));
  });
  $effect(() => {
    void features.complex;
    if (settings.overlays.neighbors) untrack(() => void features.measureVertices());
  });
}
