import type { Pair, Spindle } from '../shared/overlay-facts.ts';
import { type MeshState, VertexKind } from '../shared/types.ts';

/**
 * Spind(s) at the moment of a state (thesis, Definition 2.1.5): s, and when s is an end segment also the end segments that share
 * its input vertex (both, if both of its ends are input vertices). Null if ab is no subsegment now.
 */
export function spindleOf(state: MeshState, a: number, b: number): Spindle | null {
  const apexes = [a, b].filter((v) => isInput(state, v));
  const subsegments: Pair[] = [];
  let isLive = false;
  for (let i = 0; i < state.liveSubsegmentCount; i++) {
    const n = state.liveSubsegments[i]!;
    const p = state.subsegments[3 * n]!;
    const q = state.subsegments[3 * n + 1]!;
    if ((p === a && q === b) || (p === b && q === a)) isLive = true;
    else if (apexes.includes(p) || apexes.includes(q)) subsegments.push([p, q]);
  }
  return isLive ? { subsegments: [[a, b], ...subsegments], apexes } : null;
}

/** Corners of the box are input vertices of the complex that is refined. */
function isInput(state: MeshState, v: number): boolean {
  const kind = state.vertexKind[v];
  return kind === VertexKind.input || kind === VertexKind.box;
}
