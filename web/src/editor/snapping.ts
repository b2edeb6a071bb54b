/** Snapping: where a pointer means to be. Vertex first, then segment, then 45 degrees, then grid. Pure. */

import { distanceToSegment } from '../picture/pick';
import { roundStep } from '../picture/view';
import type { Point, SnapOptions } from '../shared/types';
import { type Document, endsOf } from './document';

export interface Snapped {
  readonly at: Point;
  readonly kind: 'vertex' | 'segment' | 'grid' | 'angle' | null;
  readonly vertex: number | null; // id
  readonly segment: number | null; // id, for kind 'segment'
}

export interface SnapQuery {
  readonly at: Point;
  readonly unitsPerPixel: number;
  readonly touch: boolean;
  /** Where the line that is being drawn begins: for 45 degrees. */
  readonly from: Point | null;
  /** Vertices that are being moved, and do not attract; nor do their segments. */
  readonly exclude: ReadonlySet<number> | null;
  /** Shift: 45 degrees, however far. */
  readonly forceAngle: boolean;
  /** Alt: nothing attracts. */
  readonly free: boolean;
}

/** Distances in pixels within which things attract; a finger is less exact. */
export const reach = {
  mouse: { vertex: 11, segment: 8 },
  touch: { vertex: 22, segment: 16 },
} as const;
/** A direction within this of a multiple of 45 degrees is taken to be meant. */
const angleTolerance = (4 * Math.PI) / 180;
/** Grid lines are at least so many pixels apart: the step that the picture draws. */
const gridPixels = 18;

export function gridStepOf(options: SnapOptions, unitsPerPixel: number): number {
  return options.gridStep > 0 ? options.gridStep : roundStep(gridPixels * unitsPerPixel);
}

/** The multiple of `step` next to a value: for steps 1, 2, 5 times a power of ten the double next to the decimal. */
export function roundTo(value: number, step: number): number {
  const k = Math.round(value / step);
  const inverse = Math.round(1 / step);
  const rounded = step < 1 && Math.abs(inverse * step - 1) < 1e-9 ? k / inverse : k * step;
  return rounded === 0 ? 0 : rounded; // no negative zero
}

/** A place as short in decimals as a tenth of a pixel allows: nobody drew the digits behind. */
export function tidy(p: Point, unitsPerPixel: number): Point {
  const step = 10 ** Math.floor(Math.log10(unitsPerPixel));
  return [roundTo(p[0], step), roundTo(p[1], step)];
}

export function snapPoint(document: Document, options: SnapOptions, query: SnapQuery): Snapped {
  const { at, unitsPerPixel, from } = query;
  const none: Snapped = { at: tidy(at, unitsPerPixel), kind: null, vertex: null, segment: null };
  if (query.free) return none;
  const radius = query.touch ? reach.touch : reach.mouse;
  if (options.vertex) {
    const vertex = nearestVertex(document, at, radius.vertex * unitsPerPixel, query.exclude);
    if (vertex) return { at: vertex.at, kind: 'vertex', vertex: vertex.id, segment: null };
  }
  const direction = from && (query.forceAngle || options.angle) ? turn(query) : null;
  if (options.segment && !query.forceAngle) {
    const hit = nearestSegment(document, at, radius.segment * unitsPerPixel, query.exclude);
    if (hit) {
      const [a, b] = hit.ends;
      const place =
        (direction &&
          from &&
          crossLine(from, direction, a, b, at, radius.segment * unitsPerPixel)) ??
        onGrid(options, project(at, a, b), a, b, unitsPerPixel);
      return { at: place, kind: 'segment', vertex: null, segment: hit.id };
    }
  }
  if (direction && from) {
    return {
      at: alongDirection(query, options, from, direction),
      kind: 'angle',
      vertex: null,
      segment: null,
    };
  }
  if (options.grid) {
    const step = gridStepOf(options, unitsPerPixel);
    return {
      at: [roundTo(at[0], step), roundTo(at[1], step)],
      kind: 'grid',
      vertex: null,
      segment: null,
    };
  }
  return none;
}

export function nearestVertex(
  document: Document,
  p: Point,
  radius: number,
  exclude: ReadonlySet<number> | null = null,
): { readonly id: number; readonly at: Point } | null {
  let best: { id: number; at: Point } | null = null;
  let distance = radius;
  for (const vertex of document.vertices) {
    if (exclude?.has(vertex.id)) continue;
    const d = Math.hypot(vertex.at[0] - p[0], vertex.at[1] - p[1]);
    if (d < distance || (d === distance && !best)) {
      best = vertex;
      distance = d;
    }
  }
  return best;
}

export function nearestSegment(
  document: Document,
  p: Point,
  radius: number,
  exclude: ReadonlySet<number> | null = null,
): { readonly id: number; readonly ends: readonly [Point, Point] } | null {
  let best: { id: number; ends: readonly [Point, Point] } | null = null;
  let distance = radius;
  for (const segment of document.segments) {
    if (exclude?.has(segment.a) || exclude?.has(segment.b)) continue;
    const ends = endsOf(document, segment);
    if (!ends) continue;
    const d = distanceToSegment(p, ends[0], ends[1]);
    if (d < distance || (d === distance && !best)) {
      best = { id: segment.id, ends };
      distance = d;
    }
  }
  return best;
}

type Turn = readonly [-1 | 0 | 1, -1 | 0 | 1];

/** The multiple of 45 degrees that the pointer is near, as signs of dx and dy. */
function turn(query: SnapQuery): Turn | null {
  const from = query.from!;
  const dx = query.at[0] - from[0];
  const dy = query.at[1] - from[1];
  if (dx === 0 && dy === 0) return null;
  const angle = Math.atan2(dy, dx);
  const eighth = Math.PI / 4;
  const k = Math.round(angle / eighth);
  if (!query.forceAngle && Math.abs(angle - k * eighth) > angleTolerance) return null;
  const turns: Turn[] = [
    [1, 0],
    [1, 1],
    [0, 1],
    [-1, 1],
    [-1, 0],
    [-1, -1],
    [0, -1],
    [1, -1],
  ];
  return turns[(k + 8) % 8]!;
}

/** On the ray from `from`; the moving coordinate on the grid if the grid is on, so that both are met. */
function alongDirection(
  query: SnapQuery,
  options: SnapOptions,
  from: Point,
  [sx, sy]: Turn,
): Point {
  const dx = query.at[0] - from[0];
  const dy = query.at[1] - from[1];
  const step = options.grid
    ? gridStepOf(options, query.unitsPerPixel)
    : 10 ** Math.floor(Math.log10(query.unitsPerPixel));
  if (sy === 0) return [roundTo(from[0] + dx, step), from[1]];
  if (sx === 0) return [from[0], roundTo(from[1] + dy, step)];
  const length = (Math.abs(dx) + Math.abs(dy)) / 2;
  const x = roundTo(from[0] + sx * length, step);
  const moved = Math.abs(x - from[0]);
  const y = from[1] + sy * moved;
  const round = 10 ** Math.floor(Math.log10(query.unitsPerPixel) - 3);
  return [x, roundTo(y, round)];
}

function project(p: Point, a: Point, b: Point): Point {
  const dx = b[0] - a[0];
  const dy = b[1] - a[1];
  const t = ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / (dx * dx + dy * dy);
  const u = Math.min(Math.max(t, 0), 1);
  return u === 0 ? a : u === 1 ? b : [a[0] + u * dx, a[1] + u * dy];
}

/** On an axis-parallel segment the free coordinate takes to the grid. */
function onGrid(options: SnapOptions, p: Point, a: Point, b: Point, unitsPerPixel: number): Point {
  const step = options.grid
    ? gridStepOf(options, unitsPerPixel)
    : 10 ** Math.floor(Math.log10(unitsPerPixel));
  const inside = (v: number, from: number, to: number) =>
    v > Math.min(from, to) && v < Math.max(from, to);
  if (a[1] === b[1]) {
    const x = roundTo(p[0], step);
    return inside(x, a[0], b[0]) ? [x, a[1]] : p;
  }
  if (a[0] === b[0]) {
    const y = roundTo(p[1], step);
    return inside(y, a[1], b[1]) ? [a[0], y] : p;
  }
  return p;
}

/** Where the ray of a 45 degree direction meets segment ab, if near the pointer. */
function crossLine(
  from: Point,
  [sx, sy]: Turn,
  a: Point,
  b: Point,
  near: Point,
  radius: number,
): Point | null {
  const rx = b[0] - a[0];
  const ry = b[1] - a[1];
  const denominator = sx * ry - sy * rx;
  if (denominator === 0) return null;
  const u = ((from[0] - a[0]) * sy - (from[1] - a[1]) * sx) / -denominator;
  if (!(u > 0 && u < 1)) return null;
  const p: Point = [a[0] + u * rx, a[1] + u * ry];
  return Math.hypot(p[0] - near[0], p[1] - near[1]) <= 2 * radius ? p : null;
}
