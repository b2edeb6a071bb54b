/** What a moment shows in space: the simplex in hand, its ball, its witness, a refused point, where it yields, what was born. */

import { centroid, minus, plus } from '../replay/geometry3';
import {
  type Complex3,
  type MeshState,
  type Moment3,
  type PictureTheme,
  type Point3,
  Protecting,
} from '../shared/types';
import { noSpaceItems, type SpaceItems } from './items';
import { place } from './mesh-layer';
import { curvePoints, patchCorners } from './protection-geometry';

/** More elements that begin at once are not pointed to. */
const MOST_ELEMENTS = 200;

/** Beneath the vertices, hidden by what is before it. */
export function momentUnder3(
  moment: Moment3,
  state: MeshState,
  theme: PictureTheme,
  complex: Complex3 | null = null,
): SpaceItems {
  const items = noSpaceItems();
  const corners = cornersOf(moment.simplex, state);
  if (corners.length >= 3) {
    const gone = moment.kind === 'inserted';
    for (const triangle of trianglesOf(corners)) {
      if (!gone)
        items.triangles.push({
          corners: triangle,
          fill: theme.acting,
          opacity: corners.length === 3 ? 0.5 : 0.25,
        });
    }
    for (const [a, b] of edgesOf(corners)) {
      const dash = gone ? 'dashed' : 'solid';
      items.lines.push({ a, b, color: theme.acting, width: gone ? 1.6 : 2.4, dash });
    }
  } else if (corners.length === 2) {
    const [a, b] = corners as [Point3, Point3];
    items.lines.push({ a, b, color: theme.acting, width: 10, opacity: 0.6 });
  }
  if (moment.yieldTo) {
    const [a, b] = cornersOf(moment.yieldTo, state);
    if (a && b) items.lines.push({ a, b, color: theme.yielding, width: 10, opacity: 0.5 });
  }
  const yieldFace = moment.yieldFace ? cornersOf(moment.yieldFace, state) : [];
  for (const [a, b] of edgesOf(yieldFace))
    items.lines.push({ a, b, color: theme.yielding, width: 6, opacity: 0.5 });
  if (moment.ball)
    items.spheres.push({ ...moment.ball, color: theme.ball, opacity: 0.1, width: 1.5 });
  const { facets, protection } = state;
  // All that a whole step protects is no news of one place.
  const born = protection && moment.elements.length <= MOST_ELEMENTS ? moment.elements : [];
  for (const n of born) {
    const record = protection!.elements.subarray(4 * n, 4 * n + 4);
    const at = (v: number) => place(state, v);
    const kind = protection!.kind[n]!;
    const color = theme.born;
    if (kind === Protecting.spherePatch || kind === Protecting.tubePatch) {
      const patch = patchCorners(kind, record, at, complex);
      items.triangles.push({ corners: patch, fill: color, opacity: 0.35 });
      for (const [a, b] of edgesOf(patch)) items.lines.push({ a, b, color, width: 1.6 });
      continue;
    }
    const points = curvePoints(kind, record, at, complex);
    for (let i = 1; i < points.length; i++)
      items.lines.push({ a: points[i - 1]!, b: points[i]!, color, width: 4.5 });
  }
  for (const n of facets ? moment.facets : []) {
    const corners = cornersOf(facets!.triangles.subarray(4 * n, 4 * n + 3), state);
    if (corners.length < 3) continue;
    items.triangles.push({
      corners: corners as unknown as [Point3, Point3, Point3],
      fill: theme.born,
      opacity: theme.dark ? 0.3 : 0.24,
    });
    for (const [a, b] of edgesOf(corners))
      items.lines.push({ a, b, color: theme.born, width: 1.6 });
  }
  return items;
}

/** Above everything. `hides`: there is what may stand before the simplex in hand: its outline is seen through it. */
export function momentOver3(
  moment: Moment3,
  state: MeshState,
  theme: PictureTheme,
  hides: boolean,
): SpaceItems {
  const items = noSpaceItems();
  const corners = cornersOf(moment.simplex, state);
  if (hides) {
    for (const [a, b] of edgesOf(corners))
      items.lines.push({ a, b, color: theme.acting, width: 1.6, dash: 'dashed', opacity: 0.8 });
  }
  const [witness] = moment.witness === null ? [] : cornersOf([moment.witness], state);
  if (witness) {
    const isCorner = corners.some((c) => c.every((x, k) => x === witness[k]));
    if (corners.length > 0 && (!isCorner || moment.near !== null)) {
      // What it is near to, or the middle of the simplex, as a witness belongs to all of it.
      const [foot = centroid(corners)] =
        moment.near === null ? [] : cornersOf([moment.near], state);
      items.lines.push({ a: witness, b: foot, color: theme.witness, width: 2.4, dash: 'dotted' });
    }
    items.marks.push({ at: witness, shape: 'disc', size: 19, stroke: theme.witness, width: 2.6 });
  }
  if (corners.length === 1 && moment.kind !== 'inserted')
    items.marks.push({ at: corners[0]!, shape: 'disc', size: 16, stroke: theme.acting, width: 3 });
  const { ghost } = moment;
  const yieldTo = moment.yieldFace ?? moment.yieldTo;
  if (ghost && yieldTo) {
    const to = cornersOf(yieldTo, state);
    if (to.length === yieldTo.length) {
      const [a, b, c] = to as [Point3, Point3, Point3?];
      const half = plus(a, minus(b, a), 0.5);
      const at = c ? plus(half, minus(c, half), 1 / 3) : half;
      items.lines.push({ a: ghost, b: at, color: theme.yielding, width: 2.4 });
      items.marks.push({ at, from: ghost, shape: 'arrow', size: 14, fill: theme.yielding });
    }
  }
  if (ghost) {
    const ring = { fill: theme.background, stroke: theme.ghost, width: 2 };
    items.marks.push({ at: ghost, shape: 'disc', size: 15, ...ring });
    items.marks.push({ at: ghost, shape: 'cross', size: 6, stroke: theme.ghost, width: 2 });
  }
  const [landed] = moment.vertex === null ? [] : cornersOf([moment.vertex], state);
  if (landed)
    items.marks.push({ at: landed, shape: 'disc', size: 17, stroke: theme.born, width: 2.4 });
  return items;
}

/** Where a moment takes place. */
export function placesOf(moment: Moment3, state: MeshState): Point3[] {
  const { simplex, witness, near, vertex, yieldTo, ball, ghost, facets, elements } = moment;
  const drawn =
    elements.length <= MOST_ELEMENTS && state.protection
      ? Array.from(elements).flatMap((n) => [
          ...state.protection!.elements.subarray(4 * n, 4 * n + 2),
        ])
      : [];
  const born = state.facets
    ? Array.from(facets).flatMap((n) => [...state.facets!.triangles.subarray(4 * n, 4 * n + 3)])
    : [];
  const named = [witness, near, vertex].filter((v) => v !== null);
  const places = cornersOf([...simplex, ...named, ...(yieldTo ?? []), ...born, ...drawn], state);
  if (ghost) places.push(ghost);
  if (ball) {
    const { center, radius } = ball;
    places.push(plus(center, [radius, radius, radius]), plus(center, [radius, radius, radius], -1));
  }
  return places;
}

function cornersOf(vertices: ArrayLike<number>, state: MeshState): Point3[] {
  return Array.from(vertices)
    .filter((v) => v < state.vertexCount)
    .map((v) => place(state, v));
}

export function edgesOf(corners: readonly Point3[]): [Point3, Point3][] {
  return corners.flatMap((a, i) => corners.slice(i + 1).map((b): [Point3, Point3] => [a, b]));
}

export function trianglesOf(corners: readonly Point3[]): (readonly [Point3, Point3, Point3])[] {
  const [a, b, c, d] = corners as readonly [Point3, Point3, Point3, Point3 | undefined];
  if (!d) return [[a, b, c]];
  return [
    [a, b, c],
    [a, b, d],
    [a, c, d],
    [b, c, d],
  ];
}
