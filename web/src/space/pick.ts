/** What lies under a place of the canvas, in double precision, one by one: a press is rare. */

import { type Complex3, Label, type MeshState, type Point3 } from '../shared/types';
import type { Cut } from './cut';
import { place } from './mesh-layer';
import type { SpaceView } from './types';
import { noHit, type SpaceHit, type SpaceLook } from './types';
import { type Basis, type Plane, project, type Size } from './view';

/** Distances in pixels within which a vertex or segment is meant. */
const reach = { vertex: 10, segment: 6 };
/** Pixels of depth that a vertex or segment may lie behind a face, and still be on it. */
const onFace = 12;

export interface PickScene {
  readonly view: SpaceView;
  readonly basis: Basis;
  readonly size: Size;
  readonly look: SpaceLook;
  readonly plane: Plane | null;
  readonly complex: Complex3 | null;
  readonly triangles: Uint32Array; // of the faces of the complex
  readonly state: MeshState | null; // null: the complex alone is drawn
  readonly filledFaces: ReadonlySet<number>;
  readonly cut: Cut;
}

export function pickSpace(scene: PickScene, x: number, y: number): SpaceHit | null {
  const { look, state } = scene;
  const surface = pickSurface(scene, x, y);
  // What solid things hide is not meant; through translucent faces vertices and segments are seen.
  const hidden = surface && (look.faces === 'solid' || surface.hit.cell !== null);
  const front = hidden ? surface.depth - onFace : Number.NEGATIVE_INFINITY;
  const vertex = pickVertex(scene, x, y, front);
  if (vertex !== null) return { ...noHit, vertex };
  const subsegment = pickSegment(scene, x, y, front);
  if (subsegment !== null) return { ...noHit, subsegment };
  if (surface && (look.faces !== 'hidden' || surface.hit.cell !== null || state))
    return surface.hit;
  return null;
}

function visible({ plane }: PickScene, p: Point3): boolean {
  if (!plane) return true;
  const [a, b, c] = plane.normal;
  return a * p[0] + b * p[1] + c * p[2] <= plane.offset;
}

function pickVertex(scene: PickScene, x: number, y: number, front: number): number | null {
  const { state, complex, look } = scene;
  const count = state ? state.vertexCount : (complex?.vertices.length ?? 0);
  let best: number | null = null;
  let bestDistance: number = reach.vertex;
  let bestDepth = Number.NEGATIVE_INFINITY;
  for (let v = 0; v < count; v++) {
    if (state && !(state.vertexBorn[v]! < state.position)) continue;
    if (state && !look.vertices && v >= (complex?.vertices.length ?? 0)) continue;
    const p = state ? place(state, v) : complex!.vertices[v]!;
    const [px, py, depth] = project(scene.view, scene.basis, scene.size, p);
    const distance = Math.hypot(px - x, py - y);
    if (!(distance <= reach.vertex) || depth < front || !visible(scene, p)) continue;
    // Of two in one place the nearer to the eye.
    if (distance < bestDistance - 1 || (distance < bestDistance + 1 && depth > bestDepth)) {
      best = v;
      bestDistance = distance;
      bestDepth = depth;
    }
  }
  return best;
}

function pickSegment(scene: PickScene, x: number, y: number, front: number): number | null {
  const { state, complex } = scene;
  let best: number | null = null;
  let bestDepth = Number.NEGATIVE_INFINITY;
  const look = (n: number, a: Point3, b: Point3) => {
    const p = project(scene.view, scene.basis, scene.size, a);
    const q = project(scene.view, scene.basis, scene.size, b);
    const [dx, dy] = [q[0] - p[0], q[1] - p[1]];
    const l2 = dx * dx + dy * dy;
    const t = l2 > 0 ? Math.min(1, Math.max(0, ((x - p[0]) * dx + (y - p[1]) * dy) / l2)) : 0;
    const distance = Math.hypot(p[0] + t * dx - x, p[1] + t * dy - y);
    const depth = p[2] + t * (q[2] - p[2]);
    if (!(distance <= reach.segment) || depth < front || depth < bestDepth) return;
    const at: Point3 = [
      a[0] + t * (b[0] - a[0]),
      a[1] + t * (b[1] - a[1]),
      a[2] + t * (b[2] - a[2]),
    ];
    if (!visible(scene, at)) return;
    best = n;
    bestDepth = depth;
  };
  if (state) {
    for (let i = 0; i < state.liveSubsegmentCount; i++) {
      const n = state.liveSubsegments[i]!;
      look(n, place(state, state.subsegments[3 * n]!), place(state, state.subsegments[3 * n + 1]!));
    }
  } else if (complex) {
    for (const [n, [a, b]] of complex.segments.entries()) {
      const [p, q] = [complex.vertices[a], complex.vertices[b]];
      if (p && q) look(n, p, q);
    }
  }
  return best;
}

/** The nearest triangle, of a face or of a cell. */
function pickSurface(
  scene: PickScene,
  x: number,
  y: number,
): { hit: SpaceHit; depth: number } | null {
  const { state, complex, cut, look } = scene;
  let best: { hit: SpaceHit; depth: number } | null = null;
  const test = (a: Point3, b: Point3, c: Point3, hit: () => SpaceHit, always = false) => {
    const [p, q, r] = [a, b, c].map((v) => project(scene.view, scene.basis, scene.size, v)) as [
      Point3,
      Point3,
      Point3,
    ];
    const area = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
    if (area === 0) return;
    const u = ((q[0] - x) * (r[1] - y) - (q[1] - y) * (r[0] - x)) / area;
    const v = ((r[0] - x) * (p[1] - y) - (r[1] - y) * (p[0] - x)) / area;
    const w = 1 - u - v;
    if (u < 0 || v < 0 || w < 0) return;
    const depth = u * p[2] + v * q[2] + w * r[2];
    if (best && depth <= best.depth) return;
    const at = (k: 0 | 1 | 2) => u * a[k] + v * b[k] + w * c[k];
    if (!always && !visible(scene, [at(0), at(1), at(2)])) return;
    best = { hit: hit(), depth };
  };
  if (look.cells && state) {
    for (let row = 0; row < cut.count; row++) {
      const at = (i: number): Point3 => [
        cut.corners[9 * row + 3 * i]!,
        cut.corners[9 * row + 3 * i + 1]!,
        cut.corners[9 * row + 3 * i + 2]!,
      ];
      // Whole cells reach beyond the plane, and caps lie on it.
      const always = !look.clip?.exact || cut.edges[row]! >= 8;
      test(at(0), at(1), at(2), () => ({ ...noHit, cell: cut.cells[row]! }), always);
    }
  }
  const facets = state?.facets;
  if (facets) {
    for (let i = 0; i < facets.liveCount; i++) {
      const n = facets.live[i]!;
      if (facets.label[n] === Label.outside) continue;
      const [a, b, c, face] = facets.triangles.subarray(4 * n, 4 * n + 4);
      const hit = () => ({ ...noHit, facet: n, face: face! });
      test(place(state, a!), place(state, b!), place(state, c!), hit);
    }
  }
  const { triangles } = scene;
  for (let t = 0; complex && t < triangles.length; t += 4) {
    const face = triangles[t + 3]!;
    if (state && scene.filledFaces.has(face)) continue;
    const [a, b, c] = [0, 1, 2].map((k) => complex.vertices[triangles[t + k]!]);
    if (a && b && c) test(a, b, c, () => ({ ...noHit, face }));
  }
  return best;
}

/** What a simplex of the mesh is picked as: a tetrahedron, a triangle of a face, a subsegment or a vertex; null if it is not there. */
export function findSimplex(state: MeshState, simplex: readonly number[]): SpaceHit | null {
  const wanted = new Set(simplex);
  const find = (live: Uint32Array, count: number, all: Uint32Array, stride: number, of: number) => {
    for (let i = 0; i < count; i++) {
      const at = stride * live[i]!;
      let found = true;
      for (let k = 0; found && k < of; k++) found = wanted.has(all[at + k]!);
      if (found) return live[i]!;
    }
    return null;
  };
  const { facets } = state;
  if (simplex.length === 4) {
    const cell = find(state.liveCells, state.liveCellCount, state.cells, 4, 4);
    return cell === null ? null : { ...noHit, cell };
  }
  if (simplex.length === 3 && facets) {
    const facet = find(facets.live, facets.liveCount, facets.triangles, 4, 3);
    return facet === null ? null : { ...noHit, facet, face: facets.triangles[4 * facet + 3]! };
  }
  if (simplex.length === 2) {
    const { liveSubsegments, liveSubsegmentCount, subsegments } = state;
    const subsegment = find(liveSubsegments, liveSubsegmentCount, subsegments, 3, 2);
    return subsegment === null ? null : { ...noHit, subsegment };
  }
  return simplex.length === 1 ? { ...noHit, vertex: simplex[0]! } : null;
}
