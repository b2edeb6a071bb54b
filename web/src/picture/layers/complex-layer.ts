/** The input as it is edited: features in ink, seeds, what is selected, and defects at their places. */

import {
  type Complex2,
  type DefectMark,
  type PictureTheme,
  type Point,
  type Selection,
  VertexKind,
} from '../../shared/types';
import { type Items, noItems } from '../items';
import { vertexMark } from '../marks';

export interface ComplexLook {
  readonly theme: PictureTheme;
  /** A mesh is shown: its subsegments and vertices are drawn in place of the input's. */
  readonly meshed: boolean;
  /** 1, or less where vertices would crowd. */
  readonly detail: number;
}

export const segmentWidth = 2.6;

function isPlace(p: Point | undefined): p is Point {
  return p !== undefined && Number.isFinite(p[0]) && Number.isFinite(p[1]);
}

/** Below the vertices of the mesh: segments, glow of the selection. */
export function complexItems(
  complex: Complex2,
  selection: Selection | null,
  look: ComplexLook,
): Items {
  const { theme, meshed, detail } = look;
  const items = noItems();
  const at = (v: number) => complex.vertices[v];
  if (selection) {
    for (const s of selection.segments) {
      const segment = complex.segments[s];
      const a = segment && at(segment[0]);
      const b = segment && at(segment[1]);
      if (isPlace(a) && isPlace(b)) {
        items.lines.push({ a, b, color: theme.selection, width: 10, opacity: 0.4 });
      }
    }
  }
  if (!meshed) {
    for (const [v, w] of complex.segments) {
      const a = at(v);
      const b = at(w);
      if (isPlace(a) && isPlace(b)) {
        items.lines.push({ a, b, color: theme.ink, width: 1 + (segmentWidth - 1) * detail });
      }
    }
  }
  for (let v = 0; v < complex.vertices.length; ++v) {
    const p = complex.vertices[v];
    if (!isPlace(p) || selection?.vertices.has(v)) continue;
    // Rings are handles to take hold of, discs are vertices of a mesh.
    if (meshed) {
      const mark = vertexMark(VertexKind.input, p, theme);
      items.marks.push({ ...mark, size: mark.size * detail, width: (mark.width ?? 0) * detail });
      continue;
    }
    items.marks.push({
      at: p,
      shape: 'disc',
      size: 9 * detail,
      fill: theme.background,
      stroke: theme.ink,
      width: 2.2 * detail,
    });
  }
  if (selection) {
    for (const v of selection.vertices) {
      const p = at(v);
      if (!isPlace(p)) continue;
      items.marks.push({
        at: p,
        shape: 'disc',
        size: 12,
        fill: theme.selection,
        stroke: theme.background,
        width: 2,
      });
    }
  }
  complex.holes.forEach((p, i) => {
    if (isPlace(p)) addHole(items, p, theme, selection?.holes.has(i) ?? false);
  });
  complex.regions.forEach((region, i) => {
    if (isPlace(region.at)) {
      addRegion(items, region.at, region.label, theme, selection?.regions.has(i) ?? false);
    }
  });
  return items;
}

function addHole(items: Items, at: Point, theme: PictureTheme, selected: boolean): void {
  if (selected) {
    items.marks.push({ at, shape: 'disc', size: 24, stroke: theme.selection, width: 3 });
  }
  items.marks.push({
    at,
    shape: 'disc',
    size: 16,
    fill: theme.background,
    stroke: theme.hole,
    width: 1.6,
  });
  items.marks.push({ at, shape: 'cross', size: 6, stroke: theme.hole, width: 2 });
}

function addRegion(
  items: Items,
  at: Point,
  label: number,
  theme: PictureTheme,
  selected: boolean,
): void {
  if (selected) {
    items.marks.push({ at, shape: 'diamond', size: 28, stroke: theme.selection, width: 3 });
  }
  items.marks.push({
    at,
    shape: 'diamond',
    size: 17,
    fill: theme.background,
    stroke: theme.ink,
    width: 1.5,
  });
  items.marks.push({ at, shape: 'disc', size: 3.5, fill: theme.ink });
  items.texts.push({
    at,
    text: String(label),
    size: 11.5,
    color: theme.ink,
    dx: 13,
    dy: -4,
    anchor: 'start',
    halo: theme.background,
  });
}

/** Above everything: a ring at each place, the features that offend under it. */
export function defectItems(
  complex: Complex2,
  defects: readonly DefectMark[],
  theme: PictureTheme,
): Items {
  const items = noItems();
  for (const defect of defects) {
    const color = defect.warning ? theme.warning : theme.defect;
    for (const feature of defect.features) {
      if (feature.kind !== 'segment') continue;
      const segment = complex.segments[feature.index];
      const a = segment && complex.vertices[segment[0]];
      const b = segment && complex.vertices[segment[1]];
      if (isPlace(a) && isPlace(b)) {
        items.lines.push({ a, b, color, width: 2.2, dash: 'dashed' });
      }
    }
    for (const place of defect.at) {
      const at = [place[0] ?? Number.NaN, place[1] ?? Number.NaN] as const;
      if (!isPlace(at)) continue;
      items.marks.push({
        at,
        shape: defect.warning ? 'triangle' : 'disc',
        size: 22,
        fill: `${color}`,
        opacity: 0.16,
      });
      items.marks.push({
        at,
        shape: defect.warning ? 'triangle' : 'disc',
        size: 22,
        stroke: color,
        width: 2.2,
      });
    }
  }
  return items;
}
