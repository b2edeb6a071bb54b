import type { Point, Point3 } from '../shared/types.ts';

/** Layout and meaning of trace events: lib/include/circumball/trace.h, 64 bytes each, little-endian. */

export const EVENT_BYTES = 64;
export const NONE = 0xffffffff;

export const Kind = {
  stepBegan: 0,
  stepEnded: 1,
  queued: 2,
  dropped: 3,
  refused: 4,
  yielded: 5,
  inserted: 6,
  relabeled: 7,
  limit: 8,
  faceChanged: 9,
  protection: 10,
} as const;

export const Reason = {
  none: 0,
  encroached: 1,
  missing: 2,
  radiusEdge: 3,
  size: 4,
  regionSize: 5,
  tooLong: 6,
  yieldedTo: 7,
  returned: 8,
  witness: 9,
  nearWitness: 10,
  nearLocalWitness: 11,
  nearVertex: 12,
  wide: 13,
  matching: 14,
  sliver: 15,
  input: 16,
  box: 17,
  midpoint: 18,
  circumcenter: 19,
  offCenter: 20,
  division: 21,
  collar: 22,
  circle: 23,
  arcMidpoint: 24,
  equalLength: 25,
  shell: 26,
  third: 27,
  ring: 28,
  seed: 29,
  surface: 30,
  picked: 31,
  outsideDomain: 32,
  protected: 33,
  minEdge: 34,
  precision: 35,
  frozen: 36,
  seditious: 37,
  outsideFace: 38,
  nearSegment: 39,
  noRoom: 46,
  notImproved: 47,
  died: 48,
  acceptable: 49,
  limitVertices: 64,
  limitMinEdge: 65,
  limitSeconds: 66,
  limitPrecision: 67,
  limitMemory: 68,
  cancelled: 69,
} as const;

/** One event, taken out of the record for whoever wants to read it at leisure. */
export interface TraceEvent {
  readonly index: number;
  readonly kind: number;
  readonly dimension: number; // of the simplex: 0 vertex, 1 subsegment, 2 triangle, 3 tetrahedron
  readonly reason: number;
  readonly step: number;
  readonly simplex: readonly number[]; // its vertices: dimension + 1 of them
  readonly segment: number; // input segment of a subsegment; NONE
  readonly face: number; // in space, the input face that a triangle, or a vertex that protects, lies in; NONE
  readonly center: number; // input vertex that an arc, or the circle of a vertex that protects, is about; NONE
  readonly across: number; // vertex of a segment that a vertex of a collar stands across from; NONE
  readonly subject: number;
  readonly other: readonly [number, number];
  readonly at: Point; // x and y
  readonly place: Point3; // all three
  readonly value: number;
}

/** The vertices of what a circumcenter yields to: two of a subsegment; in space also three of a triangle of face `subject`. */
export function yieldedTo(e: TraceEvent): readonly number[] {
  return e.value > 0 ? [...e.other, e.value - 1] : e.other;
}
