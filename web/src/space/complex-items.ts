/** The input in space as a display list: features in ink, seeds, and defects at their places. */

import {
  type Complex3,
  type DefectMark,
  type PictureTheme,
  type Point3,
  VertexKind,
} from '../shared/types';
import { noSpaceItems, type SpaceItems } from './items';
import { vertexMark3 } from './marks';
import { segmentWidth } from './mesh-layer';

function isPlace(p: Point3 | undefined): p is Point3 {
  return p?.every(Number.isFinite) === true;
}

/** `meshed`: the mesh draws its subsegments in place of the segments. */
export function complexItems3(complex: Complex3, theme: PictureTheme, meshed: boolean): SpaceItems {
  const items = noSpaceItems();
  const { vertices } = complex;
  if (!meshed) {
    for (const [a, b] of sidesOf(complex)) {
      const [p, q] = [vertices[a], vertices[b]];
      if (isPlace(p) && isPlace(q))
        items.lines.push({ a: p, b: q, color: theme.ink, width: segmentWidth });
    }
  }
  for (const at of vertices) {
    if (isPlace(at)) items.marks.push(vertexMark3(VertexKind.input, at, theme));
  }
  for (const at of [...complex.holes, ...complex.faces.flatMap((f) => f.holes)]) {
    if (!isPlace(at)) continue;
    const ring = { fill: theme.background, stroke: theme.hole, width: 1.6 };
    items.marks.push({ at, shape: 'disc', size: 14, ...ring });
    items.marks.push({ at, shape: 'cross', size: 5, stroke: theme.hole, width: 2 });
  }
  for (const { at, label } of complex.regions) {
    if (!isPlace(at)) continue;
    const { background, ink } = theme;
    items.marks.push({ at, shape: 'diamond', size: 15, fill: background, stroke: ink, width: 1.5 });
    items.texts.push({
      at,
      text: String(label),
      size: 11.5,
      color: ink,
      halo: background,
      dx: 16,
      dy: -4,
    });
  }
  return items;
}

/** Segments and sides of loops, each once: readers list the sides among the segments, but not of bad input. */
function* sidesOf(complex: Complex3): Generator<readonly [number, number]> {
  const known = new Set<string>();
  const isNew = (a: number, b: number) => {
    const name = a < b ? `${a} ${b}` : `${b} ${a}`;
    if (known.has(name)) return false;
    known.add(name);
    return true;
  };
  for (const [a, b] of complex.segments) {
    isNew(a, b);
    yield [a, b];
  }
  for (const { loops } of complex.faces) {
    for (const loop of loops) {
      for (const [i, a] of loop.entries()) {
        const b = loop[(i + 1) % loop.length]!;
        if (a !== b && isNew(a, b)) yield [a, b];
      }
    }
  }
}

/** Above everything: a ring at each place, the features that offend in its color. `triangles` fill the faces. */
export function defectItems3(
  complex: Complex3,
  triangles: Uint32Array,
  defects: readonly DefectMark[],
  theme: PictureTheme,
): SpaceItems {
  const items = noSpaceItems();
  const at = (v: number) => complex.vertices[v];
  for (const defect of defects) {
    const color = defect.warning ? theme.warning : theme.defect;
    const dash = (a: Point3 | undefined, b: Point3 | undefined) => {
      if (isPlace(a) && isPlace(b)) items.lines.push({ a, b, color, width: 2.4, dash: 'dashed' });
    };
    for (const { kind, index } of defect.features) {
      if (kind === 'segment') {
        const segment = complex.segments[index];
        if (segment) dash(at(segment[0]), at(segment[1]));
      } else if (kind === 'face') {
        for (const loop of complex.faces[index]?.loops ?? [])
          for (const [i, v] of loop.entries()) dash(at(v), at(loop[(i + 1) % loop.length]!));
        for (let t = 0; t < triangles.length; t += 4) {
          if (triangles[t + 3] !== index) continue;
          const corners = [at(triangles[t]!), at(triangles[t + 1]!), at(triangles[t + 2]!)];
          if (corners.every(isPlace))
            items.triangles.push({ corners: corners as never, fill: color, opacity: 0.22 });
        }
      }
    }
    const shape = defect.warning ? 'triangle' : 'disc';
    for (const place of defect.at) {
      const where = [
        place[0] ?? Number.NaN,
        place[1] ?? Number.NaN,
        place[2] ?? Number.NaN,
      ] as const;
      if (!isPlace(where)) continue;
      items.marks.push({ at: where, shape, size: 22, fill: color, opacity: 0.16 });
      items.marks.push({ at: where, shape, size: 22, stroke: color, width: 2.2 });
    }
  }
  return items;
}
