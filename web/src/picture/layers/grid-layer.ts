/** Grid and axes below everything, and the scale bar above everything: functions of the view alone. */

import type { Insets, PictureTheme, Point, View } from '../../shared/types';
import { type Items, noItems } from '../items';
import { noInsets, roundStep, type Size, toWorld, visibleBounds } from '../view';

/** Distance of grid lines that the eye can use at this scale: 1, 2 or 5 times a power of ten, 18 pixels or more. */
export function gridStep(scale: number): number {
  return roundStep(18 / scale);
}

export function gridItems(view: View, size: Size, theme: PictureTheme): Items {
  const items = noItems();
  const b = visibleBounds(view, size, 2);
  const step = gridStep(view.scale);
  const magnitude = Math.max(
    Math.abs(b.minX),
    Math.abs(b.maxX),
    Math.abs(b.minY),
    Math.abs(b.maxY),
  );
  if (magnitude / step > 2 ** 50) return items; // finer than doubles
  const add = (axis: 0 | 1) => {
    const [from, to] = axis === 0 ? [b.minX, b.maxX] : [b.minY, b.maxY];
    for (let k = Math.ceil(from / step); k <= Math.floor(to / step); ++k) {
      const at = k * step;
      const heavy = k === 0 ? 2 : k % 5 === 0 ? 1 : 0;
      items.lines.push({
        a: axis === 0 ? [at, b.minY] : [b.minX, at],
        b: axis === 0 ? [at, b.maxY] : [b.maxX, at],
        color: theme.inkFaint,
        width: 1,
        opacity: heavy === 2 ? 0.85 : heavy === 1 ? 0.4 : 0.17,
      });
    }
  };
  add(0);
  add(1);
  return items;
}

/** A bar of a round length at the lower right, clear of the insets. */
export function scaleBarItems(
  view: View,
  size: Size,
  theme: PictureTheme,
  insets: Insets = noInsets,
): Items {
  const items = noItems();
  if (size.width < 260) return items;
  const length = roundStep(56 / view.scale);
  const pixels = length * view.scale;
  const right = size.width - insets.right - 16;
  const y = size.height - insets.bottom - 16;
  const at = (px: number, py: number): Point => toWorld(view, size, px, py);
  const line = (x0: number, y0: number, x1: number, y1: number) =>
    items.lines.push({ a: at(x0, y0), b: at(x1, y1), color: theme.ink, width: 1.4, opacity: 0.75 });
  line(right - pixels, y, right, y);
  line(right - pixels, y - 3.5, right - pixels, y + 3.5);
  line(right, y - 3.5, right, y + 3.5);
  items.texts.push({
    at: at(right - pixels / 2, y),
    text: formatLength(length),
    size: 11.5,
    color: theme.ink,
    dx: 0,
    dy: 7,
    anchor: 'middle',
    halo: theme.background,
  });
  return items;
}

export function formatLength(value: number): string {
  if (value >= 1e-3 && value < 1e5) return String(Number(value.toPrecision(6)));
  const exponent = Math.floor(Math.log10(value) + 1e-9);
  return `${Math.round(value / 10 ** exponent)}e${exponent}`;
}
