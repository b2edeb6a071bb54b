/** What a moment shows: the simplex in hand, its ball, its witness, a refused point, where it yields, what was born. */

import type { Moment, PictureTheme, Point } from '../../shared/types';
import { type Items, noItems } from '../items';

/** Corners of triangles by number, and places of vertices; null for what is not known. */
export interface MomentSource {
  vertex(v: number): Point | null;
}

export interface StarShape {
  readonly triangles: readonly (readonly [Point, Point, Point])[];
  /** Edges that belong to one triangle only: the rim of the cavity. */
  readonly rim: readonly (readonly [Point, Point])[];
}

/** Triangles given by the vertices and their places; the rim is in order of the triangles. */
export function starShape(
  triangles: readonly (readonly [number, number, number])[],
  place: (v: number) => Point,
): StarShape {
  const count = new Map<string, number>();
  const key = (a: number, b: number) => (a < b ? `${a} ${b}` : `${b} ${a}`);
  const edges: [number, number][] = [];
  for (const t of triangles) {
    for (let k = 0; k < 3; ++k) {
      const a = t[k]!;
      const b = t[(k + 1) % 3]!;
      count.set(key(a, b), (count.get(key(a, b)) ?? 0) + 1);
      edges.push([a, b]);
    }
  }
  return {
    triangles: triangles.map((t) => [place(t[0]), place(t[1]), place(t[2])] as const),
    rim: edges
      .filter(([a, b]) => count.get(key(a, b)) === 1)
      .map(([a, b]) => [place(a), place(b)] as const),
  };
}

function midpoint(a: Point, b: Point): Point {
  return [a[0] + (b[0] - a[0]) / 2, a[1] + (b[1] - a[1]) / 2];
}

/** Below the input's features. */
export function momentUnder(
  moment: Moment,
  star: StarShape | null,
  source: MomentSource,
  theme: PictureTheme,
): Items {
  const items = noItems();
  if (star && moment.kind === 'inserted') {
    for (const points of star.triangles) {
      items.polygons.push({ points, fill: theme.born, opacity: theme.dark ? 0.22 : 0.16 });
    }
    for (const [a, b] of star.rim) {
      items.lines.push({ a, b, color: theme.born, width: 1.8, opacity: 0.9 });
    }
  }
  const corners = moment.simplex.map((v) => source.vertex(v)).filter((p) => p !== null);
  if (corners.length === 3 && corners.length === moment.simplex.length) {
    const gone = moment.kind === 'inserted';
    if (!gone) items.polygons.push({ points: corners, fill: theme.acting, opacity: 0.5 });
    for (let k = 0; k < 3; ++k) {
      items.lines.push({
        a: corners[k]!,
        b: corners[(k + 1) % 3]!,
        color: theme.acting,
        width: gone ? 1.6 : 2.2,
        dash: gone ? 'dashed' : 'solid',
      });
    }
  } else if (corners.length === 2 && moment.simplex.length === 2) {
    const [a, b] = corners as [Point, Point];
    items.lines.push({ a, b, color: theme.acting, width: 11, opacity: 0.55 });
  }
  if (moment.yieldTo) {
    const a = source.vertex(moment.yieldTo[0]);
    const b = source.vertex(moment.yieldTo[1]);
    if (a && b) items.lines.push({ a, b, color: theme.yielding, width: 10, opacity: 0.5 });
  }
  if (moment.ball) {
    items.disks.push({
      ...moment.ball,
      stroke: theme.ball,
      width: 1.5,
      fill: theme.ball,
      fillOpacity: 0.06,
    });
  }
  return items;
}

/** Above the vertices. */
export function momentOver(moment: Moment, source: MomentSource, theme: PictureTheme): Items {
  const items = noItems();
  const corners = moment.simplex.map((v) => source.vertex(v)).filter((p) => p !== null);
  const witness = moment.witness === null ? null : source.vertex(moment.witness);
  if (witness) {
    const foot = nearestOf(corners, witness);
    if (foot) {
      items.lines.push({ a: witness, b: foot, color: theme.witness, width: 2.4, dash: 'dotted' });
    }
    items.marks.push({ at: witness, shape: 'disc', size: 19, stroke: theme.witness, width: 2.6 });
  }
  if (corners.length === 1 && moment.simplex.length === 1 && moment.kind !== 'inserted') {
    items.marks.push({ at: corners[0]!, shape: 'disc', size: 16, stroke: theme.acting, width: 3 });
  }
  if (moment.ghost && moment.yieldTo) {
    const a = source.vertex(moment.yieldTo[0]);
    const b = source.vertex(moment.yieldTo[1]);
    if (a && b) {
      const to = midpoint(a, b);
      items.lines.push({ a: moment.ghost, b: to, color: theme.yielding, width: 2.4 });
      items.marks.push({
        at: to,
        shape: 'arrow',
        size: 14,
        fill: theme.yielding,
        angle: Math.atan2(to[1] - moment.ghost[1], to[0] - moment.ghost[0]),
      });
    }
  }
  if (moment.ghost) {
    const at = moment.ghost;
    items.marks.push({
      at,
      shape: 'disc',
      size: 15,
      fill: theme.background,
      stroke: theme.ghost,
      width: 2,
    });
    items.marks.push({ at, shape: 'cross', size: 6, stroke: theme.ghost, width: 2 });
  }
  const landed = moment.vertex === null ? null : source.vertex(moment.vertex);
  if (landed) {
    items.marks.push({ at: landed, shape: 'disc', size: 17, stroke: theme.born, width: 2.4 });
  }
  return items;
}

/** Where the dotted line from a witness ends: middle of the simplex, as a witness belongs to all of it. */
function nearestOf(corners: readonly Point[], from: Point): Point | null {
  if (corners.length === 0) return null;
  if (corners.length === 1) return corners[0]!;
  if (corners.length === 2) return midpoint(corners[0]!, corners[1]!);
  let x = 0;
  let y = 0;
  for (const [cx, cy] of corners) {
    x += cx / corners.length;
    y += cy / corners.length;
  }
  return corners.some((c) => c[0] === from[0] && c[1] === from[1]) ? null : [x, y];
}
