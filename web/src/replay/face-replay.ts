import type { FaceCollar, Pair } from '../shared/overlay-facts.ts';
import {
  type Complex2,
  type Complex3,
  type Face3,
  type Hit,
  type MeshChange,
  type MeshState,
  type Moment,
  type Moment3,
  NEVER,
  type Point,
  type Point3,
  Protecting,
} from '../shared/types.ts';
import type { CollarRegion } from './collar-region.ts';
import { Kind, NONE } from './event.ts';
import { type FacePlane, heightOver, toPlane } from './face-plane.ts';
import { type Ball3, centroid, point3 } from './geometry3.ts';
import type { Lives } from './lives.ts';
import type { Trace } from './trace.ts';

/** A vertex that a moment speaks of and that does not lie in the face: where it is over the plane. */
export interface Outsider {
  readonly vertex: number;
  readonly at: Point; // its projection
  readonly height: number; // signed, positive on the normal's side
  readonly near: Point | null; // the vertex of the face that it is too near to
}

/**
 * One face of a run in space as a mesh of the plane, in the frame of the core, at any position of the trace. Vertices and subsegments
 * keep the numbers that they have in space; triangles have numbers of their own, in order of birth (`facetOf` tells those of space).
 */
export class FaceReplay {
  /** Numbers of the face's triangles among all facets: ascending. */
  readonly facets: number[] = [];
  private readonly subsegments: number[] = [];
  private readonly own: ReadonlySet<number>; // input segments in the face
  private nextFacet = 0;
  private nextSubsegment = 0;
  private cells = new Uint32Array(3 * 256);
  private label = new Uint8Array(256);
  private born = new Uint32Array(256);
  private died = new Uint32Array(256);
  private live = new Uint32Array(256);
  private coordinates = new Float64Array(0);
  private vertexBorn = new Uint32Array(0);

  constructor(
    readonly trace: Trace,
    readonly complex: Complex3,
    readonly face: number,
    readonly plane: FacePlane,
  ) {
    this.own = new Set(segmentsOf(complex, face));
  }

  /** Whether a vertex belongs to the face's triangulation, now or later. */
  has(v: number): boolean {
    this.update();
    return v < this.vertexBorn.length && this.vertexBorn[v] !== NEVER;
  }

  hasSubsegment(n: number): boolean {
    this.update();
    return this.subsegments.includes(n) && this.isIn(n);
  }

  facetOf(triangle: number): number {
    return this.facets[triangle] ?? NONE;
  }

  /** The face's number of a triangle; -1 if it is of another face. */
  triangleOf(facet: number): number {
    this.update();
    const { facets } = this;
    let low = 0;
    let high = facets.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (facets[middle]! < facet) low = middle + 1;
      else high = middle;
    }
    return facets[low] === facet ? low : -1;
  }

  /** The middle of what was picked, in space. */
  placeOf({ vertex, subsegment, triangle }: Hit): Point3 | null {
    const { trace } = this;
    const of = (vertices: ArrayLike<number>) =>
      centroid(Array.from(vertices, (v) => point3(trace.coordinates.data, v)));
    if (vertex !== null) return of([vertex]);
    if (subsegment !== null)
      return of(trace.subsegments.data.subarray(3 * subsegment, 3 * subsegment + 2));
    return triangle === null ? null : of(this.cells.subarray(3 * triangle, 3 * triangle + 3));
  }

  state(position: number): MeshState {
    this.update();
    const { trace, facets } = this;
    const lives = trace.facetLives!;
    let liveCellCount = 0;
    for (const [k, n] of facets.entries()) {
      this.died[k] = lives.died.data[n]!;
      if (this.born[k]! < position && position <= this.died[k]!) this.live[liveCellCount++] = k;
    }
    const liveSubsegments = Uint32Array.from(
      this.subsegments.filter(
        (n) =>
          trace.subsegmentBorn.at(n) < position &&
          position <= trace.subsegmentDied.at(n) &&
          this.isIn(n),
      ),
    );
    return {
      dimension: 2,
      position,
      vertexCount: this.vertexBorn.length,
      coordinates: this.coordinates,
      vertexKind: trace.vertexKind.data,
      vertexBorn: this.vertexBorn,
      vertexStep: trace.vertexStep.data,
      cellCount: facets.length,
      cells: this.cells,
      cellLabel: this.label,
      cellBorn: this.born,
      cellDied: this.died,
      liveCells: this.live,
      liveCellCount,
      subsegments: trace.subsegments.data,
      subsegmentBorn: trace.subsegmentBorn.data,
      liveSubsegments,
      liveSubsegmentCount: liveSubsegments.length,
      facets: null,
    };
  }

  /** What of the collars of a state in space lies in the face. */
  collar(state: MeshState, region: CollarRegion): FaceCollar | null {
    const { protection, facets } = state;
    if (!protection || !facets || protection.liveCount === 0) return null;
    this.update();
    const found = {
      triangles: region.facets
        .filter((n) => facets.triangles[4 * n + 3] === this.face)
        .map((n) => Array.from(facets.triangles.subarray(4 * n, 4 * n + 3))),
      pieces: [] as Pair[],
      segments: [] as Pair[],
      arcs: [] as { center: number; ends: Pair }[],
    };
    for (let i = 0; i < protection.liveCount; i++) {
      const n = protection.live[i]!;
      const at = 4 * n;
      const ends: Pair = [protection.elements[at]!, protection.elements[at + 1]!];
      const carrier = protection.elements[at + 3]!;
      const kind = protection.kind[n];
      if (kind === Protecting.subsegment) {
        if (this.own.has(carrier)) found.pieces.push(ends);
      } else if (carrier !== this.face) continue;
      else if (kind === Protecting.collarSegment) found.segments.push(ends);
      else if (kind === Protecting.collarArc)
        found.arcs.push({ center: protection.elements[at + 2]!, ends });
    }
    return found;
  }

  /** What event i changed in the face, for the motion; null if nothing. */
  change(i: number, forward: boolean): MeshChange | null {
    this.update();
    const changed = this.trace.facetLives!.changed(i);
    const own = (list: Uint32Array) =>
      Uint32Array.from(Array.from(list, (n) => this.triangleOf(n)).filter((k) => k >= 0));
    const died = own(changed.died);
    const born = own(changed.born);
    if (died.length + born.length === 0) return null;
    return forward
      ? { died, born, vertex: -1, forward }
      : { died: born, born: died, vertex: -1, forward };
  }

  /** The moment of a position as far as it is about what lies in this face; null if nothing of it is. */
  moment(moment: Moment3, position: number): Moment | null {
    const { simplex, witness, vertex, ghost, ball } = moment;
    if (moment.kind === 'face-changed' || moment.kind === 'protection')
      return moment.face === this.face ? this.follows(moment, position) : null;
    const inFace = simplex.length <= 3 && simplex.length > 0 && simplex.every((v) => this.has(v));
    const acts = inFace && (simplex.length < 3 || moment.face === this.face);
    const landed = vertex !== null && this.has(vertex);
    const seen = witness !== null && this.has(witness);
    if (!acts && !landed && !seen) return null;
    return {
      dimension: 2,
      kind: moment.kind,
      rule: moment.rule,
      simplex: acts ? simplex : [],
      witness: seen ? witness : null,
      ball: acts && ball ? this.cut(ball) : null,
      ghost: acts && ghost ? toPlane(this.plane, ghost) : null,
      yieldTo: acts && moment.yieldTo?.every((v) => this.has(v)) ? moment.yieldTo : null,
      vertex: landed ? vertex : null,
      change: null,
      sentence: moment.sentence,
    };
  }

  /** Where the plane meets a ball: centers of balls may lie beside it, in the spindle of a subsegment. */
  private cut({ center, radius }: Ball3): Moment['ball'] {
    const height = heightOver(this.plane, center);
    if (!(Math.abs(height) < radius)) return null;
    return {
      center: toPlane(this.plane, center),
      radius: Math.sqrt((radius - height) * (radius + height)),
    };
  }

  /** The face's triangulation follows an insertion: shown as that. */
  private follows(moment: Moment3, position: number): Moment {
    const { trace } = this;
    let i = position - 2;
    while (i >= 0 && (trace.kind(i) === Kind.faceChanged || trace.kind(i) === Kind.protection)) i--;
    const vertex = i >= 0 && trace.kind(i) === Kind.inserted ? trace.event(i).subject : null;
    return {
      dimension: 2,
      kind: 'inserted',
      rule: moment.rule,
      simplex: [],
      witness: null,
      ball: null,
      ghost: null,
      yieldTo: null,
      vertex: vertex !== null && this.has(vertex) ? vertex : null,
      change: this.change(position - 1, true),
      sentence: moment.sentence,
    };
  }

  /** The witness of a simplex of this face that lies outside of it (as all witnesses for its triangles do). */
  outsider(moment: Moment3): Outsider | null {
    const { witness, simplex } = moment;
    if (witness === null || this.has(witness) || simplex.length === 0) return null;
    if (!simplex.every((v) => this.has(v)) || witness >= this.trace.vertexCount) return null;
    const p = point3(this.trace.coordinates.data, witness);
    const { near } = moment;
    return {
      vertex: witness,
      at: toPlane(this.plane, p),
      height: heightOver(this.plane, p),
      near:
        near !== null && this.has(near)
          ? toPlane(this.plane, point3(this.trace.coordinates.data, near))
          : null,
    };
  }

  /** The face of the input as a complex of the plane, its vertices numbered anew; `vertices` has their numbers in space. */
  outline(): Complex2 {
    const { complex, plane } = this;
    const numbers = new Map<number, number>();
    const vertices: Point[] = [];
    const number = (v: number): number => {
      let n = numbers.get(v);
      if (n === undefined) {
        n = vertices.length;
        numbers.set(v, n);
        vertices.push(toPlane(plane, complex.vertices[v]!));
      }
      return n;
    };
    const segments = [...this.own].map((s): [number, number] => {
      const [a, b] = complex.segments[s]!;
      return [number(a), number(b)];
    });
    const face = complex.faces[this.face]!;
    for (const v of [...face.loops.flat(), ...face.vertices]) number(v);
    const holes = face.holes.map((p) => toPlane(plane, p));
    return { vertices, segments, holes, regions: [] };
  }

  private update(): void {
    const { trace } = this;
    const lives = trace.facetLives!;
    this.placeVertices();
    for (; this.nextFacet < lives.count; this.nextFacet++) {
      if (lives.vertices.data[4 * this.nextFacet + 3] === this.face) this.add(lives);
    }
    for (; this.nextSubsegment < trace.subsegmentCount; this.nextSubsegment++) {
      const s = trace.subsegments.at(3 * this.nextSubsegment + 2);
      // Sides of the box are told by their ends alone, once those are known (`isIn`).
      if (s === NONE || this.own.has(s)) this.subsegments.push(this.nextSubsegment);
    }
  }

  private isIn(n: number): boolean {
    const { data } = this.trace.subsegments;
    return this.vertexBorn[data[3 * n]!] !== NEVER && this.vertexBorn[data[3 * n + 1]!] !== NEVER;
  }

  private placeVertices(): void {
    const { vertexCount } = this.trace;
    const before = this.vertexBorn.length;
    if (vertexCount <= before) return;
    const born = new Uint32Array(vertexCount).fill(NEVER);
    born.set(this.vertexBorn);
    // What is not in the face is nowhere in its plane: the picture tells faces apart by that.
    const coordinates = new Float64Array(2 * vertexCount).fill(Number.NaN);
    coordinates.set(this.coordinates);
    this.vertexBorn = born;
    this.coordinates = coordinates;
  }

  private add(lives: Lives): void {
    const n = this.nextFacet;
    const k = this.facets.length;
    this.facets.push(n);
    if (k >= this.label.length) this.grow();
    for (let i = 0; i < 3; i++) {
      const v = lives.vertices.data[4 * n + i]!;
      this.cells[3 * k + i] = v;
      if (this.vertexBorn[v] !== NEVER) continue;
      this.vertexBorn[v] = this.trace.vertexBorn.at(v);
      this.coordinates.set(toPlane(this.plane, point3(this.trace.coordinates.data, v)), 2 * v);
    }
    this.label[k] = lives.label.data[n]!;
    this.born[k] = lives.born.at(n);
  }

  private grow(): void {
    const size = 2 * this.label.length;
    const grown = <T extends Uint8Array | Uint32Array>(old: T, to: T): T => {
      to.set(old);
      return to;
    };
    this.cells = grown(this.cells, new Uint32Array(3 * size));
    this.label = grown(this.label, new Uint8Array(size));
    this.born = grown(this.born, new Uint32Array(size));
    this.died = grown(this.died, new Uint32Array(size));
    this.live = grown(this.live, new Uint32Array(size));
  }
}

/** The input segments that lie in a face: listed in it, or sides of its loops. */
export function segmentsOf(complex: Complex3, face: number): number[] {
  const f = complex.faces[face];
  if (!f) return [];
  const sides = new Set<string>();
  for (const [a, b] of sidesOf(f)) sides.add(a < b ? `${a} ${b}` : `${b} ${a}`);
  const listed = new Set(f.segments);
  return complex.segments.flatMap(([a, b], s) =>
    listed.has(s) || sides.has(a < b ? `${a} ${b}` : `${b} ${a}`) ? [s] : [],
  );
}

export function* sidesOf({ loops }: Face3): Generator<readonly [number, number]> {
  for (const loop of loops)
    for (const [i, a] of loop.entries()) yield [a, loop[(i + 1) % loop.length]!];
}
