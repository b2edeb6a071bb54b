/** Above the mesh: what is picked, outlined, and the numbers of vertices. */

import type { Complex3, MeshState, PictureTheme, Point3 } from '../shared/types';
import { noSpaceItems, type SpaceItems } from './items';
import { place } from './mesh-layer';
import { edgesOf } from './moment-items';
import type { SpaceHit } from './types';

/** Fewer labels than this can be read. */
const MOST_LABELS = 400;

/** Outlined in the color of a selection. */
export function pickedItems3(
  picked: SpaceHit | null,
  state: MeshState | null,
  complex: Complex3 | null,
  theme: PictureTheme,
): SpaceItems {
  const items = noSpaceItems();
  if (!picked) return items;
  const color = theme.selection;
  const at = (v: number): Point3 | undefined =>
    state && v < state.vertexCount ? place(state, v) : complex?.vertices[v];
  const points = (list: Iterable<number>) =>
    [...list].map(at).filter((p): p is Point3 => p !== undefined);
  const outline = (corners: readonly Point3[]) => {
    for (const [a, b] of edgesOf(corners)) items.lines.push({ a, b, color, width: 2.6 });
  };
  if (picked.vertex !== null) {
    for (const p of points([picked.vertex]))
      items.marks.push({ at: p, shape: 'disc', size: 17, stroke: color, width: 2.6 });
  } else if (picked.subsegment !== null) {
    const n = picked.subsegment;
    const ends = state
      ? state.subsegments.subarray(3 * n, 3 * n + 2)
      : (complex?.segments[n] ?? []);
    for (const [a, b] of edgesOf(points(ends)))
      items.lines.push({ a, b, color, width: 8, opacity: 0.55 });
  } else if (picked.cell !== null && state) {
    outline(points(state.cells.subarray(4 * picked.cell, 4 * picked.cell + 4)));
  } else if (picked.facet !== null && state?.facets) {
    const n = picked.facet;
    outline(points(state.facets.triangles.subarray(4 * n, 4 * n + 3)));
  }
  if (picked.face !== null) {
    for (const loop of complex?.faces[picked.face]?.loops ?? []) {
      const corners = points(loop);
      for (const [i, a] of corners.entries()) {
        const b = corners[(i + 1) % corners.length]!;
        items.lines.push({ a, b, color, width: 3, opacity: 0.8 });
      }
    }
  }
  return items;
}

export function labelItems3(
  state: MeshState | null,
  complex: Complex3 | null,
  theme: PictureTheme,
): SpaceItems {
  const items = noSpaceItems();
  const count = state ? state.vertexCount : (complex?.vertices.length ?? 0);
  let left = MOST_LABELS;
  for (let v = 0; v < count && left > 0; v++) {
    if (state && !(state.vertexBorn[v]! < state.position)) continue;
    const at = state ? place(state, v) : complex!.vertices[v]!;
    const text = { text: String(v), size: 12, color: theme.ink, halo: theme.background };
    items.texts.push({ at, ...text, dx: 0, dy: 8 });
    left--;
  }
  return items;
}
