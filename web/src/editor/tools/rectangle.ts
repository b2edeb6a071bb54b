/** An axis-parallel rectangle: by drag, or by two clicks. Shift makes it a square. */

import type { EditorPointer, Point } from '../../shared/types';
import { noIds } from '../document';
import { addPolyline } from '../edits';
import type { Snapped } from '../snapping';
import { crossingsOf, vertexAt } from './place';
import { emptySketch, hint, isDrag, type Tool, type ToolContext } from './tool';

export function createRectangleTool(context: ToolContext): Tool {
  let first: Snapped | null = null;
  let hover: Snapped | null = null;
  let press: EditorPointer | null = null;
  let startedByPress = false;

  function follow(e: EditorPointer): void {
    const snapped = context.snap({ ...e, shift: false });
    hover = snapped;
    if (!first || !e.shift) return;
    const dx = snapped.at[0] - first.at[0];
    const dy = snapped.at[1] - first.at[1];
    const side = Math.max(Math.abs(dx), Math.abs(dy));
    hover = {
      at: [first.at[0] + (dx < 0 ? -side : side), first.at[1] + (dy < 0 ? -side : side)],
      kind: null,
      vertex: null,
      segment: null,
    };
  }

  function corners(): Snapped[] {
    const free = (at: Point): Snapped => ({ at, kind: null, vertex: null, segment: null });
    const [p, q] = [first!, hover!];
    return [p, free([q.at[0], p.at[1]]), q, free([p.at[0], q.at[1]])];
  }

  const flat = () => first!.at[0] === hover!.at[0] || first!.at[1] === hover!.at[1];

  function finish(): void {
    const places = corners();
    first = null;
    context.commit('Draw rectangle', (draft) => {
      const vertices = places.map((corner) => vertexAt(draft, corner));
      addPolyline(draft, vertices, true);
      return { ...noIds, vertices: new Set(vertices) };
    });
  }

  return {
    down(e) {
      press = e;
      startedByPress = first === null;
      if (first === null) {
        follow(e);
        first = hover;
      } else {
        follow(e);
      }
      return true;
    },
    move(e) {
      follow(e);
      return true;
    },
    up(e) {
      if (!press || !first) return false;
      follow(e);
      const dragged = isDrag(press.screen, e.screen, e.touch);
      press = null;
      if ((dragged || !startedByPress) && !flat()) finish();
      return true;
    },
    key: () => false,
    cancel() {
      const busy = first !== null;
      first = null;
      press = null;
      return busy;
    },
    get sketch() {
      if (!hover) return null;
      if (!first) return { ...emptySketch, points: [hover.at], snap: hint(hover) };
      const places = corners().map((c) => c.at);
      const lines = flat()
        ? [[first.at, hover.at] as const]
        : places.map((p, i) => [p, places[(i + 1) % 4]!] as const);
      return {
        ...emptySketch,
        lines,
        points: flat() ? [first.at, hover.at] : places,
        snap: hint(hover),
        crossings: lines.flatMap(([a, b]) => crossingsOf(context.document, a, b)),
      };
    },
  };
}
