import type { Point, Point3 } from '../shared/types.ts';
import { dot, minus, plus } from './geometry3.ts';

/** The plane of a face with the frame that the core triangulates it in. */
export interface FacePlane {
  readonly origin: Point3;
  readonly first: Point3;
  readonly second: Point3;
  readonly normal: Point3;
}

/** Of the answer of `faceFrames`, which has twelve numbers a face; null for a face that has no plane. */
export function facePlane(frames: Float64Array, face: number): FacePlane | null {
  const numbers = frames.subarray(12 * face, 12 * face + 12);
  if (numbers.length < 12 || !numbers.every(Number.isFinite)) return null;
  const vector = (k: number): Point3 => [numbers[k]!, numbers[k + 1]!, numbers[k + 2]!];
  return { origin: vector(0), first: vector(3), second: vector(6), normal: vector(9) };
}

export function toPlane({ origin, first, second }: FacePlane, p: Point3): Point {
  const d = minus(p, origin);
  return [dot(d, first), dot(d, second)];
}

export function toSpace({ origin, first, second }: FacePlane, p: Point): Point3 {
  return plus(plus(origin, first, p[0]), second, p[1]);
}

/** Distance from the plane, positive on the side that the face is seen from. */
export function heightOver({ origin, normal }: FacePlane, p: Point3): number {
  return dot(minus(p, origin), normal);
}
