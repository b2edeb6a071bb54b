/** What a tool in the middle of its work shows, and what is picked for the inspector. */

import type { PictureTheme, Point, Sketch } from '../../shared/types';
import { type Items, noItems } from '../items';

/** `unitsPerPixel`: hints of the 45 degree snap are lines of a length on screen. */
export function sketchItems(sketch: Sketch, theme: PictureTheme, unitsPerPixel: number): Items {
  const items = noItems();
  const { selection, snap: snapColor } = theme;
  if (sketch.box) {
    const [p, q] = sketch.box;
    const corners: Point[] = [p, [q[0], p[1]], q, [p[0], q[1]]];
    items.polygons.push({ points: corners, fill: selection, opacity: 0.1 });
    corners.forEach((a, i) => {
      const b = corners[(i + 1) % 4]!;
      items.lines.push({ a, b, color: selection, width: 1.3, dash: 'dashed' });
    });
  }
  for (const [a, b] of sketch.lines) items.lines.push({ a, b, color: selection, width: 2.2 });
  for (const at of sketch.points) {
    items.marks.push({
      at,
      shape: 'disc',
      size: 9,
      fill: theme.background,
      stroke: selection,
      width: 2.2,
    });
  }
  for (const at of sketch.crossings ?? []) {
    items.marks.push({ at, shape: 'disc', size: 16, stroke: theme.warning, width: 2 });
    items.marks.push({ at, shape: 'cross', size: 5.5, stroke: theme.warning, width: 2 });
  }
  if (sketch.snap) {
    const { at, kind } = sketch.snap;
    if (kind === 'vertex') {
      items.marks.push({ at, shape: 'disc', size: 20, stroke: snapColor, width: 2.2 });
    } else if (kind === 'segment') {
      items.marks.push({ at, shape: 'square', size: 17, stroke: snapColor, width: 2 });
      items.marks.push({ at, shape: 'cross', size: 6, stroke: snapColor, width: 1.8 });
    } else if (kind === 'grid') {
      items.marks.push({ at, shape: 'plus', size: 15, stroke: snapColor, width: 1.8 });
    } else {
      const last = sketch.lines[sketch.lines.length - 1];
      const from = last ? last[0] : at;
      const length = Math.hypot(at[0] - from[0], at[1] - from[1]);
      if (length > 0) {
        const beyond = 28 * unitsPerPixel;
        const to: Point = [
          at[0] + ((at[0] - from[0]) / length) * beyond,
          at[1] + ((at[1] - from[1]) / length) * beyond,
        ];
        items.lines.push({ a: at, b: to, color: snapColor, width: 1.5, dash: 'dashed' });
      }
      items.marks.push({ at, shape: 'diamond', size: 15, stroke: snapColor, width: 1.8 });
    }
  }
  if (sketch.cursor) {
    const at = sketch.cursor;
    items.marks.push({ at, shape: 'plus', size: 30, stroke: theme.background, width: 5 });
    items.marks.push({ at, shape: 'plus', size: 28, stroke: theme.ink, width: 1.8 });
  }
  return items;
}
