/** The typed face of the WebAssembly core. Checked against the built module by a contract test. */

/** A complex as in the project's own JSON (docs/formats.md). */
export interface ComplexJson {
  circumball: 1;
  dimension: 2 | 3;
  vertices: number[][];
  segments?: [number, number][];
  faces?: {
    loops: number[][];
    holes?: number[][];
    segments?: number[];
    vertices?: number[];
  }[];
  holes?: number[][];
  regions?: { at: number[]; label: number; max?: number }[];
  markers?: { vertices?: number[]; segments?: number[]; faces?: number[] };
  mesh?: {
    cells: number[][];
    cellRegions?: number[];
    vertexFeatures?: [number, number][];
    edges?: [number, number, number][];
    facets?: [number, number, number, number][];
  };
}

export interface Defect {
  name: string;
  features: { kind: 'vertex' | 'segment' | 'face' | 'free'; index: number }[];
  at: number[][];
  message: string;
  warning: boolean;
}

export interface ParameterInfo {
  name: string;
  default: string | number;
  min: string | number;
  max: string | number;
  help: string;
}

export interface AlgorithmInfo {
  id: string;
  title: string;
  dimension: number;
  thesis: string;
  rules: { action: string; priority: string; unacceptability: string; safety: string };
  parameters: ParameterInfo[];
  guarantee: string;
  checks: string[];
}

/** Mirrors circumball::Options; everything may be missing. */
export interface RunOptions {
  algorithm?: string;
  tau?: number;
  minAngle?: number;
  size?: string;
  domain?: 'hull' | 'box' | 'closed';
  maxVertices?: number;
  minEdge?: number;
  maxSeconds?: number;
  parameters?: Record<string, string>;
}

export type RunStatus = 'running' | 'complete' | 'limit' | 'cancelled';

export interface Progress {
  status: RunStatus;
  step: string;
  vertices: number;
  queued: number;
  iterations: number;
  seconds: number;
}

/**
 * New part of the trace since the last call. `events`: 64 bytes each, little-endian, layout of circumball::Event
 * (lib/include/circumball/trace.h):
 *   u8 kind, u8 dimension, u8 reason, u8 step, u32 simplex[4], u32 subject, u32 other[2] (32 bytes so far),
 *   f64 at[3] at byte 32, f64 value at byte 56.
 * `simplices`: (dimension + 2) numbers for each dead and born simplex, in event order.
 */
export interface TraceChunk {
  events: Uint8Array;
  simplices: Uint32Array;
  steps: string[];
}

export interface CheckResult {
  name: string;
  ok: boolean;
  detail: string;
  bound: number | null;
  observed: number | null;
  worst: number[];
}

export interface DihedralHistogram {
  slivers: number; // cells with an angle below the bound
  min_dihedral_degrees: number;
  max_dihedral_degrees: number;
  dihedrals: number[]; // of angles in [0, 10), [10, 20), … [170, 180] degrees
}

/** The report of cli.md. */
export interface Report {
  schema: 1;
  version: string;
  algorithm: string;
  dimension: number;
  parameters: Record<string, number | string>;
  input: { vertices: number; segments: number; faces: number; smallest_angle_degrees: number };
  status: 'complete' | 'limit' | 'cancelled';
  limit?: string;
  steps: {
    name: string;
    title: string;
    vertices: number;
    inserted: number;
    refused: number;
    seconds: number;
  }[];
  mesh: Record<string, number | number[] | null>; // dihedrals, in space: counts of angles in 18 bins of 10 degrees
  /** Of the step that removes slivers, where there is one. */
  slivers?: {
    bound: number; // degrees
    before: DihedralHistogram;
    after: DihedralHistogram;
    removed: number;
    kept: number;
    reasons: Record<string, number>; // why slivers are kept, and how many
    cells: { simplex: number[]; rule: string; reason: string; near: string }[];
  };
  /** At most the first thousand. */
  unresolved: { simplex: number[]; rule: string; reason: string; near: string }[];
  /** How many there are in all. */
  unresolved_total: number;
  checks: CheckResult[];
  fingerprint: string;
  seconds: number;
  peak_bytes: number;
}

export interface MeshArrays {
  dimension: number;
  inputVertices: number;
  boxVertices: number;
  vertices: Float64Array; // (dimension) numbers a vertex
  cells: Uint32Array; // (dimension + 1) numbers a cell
  cellRegions: Float64Array;
  vertexFeatures: Uint32Array; // 2 numbers a vertex: kind (0 vertex, 1 segment, 2 face, 3 free), index
  edges: Uint32Array; // 3 numbers: a, b, input segment
  facets: Uint32Array; // in space, 4 numbers: a, b, c, input face
}

/** Feature sizes of a complex at points (thesis, Definition 2.1.6), by the oracle that the theorems are checked with. */
export interface FeatureSizesAnswer {
  ok: boolean;
  error: string; // why there are none; the arrays are empty then
  lfs: Float64Array; // one number a point; infinity where no two features are disjoint
  mfs: Float64Array; // one number a point; infinity where there are no two features
  witnesses: Uint32Array; // 4 numbers a point: kind (0 vertex, 1 segment, 2 face; 3 none), index of the two features of lfs, nearer first
  at: Float64Array; // coordinates of the point of each that is nearest to it (4 numbers a point in the plane, 6 in space); NaN where there are none
}

/** Smallest balls that meet two features, centered where the infimum over a set is attained; NaN where there are none. */
export interface FeatureBalls {
  radius: Float64Array; // infinity where there are no two features
  center: Float64Array; // coordinates
  witnesses: Uint32Array; // as in FeatureSizesAnswer
  at: Float64Array;
}

/** fs_1(s), lfs_1(s) and lfs(s) of subsegments (thesis, Definitions 2.1.6 and 2.1.7). */
export interface SubsegmentSizesAnswer {
  ok: boolean;
  error: string; // why there are none; the arrays are empty then
  fs1: FeatureBalls; // lfs_1(s) of an end segment, mfs_1(s) of any other
  lfs1: FeatureBalls; // features of dimension 0 and 1 only
  lfs: FeatureBalls;
}

export interface ReadAnswer {
  ok: boolean;
  format: string;
  complex: ComplexJson;
  mesh: MeshArrays | null;
  defects: Defect[];
}

/** A function u(x, y) worth looking at with linear elements (docs/fem.md). */
export interface FemFunction {
  id: string;
  title: string;
  expression: string;
  /** What is to be seen with it. */
  sentence: string;
  /** In which Sobolev spaces it is. */
  regularity: string;
  /** Corners of the domain that it is meant for. */
  outline: [number, number][];
  /** Whether it is zero on the boundary of that domain (as Theorem 7.12 asks). */
  zeroOnBoundary: boolean;
}

export interface FemFamilyInfo {
  id: string;
  title: string;
  sentence: string;
}

/** The sizes that error estimates speak of; angles in degrees. */
export interface FemSize {
  vertices: number;
  cells: number;
  flatCells: number;
  h: number;
  maxCircumradius: number;
  minAngle: number;
  maxAngle: number;
  area: number;
}

/** A continuous, piecewise linear function on a mesh, and its distance from u. Where `ok` is false, `error` says why. */
export interface FemField {
  ok: boolean;
  error: string;
  /** A sentence that what was measured needs, or empty. */
  warning: string;
  size: FemSize;
  /** Norm of the error in L2, seminorm in H1. */
  l2: number;
  h1: number;
  /** Seminorms of u itself; those that are infinite come out as some large number. */
  u: { l2: number; h1: number; h2: number };
  nodal: Float64Array; // a value for each vertex of the mesh
  cellL2: Float64Array; // the error on each cell
  cellH1: Float64Array;
  /** Evaluations of u, and cells on which the quadrature did not settle. */
  points: number;
  unsettledCells: number;
}

export interface FemPoisson extends FemField {
  unknowns: number;
  factorEntries: number;
  /** Whether the load was taken weakly, since u is made of pieces. */
  weakLoad: boolean;
}

export interface FemAveraged extends FemField {
  averagingRadius: number;
}

/** One triangle, and the constant of Theorem 7.10 on it. Arrays go by corners a, b, c and the edges opposite to them. */
export interface FemTriangle {
  ok: boolean;
  error: string;
  lengths: number[];
  angles: number[]; // degrees
  h: number;
  area: number;
  circumradius: number;
  inradius: number;
  radiusEdge: number;
  circumcenter: [number, number];
  /** T_h(alpha, beta) of Figure 7.2. */
  alpha: number;
  beta: number;
  /** Proposition 7.5: the circumradius is at least this. */
  circumradiusBound: number;
  /** The largest |u - Iu|_1 / |u|_2 among quadratic u, and the same for the norm in L2. */
  h1Constant: number;
  l2Constant: number;
  /** Coefficients of x^2, xy, y^2 of the quadratic that attains h1Constant. */
  worstQuadratic: number[];
  /** Kobayashi's bound on |u - Iu|_1 / |u|_2 for all u in H^2; less than the circumradius. */
  kobayashiBound: number;
  /** For the expression, if there was one; else `interpolationError` may say why. */
  interpolation: { l2: number; h1: number; u: { l2: number; h1: number; h2: number } } | null;
  interpolationError: string;
}

/** A mesh of one size, with what linear elements make of u on it. */
export interface FemStudy {
  ok: boolean;
  error: string;
  defects: Defect[];
  /** How the run ended: 'complete', or by which limit. */
  status: RunStatus;
  mesh: MeshArrays | null;
  interpolation: FemField | null;
  poisson: FemPoisson | null;
}

/** Every function returns a plain object or typed arrays that the caller owns; nothing throws, nothing must be deleted. */
export interface CircumballModule {
  version(): string;
  /** Empty when the arithmetic is sound; else what is wrong. */
  selfTest(): string;
  algorithms(): AlgorithmInfo[];
  /** The names of the enumerators of circumball::EventKind and Reason, by number. */
  traceNames(): { kinds: Record<number, string>; reasons: Record<number, string> };
  /** `files[0]` is read; the others are its siblings (.node beside .poly). */
  read(files: { name: string; bytes: Uint8Array }[]): ReadAnswer;
  check(complex: string): Defect[];
  /**
   * Fills the faces of a complex of space: four numbers a triangle, three vertices (counter-clockwise about the face's normal) and
   * the face. A face that is no polygon has none.
   */
  faceTriangles(complex: string): Uint32Array;
  /**
   * The plane of each face of a complex of space: twelve numbers a face, an origin, two axes and the normal (orthonormal; the frame
   * that the face is triangulated in). NaN as the origin of a face that has none.
   */
  faceFrames(complex: string): Float64Array;
  /** At `points`, two or three coordinates each. The last complex is kept, so that asking about it again is fast. */
  featureSizes(complex: string, points: Float64Array): FeatureSizesAnswer;
  /** Of pieces of input segments: the coordinates of their two ends, one after the other. The last complex is kept here, too. */
  subsegmentSizes(complex: string, ends: Float64Array): SubsegmentSizesAnswer;
  /** Starts a run with a recording sink; `complex` and `options` are JSON. */
  start(
    complex: string,
    options: string,
  ): {
    ok: boolean;
    run: number;
    error: string;
    defects: Defect[];
    steps: string[];
    tau: number;
    domain: string;
    algorithm: string;
  };
  /** Up to `iterations` iterations (0: no bound), about `seconds` at most (0: no bound). */
  advance(run: number, iterations: number, seconds: number): Progress;
  cancel(run: number): Progress;
  takeTrace(run: number): TraceChunk;
  /** The complex that a run refines, the box about it included, as JSON; empty if there is no such run. */
  runComplex(run: number): string;
  mesh(run: number): MeshArrays | null;
  /** The report; `verify` runs the checks that the algorithm promises. */
  report(run: number, verify: boolean): Report | null;
  /** Files in the format of an extension (".ele" gives the family). */
  write(
    run: number,
    extension: string,
  ): { ok: boolean; error: string; files: { extension: string; bytes: Uint8Array }[] };
  writeComplex(
    complex: string,
    extension: string,
  ): { ok: boolean; error: string; files: { extension: string; bytes: Uint8Array }[] };
  meshExtensions(dimension: number): string[];
  release(run: number): void;

  /** Linear finite elements: chapter 7 of the thesis as a laboratory (docs/fem.md). Expressions are those of `size`. */
  femFunctions(): FemFunction[];
  femFamilies(): FemFamilyInfo[];
  /** A mesh of Figure 7.1 with n columns; the larger `degeneration`, the narrower its triangles. */
  femFamily(
    id: string,
    n: number,
    degeneration: number,
  ): { ok: boolean; error: string; mesh: MeshArrays | null };
  /** The linear interpolant on the mesh of a run, or on any other mesh of the plane. */
  femInterpolate(mesh: number | MeshArrays, expression: string): FemField;
  /** -Laplace(v) = -Laplace(u) with v = u on the boundary. */
  femPoisson(mesh: number | MeshArrays, expression: string): FemPoisson;
  /** The averaged interpolant of Theorem 7.12; `h` is at least the longest edge, 0 for just that. */
  femAveraged(mesh: number | MeshArrays, expression: string, h: number): FemAveraged;
  /** One triangle; without interpolation if the expression is empty. */
  femTriangle(
    ax: number,
    ay: number,
    bx: number,
    by: number,
    cx: number,
    cy: number,
    expression: string,
  ): FemTriangle;
  /**
   * Meshes the complex with the given options and size, interpolates, and solves. One point of a study: call it for one
   * size after the other. Without `maxVertices` among the options, 200,000 is taken.
   */
  femStudy(complex: string, options: string, expression: string, size: number): FemStudy;
}

export default function createCircumball(options?: {
  locateFile?: (path: string) => string;
  wasmBinary?: ArrayBuffer | Uint8Array;
}): Promise<CircumballModule>;
