/** The cursor that arrow keys move, for those who draw without a pointer. */

import type { EditorKey, Point, SnapOptions } from '../shared/types';
import type { Document } from './document';
import { gridStepOf, roundTo } from './snapping';

/** Without a grid an arrow key goes so many pixels. */
const pixelsPerStep = 8;
const largeFactor = 5; // with Shift
const smallFactor = 0.1; // with Alt

const directions: Readonly<Record<string, Point>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

export class KeyboardCursor {
  at: Point | null = null;
  /** Enter was pressed since the cursor came here. */
  pressedHere = false;
  private last: Point | null = null; // where pointer or selection were

  /** How far an arrow key goes, in world units; null for other keys. */
  stepOf(e: EditorKey, snap: SnapOptions): Point | null {
    const direction = directions[e.key];
    if (!direction) return null;
    const step = snap.grid
      ? gridStepOf(snap, e.unitsPerPixel)
      : 10 ** Math.floor(Math.log10(e.unitsPerPixel)) * pixelsPerStep;
    const length = step * (e.shift ? largeFactor : e.alt ? smallFactor : 1);
    return [direction[0] * length, direction[1] * length];
  }

  /** Moves on the raster of the step. It appears where the pointer was, or in the middle of the drawing. */
  move(step: Point, document: Document): Point {
    const from = this.at ?? this.last ?? middleOf(document);
    const length = Math.max(Math.abs(step[0]), Math.abs(step[1]));
    const at: Point = [
      step[0] === 0 ? from[0] : roundTo(from[0] + step[0], length),
      step[1] === 0 ? from[1] : roundTo(from[1] + step[1], length),
    ];
    this.at = at;
    this.pressedHere = false;
    return at;
  }

  /** The pointer took over. */
  follow(at: Point): void {
    this.at = null;
    this.last = at;
    this.pressedHere = false;
  }

  hide(): boolean {
    const shown = this.at !== null;
    this.at = null;
    this.pressedHere = false;
    return shown;
  }
}

function middleOf(document: Document): Point {
  if (document.vertices.length === 0) return [0.5, 0.5];
  const xs = document.vertices.map((v) => v.at[0]);
  const ys = document.vertices.map((v) => v.at[1]);
  const mid = (list: number[]) => {
    const low = list.reduce((m, v) => Math.min(m, v), Number.POSITIVE_INFINITY);
    const high = list.reduce((m, v) => Math.max(m, v), Number.NEGATIVE_INFINITY);
    return low + (high - low) / 2;
  };
  return [mid(xs), mid(ys)];
}
