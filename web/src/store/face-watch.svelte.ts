import { untrack } from 'svelte';
import { point3 } from '../replay/geometry3.ts';
import { pictureTheme } from '../shared/theme.ts';
import type { PictureTheme } from '../shared/types.ts';
import { append, ballItems, chainItems, faceItems } from '../space/face-items.ts';
import { noSpaceItems, type SpaceItems } from '../space/items.ts';
import { stopperItems } from '../space/stopper-items.ts';
import { noHit } from '../space/types.ts';
import type { App } from './app.svelte.ts';

/** Keeps the face in its plane and the picture of space in step. To be called while a component initializes. */
export function watchFace(app: App): void {
  const { face, first, segment, settings } = app;
  $effect(() => {
    const { complex, open } = face;
    if (complex && open) untrack(() => void face.measure());
  });
  // Another run may have fewer faces.
  $effect(() => {
    const { count, index } = face;
    if (index >= count) untrack(() => (face.index = 0));
  });
  // A face that is picked in space is the one to show.
  $effect(() => {
    const picked = first.spacePicked?.face ?? null;
    if (picked !== null) untrack(() => face.open && face.show(picked));
  });
  $effect(() => {
    const { moment } = first.playback;
    const acting = moment?.dimension === 3 ? moment.face : null;
    if (face.open && face.following && acting !== null) untrack(() => face.show(acting));
  });
  // What is picked is measured, once it is picked.
  $effect(() => {
    const { spacePicked, run } = first;
    void [spacePicked, run.refined, run.trace];
    untrack(() => void segment.measure());
  });
  $effect(() => {
    const { spacePicture: picture } = first;
    const theme = pictureTheme(settings.dark, settings.reducedMotion);
    picture?.setExtras(app.comparing ? null : extras(app, theme));
  });
}

function extras({ face, first, segment, settings }: App, theme: PictureTheme): SpaceItems | null {
  const { refined, trace } = first.run;
  void first.run.traceVersion;
  if (!refined || !trace) return null;
  const items = noSpaceItems();
  if (face.open) append(items, faceItems(refined, face.index, theme));
  const { balls, drawn } = segment;
  const { vertex, subsegment } = first.spacePicked ?? noHit;
  const { stops } = first;
  const place = (v: number) => point3(trace.coordinates.data, v);
  if (stops && stops.stoppers.length > 0)
    append(items, stopperItems(stops.ball, stops.stoppers, place, theme));
  if (balls && subsegment !== null && balls.subsegment === subsegment) {
    const own = trace.subsegments.at(3 * subsegment + 2);
    if (drawn !== 'lfs') append(items, ballItems(refined, balls.fs1, 'fs1', theme, own));
    if (drawn !== 'fs1') append(items, ballItems(refined, balls.lfs, 'lfs', theme, own));
  }
  if (vertex !== null && vertex < trace.vertexCount && settings.overlays.ancestry) {
    const chain = first.overlays.ancestry?.chain(vertex) ?? [];
    append(items, chainItems(chain, place, theme));
  }
  return items;
}
