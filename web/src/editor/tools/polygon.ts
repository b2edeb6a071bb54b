/** A closed polygon: corner after corner; the first corner, Enter or a double click closes it. One step of undo. */

import type { Point } from '../../shared/types';
import { findMeetings } from '../crossings';
import { noIds } from '../document';
import { addPolyline } from '../edits';
import { reach, type Snapped } from '../snapping';
import { crossingsOf, vertexAt } from './place';
import { emptySketch, hint, type Tool, type ToolContext } from './tool';

/** Where the polygon in the making crosses itself. */
function ownCrossings(lines: readonly (readonly [Point, Point])[]): Point[] {
  return findMeetings(lines).flatMap(({ meeting }) =>
    meeting.kind === 'crossing' ? [meeting.at] : [],
  );
}

export function createPolygonTool(context: ToolContext): Tool {
  let corners: Snapped[] = [];
  let hover: Snapped | null = null;
  let closing = false; // the pointer is at the first corner
  let pressed = false;

  function close(): boolean {
    if (corners.length < 3) return false;
    const places = corners;
    reset();
    context.commit('Draw polygon', (draft) => {
      const vertices = places.map((corner) => vertexAt(draft, corner));
      addPolyline(draft, vertices, true);
      return { ...noIds, vertices: new Set(vertices) };
    });
    return true;
  }

  function reset(): void {
    corners = [];
    closing = false;
    pressed = false;
  }

  function follow(e: Parameters<Tool['move']>[0]): void {
    const first = corners[0];
    const last = corners.at(-1);
    const radius = (e.touch ? reach.touch : reach.mouse).vertex * e.unitsPerPixel;
    closing =
      corners.length >= 3 &&
      first !== undefined &&
      Math.hypot(e.at[0] - first.at[0], e.at[1] - first.at[1]) <= radius;
    hover = closing ? { ...first!, kind: 'vertex' } : context.snap(e, last?.at ?? null);
  }

  return {
    down(e) {
      follow(e);
      if (e.double && corners.length >= 3) {
        close();
        return true;
      }
      pressed = true;
      return true;
    },
    move(e) {
      follow(e);
      return true;
    },
    up(e) {
      if (!pressed) return false;
      pressed = false;
      follow(e);
      if (closing) {
        close();
        return true;
      }
      const at = hover!.at;
      // A corner twice would be a segment of length zero, or a polygon that touches itself.
      if (!corners.some((c) => c.at[0] === at[0] && c.at[1] === at[1]))
        corners = [...corners, hover!];
      return true;
    },
    key(e) {
      if (e.key === 'Enter') return close();
      if (e.key === 'Backspace' && corners.length > 0) {
        corners = corners.slice(0, -1);
        closing = false;
        return true;
      }
      return false;
    },
    cancel() {
      const busy = corners.length > 0 || pressed;
      reset();
      return busy;
    },
    get sketch() {
      if (!hover && corners.length === 0) return null;
      const places: Point[] = corners.map((c) => c.at);
      if (hover && !closing) places.push(hover.at);
      const lines: (readonly [Point, Point])[] = [];
      for (let i = 1; i < places.length; ++i) lines.push([places[i - 1]!, places[i]!]);
      if (closing) lines.push([places.at(-1)!, places[0]!]);
      return {
        ...emptySketch,
        lines,
        points: places,
        snap: hover ? hint(hover) : null,
        crossings: [
          ...lines.flatMap(([a, b]) => crossingsOf(context.document, a, b)),
          ...ownCrossings(lines),
        ],
      };
    },
  };
}
