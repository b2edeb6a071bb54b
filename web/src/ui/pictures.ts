import type { Insets, PictureTheme } from '../shared/types.ts';

/** What pictures have in common where they stand in the page. */

/** A picture on a canvas. */
export interface Shown {
  setTheme(theme: PictureTheme): void;
  resize(width: number, height: number, pixelRatio: number): void;
  dispose(): void;
}

interface Viewed<V> {
  getView(): V;
  setView(view: V): void;
  onViewChange(listener: (view: V) => void): () => void;
}

/** One view for both, whichever is moved. Returns what unlinks them. */
export function linkViews<V>(a: Viewed<V>, b: Viewed<V>): () => void {
  let linking = false;
  const link = (from: Viewed<V>, to: Viewed<V>) =>
    from.onViewChange((view) => {
      if (linking) return;
      linking = true;
      to.setView(view);
      linking = false;
    });
  b.setView(a.getView());
  const ends = [link(a, b), link(b, a)];
  return () => {
    for (const end of ends) end();
  };
}

/** Room that controls cover in a picture of this size. */
export function insetsOf(width: number, height: number): Insets {
  // Above an open sheet there is little height: the buttons in the corner may cover a corner of the input.
  const bottom = height < 300 ? 8 : width < 500 ? 74 : 56;
  return { left: 56, top: 8, right: 8, bottom };
}
