/** The camera in the plane: pure functions of a `View` and the size of the canvas in CSS pixels. y points up. */

import type { Bounds, Insets, Point, View } from '../shared/types';

export interface Size {
  readonly width: number;
  readonly height: number;
}

/** What is left around the contents by `fit`, as a part of the smaller side, and at least so many pixels. */
const marginPart = 0.04;
const marginPixels = 24;

export function toScreen(view: View, size: Size, p: Point): Point {
  return [
    size.width / 2 + (p[0] - view.x) * view.scale,
    size.height / 2 - (p[1] - view.y) * view.scale,
  ];
}

export function toWorld(view: View, size: Size, x: number, y: number): Point {
  return [view.x + (x - size.width / 2) / view.scale, view.y - (y - size.height / 2) / view.scale];
}

/** The part of the plane on the canvas. */
export function visibleBounds(view: View, size: Size, marginPx = 0): Bounds {
  const halfWidth = (size.width / 2 + marginPx) / view.scale;
  const halfHeight = (size.height / 2 + marginPx) / view.scale;
  return {
    minX: view.x - halfWidth,
    minY: view.y - halfHeight,
    maxX: view.x + halfWidth,
    maxY: view.y + halfHeight,
  };
}

/** Zooms by `factor`; the world point under `at` (CSS pixels) stays where it is. */
export function zoomAt(view: View, size: Size, factor: number, at: Point, extent: number): View {
  const scale = clampScale(view.scale * factor, view, extent);
  const dx = at[0] - size.width / 2;
  const dy = at[1] - size.height / 2;
  return {
    x: view.x + dx / view.scale - dx / scale,
    y: view.y - dy / view.scale + dy / scale,
    scale,
  };
}

export function panBy(view: View, dx: number, dy: number): View {
  return { x: view.x - dx / view.scale, y: view.y + dy / view.scale, scale: view.scale };
}

/** On the straight way from one view to another, at equal shares of the magnification: `t` from 0 to 1. */
export function between(a: View, b: View, t: number): View {
  const scale = a.scale * (b.scale / a.scale) ** t;
  // The share of the way of the centers that keeps one place of the plane where it is on the canvas.
  const same = Math.abs(b.scale / a.scale - 1) < 1e-9;
  const share = same ? t : (1 / a.scale - 1 / scale) / (1 / a.scale - 1 / b.scale);
  return { x: a.x + (b.x - a.x) * share, y: a.y + (b.y - a.y) * share, scale };
}

/** `view` after a zoom about a place of the plane, which stays where it is on the canvas. */
export function zoomAbout(view: View, at: Point, factor: number): View {
  return {
    x: at[0] + (view.x - at[0]) / factor,
    y: at[1] + (view.y - at[1]) / factor,
    scale: view.scale * factor,
  };
}

/**
 * Keeps the scale where doubles still tell pixels apart (about four ulps of the center to a pixel), and where the contents are
 * still more than a speck.
 */
export function clampScale(scale: number, view: View, extent: number): number {
  const magnitude = Math.max(Math.abs(view.x), Math.abs(view.y), extent * 1e-6, Number.MIN_VALUE);
  const max = 1 / (magnitude * Number.EPSILON * 4);
  const min = extent > 0 ? 2 / extent : Number.MIN_VALUE;
  return Math.min(Math.max(scale, min), Math.max(max, min));
}

export const noInsets: Insets = { left: 0, top: 0, right: 0, bottom: 0 };

/** The view that shows `bounds` with a margin, clear of the insets. A single point is shown at scale 100 pixels a unit. */
export function fitView(bounds: Bounds, size: Size, insets: Insets = noInsets): View {
  const width = bounds.maxX - bounds.minX;
  const height = bounds.maxY - bounds.minY;
  const freeX = Math.max(size.width - insets.left - insets.right, size.width * 0.4);
  const freeY = Math.max(size.height - insets.top - insets.bottom, size.height * 0.4);
  const margin = Math.max(marginPixels, marginPart * Math.min(freeX, freeY));
  const roomX = Math.max(freeX - 2 * margin, freeX * 0.5, 1);
  const roomY = Math.max(freeY - 2 * margin, freeY * 0.5, 1);
  const fitting = Math.min(
    width > 0 ? roomX / width : Number.POSITIVE_INFINITY,
    height > 0 ? roomY / height : Number.POSITIVE_INFINITY,
  );
  const scale = Number.isFinite(fitting) && fitting > 0 ? fitting : 100;
  return {
    x: bounds.minX + width / 2 - (insets.left - insets.right) / 2 / scale,
    y: bounds.minY + height / 2 + (insets.top - insets.bottom) / 2 / scale,
    scale,
  };
}

/** Null if there is no finite point. */
export function boundsOf(points: Iterable<Point>): Bounds | null {
  let minX = Number.POSITIVE_INFINITY;
  let minY = Number.POSITIVE_INFINITY;
  let maxX = Number.NEGATIVE_INFINITY;
  let maxY = Number.NEGATIVE_INFINITY;
  for (const [x, y] of points) {
    if (!Number.isFinite(x) || !Number.isFinite(y)) continue;
    minX = Math.min(minX, x);
    minY = Math.min(minY, y);
    maxX = Math.max(maxX, x);
    maxY = Math.max(maxY, y);
  }
  return minX <= maxX ? { minX, minY, maxX, maxY } : null;
}

export function unite(a: Bounds | null, b: Bounds | null): Bounds | null {
  if (!a || !b) return a ?? b;
  return {
    minX: Math.min(a.minX, b.minX),
    minY: Math.min(a.minY, b.minY),
    maxX: Math.max(a.maxX, b.maxX),
    maxY: Math.max(a.maxY, b.maxY),
  };
}

/** 1, 2 or 5 times a power of ten, at least `value`: steps of grids and lengths of scale bars. */
export function roundStep(value: number): number {
  const exponent = Math.floor(Math.log10(value));
  const power = 10 ** exponent;
  for (const m of [1, 2, 5]) if (m * power >= value * (1 - 1e-12)) return m * power;
  return 10 ** (exponent + 1);
}
