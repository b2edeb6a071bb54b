/** What a pointer touches in the document, by id. Seeds lie above vertices, vertices above segments. */

import type { Point } from '../shared/types';
import { type Document, endsOf, type Ids, noIds } from './document';
import { nearestSegment, nearestVertex, reach } from './snapping';

export type Target = {
  readonly kind: 'vertices' | 'segments' | 'holes' | 'regions';
  readonly id: number;
};

/** A seed is a larger mark than a vertex. */
const seedReach = { mouse: 13, touch: 24 } as const;

export function hitTest(
  document: Document,
  at: Point,
  unitsPerPixel: number,
  touch: boolean,
): Target | null {
  const radius = touch ? reach.touch : reach.mouse;
  const vertex = nearestVertex(document, at, radius.vertex * unitsPerPixel);
  if (vertex) return { kind: 'vertices', id: vertex.id };
  let best: Target | null = null;
  let distance = (touch ? seedReach.touch : seedReach.mouse) * unitsPerPixel;
  for (const kind of ['holes', 'regions'] as const) {
    for (const seed of document[kind]) {
      const d = Math.hypot(seed.at[0] - at[0], seed.at[1] - at[1]);
      if (d < distance) {
        best = { kind, id: seed.id };
        distance = d;
      }
    }
  }
  if (best) return best;
  const segment = nearestSegment(document, at, radius.segment * unitsPerPixel);
  return segment ? { kind: 'segments', id: segment.id } : null;
}

/** Everything wholly inside the box. */
export function inBox(document: Document, p: Point, q: Point): Ids {
  const minX = Math.min(p[0], q[0]);
  const maxX = Math.max(p[0], q[0]);
  const minY = Math.min(p[1], q[1]);
  const maxY = Math.max(p[1], q[1]);
  const inside = (at: Point) => at[0] >= minX && at[0] <= maxX && at[1] >= minY && at[1] <= maxY;
  const places = (list: readonly { id: number; at: Point }[]) =>
    new Set(list.filter((e) => inside(e.at)).map((e) => e.id));
  return {
    vertices: places(document.vertices),
    segments: new Set(
      document.segments.filter((s) => endsOf(document, s)?.every(inside) ?? false).map((s) => s.id),
    ),
    holes: places(document.holes),
    regions: places(document.regions),
  };
}

export function union(a: Ids, b: Ids): Ids {
  return {
    vertices: new Set([...a.vertices, ...b.vertices]),
    segments: new Set([...a.segments, ...b.segments]),
    holes: new Set([...a.holes, ...b.holes]),
    regions: new Set([...a.regions, ...b.regions]),
  };
}

export function only(target: Target): Ids {
  return { ...noIds, [target.kind]: new Set([target.id]) };
}

export function toggled(ids: Ids, target: Target): Ids {
  const set = new Set(ids[target.kind]);
  if (!set.delete(target.id)) set.add(target.id);
  return { ...ids, [target.kind]: set };
}
