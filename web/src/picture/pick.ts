/**
 * What lies under a place of the canvas, in double precision. A scan with a test of the box first takes about a millisecond for
 * 100,000 triangles; that is once a click, so no index has to be kept while the mesh changes.
 */

import type { Complex2, Hit, Point } from '../shared/types';
import type { MeshModel } from './mesh-model';

/** Distances in pixels within which a vertex or segment is meant. */
export interface PickReach {
  readonly vertex: number;
  readonly segment: number;
}

export function distanceToSegment(p: Point, a: Point, b: Point): number {
  const dx = b[0] - a[0];
  const dy = b[1] - a[1];
  const lengthSquared = dx * dx + dy * dy;
  const t = lengthSquared > 0 ? ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / lengthSquared : 0;
  if (t <= 0) return Math.hypot(p[0] - a[0], p[1] - a[1]);
  if (t >= 1) return Math.hypot(p[0] - b[0], p[1] - b[1]);
  return Math.abs(dx * (p[1] - a[1]) - dy * (p[0] - a[0])) / Math.sqrt(lengthSquared);
}

/** Index of the nearest place within `reach`, or null. Ties go to the lower index. */
export function nearestPoint(p: Point, places: readonly Point[], reach: number): number | null {
  let best: number | null = null;
  let bestDistance = reach;
  places.forEach((q, i) => {
    const d = Math.hypot(p[0] - q[0], p[1] - q[1]);
    if (d < bestDistance || (d === bestDistance && best === null)) {
      best = i;
      bestDistance = d;
    }
  });
  return best;
}

export function pickComplex(complex: Complex2, p: Point, scale: number, reach: PickReach): Hit {
  const vertex = nearestPoint(p, complex.vertices, reach.vertex / scale);
  const hole = nearestPoint(p, complex.holes, reach.vertex / scale);
  const region = nearestPoint(
    p,
    complex.regions.map((r) => r.at),
    reach.vertex / scale,
  );
  let subsegment: number | null = null;
  let best = reach.segment / scale;
  complex.segments.forEach(([v, w], i) => {
    const a = complex.vertices[v];
    const b = complex.vertices[w];
    if (!a || !b) return;
    const d = distanceToSegment(p, a, b);
    if (d <= best) {
      best = d;
      subsegment = i;
    }
  });
  return { vertex, subsegment, triangle: null, hole, region };
}

/** Vertices, subsegments and triangles by their numbers in the trace; hidden outside triangles are not met. */
export function pickMesh(
  model: MeshModel,
  p: Point,
  scale: number,
  reach: PickReach,
  outside: boolean,
): Hit {
  const xy = model.coordinates;
  let vertex: number | null = null;
  let best = reach.vertex / scale;
  for (let v = 0; v < model.vertexCount; ++v) {
    if (!model.vertexAlive[v]) continue;
    const dx = Math.abs(xy[2 * v]! - p[0]);
    if (dx > best) continue;
    const d = Math.hypot(dx, xy[2 * v + 1]! - p[1]);
    if (d < best) {
      best = d;
      vertex = v;
    }
  }
  let subsegment: number | null = null;
  best = reach.segment / scale;
  for (let s = 0; s < model.subsegmentCount; ++s) {
    const a = model.subsegments[3 * s]!;
    const b = model.subsegments[3 * s + 1]!;
    const d = distanceToSegment(p, [xy[2 * a]!, xy[2 * a + 1]!], [xy[2 * b]!, xy[2 * b + 1]!]);
    if (d <= best) {
      best = d;
      subsegment = model.subsegmentSlots.numbers[s]!;
    }
  }
  return {
    vertex,
    subsegment,
    triangle: pickTriangle(model, p, outside),
    hole: null,
    region: null,
  };
}

function pickTriangle(model: MeshModel, p: Point, outside: boolean): number | null {
  const xy = model.coordinates;
  const [x, y] = p;
  for (let slot = 0; slot < model.triangleCount; ++slot) {
    if (!outside && model.labels[slot] === 2) continue;
    const a = 2 * model.triangles[3 * slot]!;
    const b = 2 * model.triangles[3 * slot + 1]!;
    const c = 2 * model.triangles[3 * slot + 2]!;
    const ax = xy[a]! - x;
    const bx = xy[b]! - x;
    const cx = xy[c]! - x;
    if ((ax > 0 && bx > 0 && cx > 0) || (ax < 0 && bx < 0 && cx < 0)) continue;
    const ay = xy[a + 1]! - y;
    const by = xy[b + 1]! - y;
    const cy = xy[c + 1]! - y;
    if (ax * by - ay * bx >= 0 && bx * cy - by * cx >= 0 && cx * ay - cy * ax >= 0) {
      return model.triangleSlots.numbers[slot]!;
    }
  }
  return null;
}
