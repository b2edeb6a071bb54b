import { type MeshState, type Point3, Protecting } from '../shared/types.ts';
import { simplexName } from '../words.ts';
import type { CollarRegion } from './collar-region.ts';
import { Kind, NONE, type TraceEvent } from './event.ts';
import { type Ball3, circumball, distance3, point3 } from './geometry3.ts';
import type { Trace } from './trace.ts';

/** A collar simplex whose ball holds a circumcenter, so that this is refused (thesis, Theorem 6.11). */
export interface Stopper {
  readonly vertices: readonly number[]; // of a triangle of a face, or a piece of a segment
  readonly name: string;
  readonly ball: Ball3;
  readonly depth: number; // how far inside: 0 at the center of the ball, 1 on its sphere
}

/** kLengthSlack of the core: what lies on a sphere but for rounding lies in it. */
const SLACK = 1 + 1e-10;

/** The collar simplices of a state whose balls hold a point, the deepest first. O(collar simplices). */
export function stoppersOf(state: MeshState, region: CollarRegion, at: Point3): Stopper[] {
  const { facets, protection } = state;
  const found: Stopper[] = [];
  const ask = (vertices: readonly number[], name: () => string) => {
    const ball = circumball(vertices.map((v) => point3(state.coordinates, v)));
    if (!ball) return;
    const depth = distance3(ball.center, at) / ball.radius;
    if (depth < SLACK) found.push({ vertices, name: name(), ball, depth });
  };
  for (const n of facets ? region.facets : []) {
    const [a, b, c, face] = facets!.triangles.subarray(4 * n, 4 * n + 4) as unknown as Four;
    ask([a, b, c], () => simplexName([a, b, c], NONE, face));
  }
  for (let i = 0; protection && i < protection.liveCount; i++) {
    const n = protection.live[i]!;
    if (protection.kind[n] !== Protecting.subsegment) continue;
    const [a, b, , segment] = protection.elements.subarray(4 * n, 4 * n + 4) as unknown as Four;
    ask([a, b], () => simplexName([a, b], segment));
  }
  return found.sort((p, q) => p.depth - q.depth);
}

type Four = [number, number, number, number];

/** The event that refused a simplex; null if none did. O(events), and looks at refusals alone. */
export function refusalOf(trace: Trace, simplex: readonly number[]): TraceEvent | null {
  const wanted = new Set(simplex);
  for (let i = trace.eventCount - 1; i >= 0; i--) {
    if (trace.kind(i) !== Kind.refused) continue;
    const e = trace.event(i);
    if (e.simplex.length === wanted.size && e.simplex.every((v) => wanted.has(v))) return e;
  }
  return null;
}
