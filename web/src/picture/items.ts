/**
 * The display list: what the canvas and the SVG draw alike. Places are in world coordinates (double precision),
 * widths and sizes in CSS pixels.
 */

import type { Point } from '../shared/types';

export type Dash = 'solid' | 'dashed' | 'dotted';

export interface PolygonItem {
  readonly points: readonly Point[]; // convex
  readonly fill: string;
  readonly opacity: number;
}

export interface LineItem {
  readonly a: Point;
  readonly b: Point;
  readonly color: string;
  readonly width: number;
  readonly dash?: Dash;
  readonly opacity?: number;
}

export interface DiskItem {
  readonly center: Point;
  readonly radius: number; // world units
  readonly stroke: string;
  readonly width: number;
  readonly dash?: Dash;
  readonly opacity?: number;
  readonly fill?: string;
  readonly fillOpacity?: number;
}

export type Shape = 'disc' | 'square' | 'diamond' | 'cross' | 'plus' | 'arrow' | 'triangle';

export interface MarkItem {
  readonly at: Point;
  readonly shape: Shape;
  readonly size: number; // diameter or side
  readonly fill?: string; // without: hollow
  readonly stroke?: string;
  readonly width?: number; // of the stroke
  readonly opacity?: number;
  readonly angle?: number; // radians, counter-clockwise: where an arrow points
}

export interface TextItem {
  readonly at: Point;
  readonly text: string;
  readonly size: number;
  readonly color: string;
  readonly dx: number; // offset of the anchor in pixels; dy points up
  readonly dy: number;
  readonly anchor: 'start' | 'middle' | 'end';
  readonly halo?: string;
}

/** Drawn in this order: polygons, disks, lines, marks, texts. */
export interface Items {
  readonly polygons: PolygonItem[];
  readonly disks: DiskItem[];
  readonly lines: LineItem[];
  readonly marks: MarkItem[];
  readonly texts: TextItem[];
}

export function noItems(): Items {
  return { polygons: [], disks: [], lines: [], marks: [], texts: [] };
}

/** Lengths in pixels of dash and gap; the dots of a dotted line are as long as it is wide. */
export const dashes: Record<Exclude<Dash, 'solid'>, readonly [number, number]> = {
  dashed: [7, 5],
  dotted: [0.01, 5],
};
