/** Vertices, one a click. */

import { noIds } from '../document';
import type { Snapped } from '../snapping';
import { vertexAt } from './place';
import { emptySketch, hint, type Tool, type ToolContext } from './tool';

export function createPointTool(context: ToolContext): Tool {
  let hover: Snapped | null = null;
  let pressed = false;

  return {
    down(e) {
      hover = context.snap(e);
      pressed = true;
      return true;
    },
    move(e) {
      hover = context.snap(e);
      return true;
    },
    up(e) {
      if (!pressed) return false;
      pressed = false;
      const snapped = context.snap(e);
      hover = snapped;
      context.commit('Add vertex', (draft) => ({
        ...noIds,
        vertices: new Set([vertexAt(draft, snapped)]),
      }));
      return true;
    },
    key: () => false,
    cancel() {
      const busy = pressed;
      pressed = false;
      return busy;
    },
    get sketch() {
      return hover ? { ...emptySketch, points: [hover.at], snap: hint(hover) } : null;
    },
  };
}
