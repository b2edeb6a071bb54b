/** Select and move. Idle, pressed on something, dragging it, or drawing a box. */

import type { EditorKey, EditorPointer, Point, Sketch } from '../../shared/types';
import { find, type Ids, isEmpty, noIds } from '../document';
import { moveAll, movedVertices, splitSegment, weld } from '../edits';
import { hitTest, inBox, only, type Target, toggled, union } from '../hit';
import { emptySketch, hint, isDrag, type Tool, type ToolContext } from './tool';

type State =
  | { readonly name: 'idle' }
  | {
      readonly name: 'pressed';
      readonly target: Target | null;
      readonly start: EditorPointer;
      readonly wasSelected: boolean;
    }
  | {
      readonly name: 'dragging';
      readonly target: Target;
      readonly start: EditorPointer;
      readonly ids: Ids;
      readonly moved: ReadonlySet<number>;
      readonly anchor: Point; // what is dragged, where it was
      readonly by: Point;
      readonly snap: Sketch['snap'];
    }
  | {
      readonly name: 'box';
      readonly start: EditorPointer;
      readonly to: Point;
      readonly before: Ids;
    };

export function createSelectTool(context: ToolContext): Tool {
  let state: State = { name: 'idle' };

  function drag(from: Extract<State, { name: 'dragging' }>, e: EditorPointer): void {
    const wanted: Point = [
      from.anchor[0] + e.at[0] - from.start.at[0],
      from.anchor[1] + e.at[1] - from.start.at[1],
    ];
    // Shift keeps to 45 degrees from where it was.
    const snapped = context.snap({ ...e, at: wanted }, e.shift ? from.anchor : null, from.moved);
    const by: Point = [snapped.at[0] - from.anchor[0], snapped.at[1] - from.anchor[1]];
    state = { ...from, by, snap: hint(snapped) };
    context.preview((draft) => place(draft, from, by, snapped.at));
  }

  /** What is dragged lands bit for bit on the snap; the rest keeps its distance. */
  function place(
    draft: Parameters<Parameters<ToolContext['commit']>[1]>[0],
    from: Extract<State, { name: 'dragging' }>,
    by: Point,
    at: Point,
  ): void {
    moveAll(draft, from.ids, by[0], by[1]);
    if (from.target.kind === 'vertices') draft.change('vertices', from.target.id, { at });
  }

  function anchorOf(target: Target, start: EditorPointer): Point {
    if (target.kind === 'segments') {
      const segment = find(context.document, 'segments', target.id);
      const end = segment && find(context.document, 'vertices', segment.a);
      return end?.at ?? start.at;
    }
    return find(context.document, target.kind, target.id)?.at ?? start.at;
  }

  return {
    down(e) {
      const target = hitTest(context.document, e.at, e.unitsPerPixel, e.touch);
      if (e.double && target?.kind === 'segments') {
        const segment = target.id;
        const snapped = context.snap(e);
        state = { name: 'idle' };
        context.commit('Split segment', (draft) => {
          const vertex = splitSegment(
            draft,
            segment,
            snapped.segment === segment ? snapped.at : e.at,
          );
          return { ...noIds, vertices: new Set([vertex]) };
        });
        return true;
      }
      const wasSelected = target !== null && context.selection[target.kind].has(target.id);
      if (target && !wasSelected) {
        context.select(e.shift ? toggled(context.selection, target) : only(target));
      }
      state = { name: 'pressed', target, start: e, wasSelected };
      return true;
    },

    move(e) {
      if (state.name === 'pressed' && isDrag(state.start.screen, e.screen, e.touch)) {
        const { target, start } = state;
        if (target) {
          const ids = context.selection[target.kind].has(target.id)
            ? context.selection
            : only(target);
          const moved = movedVertices(context.document, ids);
          const anchor = anchorOf(target, start);
          state = { name: 'dragging', target, start, ids, moved, anchor, by: [0, 0], snap: null };
        } else {
          const before = start.shift ? context.selection : noIds;
          state = { name: 'box', start, to: e.at, before };
        }
      }
      if (state.name === 'dragging') {
        drag(state, e);
        return true;
      }
      if (state.name === 'box') {
        state = { ...state, to: e.at };
        context.select(union(state.before, inBox(context.document, state.start.at, e.at)));
        return true;
      }
      return state.name === 'pressed';
    },

    up(e) {
      const done = state;
      if (done.name === 'idle') return false;
      if (done.name === 'dragging') {
        drag(done, e);
        const { by, snap } = state as typeof done;
        const at: Point = [done.anchor[0] + by[0], done.anchor[1] + by[1]];
        const landed = snap?.at ?? at;
        state = { name: 'idle' };
        context.preview(null);
        if (by[0] !== 0 || by[1] !== 0) {
          context.commit(moveTitle(done.ids, done.moved.size), (draft) => {
            place(draft, done, by, landed);
            weld(draft, done.moved);
            return done.ids;
          });
        }
        return true;
      }
      if (done.name === 'pressed') {
        const { target, wasSelected, start } = done;
        if (!target && !start.shift) context.select(noIds);
        // A click on what was selected: with Shift it goes out, without it alone remains.
        else if (target && wasSelected) {
          context.select(start.shift ? toggled(context.selection, target) : only(target));
        }
      }
      state = { name: 'idle' };
      return true;
    },

    key: (_: EditorKey) => false,

    cancel() {
      const busy = state.name !== 'idle';
      if (state.name === 'dragging') context.preview(null);
      state = { name: 'idle' };
      if (busy) return true;
      if (isEmpty(context.selection)) return false;
      context.select(noIds);
      return true;
    },

    get sketch() {
      if (state.name === 'box') return { ...emptySketch, box: [state.start.at, state.to] as const };
      if (state.name === 'dragging' && state.snap) return { ...emptySketch, snap: state.snap };
      return null;
    },
  };
}

export function moveTitle(ids: Ids, vertices: number): string {
  const seeds = ids.holes.size + ids.regions.size;
  if (seeds === 0) return vertices === 1 ? 'Move vertex' : `Move ${vertices} vertices`;
  if (vertices === 0 && seeds === 1) return ids.holes.size === 1 ? 'Move hole' : 'Move region';
  return `Move ${vertices + seeds} things`;
}
