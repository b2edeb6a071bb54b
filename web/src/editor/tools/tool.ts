/** A tool: a small state machine that hears of pointer and keys, and asks the context for everything else. */

import type { EditorKey, EditorPointer, Point, Sketch, SnapOptions } from '../../shared/types';
import type { Draft } from '../command';
import type { Document, Ids } from '../document';
import type { Snapped } from '../snapping';

export interface ToolContext {
  /** As shown: with the preview of an edit in the making. */
  readonly document: Document;
  readonly selection: Ids;
  readonly snapOptions: SnapOptions;
  snap(e: EditorPointer, from?: Point | null, exclude?: ReadonlySet<number>): Snapped;
  /** Carries out an edit as one step of undo. `build` may return what is selected afterwards. */
  commit(title: string, build: (draft: Draft) => Ids | undefined, merge?: string): void;
  /** Shows an edit without carrying it out; null ends it. */
  preview(build: ((draft: Draft) => void) | null): void;
  select(ids: Ids): void;
}

export interface Tool {
  down(e: EditorPointer): boolean;
  move(e: EditorPointer): boolean;
  up(e: EditorPointer): boolean;
  /** Enter, Backspace and the like while the tool is in the middle of something. */
  key(e: EditorKey): boolean;
  /** Drops what it is doing; false if it was doing nothing. */
  cancel(): boolean;
  readonly sketch: Sketch | null;
}

export const emptySketch: Sketch = { lines: [], points: [], box: null, snap: null, cursor: null };

/** The snap as the sketch shows it. */
export function hint(snapped: Snapped): Sketch['snap'] {
  return snapped.kind ? { at: snapped.at, kind: snapped.kind } : null;
}

/** Pixels that a press may wander before it is a drag. */
export function isDrag(from: Point, to: Point, touch: boolean): boolean {
  return Math.hypot(to[0] - from[0], to[1] - from[1]) > (touch ? 10 : 4);
}
