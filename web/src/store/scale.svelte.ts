import type { ColorScale } from '../shared/types.ts';

/** The color scale that the picture used last: the legend reads it. */
class ScaleStore {
  current = $state.raw<ColorScale | null>(null);
}
export const scale = new ScaleStore();
