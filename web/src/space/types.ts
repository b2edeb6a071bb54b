/**
 * The seam of the picture in space: what it is given, what it shows, what the page asks of it. Coordinates are the doubles of the
 * core; numbers of vertices, cells, facets and subsegments are those of the trace (shared/types.ts).
 */

import type { CollarRegion } from '../replay/collar-region';
import type {
  Background,
  ColorMode,
  ColorScale,
  Complex3,
  DefectMark,
  Insets,
  MeshState,
  Moment3,
  PictureTheme,
  Point,
  Point3,
} from '../shared/types';
import type { SpaceItems } from './items';

/**
 * Parallel projection, the third axis up: parallel edges stay parallel, and what is equally long in one direction looks so. Angles in
 * degrees: `azimuth` turns about the third axis, 0 looks along the negative first axis; `elevation` 90 looks down from above.
 */
export interface SpaceView {
  readonly target: Point3; // world coordinates of what is at the center of the canvas
  readonly azimuth: number;
  readonly elevation: number;
  readonly scale: number; // CSS pixels per world unit
}

export type FaceLook = 'translucent' | 'solid' | 'hidden';
export type ClipAxis = 'x' | 'y' | 'z' | 'view';

/** What lies beyond the plane is not drawn. */
export interface ClipLook {
  readonly axis: ClipAxis;
  readonly normal: Point3; // unit; of the axis, or of the view when the plane was set
  readonly offset: number; // 0 to 1: through what there is, along the normal
  readonly flipped: boolean; // the other half is drawn
  /** Cells that the plane meets: cut through, or (false) whole if their centroid is on the side that is drawn. */
  readonly exact: boolean;
}

export interface SpaceLook {
  readonly faces: FaceLook;
  readonly facets: boolean; // edges of the faces' own triangulations
  readonly cells: boolean;
  readonly outside: boolean; // cells outside the domain
  readonly vertices: boolean; // Steiner vertices
  readonly collars: boolean; // collar segments and arcs, and what lies between them and the segments
  readonly surfaces: boolean; // spheres and tubes that protect
  readonly labels: boolean; // numbers of vertices, where there is room
  readonly clip: ClipLook | null;
  readonly shrink: number; // 0 to 1: cells drawn towards their centroids, an exploded view
  readonly peel: number; // layers of cells that are taken off the boundary
  readonly color: ColorMode;
  readonly highlight: ReadonlySet<number> | null; // cells to show alone, by number
}

/** What a link carries of it; missing things are as at a first visit. */
export type SharedLook = Partial<Omit<SpaceLook, 'highlight'>>;

export const defaultLook: SpaceLook = {
  faces: 'translucent',
  facets: true,
  cells: false,
  outside: false,
  vertices: true,
  collars: true,
  surfaces: true,
  labels: false,
  clip: null,
  shrink: 0,
  peel: 0,
  color: 'plain',
  highlight: null,
};

/** What lies under a place of the canvas. One of them is set. */
export interface SpaceHit {
  readonly vertex: number | null; // of the mesh; of the complex before a run
  readonly subsegment: number | null; // its number; the input segment before a run
  readonly face: number | null; // input face
  readonly facet: number | null; // triangle of a face's own triangulation, by number; with `face`
  readonly cell: number | null;
}

export const noHit: SpaceHit = {
  vertex: null,
  subsegment: null,
  face: null,
  facet: null,
  cell: null,
};

export type StandardView = 'front' | 'right' | 'top' | 'corner';

/** The three.js picture of space. Draws on demand only; owns no data but copies for the GPU. */
export interface SpacePicture {
  readonly canvas: HTMLCanvasElement;
  /** `triangles`: four numbers each, three vertices and the face that they fill. */
  setComplex(
    complex: Complex3 | null,
    triangles: Uint32Array,
    defects: readonly DefectMark[],
  ): void;
  /** Null: no mesh is shown. `run` tells runs apart: numbers name the same things as long as it is the same object. */
  setMesh(
    state: MeshState | null,
    run: object | null,
    /** Of the same state; asked for when it is drawn. */
    region?: (() => CollarRegion) | null,
  ): void;
  setMoment(moment: Moment3 | null): void;
  setLook(look: SpaceLook): void;
  setPicked(hit: SpaceHit | null): void;
  /** More to draw, above the mesh: spheres, lines, marks. */
  setExtras(items: SpaceItems | null): void;
  setTheme(theme: PictureTheme): void;
  setInsets(insets: Insets): void;
  /** What the colors mean, or null; as of the last drawing. */
  readonly scale: ColorScale | null;
  onScaleChange(listener: (scale: ColorScale | null) => void): () => void;
  getView(): SpaceView;
  /** `smooth`: moves there in a quarter of a second, unless motion is to be reduced. */
  setView(view: SpaceView, smooth?: boolean): void;
  onViewChange(listener: (view: SpaceView) => void): () => void;
  fit(smooth?: boolean): void;
  look(from: StandardView): void;
  zoomBy(factor: number, at?: Point): void; // `at` in CSS pixels of the canvas
  panBy(dx: number, dy: number): void; // CSS pixels
  orbitBy(dx: number, dy: number): void; // CSS pixels of a drag
  /** Turns nothing, and brings what the moment is about into sight, large. False if it is about no place. */
  lookAtMoment(): boolean;
  /** The same of some places. */
  lookAt(places: readonly Point3[]): boolean;
  /** Brings a place to the center of the canvas. */
  centerOn(at: Point3): void;
  toScreen(p: Point3): Point;
  /** Unit vector from what is looked at to the eye. */
  direction(): Point3;
  pick(x: number, y: number): SpaceHit | null;
  resize(width: number, height: number, pixelRatio: number): void;
  toPNG(width: number, background: Background): Promise<Blob>;
  dispose(): void;
}

export function isSpaceView(x: unknown): x is SpaceView {
  if (typeof x !== 'object' || x === null) return false;
  const { target, azimuth, elevation, scale } = x as Record<string, unknown>;
  return (
    Array.isArray(target) &&
    target.length === 3 &&
    [...target, azimuth, elevation, scale].every((n) => Number.isFinite(n)) &&
    (scale as number) > 0
  );
}
