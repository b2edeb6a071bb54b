/** The display list of space. Places are in world coordinates (double precision), widths and sizes in CSS pixels. */

import type { Dash, Shape } from '../picture/items';
import type { Point3 } from '../shared/types';

export interface Triangle3Item {
  readonly corners: readonly [Point3, Point3, Point3];
  readonly fill: string;
  readonly opacity: number;
}

export interface Line3Item {
  readonly a: Point3;
  readonly b: Point3;
  readonly color: string;
  readonly width: number;
  readonly dash?: Dash;
  readonly opacity?: number;
}

/** A ball, drawn as a translucent sphere with its rim. */
export interface SphereItem {
  readonly center: Point3;
  readonly radius: number;
  readonly color: string;
  readonly opacity: number; // of the fill at the middle; more at the rim
  readonly width?: number; // of the rim
  readonly dash?: Dash;
}

export interface Mark3Item {
  readonly at: Point3;
  readonly shape: Shape;
  readonly size: number;
  readonly fill?: string;
  readonly stroke?: string;
  readonly width?: number;
  readonly opacity?: number;
  /** An arrow head points from here to its place. */
  readonly from?: Point3;
}

export interface Text3Item {
  readonly at: Point3;
  readonly text: string;
  readonly size: number;
  readonly color: string;
  readonly halo?: string;
  readonly dx: number;
  readonly dy: number;
}

/** Drawn in this order: triangles, spheres, lines, marks, texts. */
export interface SpaceItems {
  readonly triangles: Triangle3Item[];
  readonly spheres: SphereItem[];
  readonly lines: Line3Item[];
  readonly marks: Mark3Item[];
  readonly texts: Text3Item[];
}

export function noSpaceItems(): SpaceItems {
  return { triangles: [], spheres: [], lines: [], marks: [], texts: [] };
}
