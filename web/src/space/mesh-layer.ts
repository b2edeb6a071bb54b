/** The mesh in space on the GPU: triangles of faces, tetrahedra, subsegments and vertices; only what changed is written anew. */

import { type Object3D, Vector4 } from 'three';
import { parseColor } from '../picture/color';
import { Batch } from '../picture/gpu/batch';
import { SlotTable } from '../picture/mesh-model';
import {
  type FacetState,
  Label,
  type MeshState,
  type PictureTheme,
  type Point3,
  VertexKind,
} from '../shared/types';
import { type Adjacency, adjacencyOf } from './adjacency';
import { rgbaOf, type SpaceColoring } from './coloring';
import { type Cut, cutCells, noCut } from './cut';
import { putLine, putMark3, putPoint3 } from './layer';
import { vertexMark3 } from './marks';
import { line3Shader, mark3Shader, type SpaceUniforms, triangleShader } from './shaders';
import type { SpaceLook } from './types';
import type { Plane, Window3 } from './view';

export const segmentWidth = 2.4;
/** In place of an input segment: of the box. */
const NO_SEGMENT = 0xffffffff;

/** Everything that the rows are written from. */
export interface MeshLook {
  readonly theme: PictureTheme;
  readonly look: SpaceLook;
  readonly coloring: SpaceColoring;
  readonly plane: Plane | null;
  readonly window: Window3;
}

function triangleUniforms(lift: number) {
  return {
    uEdge: { value: new Vector4() },
    uEdgeWidth: { value: 1 },
    uOpacity: { value: 1 },
    uLit: { value: 1 },
    uClips: { value: 1 },
    uLift: { value: lift },
  };
}

export class SpaceMeshLayer {
  readonly cut: Cut = noCut();
  /** Faces with triangles of their own: the fill of the input gives way to them. */
  readonly filledFaces = new Set<number>();
  private readonly cellUniforms = triangleUniforms(0);
  private readonly facetUniforms = triangleUniforms(0.75);
  private readonly cells: Batch;
  private readonly facets: Batch;
  private readonly segments: Batch;
  private readonly vertices: Batch;
  private readonly vertexSize = { value: 1 };
  private readonly facetSlots = new SlotTable();
  private readonly segmentSlots = new SlotTable();
  private vertexSeen = new Uint8Array(0); // 1: row is written for a vertex that is there
  private vertexCount = 0;
  private lastAdjacency: { state: MeshState; adjacency: Adjacency } | null = null;

  constructor(parent: Object3D, uniforms: SpaceUniforms) {
    this.cells = new Batch(triangleShader(this.cellUniforms), uniforms, 0, 'write');
    this.facets = new Batch(triangleShader(this.facetUniforms), uniforms, 12, 'test');
    this.segments = new Batch(line3Shader, uniforms, 30, 'test');
    this.vertices = new Batch(mark3Shader({ uSize: this.vertexSize }), uniforms, 44, 'test');
    for (const batch of this.batches()) parent.add(batch.mesh);
  }

  /** Another run, or another window: every row is written at the next `sync`. */
  clear(): void {
    this.facetSlots.clear();
    this.segmentSlots.clear();
    this.filledFaces.clear();
    this.vertexSeen.fill(0);
    this.vertexCount = 0;
    this.cut.count = 0;
    for (const batch of this.batches()) batch.flush(0);
  }

  setLook({ theme, look }: MeshLook): void {
    const solid = look.faces === 'solid';
    const { facetUniforms, cellUniforms } = this;
    const edge = parseColor(theme.edge);
    const faint = look.cells ? 0.35 : 1;
    facetUniforms.uEdge.value.set(edge[0], edge[1], edge[2], look.facets ? faint : 0);
    facetUniforms.uOpacity.value = faceOpacity(look, theme);
    facetUniforms.uLit.value = solid ? (look.color === 'plain' ? 1 : 0.5) : 0.4;
    const ink = parseColor(theme.dark ? '#0a0c0e' : '#3c4a54');
    cellUniforms.uEdge.value.set(ink[0], ink[1], ink[2], theme.dark ? 0.9 : 0.55);
    // Colors are to be compared with those of the scale: they are lit less.
    cellUniforms.uLit.value = look.color === 'plain' ? 1 : 0.5;
    this.facets.mesh.material.depthWrite = solid;
    // Solid faces are drawn before what is translucent.
    this.facets.mesh.renderOrder = solid ? 1 : 12;
  }

  setVertexSize(size: number): void {
    this.vertexSize.value = size;
  }

  show(meshed: boolean, look: SpaceLook): void {
    this.cells.mesh.visible = meshed && look.cells && this.cells.count > 0;
    this.facets.mesh.visible =
      meshed && (look.faces !== 'hidden' || look.facets) && this.facets.count > 0;
    this.segments.mesh.visible = meshed && this.segments.count > 0;
    this.vertices.mesh.visible = meshed && look.vertices && this.vertices.count > 0;
  }

  /** Brings subsegments, vertices and triangles of faces to a state. O(live) comparisons, writes only what differs. */
  sync(state: MeshState, look: MeshLook): void {
    this.syncSegments(state, look);
    this.syncVertices(state, look);
    if (state.facets) this.syncFacets(state, state.facets, look);
  }

  /** O(live cells): what is seen of them depends on all of them. */
  setCells(state: MeshState, { look, coloring, theme, plane, window }: MeshLook): void {
    const { cells: batch, cut } = this;
    const { outside, highlight: only, shrink, peel } = look;
    const exact = look.clip?.exact ?? false;
    const options = { outside, only, plane, exact, shrink: 0.7 * shrink, peel };
    cutCells(state, options, cut, shrink > 0 && peel === 0 ? null : this.adjacencyOf(state));
    this.cellUniforms.uClips.value = exact && !only ? 1 : 0;
    const plain = parseColor(theme.dark ? '#3a4a54' : '#d3e1e9');
    batch.reserve(cut.count);
    const { array, stride } = batch;
    const [ox, oy, oz] = window.origin;
    for (let row = 0; row < cut.count; row++) {
      const at = row * stride;
      for (let k = 0; k < 9; k += 3) {
        array[at + k] = (cut.corners[9 * row + k]! - ox) * window.unit;
        array[at + k + 1] = (cut.corners[9 * row + k + 1]! - oy) * window.unit;
        array[at + k + 2] = (cut.corners[9 * row + k + 2]! - oz) * window.unit;
      }
      const color = coloring.mode === 'plain' ? plain : coloring.cellColor(state, cut.cells[row]!);
      array[at + 9] = color[0];
      array[at + 10] = color[1];
      array[at + 11] = color[2];
      array[at + 12] = 1;
      array[at + 13] = cut.edges[row]!;
    }
    batch.touchAll();
    batch.flush(cut.count);
  }

  /** Mean length of the subsegments that are not of the box. */
  spacing(state: MeshState): number {
    let sum = 0;
    let count = 0;
    for (let i = 0; i < state.liveSubsegmentCount; i++) {
      const n = 3 * state.liveSubsegments[i]!;
      if (state.subsegments[n + 2] === NO_SEGMENT) continue;
      const a = 3 * state.subsegments[n]!;
      const b = 3 * state.subsegments[n + 1]!;
      const at = state.coordinates;
      sum += Math.hypot(at[a]! - at[b]!, at[a + 1]! - at[b + 1]!, at[a + 2]! - at[b + 2]!);
      count++;
    }
    return count > 0 ? sum / count : 0;
  }

  /** Kept while the plane moves through one state. */
  private adjacencyOf(state: MeshState): Adjacency {
    const { lastAdjacency: last } = this;
    if (last?.state === state) return last.adjacency;
    const adjacency = adjacencyOf(state);
    this.lastAdjacency = { state, adjacency };
    return adjacency;
  }

  dispose(): void {
    for (const batch of this.batches()) batch.dispose();
  }

  private batches(): Batch[] {
    return [this.cells, this.facets, this.segments, this.vertices];
  }

  private syncSegments(state: MeshState, { theme, window }: MeshLook): void {
    const { segments: batch, segmentSlots: slots } = this;
    batch.reserve(state.liveSubsegmentCount);
    const count = state.subsegments.length / 3;
    const ink = parseColor(theme.ink);
    const ofBox = parseColor(theme.box);
    slots.sync(state.liveSubsegments, state.liveSubsegmentCount, count, (slot) => {
      const n = slots.numbers[slot]!;
      const [a, b, s] = state.subsegments.subarray(3 * n, 3 * n + 3) as unknown as Three;
      const isBox = s === NO_SEGMENT;
      const color = isBox ? ofBox : ink;
      const width = isBox ? 1.2 : segmentWidth;
      const [p, q] = [place(state, a), place(state, b)];
      // A line out of sight keeps its row, with nothing to see.
      if (putLine(batch, slot, p, q, color, window, width) === 0)
        batch.array.fill(0, slot * batch.stride, (slot + 1) * batch.stride);
      batch.touch(slot);
    });
    batch.flush(slots.count);
  }

  private syncVertices(state: MeshState, { theme, window }: MeshLook): void {
    const { vertices: batch } = this;
    const n = state.vertexCount;
    if (this.vertexSeen.length < n) {
      const seen = new Uint8Array(Math.ceil(n * 1.5) + 64);
      seen.set(this.vertexSeen);
      this.vertexSeen = seen;
    }
    batch.reserve(n);
    for (let v = 0; v < n; v++) {
      const alive = state.vertexBorn[v]! < state.position ? 1 : 0;
      if (v < this.vertexCount && this.vertexSeen[v] === alive) continue;
      this.vertexSeen[v] = alive;
      const kind = state.vertexKind[v]!;
      // Vertices of the input are drawn with the input.
      if (alive === 0 || kind === VertexKind.input)
        batch.array.fill(0, v * batch.stride, (v + 1) * batch.stride);
      else putMark3(batch, v, vertexMark3(kind, place(state, v), theme), window);
      batch.touch(v);
    }
    this.vertexCount = Math.max(this.vertexCount, n);
    batch.flush(n);
  }

  private syncFacets(state: MeshState, facets: FacetState, mesh: MeshLook): void {
    const { facets: batch, facetSlots: slots } = this;
    batch.reserve(facets.liveCount);
    slots.sync(facets.live, facets.liveCount, facets.count, (slot) => {
      const n = slots.numbers[slot]!;
      this.filledFaces.add(facets.triangles[4 * n + 3]!);
      this.putFacet(state, facets, n, slot, mesh);
      batch.touch(slot);
    });
    batch.flush(slots.count);
    if (facets.liveCount === 0) this.filledFaces.clear();
  }

  private putFacet(
    state: MeshState,
    facets: FacetState,
    n: number,
    slot: number,
    { theme, coloring, look, window }: MeshLook,
  ): void {
    const { array, stride } = this.facets;
    const at = slot * stride;
    for (let k = 0; k < 3; k++)
      putPoint3(array, at + 3 * k, place(state, facets.triangles[4 * n + k]!), window);
    if (facets.label[n] === Label.outside) {
      // A hole of the face: its triangulation goes on there, but the face does not.
      array.fill(0, at + 9, at + 14);
      return;
    }
    const colored = coloring.mode !== 'plain' && !look.cells;
    const color = colored ? coloring.facetColor(state, n) : rgbaOf(faceColor(theme));
    array.set(color, at + 9);
    // A translucent color would be another one.
    array[at + 12] = colored && look.faces === 'translucent' ? 3 : 1;
    array[at + 13] = 7;
  }
}

type Three = [number, number, number];

export function place(state: MeshState, v: number): Point3 {
  const xyz = state.coordinates;
  return [xyz[3 * v]!, xyz[3 * v + 1]!, xyz[3 * v + 2]!];
}

export function faceColor(theme: PictureTheme): string {
  return theme.dark ? '#4f7f9f' : '#7fa9c4';
}

export function faceOpacity(look: SpaceLook, theme: PictureTheme): number {
  if (look.faces === 'hidden') return 0;
  return look.faces === 'solid' ? 1 : theme.dark ? 0.2 : 0.22;
}
