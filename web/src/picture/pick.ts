/** What lies under a place of the canvas, in double precision. The mesh is asked through its index, the input one by one. */

import { type Complex2, type Hit, Label, type Point } from '../shared/types';
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
  const { coordinates: xy, subsegments, index } = model;
  const place = (v: number): Point => [xy[2 * v]!, xy[2 * v + 1]!];
  const vertex = index.vertexNear(p, reach.vertex / scale);
  const subsegment = index.subsegmentNear(p, reach.segment / scale, (s) =>
    distanceToSegment(p, place(subsegments[3 * s]!), place(subsegments[3 * s + 1]!)),
  );
  const triangle = index.triangleAt(p, (t) => !outside && model.labels[t] === Label.outside);
  return {
    vertex: vertex < 0 ? null : vertex,
    subsegment: subsegment < 0 ? null : model.subsegmentSlots.numbers[subsegment]!,
    triangle: triangle < 0 ? null : model.triangleSlots.numbers[triangle]!,
    hole: null,
    region: null,
  };
}
