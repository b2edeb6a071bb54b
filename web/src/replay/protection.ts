import type { CollarSimplex, Intestine, Pair } from '../shared/overlay-facts.ts';
import { Label, type MeshState } from '../shared/types.ts';
import { Kind, NONE, Reason } from './event.ts';
import { distance, point } from './geometry.ts';
import type { Trace } from './trace.ts';

/** A vertex at distance d of the input vertex that it protects (thesis, step 1b of Algorithm 5.1). */
interface ProtectingVertex {
  readonly vertex: number;
  readonly born: number;
  readonly onSegment: boolean;
}

interface Circle {
  readonly center: number;
  readonly radius: number;
  readonly vertices: ProtectingVertex[];
}

/** Protecting circles span no arc of more than a quarter turn (thesis 5.3.1); wider gaps lie outside the domain. */
const QUARTER_TURN = Math.PI / 2 + 1e-6;

/** Collars and intestines as a trace tells of them: read once, event by event, as it grows. */
export class Protection {
  private readonly circles = new Map<number, Circle>();
  private readonly centers = new Map<number, number>(); // by vertex on a circle
  private next = 0;

  constructor(private readonly trace: Trace) {}

  /** The collar simplices at a position: end segments from a protected input vertex to the vertex at distance d. */
  collars(position: number): CollarSimplex[] {
    this.update();
    const found: CollarSimplex[] = [];
    for (const { center, vertices } of this.circles.values()) {
      for (const { vertex, born, onSegment } of vertices) {
        if (onSegment && born < position) found.push({ center, end: vertex });
      }
    }
    return found;
  }

  /** The protecting circles at a position, cut into arcs; arcs that the mesh knows to lie outside the domain are left out. */
  intestines(position: number, state: MeshState): Intestine[] {
    this.update();
    const outside = this.outsideFans(state);
    const found: Intestine[] = [];
    for (const { center, radius, vertices } of this.circles.values()) {
      const live = vertices.filter((v) => v.born < position).map((v) => v.vertex);
      if (live.length === 0) continue;
      const arcs = this.arcs(center, live).filter(([a, b]) => !outside.has(fan(center, a, b)));
      found.push({ center, radius, arcs });
    }
    return found;
  }

  /** The input vertex whose angle a vertex protects; NONE for all others. */
  centerOf(vertex: number): number {
    this.update();
    return this.centers.get(vertex) ?? NONE;
  }

  private arcs(center: number, vertices: readonly number[]): Pair[] {
    const xy = this.trace.coordinates.data;
    const [cx, cy] = point(xy, center);
    const angle = new Map(
      vertices.map((v) => [v, Math.atan2(xy[2 * v + 1]! - cy, xy[2 * v]! - cx)] as const),
    );
    const order = [...vertices].sort((a, b) => angle.get(a)! - angle.get(b)!);
    const arcs: Pair[] = [];
    for (const [i, a] of order.entries()) {
      const b = order[(i + 1) % order.length]!;
      const turn = (angle.get(b)! - angle.get(a)! + 2 * Math.PI) % (2 * Math.PI);
      if (a !== b && turn > 0 && turn <= QUARTER_TURN) arcs.push([a, b]);
    }
    return arcs;
  }

  /** Fans between an input vertex and an arc that are triangles outside the domain. */
  private outsideFans(state: MeshState): Set<string> {
    const found = new Set<string>();
    for (let i = 0; i < state.liveCellCount; i++) {
      const n = state.liveCells[i]!;
      if (state.cellLabel[n] !== Label.outside) continue;
      for (let k = 0; k < 3; k++) {
        const center = state.cells[3 * n + k]!;
        if (!this.circles.has(center)) continue;
        const a = state.cells[3 * n + ((k + 1) % 3)]!;
        const b = state.cells[3 * n + ((k + 2) % 3)]!;
        found.add(fan(center, a, b));
      }
    }
    return found;
  }

  private update(): void {
    const { trace } = this;
    for (; this.next < trace.eventCount; this.next++) {
      if (trace.kind(this.next) !== Kind.inserted) continue;
      const reason = trace.reason(this.next);
      const isOne =
        reason === Reason.collar || reason === Reason.circle || reason === Reason.arcMidpoint;
      if (!isOne) continue;
      const e = trace.event(this.next);
      const onSegment = reason === Reason.collar;
      let center = e.center;
      if (onSegment) center = this.nearestInputEnd(e.simplex, e.at);
      else if (reason === Reason.circle) center = this.circleThrough(e.at);
      if (center === NONE) continue;
      this.centers.set(e.subject, center);
      let circle = this.circles.get(center);
      if (!circle) {
        const radius = distance(point(trace.coordinates.data, center), e.at);
        circle = { center, radius, vertices: [] };
        this.circles.set(center, circle);
      }
      circle.vertices.push({ vertex: e.subject, born: this.next, onSegment });
    }
  }

  /** Of the circles that collar vertices lie on: the one that passes nearest by, by a part of its radius. */
  private circleThrough(at: readonly [number, number]): number {
    let nearest = NONE;
    let best = Number.POSITIVE_INFINITY;
    for (const { center, radius } of this.circles.values()) {
      const d = distance(point(this.trace.coordinates.data, center), at);
      const off = Math.abs(d - radius) / radius;
      if (off < best) {
        best = off;
        nearest = center;
      }
    }
    return nearest;
  }

  /** d is less than half of the segment (0.45 N), so the nearer input vertex is the one that is protected. */
  private nearestInputEnd(simplex: readonly number[], at: readonly [number, number]): number {
    const xy = this.trace.coordinates.data;
    let nearest = NONE;
    for (const v of simplex) {
      if (v >= this.trace.input.vertexCount) continue;
      if (nearest === NONE || distance(point(xy, v), at) < distance(point(xy, nearest), at)) {
        nearest = v;
      }
    }
    return nearest;
  }
}

function fan(center: number, a: number, b: number): string {
  return a < b ? `${center} ${a} ${b}` : `${center} ${b} ${a}`;
}
