/** The mesh on the GPU: triangles with their edges, and vertices, row by row as the model's slots change. */

import {
  ClampToEdgeWrapping,
  DataTexture,
  LinearFilter,
  NearestFilter,
  type Object3D,
  RGBAFormat,
  UnsignedByteType,
  type Vector4,
} from 'three';
import { Label, type PictureTheme, type Point, VertexKind } from '../../shared/types';
import { clipPolygon } from '../clip';
import { mix, parseColor } from '../color';
import type { Coloring } from '../coloring';
import { vertexMark } from '../marks';
import type { MeshModel } from '../mesh-model';
import type { Window } from '../window';
import { Batch } from './batch';
import { contains, putMark } from './layer';
import { markShader } from './shapes';
import { makeTriangleUniforms, TriangleFlag, triangleShader } from './triangles';
import type { ViewUniforms } from './uniforms';

export interface MeshLook {
  readonly theme: PictureTheme;
  readonly outside: boolean;
  readonly highlight: ReadonlySet<number> | null;
}

export class MeshLayer {
  private readonly triangles: Batch;
  private readonly vertices: Batch;
  private readonly triangleUniforms;
  private readonly markUniforms = {
    uSize: { value: 1 },
    uLanding: { value: -1 },
    uLandingSize: { value: 1 },
  };
  private readonly ramp: DataTexture;
  private readonly model: MeshModel;

  constructor(parent: Object3D, view: ViewUniforms, model: MeshModel, order: number, top: number) {
    this.model = model;
    this.ramp = new DataTexture(new Uint8Array(256 * 4), 256, 1, RGBAFormat, UnsignedByteType);
    this.ramp.wrapS = ClampToEdgeWrapping;
    this.triangleUniforms = makeTriangleUniforms(this.ramp);
    this.triangles = new Batch(triangleShader(this.triangleUniforms), view, order);
    this.vertices = new Batch(markShader(this.markUniforms), view, top);
    parent.add(this.triangles.mesh, this.vertices.mesh);
  }

  /** Colors and widths that need no buffer. */
  setLook(theme: PictureTheme, coloring: Coloring): void {
    const u = this.triangleUniforms;
    setPremultiplied(u.uFill.value, theme.fill);
    setPremultiplied(u.uFillOutside.value, theme.fillOutside);
    setPremultiplied(u.uEdge.value, theme.edge);
    setPremultiplied(u.uEdgeOutside.value, theme.inkFaint);
    setPremultiplied(u.uStress.value, mix(theme.fill, theme.selection, 0.6));
    const scale = coloring.scale;
    u.uColored.value = scale ? 1 : 0;
    if (scale) {
      const data = this.ramp.image.data as Uint8Array;
      for (let i = 0; i < 256; ++i) {
        const [r, g, b] = coloring.rgba(i / 255);
        data.set([r * 255, g * 255, b * 255, 255].map(Math.round), 4 * i);
      }
      const filter = coloring.categorical ? NearestFilter : LinearFilter;
      this.ramp.minFilter = filter;
      this.ramp.magFilter = filter;
      this.ramp.needsUpdate = true;
      // On paper quieter edges leave the word to the colors; on dark fills they would be lost.
      if (!theme.dark) u.uEdge.value.multiplyScalar(0.75);
    }
    this.setRange(coloring);
  }

  setRange(coloring: Coloring): void {
    const [min, max] = coloring.range;
    this.triangleUniforms.uRange.value.set(min, max > min ? 1 / (max - min) : 0, 0, 0);
  }

  setVertexSize(size: number): void {
    this.markUniforms.uSize.value = size;
  }

  /** The vertex that is landing, and how large it is drawn meanwhile. Only while no window clips. */
  setLanding(vertex: number, size: number): void {
    this.markUniforms.uLanding.value = vertex;
    this.markUniforms.uLandingSize.value = size;
  }

  show(triangles: boolean, vertices: boolean): void {
    this.triangles.mesh.visible = triangles && this.triangles.count > 0;
    this.vertices.mesh.visible = vertices && this.vertices.count > 0;
  }

  /** Writes the rows of these slots; for use while the window is whole. */
  updateTriangles(
    slots: readonly number[],
    window: Window,
    look: MeshLook,
    coloring: Coloring,
  ): void {
    this.triangles.reserve(this.model.triangleCount);
    for (const slot of slots) {
      if (slot >= this.model.triangleCount) continue;
      this.writeTriangle(slot, slot, this.corners(slot), window, look, coloring);
      this.triangles.touch(slot);
    }
    this.triangles.flush(this.model.triangleCount);
  }

  /** Writes everything anew, clipped to the window if it has a box. */
  rebuildTriangles(window: Window, look: MeshLook, coloring: Coloring): void {
    const model = this.model;
    const box = window.box;
    let row = 0;
    for (let slot = 0; slot < model.triangleCount; ++slot) {
      let corners = this.corners(slot);
      if (box) {
        const [[ax, ay], [bx, by], [cx, cy]] = corners as [Point, Point, Point];
        if (
          Math.max(ax, bx, cx) < box.minX ||
          Math.min(ax, bx, cx) > box.maxX ||
          Math.max(ay, by, cy) < box.minY ||
          Math.min(ay, by, cy) > box.maxY
        ) {
          continue;
        }
        corners = clipPolygon(corners, box);
      }
      this.triangles.reserve(row + corners.length);
      for (let i = 1; i + 1 < corners.length; ++i) {
        const piece = [corners[0]!, corners[i]!, corners[i + 1]!];
        this.writeTriangle(row++, slot, piece, window, look, coloring);
      }
    }
    this.triangles.touchAll();
    this.triangles.flush(row);
  }

  updateVertices(changed: readonly number[], window: Window, look: MeshLook): void {
    this.vertices.reserve(this.model.vertexCount);
    for (const v of changed) {
      this.writeVertex(v, v, window, look);
      this.vertices.touch(v);
    }
    this.vertices.flush(this.model.vertexCount);
  }

  rebuildVertices(window: Window, look: MeshLook): void {
    const model = this.model;
    this.vertices.reserve(model.vertexCount);
    let row = 0;
    for (let v = 0; v < model.vertexCount; ++v) {
      if (window.box && (!model.vertexAlive[v] || !contains(window, this.place(v)))) continue;
      this.writeVertex(row++, v, window, look);
    }
    this.vertices.touchAll();
    this.vertices.flush(row);
  }

  dispose(): void {
    this.triangles.dispose();
    this.vertices.dispose();
    this.ramp.dispose();
  }

  private place(v: number): Point {
    return [this.model.coordinates[2 * v]!, this.model.coordinates[2 * v + 1]!];
  }

  private corners(slot: number): readonly Point[] {
    const t = this.model.triangles;
    return [this.place(t[3 * slot]!), this.place(t[3 * slot + 1]!), this.place(t[3 * slot + 2]!)];
  }

  private writeVertex(row: number, v: number, window: Window, look: MeshLook): void {
    const batch = this.vertices;
    putMark(
      batch.array,
      row * batch.stride,
      vertexMark(this.model.vertexKind[v]!, this.place(v), look.theme),
      window,
    );
    // Those of the input are drawn with the input, before they are in the mesh and however dense it is.
    const shown = this.model.vertexAlive[v] && this.model.vertexKind[v] !== VertexKind.input;
    if (!shown) batch.array[row * batch.stride + 2] = 0;
  }

  private writeTriangle(
    row: number,
    slot: number,
    piece: readonly Point[],
    window: Window,
    look: MeshLook,
    coloring: Coloring,
  ): void {
    const batch = this.triangles;
    const { array, stride } = batch;
    const at = row * stride;
    const label = this.model.labels[slot]!;
    if (label === Label.outside && !look.outside) {
      array.fill(0, at, at + stride);
      return;
    }
    for (let k = 0; k < 3; ++k) {
      array[at + 2 * k] = (piece[k]![0] - window.originX) * window.unit;
      array[at + 2 * k + 1] = (piece[k]![1] - window.originY) * window.unit;
    }
    const corners = this.corners(slot);
    let longest = 0;
    for (let k = 0; k < 3; ++k) {
      const p = corners[k]!;
      const q = corners[(k + 1) % 3]!;
      const dx = q[0] - p[0];
      const dy = q[1] - p[1];
      const length = Math.hypot(dx, dy);
      longest = Math.max(longest, length);
      const ox = window.originX - p[0];
      const oy = window.originY - p[1];
      const e = at + 6 + 3 * k;
      array[e] = -dy / length;
      array[e + 1] = dx / length;
      array[e + 2] = ((dx * oy - dy * ox) / length) * window.unit;
    }
    let flags = 0;
    if (label === Label.outside) flags |= TriangleFlag.outside;
    else if (label === Label.unknown) flags |= TriangleFlag.unknown;
    if (look.highlight) {
      const stressed = look.highlight.has(this.model.triangleSlots.numbers[slot]!);
      flags |= stressed ? TriangleFlag.stressed : TriangleFlag.dimmed;
    }
    array[at + 15] = Math.min(longest * window.unit, 3e38);
    array[at + 16] = coloring.value(slot);
    array[at + 17] = flags;
  }
}

function setPremultiplied(target: Vector4, css: string): void {
  const [r, g, b, a] = parseColor(css);
  target.set(r * a, g * a, b * a, a);
}
