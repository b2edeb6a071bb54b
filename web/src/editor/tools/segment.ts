/**
 * Segments: click after click a chain, or one by press, drag and release. Each is a step of undo of its own. The chain ends with Enter,
 * Escape, a double click, or where it began.
 */

import type { EditorPointer, Point, Sketch } from '../../shared/types';
import { find, noIds } from '../document';
import { addSegment } from '../edits';
import type { Snapped } from '../snapping';
import { crossingsOf, vertexAt } from './place';
import { emptySketch, hint, isDrag, type Tool, type ToolContext } from './tool';

type State =
  | { readonly name: 'idle'; readonly hover: Snapped | null }
  | {
      readonly name: 'chain';
      readonly first: Snapped; // where the chain began
      readonly from: Snapped;
      readonly hover: Snapped;
      readonly press: EditorPointer | null; // button down
      readonly pressedHere: boolean; // this press set `from`
    };

const samePlace = (a: Snapped, b: Snapped) => a.at[0] === b.at[0] && a.at[1] === b.at[1];

export function createSegmentTool(context: ToolContext): Tool {
  let state: State = { name: 'idle', hover: null };

  /** Draws the segment; returns the end as the vertex that it has become. */
  function draw(from: Snapped, to: Snapped): Snapped {
    let vertex = 0;
    context.commit('Draw segment', (draft) => {
      const a = vertexAt(draft, from);
      vertex = vertexAt(draft, to);
      addSegment(draft, a, vertex);
      return { ...noIds, vertices: new Set([vertex]) };
    });
    const at = find(context.document, 'vertices', vertex)?.at ?? to.at;
    return { at, kind: 'vertex', vertex, segment: null };
  }

  function advance(chain: Extract<State, { name: 'chain' }>, to: Snapped, last: boolean): void {
    const end = draw(chain.from, to);
    const closed = samePlace(end, chain.first);
    // The first vertex has an id now, if it was new before.
    const first =
      chain.first.vertex === null
        ? context.document.vertices.find(
            (v) => v.at[0] === chain.first.at[0] && v.at[1] === chain.first.at[1],
          )
        : null;
    state =
      last || closed
        ? { name: 'idle', hover: null }
        : {
            ...chain,
            first: first ? { ...chain.first, vertex: first.id, segment: null } : chain.first,
            from: end,
            hover: end,
            press: null,
            pressedHere: false,
          };
  }

  return {
    down(e) {
      if (state.name === 'idle') {
        const from = context.snap(e);
        state = { name: 'chain', first: from, from, hover: from, press: e, pressedHere: true };
        return true;
      }
      const to = context.snap(e, state.from.at);
      if (e.double && samePlace(to, state.from)) {
        state = { name: 'idle', hover: to };
        return true;
      }
      state = { ...state, hover: to, press: e, pressedHere: false };
      return true;
    },

    move(e) {
      if (state.name === 'idle') state = { name: 'idle', hover: context.snap(e) };
      else state = { ...state, hover: context.snap(e, state.from.at) };
      return true;
    },

    up(e) {
      if (state.name === 'idle' || !state.press) return false;
      const to = context.snap(e, state.from.at);
      const dragged = isDrag(state.press.screen, e.screen, e.touch);
      if (state.pressedHere && !dragged) {
        state = { ...state, press: null, pressedHere: false };
      } else if (!samePlace(to, state.from)) {
        advance(state, to, state.pressedHere && dragged);
      } else {
        state = { ...state, press: null };
      }
      return true;
    },

    key(e) {
      if (state.name === 'idle') return false;
      if (e.key === 'Enter') {
        state = { name: 'idle', hover: null };
        return true;
      }
      return false;
    },

    cancel() {
      const busy = state.name === 'chain';
      state = { name: 'idle', hover: null };
      return busy;
    },

    get sketch(): Sketch | null {
      if (state.name === 'idle') {
        const { hover } = state;
        return hover ? { ...emptySketch, points: [hover.at], snap: hint(hover) } : null;
      }
      const { from, hover } = state;
      const line: readonly [Point, Point] = [from.at, hover.at];
      return {
        ...emptySketch,
        lines: samePlace(from, hover) ? [] : [line],
        points: [from.at, hover.at],
        snap: hint(hover),
        crossings: crossingsOf(context.document, from.at, hover.at),
      };
    },
  };
}
