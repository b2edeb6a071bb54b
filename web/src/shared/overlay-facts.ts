/**
 * What the overlays of the picture show beyond the mesh itself: measured by the core (local feature size) or read off
 * the trace (protection, spindles, ancestry), each a plain value. A picture draws what it is given, so that two pictures can
 * show two runs. Vertices by number as in the mesh; coordinates where no vertex is.
 */

import type { Point, Point3 } from './types';

/** lfs on a lattice over the view: value (i, j) belongs to the point (x + i step, y + j step). */
export interface FeatureField {
  readonly x: number;
  readonly y: number;
  readonly step: number;
  readonly columns: number;
  readonly rows: number;
  readonly values: Float64Array; // row by row, from below; infinite where no two features are disjoint
}

/** A feature of the input that a ball touches, as the core names it. */
export interface Witness {
  readonly kind: 'vertex' | 'segment';
  readonly index: number; // as in the complex that was asked about
  readonly ends: readonly Point[]; // one place or two
  readonly at: Point; // its point nearest to the center
}

/** The smallest closed ball about a point that meets two disjoint input features (thesis, Definition 2.1.6). */
export interface FeatureBall {
  readonly center: Point;
  readonly radius: number; // lfs; infinite if no two features are disjoint
  readonly witnesses: readonly Witness[]; // two, or none
}

/** The same in space, of a subsegment: about the point of it where the infimum is attained. */
export interface FeatureBall3 {
  readonly radius: number; // infinite if there are no two such features
  readonly center: Point3;
  readonly witnesses: readonly Witness3[]; // two, nearer first, or none
}

export interface Witness3 {
  readonly kind: 'vertex' | 'segment' | 'face';
  readonly index: number; // of the complex that the run refines
  readonly at: Point3; // its point nearest to the center
}

/** N and lfs at an input vertex, in world units; lfs NaN while it is not known. */
export interface NeighborRing {
  readonly vertex: number;
  readonly nearest: number;
  readonly lfs: number;
  readonly promised: boolean; // the algorithm promises 1/2 <= N / lfs <= sqrt 2 (when it ends)
}

export type Pair = readonly [number, number];

/** Spind(s) (thesis, Definition 2.1.5): s first. */
export interface Spindle {
  readonly subsegments: readonly Pair[];
  readonly apexes: readonly number[]; // input vertices that it is about
}

/** An end segment that is never split, of input vertex `center`. */
export interface CollarSimplex {
  readonly center: number;
  readonly end: number;
}

/** The circle about an input vertex that protects its angle, and the arcs that it is cut into. */
export interface Intestine {
  readonly center: number;
  readonly radius: number;
  readonly arcs: readonly Pair[]; // counter-clockwise from the first to the second
}

/** One step back: what made the insertion of the vertex before it necessary. */
export interface AncestryLink {
  readonly vertex: number;
  readonly parent: number;
}

/** The collar in one face of a run in space (thesis, Table 6.1). */
export interface FaceCollar {
  readonly triangles: readonly (readonly number[])[]; // that belong to it, by vertices
  readonly pieces: readonly Pair[]; // of segments, protected
  readonly segments: readonly Pair[];
  readonly arcs: readonly { readonly center: number; readonly ends: Pair }[];
}

export interface OverlayFacts {
  readonly field: FeatureField | null;
  readonly ball: FeatureBall | null;
  readonly neighbors: readonly NeighborRing[];
  readonly spindle: Spindle | null;
  readonly collars: readonly CollarSimplex[];
  readonly intestines: readonly Intestine[];
  readonly ancestry: readonly AncestryLink[];
  readonly faceCollar?: FaceCollar | null;
}

export const noFacts: OverlayFacts = {
  field: null,
  ball: null,
  neighbors: [],
  spindle: null,
  collars: [],
  intestines: [],
  ancestry: [],
};
