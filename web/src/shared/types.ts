/**
 * The seam between the parts of the page: what the replay gives, what the picture draws, what the editor edits.
 * Nothing here has behavior. Coordinates are the doubles of the core; the picture rebases them before they become
 * single precision. Vertices, cells (triangles in the plane, tetrahedra in space) and subsegments are named by number:
 *   vertex number      as in the mesh (input, box, then Steiner vertices by birth)
 *   cell number        order of birth in the trace (a cell that dies and is born again has two numbers)
 *   facet number       the same of the triangles of faces, in space
 *   subsegment number  order of birth, the input's segments first
 */

import type { OverlayFacts } from './overlay-facts';

export type Point = readonly [number, number];
export type Point3 = readonly [number, number, number];

// ---------------------------------------------------------------------------------------------- the document

/** A 2D complex as the editor holds it: immutable, shared between undo states, plain JSON. */
export interface Complex2 {
  readonly vertices: readonly Point[];
  readonly segments: readonly (readonly [number, number])[];
  readonly holes: readonly Point[];
  readonly regions: readonly Region2[];
  readonly markers?: {
    readonly vertices?: readonly number[];
    readonly segments?: readonly number[];
  };
}

export interface Region2 {
  readonly at: Point;
  readonly label: number;
  readonly max?: number;
}

export const emptyComplex: Complex2 = { vertices: [], segments: [], holes: [], regions: [] };

/** A complex of space: opened, looked at and played, not edited. Indices as in the project's JSON (docs/formats.md). */
export interface Complex3 {
  readonly dimension: 3;
  readonly vertices: readonly Point3[];
  readonly segments: readonly (readonly [number, number])[];
  readonly faces: readonly Face3[];
  readonly holes: readonly Point3[];
  readonly regions: readonly { at: Point3; label: number; max?: number }[];
  readonly markers?: {
    readonly vertices?: readonly number[];
    readonly segments?: readonly number[];
    readonly faces?: readonly number[];
  };
}

/** A planar polygon with what lies in it: loops of vertices, places of holes, segments and vertices by index. */
export interface Face3 {
  readonly loops: readonly (readonly number[])[];
  readonly holes: readonly Point3[];
  readonly segments: readonly number[];
  readonly vertices: readonly number[];
}

/** What a run is about. */
export type Input = Complex2 | Complex3;

export function isSpace(input: Input): input is Complex3 {
  return 'faces' in input;
}

/** What is selected in the document, by index. */
export interface Selection {
  readonly vertices: ReadonlySet<number>;
  readonly segments: ReadonlySet<number>;
  readonly holes: ReadonlySet<number>;
  readonly regions: ReadonlySet<number>;
}

/** A defect as the core reports it (wasm/circumball.d.mts), drawn at its place. */
export interface DefectMark {
  readonly name: string;
  readonly message: string;
  readonly warning: boolean;
  readonly at: readonly (readonly number[])[];
  readonly features: readonly { readonly kind: string; readonly index: number }[];
}

// ---------------------------------------------------------------------------------------------- the mesh

export const VertexKind = { input: 0, box: 1, onSegment: 2, inFace: 3, free: 4 } as const;
export type VertexKind = (typeof VertexKind)[keyof typeof VertexKind];

/** Domain label of a cell in the trace, or of a triangle in a face's own triangulation. */
export const Label = { unknown: 0, inside: 1, outside: 2 } as const;

/** "Never died": value of `cellDied` and `subsegmentDied` for what is still alive at the end of the trace. */
export const NEVER = 0xffffffff;

/**
 * The mesh at a position of the trace (`position` events applied). The arrays indexed by number hold *everything that
 * the trace ever made* and may be longer than their counts; what exists now is listed in the `live` arrays
 * (first `liveCellCount` / `liveSubsegmentCount` entries, no particular order) and by `vertexBorn[v] < position`.
 * Arrays are owned by the replay: read them at once, don't keep them. Born/died are event indices: event i makes
 * position i + 1, so a thing is alive iff born < position <= died.
 */
export interface MeshState {
  readonly dimension: 2 | 3;
  readonly position: number;
  readonly vertexCount: number;
  readonly coordinates: Float64Array; // `dimension` numbers a vertex
  readonly vertexKind: Uint8Array;
  readonly vertexBorn: Uint32Array; // event index; NEVER: not yet known
  readonly vertexStep: Uint8Array; // index of the step that made it

  readonly cellCount: number;
  readonly cells: Uint32Array; // `dimension + 1` vertices a cell, positively oriented
  readonly cellLabel: Uint8Array;
  readonly cellBorn: Uint32Array;
  readonly cellDied: Uint32Array;
  readonly liveCells: Uint32Array;
  readonly liveCellCount: number;

  readonly subsegments: Uint32Array; // 3 numbers: a, b, input segment (0xffffffff: of the box)
  readonly subsegmentBorn: Uint32Array;
  readonly liveSubsegments: Uint32Array;
  readonly liveSubsegmentCount: number;

  readonly facets: FacetState | null; // in space
  readonly protection?: ProtectionState | null; // in space
}

/** The triangles of the faces' own triangulations, as the cells are in MeshState. */
export interface FacetState {
  readonly count: number;
  readonly triangles: Uint32Array; // 4 numbers: a, b, c (counter-clockwise about the normal of the face), face
  readonly label: Uint8Array;
  readonly born: Uint32Array;
  readonly live: Uint32Array;
  readonly liveCount: number;
}

/** What protects acute features in space (lib/include/circumball/trace.h). */
export const Protecting = {
  collarSegment: 0, // a, b in a face
  collarArc: 1, // from a to b about input vertex c, in a face
  ringArc: 2, // from a to b about vertex c on an input segment
  spherePatch: 3, // a, b, c on the sphere about an input vertex
  tubePatch: 4, // a, b, c on the tube about an input segment
  subsegment: 5, // a, b of an input segment, never split any more
} as const;

/** Its elements, as the cells are in MeshState. */
export interface ProtectionState {
  readonly count: number;
  readonly elements: Uint32Array; // 4 numbers: a, b, c, and the face, input vertex or input segment that carries it
  readonly kind: Uint8Array; // as in Protecting
  readonly live: Uint32Array;
  readonly liveCount: number;
}

/** What one event changed, for the motion that explains it. Numbers of cells; `vertex` is -1 if none landed. */
export interface MeshChange {
  readonly died: Uint32Array;
  readonly born: Uint32Array;
  readonly vertex: number;
  readonly forward: boolean; // false: the event was taken back
}

export type MomentKind =
  | 'start' // before the first event
  | 'step-began'
  | 'step-ended'
  | 'queued'
  | 'dropped'
  | 'refused'
  | 'yielded'
  | 'inserted'
  | 'relabeled'
  | 'limit'
  | 'face-changed'
  | 'protection';

/** Which of the four rules is acting at a moment. */
export type RuleName = 'action' | 'priority' | 'unacceptability' | 'safety';

/** What a moment (the event that led to the position) shows in the picture. Missing things are null. */
interface MomentOf<P> {
  readonly kind: MomentKind;
  readonly rule: RuleName | null;
  readonly simplex: readonly number[]; // vertices of the simplex in hand: 1 to 4; empty if none
  readonly witness: number | null; // vertex, ringed and joined to the simplex by a dotted line
  readonly ball: { readonly center: P; readonly radius: number } | null; // thin circle, or a sphere
  readonly ghost: P | null; // refused or yielding point: hollow, with a cross
  readonly yieldTo: readonly [number, number] | null; // subsegment: arrow from the ghost to its midpoint
  readonly yieldFace?: readonly number[] | null; // in space, triangle of a face: arrow to its centroid
  readonly vertex: number | null; // the vertex that has just landed
  readonly change: MeshChange | null;
  readonly sentence: string;
}
export interface Moment extends MomentOf<Point> {
  readonly dimension: 2;
}
/** In space; `face` is the input face that the event is about. */
export interface Moment3 extends MomentOf<Point3> {
  readonly dimension: 3;
  readonly face: number | null;
  readonly near: number | null; // vertex that the witness is a near neighbor of
  readonly facets: Uint32Array; // triangles of a face's own triangulation that were born
  readonly elements: Uint32Array; // protecting elements that were born
}

// ---------------------------------------------------------------------------------------------- the picture

export type ColorMode =
  | 'plain'
  | 'quality'
  | 'size'
  | 'radius'
  | 'step'
  | 'age'
  | 'region'
  | 'error'
  | 'dihedral'
  | 'radiusEdge'
  | 'volume';

/** What cells can be colored by; errors are measured, and shown, beside the numbers of the Numerics tab. */
export const colorModes: { readonly 2: readonly ColorMode[]; readonly 3: readonly ColorMode[] } = {
  2: ['plain', 'quality', 'size', 'radius', 'step', 'age', 'region'],
  3: ['plain', 'dihedral', 'radiusEdge', 'volume', 'radius', 'step', 'age'],
};

/** A color scale laid over the triangles; the picture fills it in when it colors, the legend reads it. */
export interface ColorScale {
  readonly mode: ColorMode;
  readonly min: number;
  readonly max: number;
  readonly logarithmic: boolean;
  readonly unit: string; // "°", "", …
  readonly at: (t: number) => string; // CSS color at t in [0, 1]
}

export interface Overlays {
  readonly mesh: boolean; // triangles and their edges
  readonly outside: boolean; // triangles outside the domain, faint
  readonly vertices: boolean; // Steiner vertices by kind
  readonly circumcircles: boolean; // of all triangles (few only)
  readonly diametral: boolean; // diametral disks of all subsegments; encroached ones with their vertex
  readonly featureSize: boolean; // lfs as a field over the plane, and the ball at the point that was asked for
  readonly neighbors: boolean; // N against lfs at each input vertex
  readonly spindles: boolean; // Spind(s) of the picked or acting subsegment
  readonly collars: boolean; // collar simplices with their diametral disks
  readonly intestines: boolean; // protecting disks and their arcs
  readonly ancestry: boolean; // parents of the picked vertex, back to the input
  readonly labels: boolean; // vertex numbers where there is room
  readonly grid: boolean;
  readonly highlight: ReadonlySet<number> | null; // triangles to stress (a bin of the histogram), by number
}

/** What is drawn at a first visit. */
export const defaultOverlays: Overlays = {
  mesh: true,
  outside: false,
  vertices: true,
  circumcircles: false,
  diametral: false,
  featureSize: false,
  neighbors: false,
  spindles: false,
  collars: false,
  intestines: false,
  ancestry: true,
  labels: false,
  grid: false,
  highlight: null,
};

/** Overlays of the theory, in the order in which they are listed. */
export const theoryOverlays = [
  'featureSize',
  'neighbors',
  'diametral',
  'spindles',
  'collars',
  'intestines',
  'ancestry',
] as const;
export type TheoryOverlay = (typeof theoryOverlays)[number];

export interface PictureTheme {
  readonly dark: boolean;
  readonly reducedMotion: boolean;
  readonly background: string;
  readonly ink: string; // input features
  readonly inkFaint: string; // grid, outside edges
  readonly edge: string; // mesh edges
  readonly fill: string; // plain triangles
  readonly fillOutside: string;
  readonly steinerSegment: string;
  readonly steinerFree: string;
  readonly box: string;
  readonly acting: string; // simplex in hand
  readonly witness: string;
  readonly ball: string;
  readonly ghost: string;
  readonly born: string;
  readonly died: string;
  readonly yielding: string;
  readonly hole: string;
  readonly selection: string;
  readonly snap: string;
  readonly defect: string;
  readonly warning: string;
  readonly featureSize: string; // lfs: field, contours, ball
  readonly neighbor: string; // N at an input vertex
  readonly spindle: string;
  readonly collar: string;
  readonly intestine: string;
  readonly ancestry: string;
}

export interface View {
  readonly x: number; // world coordinates of the center of the canvas
  readonly y: number;
  readonly scale: number; // CSS pixels per world unit
}

export interface Bounds {
  readonly minX: number;
  readonly minY: number;
  readonly maxX: number;
  readonly maxY: number;
}

/** Room at the sides of the canvas that controls cover, in CSS pixels: `fit` and the scale bar keep out of it. */
export interface Insets {
  readonly left: number;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
}

/** What lies under a place of the canvas, nearest first by kind: vertex, subsegment, triangle. Null: nothing. */
export interface Hit {
  readonly vertex: number | null; // mesh vertex (document vertex while editing)
  readonly subsegment: number | null; // number of the subsegment, or index of the document segment while editing
  readonly triangle: number | null;
  readonly hole: number | null;
  readonly region: number | null;
}

/** What a tool in the middle of its work shows: rubber bands, the snap it found, a lasso. World coordinates. */
export interface Sketch {
  readonly lines: readonly (readonly [Point, Point])[];
  readonly points: readonly Point[];
  readonly box: readonly [Point, Point] | null; // rubber-band selection
  readonly snap: {
    readonly at: Point;
    readonly kind: 'vertex' | 'segment' | 'grid' | 'angle';
  } | null;
  readonly cursor: Point | null; // keyboard cursor of the editor
  readonly crossings?: readonly Point[]; // where the rubber bands cross segments of the document
}

/** The three.js picture. Draws on demand only; owns no data but copies for the GPU. Built in web/src/picture/. */
export interface Picture {
  readonly canvas: HTMLCanvasElement;
  /** Null: no mesh is shown (editing). `change` given: animate from the state before (150–250 ms, less than the time between events;
   * `speed` in events a second). */
  setMesh(state: MeshState | null, change?: MeshChange | null, speed?: number): void;
  setMoment(moment: Moment | null): void;
  setComplex(complex: Complex2, selection: Selection | null, defects: readonly DefectMark[]): void;
  setSketch(sketch: Sketch | null): void;
  setColorMode(mode: ColorMode): ColorScale | null;
  /** What the mode 'error' colors by: a number for each triangle, by its number. Null: nothing was measured. */
  setValues(values: Float64Array | null): void;
  setOverlays(overlays: Overlays): void;
  /** What the overlays show beyond the mesh; drawn as far as `setOverlays` switches it on. */
  setFacts(facts: OverlayFacts): void;
  setTheme(theme: PictureTheme): void;
  /** A mesh vertex, subsegment or triangle picked for the inspector: outlined. */
  setPicked(hit: Hit | null): void;
  getView(): View;
  setView(view: View): void;
  onViewChange(listener: (view: View) => void): () => void;
  fit(bounds?: Bounds): void;
  setInsets(insets: Insets): void;
  zoomBy(factor: number, at?: Point): void; // `at` in CSS pixels of the canvas
  panBy(dx: number, dy: number): void; // CSS pixels
  toWorld(x: number, y: number): Point; // CSS pixels of the canvas -> world
  toScreen(p: Point): Point;
  pick(x: number, y: number): Hit | null;
  resize(width: number, height: number, pixelRatio: number): void;
  /** Renders off screen, `width` pixels wide, same view. */
  toPNG(width: number, background: Background): Promise<Blob>;
  /** What is on the canvas, as vectors, with the same legend of shapes and dashes. */
  toSVG(centimeters: number, background: Background): string;
  dispose(): void;
}

/** Of an exported picture. */
export type Background = 'theme' | 'white' | 'transparent';

export interface PictureOptions {
  readonly theme: PictureTheme;
  readonly antialias: boolean;
}
/** Exported by web/src/picture/index.ts. Throws if WebGL 2 is not to be had. */
export type CreatePicture = (canvas: HTMLCanvasElement, options: PictureOptions) => Picture;

// ---------------------------------------------------------------------------------------------- the editor

export type ToolId =
  | 'select'
  | 'point'
  | 'segment'
  | 'polygon'
  | 'rectangle'
  | 'hole'
  | 'region'
  | 'pan';

export interface ToolInfo {
  readonly id: ToolId;
  readonly title: string;
  readonly hint: string; // one sentence, shown while the tool is in hand
  readonly key: string; // shortcut, one letter
  readonly icon: string; // SVG path data in a 24 x 24 box, stroked
}

export interface SnapOptions {
  readonly vertex: boolean;
  readonly segment: boolean;
  readonly grid: boolean;
  readonly angle: boolean; // 45 degrees
  readonly gridStep: number; // 0: follows the zoom
}

/** The editor: document, selection, tools, undo. No DOM, no Svelte; listeners hear of every change. In web/src/editor/. */
export interface Editor {
  readonly tools: readonly ToolInfo[];
  readonly tool: ToolId;
  readonly complex: Complex2;
  readonly selection: Selection;
  readonly snap: SnapOptions;
  readonly canUndo: boolean;
  readonly canRedo: boolean;
  /** Title of what undo / redo would do ("Move 3 vertices"), empty if nothing. */
  readonly undoTitle: string;
  readonly redoTitle: string;
  setTool(tool: ToolId): void;
  setSnap(snap: SnapOptions): void;
  /** Puts a document in place of this one; undoable. */
  replace(complex: Complex2, title: string): void;
  /** Adds a complex beside what is there; equal vertices become one. */
  paste(complex: Complex2): void;
  undo(): void;
  redo(): void;
  select(selection: Partial<Selection>): void;
  selectAll(): void;
  clearSelection(): void;
  deleteSelection(): void;
  duplicateSelection(): void;
  moveSelection(dx: number, dy: number): void;
  /** Exact coordinates: of a vertex, hole or region, or a new one. */
  setPosition(kind: 'vertex' | 'hole' | 'region', index: number, at: Point): void;
  addPoint(at: Point): void;
  addSegment(a: number, b: number): void;
  /** Joins the selected vertices in order / closes them to a polygon. */
  joinSelection(close: boolean): void;
  setRegion(index: number, region: Region2): void;
  /** Splits crossing segments at their crossings; returns how many crossings were split. */
  splitCrossings(): number;
  /** Pointer and key events that the navigation did not take. True: the editor used it. */
  pointerDown(e: EditorPointer): boolean;
  pointerMove(e: EditorPointer): boolean;
  pointerUp(e: EditorPointer): boolean;
  keyDown(e: EditorKey): boolean;
  cancel(): void; // Escape: the tool drops what it is doing
  /** Called after document, selection, tool, snap or sketch changed. */
  subscribe(listener: (change: EditorChange) => void): () => void;
  readonly sketch: Sketch | null;
  /** Undo history for persistence: plain JSON, bounded. */
  serialize(): string;
  restore(text: string): boolean;
}

export interface EditorChange {
  readonly document: boolean;
  readonly selection: boolean;
  readonly tool: boolean;
  readonly sketch: boolean;
}

export interface EditorPointer {
  readonly at: Point; // world
  readonly screen: Point; // CSS pixels of the canvas
  readonly unitsPerPixel: number;
  readonly touch: boolean; // wider targets
  readonly shift: boolean;
  readonly alt: boolean;
  readonly control: boolean;
  readonly double: boolean; // second press of a double click
}

export interface EditorKey {
  readonly key: string; // KeyboardEvent.key
  readonly shift: boolean;
  readonly alt: boolean;
  readonly control: boolean; // Control or Command
  readonly unitsPerPixel: number;
}

/** Exported by web/src/editor/index.ts. */
export type CreateEditor = (initial: Complex2) => Editor;

/**
 * Exported by web/src/editor/index.ts: binds pointer, wheel and touch of the canvas to navigation (wheel and pinch
 * zoom, two fingers / space / middle button / pan tool pan), to the editor while `editing()` is true, and to
 * `onPick` otherwise. Returns a function that unbinds.
 */
export type AttachInput = (
  picture: Picture,
  editor: Editor,
  options: {
    editing: () => boolean;
    onPick: (hit: Hit | null, at: Point) => void;
    onHover?: (at: Point | null) => void;
    /** Right button or long press: where, in the world and in CSS pixels of the canvas. */
    onMenu?: (at: Point, screen: Point) => void;
  },
) => () => void;
