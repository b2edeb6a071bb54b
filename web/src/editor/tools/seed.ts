/** Seeds of holes and of regions, one a click: they lie in the open, so they do not snap to vertices and segments. */

import type { Point } from '../../shared/types';
import { noIds } from '../document';
import { tidy } from '../snapping';
import { emptySketch, type Tool, type ToolContext } from './tool';

export function createSeedTool(context: ToolContext, kind: 'holes' | 'regions'): Tool {
  let hover: Point | null = null;
  let pressed = false;

  return {
    down(e) {
      hover = tidy(e.at, e.unitsPerPixel);
      pressed = true;
      return true;
    },
    move(e) {
      hover = tidy(e.at, e.unitsPerPixel);
      return true;
    },
    up(e) {
      if (!pressed) return false;
      pressed = false;
      const at = tidy(e.at, e.unitsPerPixel);
      context.commit(kind === 'holes' ? 'Add hole' : 'Add region', (draft) => {
        if (kind === 'holes') return { ...noIds, holes: new Set([draft.insert('holes', { at })]) };
        const used = draft.document.regions.map((r) => r.label);
        const label = used.length > 0 ? Math.max(...used) + 1 : 1;
        return { ...noIds, regions: new Set([draft.insert('regions', { at, label })]) };
      });
      return true;
    },
    key: () => false,
    cancel() {
      const busy = pressed;
      pressed = false;
      return busy;
    },
    get sketch() {
      return hover ? { ...emptySketch, points: [hover] } : null;
    },
  };
}
