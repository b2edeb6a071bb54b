/** A display list of space on the GPU: triangles, spheres, lines, marks, texts. */

import { type Object3D, Vector4 } from 'three';
import { parseColor, type Rgba } from '../picture/color';
import { Batch, type Depth } from '../picture/gpu/batch';
import { type Glyphs, textWidth } from '../picture/gpu/glyphs';
import { finish, putStyle, shapeNumber } from '../picture/gpu/layer';
import type { Point3 } from '../shared/types';
import type { Mark3Item, SpaceItems, Text3Item } from './items';
import {
  line3Shader,
  mark3Shader,
  type SpaceUniforms,
  sphereShader,
  text3Shader,
  triangleShader,
} from './shaders';
import { clipToWindow, type Window3 } from './view';

/** Spheres of more pixels are planes: their rim is far away, and single precision does not hold them. */
const LARGEST_SPHERE = 1e6;

export class SpaceLayer {
  private readonly triangles: Batch;
  private readonly spheres: Batch;
  private readonly lines: Batch;
  private readonly marks: Batch;
  private readonly texts: Batch;
  private readonly size = { value: 1 };

  /** `depth` none: above everything; test: what is behind is hidden. */
  constructor(
    parent: Object3D,
    uniforms: SpaceUniforms,
    private readonly glyphs: Glyphs,
    order: number,
    depth: Depth,
  ) {
    const plain = {
      uEdge: { value: new Vector4() },
      uEdgeWidth: { value: 0 },
      uOpacity: { value: 1 },
      uLit: { value: 0 },
      uClips: { value: 0 },
      uLift: { value: 1 },
    };
    this.triangles = new Batch(triangleShader(plain), uniforms, order, depth);
    this.spheres = new Batch(sphereShader, uniforms, order + 1, 'test');
    this.lines = new Batch(line3Shader, uniforms, order + 2, depth);
    this.marks = new Batch(mark3Shader({ uSize: this.size }), uniforms, order + 3, depth);
    this.texts = new Batch(text3Shader(glyphs.texture), uniforms, order + 4, depth);
    for (const batch of this.batches()) parent.add(batch.mesh);
  }

  setMarkSize(size: number): void {
    this.size.value = size;
  }

  /** `scale`: pixels a world unit. */
  set(items: SpaceItems, window: Window3, scale: number): void {
    this.setTriangles(items, window);
    this.setSpheres(items, window, scale);
    this.setLines(items, window);
    this.setMarks(items.marks, window);
    this.setTexts(items.texts, window);
  }

  dispose(): void {
    for (const batch of this.batches()) batch.dispose();
  }

  private batches(): Batch[] {
    return [this.triangles, this.spheres, this.lines, this.marks, this.texts];
  }

  private setTriangles({ triangles }: SpaceItems, window: Window3): void {
    const batch = this.triangles;
    batch.reserve(triangles.length);
    for (const [row, { corners, fill, opacity }] of triangles.entries()) {
      const at = row * batch.stride;
      for (const [k, p] of corners.entries()) putPoint3(batch.array, at + 3 * k, p, window);
      const color = parseColor(fill);
      batch.array.set(color, at + 9);
      batch.array[at + 12] = color[3] * opacity;
      batch.array[at + 13] = 0;
    }
    finish(batch, triangles.length);
  }

  private setSpheres({ spheres }: SpaceItems, window: Window3, scale: number): void {
    const batch = this.spheres;
    batch.reserve(spheres.length);
    let row = 0;
    for (const item of spheres) {
      if (!(item.radius * scale < LARGEST_SPHERE)) continue;
      const at = row++ * batch.stride;
      putPoint3(batch.array, at, item.center, window);
      batch.array[at + 3] = item.radius * window.unit;
      putStyle(batch.array, at + 4, item.width ?? 1.5, item.dash);
      batch.array.set(parseColor(item.color), at + 7);
      batch.array[at + 10] = item.opacity;
    }
    finish(batch, row);
  }

  private setLines({ lines }: SpaceItems, window: Window3): void {
    const batch = this.lines;
    batch.reserve(lines.length);
    let row = 0;
    for (const item of lines) {
      const { color, width, dash, opacity } = item;
      row += putLine(batch, row, item.a, item.b, parseColor(color), window, width, dash, opacity);
    }
    finish(batch, row);
  }

  private setMarks(marks: readonly Mark3Item[], window: Window3): void {
    const batch = this.marks;
    batch.reserve(marks.length);
    for (const [row, item] of marks.entries()) putMark3(batch, row, item, window);
    finish(batch, marks.length);
  }

  private setTexts(items: readonly Text3Item[], window: Window3): void {
    let row = 0;
    for (const item of items) {
      // The halo of a character must not cut into the one before.
      if (item.halo) row = this.putText(row, item, clear, parseColor(item.halo), window);
      row = this.putText(row, item, parseColor(item.color), clear, window);
    }
    finish(this.texts, row);
  }

  private putText(row: number, item: Text3Item, ink: Rgba, halo: Rgba, window: Window3): number {
    const { glyphs, texts: batch } = this;
    const side = glyphs.cellSize * item.size;
    let next = row;
    let pen = item.dx - textWidth(glyphs, item.text, item.size) / 2;
    batch.reserve(row + item.text.length);
    for (const c of item.text) {
      const at = next++ * batch.stride;
      putPoint3(batch.array, at, item.at, window);
      const left = pen - glyphs.padX * item.size;
      batch.array.set([left, item.dy - glyphs.padY * item.size, side, side], at + 3);
      batch.array.set(glyphs.uv(c), at + 7);
      batch.array.set(ink, at + 11);
      batch.array.set(halo, at + 15);
      pen += glyphs.advance(c) * item.size;
    }
    return next;
  }
}

const clear: Rgba = [0, 0, 0, 0];

export function putPoint3(array: Float32Array, at: number, p: Point3, window: Window3): void {
  const { origin, unit } = window;
  array[at] = (p[0] - origin[0]) * unit;
  array[at + 1] = (p[1] - origin[1]) * unit;
  array[at + 2] = (p[2] - origin[2]) * unit;
}

/** Writes a row of a line batch, and returns how many: none for a line that is nowhere near the window. */
export function putLine(
  batch: Batch,
  row: number,
  a: Point3,
  b: Point3,
  color: Rgba,
  window: Window3,
  width: number,
  dash?: 'solid' | 'dashed' | 'dotted',
  opacity = 1,
): 0 | 1 {
  const ends = clipToWindow(a, b, window);
  if (!ends) return 0;
  const at = row * batch.stride;
  putPoint3(batch.array, at, ends[0], window);
  putPoint3(batch.array, at + 3, ends[1], window);
  batch.array.set(color, at + 6);
  batch.array[at + 9] = color[3] * opacity;
  putStyle(batch.array, at + 10, width, dash);
  return 1;
}

export function putMark3(batch: Batch, row: number, item: Mark3Item, window: Window3): void {
  const at = row * batch.stride;
  const { array } = batch;
  putPoint3(array, at, item.at, window);
  putPoint3(array, at + 3, item.from ?? item.at, window);
  array[at + 6] = item.size;
  array[at + 7] = shapeNumber[item.shape];
  array[at + 8] = item.stroke ? (item.width ?? 1.5) : 0;
  const fill = item.fill ? parseColor(item.fill) : null;
  const stroke = item.stroke ? parseColor(item.stroke) : null;
  array.set(fill ?? stroke ?? clear, at + 9);
  array[at + 12] = fill ? fill[3] * (item.opacity ?? 1) : 0;
  array.set(stroke ?? fill ?? clear, at + 13);
  array[at + 16] = stroke ? stroke[3] * (item.opacity ?? 1) : 0;
}
