/** A display list on the GPU: five batches drawn in the order polygons, disks, lines, marks, texts. */

import type { Object3D } from 'three';
import type { Point } from '../../shared/types';
import { clipPolygon, clipSegment } from '../clip';
import { parseColor, type Rgba } from '../color';
import {
  type Dash,
  type DiskItem,
  dashes,
  type Items,
  type LineItem,
  type MarkItem,
  type PolygonItem,
  type Shape,
  type TextItem,
} from '../items';
import type { Window } from '../window';
import { Batch } from './batch';
import { type Glyphs, textWidth } from './glyphs';
import { diskShader, glyphShader, lineShader, markShader, polygonShader } from './shapes';
import type { ViewUniforms } from './uniforms';

export const shapeNumber: Record<Shape, number> = {
  disc: 0,
  square: 1,
  diamond: 2,
  cross: 3,
  plus: 4,
  arrow: 5,
  triangle: 6,
};

/** Radius in pixels up to which single precision draws a circle sharply; larger ones become arcs of lines. */
const largestDisk = 4000;
/** An arc is replaced by chords that stay this many pixels from it. */
const sagitta = 0.05;

export class Layer {
  private readonly polygons: Batch;
  private readonly disks: Batch;
  private readonly lines: Batch;
  private readonly marks: Batch;
  private readonly texts: Batch;
  private readonly glyphs: Glyphs;

  constructor(parent: Object3D, view: ViewUniforms, glyphs: Glyphs, order: number) {
    this.glyphs = glyphs;
    this.polygons = new Batch(polygonShader, view, order);
    this.disks = new Batch(diskShader, view, order + 1);
    this.lines = new Batch(lineShader, view, order + 2);
    const size = { uSize: { value: 1 }, uLanding: { value: -1 }, uLandingSize: { value: 1 } };
    this.marks = new Batch(markShader(size), view, order + 3);
    this.texts = new Batch(glyphShader(glyphs.texture), view, order + 4);
    for (const batch of this.batches()) parent.add(batch.mesh);
  }

  /** `scale`: pixels a world unit, by which circles too large for the shader are told. */
  set(items: Items, window: Window, scale: number): void {
    const arcs: LineItem[] = [];
    this.setPolygons(items.polygons, window);
    this.setDisks(items.disks, window, scale, arcs);
    this.setLines(arcs.length > 0 ? [...arcs, ...items.lines] : items.lines, window);
    this.setMarks(items.marks, window);
    this.setTexts(items.texts, window);
  }

  dispose(): void {
    for (const batch of this.batches()) batch.dispose();
  }

  private batches(): Batch[] {
    return [this.polygons, this.disks, this.lines, this.marks, this.texts];
  }

  private setPolygons(items: readonly PolygonItem[], window: Window): void {
    const batch = this.polygons;
    let row = 0;
    for (const item of items) {
      const points = window.box ? clipPolygon(item.points, window.box) : item.points;
      const color = parseColor(item.fill);
      batch.reserve(row + points.length);
      for (let i = 1; i + 1 < points.length; ++i) {
        const at = row++ * batch.stride;
        putPoint(batch.array, at, points[0]!, window);
        putPoint(batch.array, at + 2, points[i]!, window);
        putPoint(batch.array, at + 4, points[i + 1]!, window);
        batch.array.set(color, at + 6);
        batch.array[at + 9] = color[3] * item.opacity;
      }
    }
    finish(batch, row);
  }

  private setDisks(
    items: readonly DiskItem[],
    window: Window,
    scale: number,
    arcs: LineItem[],
  ): void {
    const batch = this.disks;
    batch.reserve(items.length);
    let row = 0;
    for (const item of items) {
      if (item.radius * scale > largestDisk) {
        addArc(item, window, scale, arcs);
        continue;
      }
      const at = row++ * batch.stride;
      putPoint(batch.array, at, item.center, window);
      batch.array[at + 2] = item.radius * window.unit;
      putStyle(batch.array, at + 3, item.width, item.dash);
      const stroke = parseColor(item.stroke);
      batch.array.set(stroke, at + 6);
      batch.array[at + 9] = stroke[3] * (item.opacity ?? 1);
      const fill = item.fill ? parseColor(item.fill) : stroke;
      batch.array.set(fill, at + 10);
      batch.array[at + 13] = item.fill ? fill[3] * (item.fillOpacity ?? 1) : 0;
    }
    finish(batch, row);
  }

  private setLines(items: readonly LineItem[], window: Window): void {
    const batch = this.lines;
    batch.reserve(items.length);
    let row = 0;
    for (const item of items) {
      const ends = window.box ? clipSegment(item.a, item.b, window.box) : [item.a, item.b];
      if (!ends) continue;
      const at = row++ * batch.stride;
      putPoint(batch.array, at, ends[0]!, window);
      putPoint(batch.array, at + 2, ends[1]!, window);
      const color = parseColor(item.color);
      batch.array.set(color, at + 4);
      batch.array[at + 7] = color[3] * (item.opacity ?? 1);
      putStyle(batch.array, at + 8, item.width, item.dash);
    }
    finish(batch, row);
  }

  private setMarks(items: readonly MarkItem[], window: Window): void {
    const batch = this.marks;
    batch.reserve(items.length);
    let row = 0;
    for (const item of items) {
      if (window.box && !contains(window, item.at)) continue;
      putMark(batch.array, row++ * batch.stride, item, window);
    }
    finish(batch, row);
  }

  private setTexts(items: readonly TextItem[], window: Window): void {
    let row = 0;
    for (const item of items) {
      if (window.box && !contains(window, item.at)) continue;
      // The halo of a character must not cut into the one before.
      if (item.halo) row = this.putText(row, item, clear, parseColor(item.halo), window);
      row = this.putText(row, item, parseColor(item.color), clear, window);
    }
    finish(this.texts, row);
  }

  private putText(row: number, item: TextItem, color: Rgba, halo: Rgba, window: Window): number {
    const batch = this.texts;
    const { glyphs } = this;
    const width = textWidth(glyphs, item.text, item.size);
    const side = glyphs.cellSize * item.size;
    let pen = item.dx - (item.anchor === 'middle' ? width / 2 : item.anchor === 'end' ? width : 0);
    batch.reserve(row + item.text.length);
    for (const c of item.text) {
      const at = row++ * batch.stride;
      putPoint(batch.array, at, item.at, window);
      batch.array.set(
        [pen - glyphs.padX * item.size, item.dy - glyphs.padY * item.size, side, side],
        at + 2,
      );
      batch.array.set(glyphs.uv(c), at + 6);
      batch.array.set(color, at + 10);
      batch.array.set(halo, at + 14);
      pen += glyphs.advance(c) * item.size;
    }
    return row;
  }
}

const clear: Rgba = [0, 0, 0, 0];

/** One row of a mark batch. */
export function putMark(array: Float32Array, at: number, item: MarkItem, window: Window): void {
  putPoint(array, at, item.at, window);
  array[at + 2] = item.size;
  array[at + 3] = shapeNumber[item.shape];
  array[at + 4] = item.stroke ? (item.width ?? 1.5) : 0;
  array[at + 5] = item.angle ?? 0;
  const fill = item.fill ? parseColor(item.fill) : null;
  const stroke = item.stroke ? parseColor(item.stroke) : null;
  array.set(fill ?? stroke ?? [0, 0, 0, 0], at + 6);
  array[at + 9] = fill ? fill[3] * (item.opacity ?? 1) : 0;
  array.set(stroke ?? fill ?? [0, 0, 0, 0], at + 10);
  array[at + 13] = stroke ? stroke[3] * (item.opacity ?? 1) : 0;
}

export function contains(window: Window, p: Point): boolean {
  const b = window.box;
  return !b || (p[0] >= b.minX && p[0] <= b.maxX && p[1] >= b.minY && p[1] <= b.maxY);
}

export function putPoint(array: Float32Array, at: number, p: Point, window: Window): void {
  array[at] = (p[0] - window.originX) * window.unit;
  array[at + 1] = (p[1] - window.originY) * window.unit;
}

export function putStyle(
  array: Float32Array,
  at: number,
  width: number,
  dash: Dash | undefined,
): void {
  const pattern = dash && dash !== 'solid' ? dashes[dash] : ([0, 0] as const);
  array[at] = width;
  array[at + 1] = pattern[0];
  array[at + 2] = pattern[1];
}

export function finish(batch: Batch, rows: number): void {
  if (rows > 0) batch.touchAll();
  batch.flush(rows);
}

/** The part of a huge circle that crosses the window, as chords. */
export function addArc(item: DiskItem, window: Window, scale: number, out: LineItem[]): void {
  const { center, radius } = item;
  if (!Number.isFinite(radius)) return;
  const step = 2 * Math.acos(Math.max(1 - sagitta / (radius * scale), 0));
  let from = 0;
  let to = 2 * Math.PI;
  if (window.box) {
    const { minX, minY, maxX, maxY } = window.box;
    const toBox = Math.atan2((minY + maxY) / 2 - center[1], (minX + maxX) / 2 - center[0]);
    const half = Math.hypot(maxX - minX, maxY - minY) / 2;
    const distance = Math.hypot((minX + maxX) / 2 - center[0], (minY + maxY) / 2 - center[1]);
    if (Math.abs(distance - radius) > half) return;
    const spread = 2 * Math.asin(Math.min((1.01 * half) / Math.max(distance, half), 1));
    from = toBox - spread;
    to = toBox + spread;
  }
  const n = Math.min(Math.max(Math.ceil((to - from) / step), 8), 4096);
  const at = (i: number): Point => {
    const angle = from + ((to - from) * i) / n;
    return [center[0] + radius * Math.cos(angle), center[1] + radius * Math.sin(angle)];
  };
  for (let i = 0; i < n; ++i) {
    out.push({
      a: at(i),
      b: at(i + 1),
      color: item.stroke,
      width: item.width,
      opacity: item.opacity ?? 1,
    });
  }
}
