/**
 * Windows: how doubles become the single precision of the GPU.
 *
 * A window is an origin, a unit and, when the view is deep, a box. World coordinates are taken relative to the origin
 * and scaled by the unit in double precision before they are rounded. As long as the whole contents are less than
 * `preciseSpan` pixels wide, one window over everything serves (an error below 2e5 * 2^-24 = 0.012 pixels), and
 * panning and zooming touch no buffer. Deeper, contents are clipped in double precision to a box of a few
 * canvases about the view: a line whose ends are a billion canvases away still passes where it should. The window is renewed only
 * when the view leaves it.
 */

import type { Bounds, View } from '../shared/types';
import { type Size, visibleBounds } from './view';

export interface Window {
  readonly originX: number;
  readonly originY: number;
  /** Window units a world unit. */
  readonly unit: number;
  /** What is uploaded; null: everything. */
  readonly box: Bounds | null;
}

const preciseSpan = 2e5;
/** Canvases on each side that a deep window reaches beyond the view. */
const reach = 1.5;

export function makeWindow(view: View, size: Size, contents: Bounds | null): Window {
  const bounds = contents ?? visibleBounds(view, size);
  const span = spanFrom(view, bounds);
  if (span * view.scale <= preciseSpan / 2) {
    const width = Math.max(bounds.maxX - bounds.minX, bounds.maxY - bounds.minY);
    return {
      originX: bounds.minX + (bounds.maxX - bounds.minX) / 2,
      originY: bounds.minY + (bounds.maxY - bounds.minY) / 2,
      unit: width > 0 ? 1000 / width : view.scale,
      box: null,
    };
  }
  const margin = reach * Math.max(size.width, size.height);
  return {
    originX: view.x,
    originY: view.y,
    unit: view.scale,
    box: visibleBounds(view, size, margin),
  };
}

/** Does the window still serve this view? */
export function serves(window: Window, view: View, size: Size, contents: Bounds | null): boolean {
  if (!window.box) {
    const bounds = contents ?? visibleBounds(view, size);
    const center = bounds.minX + (bounds.maxX - bounds.minX) / 2;
    const middle = bounds.minY + (bounds.maxY - bounds.minY) / 2;
    const span = spanFrom(view, bounds);
    const drift =
      Math.max(Math.abs(center - window.originX), Math.abs(middle - window.originY)) * view.scale;
    return span * view.scale <= preciseSpan && drift <= preciseSpan;
  }
  const ratio = view.scale / window.unit;
  const seen = visibleBounds(view, size, 40);
  return (
    ratio < 32 &&
    ratio > 1 / 8 &&
    seen.minX >= window.box.minX &&
    seen.minY >= window.box.minY &&
    seen.maxX <= window.box.maxX &&
    seen.maxY <= window.box.maxY
  );
}

function spanFrom(view: View, b: Bounds): number {
  return Math.max(
    b.maxX - b.minX,
    b.maxY - b.minY,
    Math.abs(view.x - b.minX),
    Math.abs(view.x - b.maxX),
    Math.abs(view.y - b.minY),
    Math.abs(view.y - b.maxY),
  );
}
