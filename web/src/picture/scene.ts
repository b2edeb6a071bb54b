/**
 * What is on the canvas, as data: everything that was set, and the display lists that follow from it. The GPU and
 * the SVG both draw from here, so they cannot differ.
 */

import { noFacts, type OverlayFacts } from '../shared/overlay-facts';
import type {
  Bounds,
  Complex2,
  DefectMark,
  Hit,
  Insets,
  MeshChange,
  MeshState,
  Moment,
  Overlays,
  PictureTheme,
  Point,
  Selection,
  Sketch,
  View,
} from '../shared/types';
import { defaultOverlays, emptyComplex, Label, VertexKind } from '../shared/types';
import { mix } from './color';
import { Coloring } from './coloring';
import { fieldPixels } from './field';
import { type Items, noItems } from './items';
import { complexItems, defectItems, segmentWidth } from './layers/complex-layer';
import { gridItems, scaleBarItems } from './layers/grid-layer';
import { momentOver, momentUnder, type StarShape, starShape } from './layers/moment-layer';
import {
  ancestryItems,
  ballItems,
  collarItems,
  faceCollarItems,
  fieldItems,
  intestineItems,
  neighborItems,
  type OverlayLook,
  spindleItems,
} from './layers/overlay-layer';
import { sketchItems } from './layers/sketch-layer';
import { measureTriangle } from './measures';
import { MeshModel } from './mesh-model';
import { noInsets, type Size, toScreen, visibleBounds } from './view';

/** Circles of all triangles or subsegments are drawn while so few are in sight. */
const mostCircles = 1500;
const mostLabels = 600;

interface DiametralDisk {
  readonly center: Point;
  readonly radius: number;
  readonly ofBox: boolean;
  readonly encroaching: number; // a vertex inside, or -1
}

export class Scene {
  readonly model = new MeshModel();
  readonly coloring = new Coloring(this.model);
  meshed = false;
  moment: Moment | null = null;
  star: StarShape | null = null;
  complex: Complex2 = emptyComplex;
  selection: Selection | null = null;
  defects: readonly DefectMark[] = [];
  sketch: Sketch | null = null;
  picked: Hit | null = null;
  insets: Insets = noInsets;
  theme: PictureTheme;
  overlays: Overlays = { ...defaultOverlays, outside: true, grid: true };
  facts: OverlayFacts = noFacts;
  private fieldImage: { key: unknown[]; pixels: Uint8Array } | null = null;
  private disks: { key: unknown[]; disks: readonly DiametralDisk[] } | null = null;
  private changeShape: { change: MeshChange; star: StarShape } | null = null;

  constructor(theme: PictureTheme) {
    this.theme = theme;
  }

  place(v: number): Point {
    return [this.model.coordinates[2 * v]!, this.model.coordinates[2 * v + 1]!];
  }

  /** A vertex of the mesh, or of the input while there is no mesh. */
  vertex(v: number): Point | null {
    if (this.meshed) return v < this.model.vertexCount ? this.place(v) : null;
    return this.complex.vertices[v] ?? null;
  }

  /** Keeps the shape of what a change made, while the arrays that hold it are at hand. */
  rememberChange(state: MeshState, change: MeshChange): void {
    const triangles = Array.from(
      change.born,
      (t) => [state.cells[3 * t]!, state.cells[3 * t + 1]!, state.cells[3 * t + 2]!] as const,
    );
    this.changeShape = { change, star: starShape(triangles, (v) => this.place(v)) };
  }

  setMoment(moment: Moment | null): void {
    this.moment = moment;
    this.star = null;
    const change = moment?.change;
    if (!change || !this.meshed) return;
    if (this.changeShape?.change === change) {
      this.star = this.changeShape.star;
      return;
    }
    const triangles: [number, number, number][] = [];
    for (const number of change.born) {
      const slot = this.model.triangleSlots.slot(number);
      if (slot < 0) return;
      const t = this.model.triangles;
      triangles.push([t[3 * slot]!, t[3 * slot + 1]!, t[3 * slot + 2]!]);
    }
    this.star = starShape(triangles, (v) => this.place(v));
  }

  /** Between 0.4 and 1: how large vertices are drawn, by the room that each has. */
  detail(view: View): number {
    const points = this.complex.vertices.length;
    const b = extentOf(this.complex.vertices);
    if (points < 40 || b === 0) return 1;
    const spacing = (b / Math.sqrt(points)) * view.scale;
    return Math.round(Math.min(Math.max(spacing / 22, 0.4), 1) * 10) / 10;
  }

  /** The same for vertices of the mesh: 0 where they would only be noise, up to 1. */
  vertexSize(view: View, size: Size): number {
    const { model } = this;
    if (!model.bounds || model.vertexCount < 4) return 1;
    const b = model.bounds;
    const seen = visibleBounds(view, size);
    const width = Math.min(b.maxX, seen.maxX) - Math.max(b.minX, seen.minX);
    const height = Math.min(b.maxY, seen.maxY) - Math.max(b.minY, seen.minY);
    if (width <= 0 || height <= 0) return 1;
    let count = 0;
    for (let v = 0; v < model.vertexCount; ++v) {
      const x = model.coordinates[2 * v]!;
      const y = model.coordinates[2 * v + 1]!;
      if (x >= seen.minX && x <= seen.maxX && y >= seen.minY && y <= seen.maxY) {
        count += model.vertexAlive[v]!;
      }
    }
    const spacing = Math.sqrt((width * height) / Math.max(count, 1)) * view.scale;
    const part = Math.min((spacing - 4) / 24, 1);
    return part < 0.15 ? 0 : part;
  }

  /** Below the mesh. */
  background(view: View, size: Size): Items {
    return this.overlays.grid ? gridItems(view, size, this.theme) : noItems();
  }

  /** The tint of lfs, laid over the triangles; the same array as long as nothing of it changed. */
  image(): { pixels: Uint8Array; width: number; height: number; bounds: Bounds } | null {
    const { field } = this.facts;
    if (!field || !this.overlays.featureSize) return null;
    const key = [field, this.theme.featureSize];
    if (!this.fieldImage?.key.every((k, i) => k === key[i])) {
      this.fieldImage = { key, pixels: fieldPixels(field, this.theme.featureSize) };
    }
    // Points of the lattice are centers of texels.
    const minX = field.x - field.step / 2;
    const minY = field.y - field.step / 2;
    return {
      pixels: this.fieldImage!.pixels,
      width: field.columns,
      height: field.rows,
      bounds: {
        minX,
        minY,
        maxX: minX + field.columns * field.step,
        maxY: minY + field.rows * field.step,
      },
    };
  }

  /** Right over the triangles, below all that stands out: contours of lfs. */
  field(view: View): Items {
    const { field } = this.facts;
    return field && this.overlays.featureSize ? fieldItems(field, this.look(view)) : noItems();
  }

  private look(view: View): OverlayLook {
    return { theme: this.theme, pixel: 1 / view.scale, place: (v) => this.vertex(v) };
  }

  /** What the overlays lay below and above the input's features. */
  private overlayItems(view: View): { under: Items; over: Items } {
    const { facts, overlays } = this;
    const look = this.look(view);
    const under = noItems();
    const over = noItems();
    const add = (items: { under: Items; over: Items }) => {
      append(under, items.under);
      append(over, items.over);
    };
    if (overlays.intestines && this.meshed) append(under, intestineItems(facts.intestines, look));
    if (facts.faceCollar && this.meshed) append(under, faceCollarItems(facts.faceCollar, look));
    if (overlays.collars && this.meshed) append(under, collarItems(facts.collars, look));
    if (overlays.neighbors && this.meshed) add(neighborItems(facts.neighbors, look));
    if (overlays.spindles && this.meshed && facts.spindle) add(spindleItems(facts.spindle, look));
    if (overlays.ancestry && this.meshed) append(over, ancestryItems(facts.ancestry, look));
    if (overlays.featureSize && facts.ball) add(ballItems(facts.ball, look));
    return { under, over };
  }

  /** Over the triangles: circles, the simplex in hand, subsegments, the input. */
  middle(view: View, size: Size): { under: Items; features: Items } {
    const under =
      this.moment && this.meshed
        ? momentUnder(this.moment, this.star, { vertex: (v) => this.vertex(v) }, this.theme)
        : noItems();
    append(under, this.overlayItems(view).under);
    if (this.meshed) this.addCircles(under, view, size);
    const features = complexItems(this.complex, this.selection, {
      theme: this.theme,
      meshed: this.meshed,
      detail: this.detail(view),
    });
    if (this.meshed) this.addSubsegments(features);
    return { under, features };
  }

  /** Over the vertices of the mesh. */
  top(view: View, size: Size): Items {
    const items =
      this.moment && this.meshed
        ? momentOver(this.moment, { vertex: (v) => this.vertex(v) }, this.theme)
        : noItems();
    append(items, this.overlayItems(view).over);
    if (this.meshed && this.overlays.diametral) this.addEncroaching(items, view, size);
    this.addPicked(items);
    append(items, defectItems(this.complex, this.defects, this.theme));
    if (this.overlays.labels) this.addLabels(items, view, size);
    if (this.sketch) append(items, sketchItems(this.sketch, this.theme, 1 / view.scale));
    append(items, scaleBarItems(view, size, this.theme, this.insets));
    return items;
  }

  private addSubsegments(items: Items): void {
    const { model, theme } = this;
    const { numbers } = model.subsegmentSlots;
    const order = Array.from({ length: model.subsegmentCount }, (_, s) => s);
    order.sort((s, t) => numbers[s]! - numbers[t]!);
    for (const s of order) {
      const a = this.place(model.subsegments[3 * s]!);
      const b = this.place(model.subsegments[3 * s + 1]!);
      const ofBox = model.subsegments[3 * s + 2] === 0xffffffff;
      items.lines.push(
        ofBox
          ? { a, b, color: theme.box, width: 1.5, dash: 'dashed' }
          : { a, b, color: theme.ink, width: segmentWidth },
      );
    }
  }

  private addCircles(items: Items, view: View, size: Size): void {
    const { model, theme } = this;
    const seen = visibleBounds(view, size, 20);
    if (this.overlays.circumcircles) {
      let left = mostCircles;
      const m = { minAngle: 0, circumradius: 0, longest: 0, height: 0 };
      for (let slot = 0; slot < model.triangleCount && left > 0; ++slot) {
        if (model.labels[slot] === Label.outside) continue;
        const [a, b, c] = [0, 1, 2].map((k) => this.place(model.triangles[3 * slot + k]!));
        const center = circumcenter(a!, b!, c!);
        measureTriangle(a![0], a![1], b![0], b![1], c![0], c![1], m);
        if (!Number.isFinite(m.circumradius) || !overlaps(a!, m.longest, seen)) continue;
        --left;
        items.disks.push({
          center,
          radius: m.circumradius,
          stroke: theme.ball,
          width: 1,
          opacity: 0.45,
        });
      }
    }
    if (this.overlays.diametral) {
      for (const { center, radius, ofBox, encroaching } of this.diametralDisks(view, size)) {
        const color = encroaching < 0 ? theme.steinerSegment : theme.witness;
        items.disks.push({
          center,
          radius,
          stroke: color,
          width: encroaching < 0 ? 1.1 : 1.8,
          dash: encroaching < 0 ? 'solid' : 'dashed',
          opacity: ofBox && encroaching < 0 ? 0.3 : 0.8,
          fill: color,
          fillOpacity: ofBox ? 0 : 0.07,
        });
      }
    }
  }

  /** Found once for a moment and a view. */
  private diametralDisks(view: View, size: Size): readonly DiametralDisk[] {
    const { model } = this;
    const key = [model.revision, view, size];
    if (this.disks?.key.every((k, i) => k === key[i])) return this.disks.disks;
    const seen = visibleBounds(view, size, 20);
    const disks: DiametralDisk[] = [];
    for (let s = 0; s < model.subsegmentCount && disks.length < mostCircles; ++s) {
      const v = model.subsegments[3 * s]!;
      const w = model.subsegments[3 * s + 1]!;
      if (!model.vertexAlive[v] || !model.vertexAlive[w]) continue;
      const a = this.place(v);
      const b = this.place(w);
      const center: Point = [a[0] + (b[0] - a[0]) / 2, a[1] + (b[1] - a[1]) / 2];
      const radius = Math.hypot(b[0] - a[0], b[1] - a[1]) / 2;
      if (!overlaps(center, radius, seen)) continue;
      const ofBox = model.subsegments[3 * s + 2] === 0xffffffff;
      disks.push({ center, radius, ofBox, encroaching: model.index.encroaching(v, w) });
    }
    this.disks = { key, disks };
    return disks;
  }

  /** The vertex inside an encroached disk, ringed and joined to its center. */
  private addEncroaching(items: Items, view: View, size: Size): void {
    const { theme } = this;
    for (const { center, encroaching } of this.diametralDisks(view, size)) {
      if (encroaching < 0) continue;
      const at = this.place(encroaching);
      items.lines.push({ a: at, b: center, color: theme.witness, width: 1.8, dash: 'dotted' });
      items.marks.push({ at, shape: 'disc', size: 14, stroke: theme.witness, width: 2 });
    }
  }

  private addPicked(items: Items): void {
    const { picked, model, theme } = this;
    if (!picked) return;
    const color = theme.selection;
    if (picked.triangle !== null && this.meshed) {
      const slot = model.triangleSlots.slot(picked.triangle);
      if (slot >= 0) {
        const points = [0, 1, 2].map((k) => this.place(model.triangles[3 * slot + k]!));
        items.polygons.push({ points, fill: color, opacity: 0.28 });
        points.forEach((a, k) => {
          items.lines.push({ a, b: points[(k + 1) % 3]!, color, width: 2.4 });
        });
      }
    }
    if (picked.subsegment !== null && this.meshed) {
      const slot = model.subsegmentSlots.slot(picked.subsegment);
      if (slot >= 0) {
        const a = this.place(model.subsegments[3 * slot]!);
        const b = this.place(model.subsegments[3 * slot + 1]!);
        items.lines.push({ a, b, color, width: 6, opacity: 0.75 });
      }
    }
    if (picked.vertex !== null) {
      const at = this.vertex(picked.vertex);
      if (at) items.marks.push({ at, shape: 'disc', size: 18, stroke: color, width: 3 });
    }
  }

  /** Numbers of vertices, as many as do not run into each other. */
  private addLabels(items: Items, view: View, size: Size): void {
    const seen = visibleBounds(view, size);
    const taken = new Set<string>();
    let left = mostLabels;
    const count = this.meshed ? this.model.vertexCount : this.complex.vertices.length;
    for (let v = 0; v < count && left > 0; ++v) {
      const at = this.vertex(v)!;
      if (this.meshed && !this.model.vertexAlive[v]) continue;
      if (at[0] < seen.minX || at[0] > seen.maxX || at[1] < seen.minY || at[1] > seen.maxY) {
        continue;
      }
      const [x, y] = toScreen(view, size, at);
      const column = Math.round(x / 17);
      const row = Math.round(y / 15);
      let free = true;
      for (let i = -1; i <= 1; ++i)
        for (let j = -1; j <= 1; ++j) free &&= !taken.has(`${column + i} ${row + j}`);
      if (!free) continue;
      taken.add(`${column} ${row}`);
      --left;
      items.texts.push({
        at,
        text: String(v),
        size: 11,
        color:
          this.meshed && this.model.vertexKind[v] !== VertexKind.input
            ? mix(this.theme.ink, this.theme.edge, 0.35)
            : this.theme.ink,
        dx: 7,
        dy: 5,
        anchor: 'start',
        halo: this.theme.background,
      });
    }
  }
}

function append(items: Items, more: Items): void {
  const add = <T>(to: T[], from: readonly T[]) => {
    for (const item of from) to.push(item);
  };
  add(items.polygons, more.polygons);
  add(items.disks, more.disks);
  add(items.lines, more.lines);
  add(items.marks, more.marks);
  add(items.texts, more.texts);
}

function overlaps(
  p: Point,
  reach: number,
  b: { minX: number; minY: number; maxX: number; maxY: number },
): boolean {
  return (
    p[0] + reach >= b.minX &&
    p[0] - reach <= b.maxX &&
    p[1] + reach >= b.minY &&
    p[1] - reach <= b.maxY
  );
}

/** Largest side of the box about finite places. */
export function extentOf(points: readonly Point[]): number {
  let minX = Number.POSITIVE_INFINITY;
  let minY = Number.POSITIVE_INFINITY;
  let maxX = Number.NEGATIVE_INFINITY;
  let maxY = Number.NEGATIVE_INFINITY;
  for (const [x, y] of points) {
    if (!Number.isFinite(x) || !Number.isFinite(y)) continue;
    minX = Math.min(minX, x);
    minY = Math.min(minY, y);
    maxX = Math.max(maxX, x);
    maxY = Math.max(maxY, y);
  }
  return minX <= maxX ? Math.max(maxX - minX, maxY - minY) : 0;
}

/** Relative to a, so that a small triangle far from the origin keeps its center. */
export function circumcenter(a: Point, b: Point, c: Point): Point {
  const bx = b[0] - a[0];
  const by = b[1] - a[1];
  const cx = c[0] - a[0];
  const cy = c[1] - a[1];
  const d = 2 * (bx * cy - by * cx);
  const b2 = bx * bx + by * by;
  const c2 = cx * cx + cy * cy;
  return [a[0] + (cy * b2 - by * c2) / d, a[1] + (bx * c2 - cx * b2) / d];
}
