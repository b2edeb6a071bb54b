/** The picture of space on a canvas: three.js draws when something changed, and only then. */

import { OrthographicCamera, Scene as ThreeScene, Vector4, WebGLRenderer } from 'three';
import { parseColor } from '../picture/color';
import { Batch } from '../picture/gpu/batch';
import { type Glyphs, makeGlyphs } from '../picture/gpu/glyphs';
import { renderPng } from '../picture/png';
import { distance3, dot, minus, plus } from '../replay/geometry3';
import type {
  Background,
  ColorScale,
  Complex3,
  DefectMark,
  Insets,
  MeshState,
  Moment3,
  PictureOptions,
  PictureTheme,
  Point,
  Point3,
} from '../shared/types';
import { rgbaOf, SpaceColoring } from './coloring';
import { complexItems3, defectItems3 } from './complex-items';
import { noSpaceItems, type SpaceItems } from './items';
import { putPoint3, SpaceLayer } from './layer';
import { faceColor, faceOpacity, type MeshLook, place, SpaceMeshLayer } from './mesh-layer';
import { edgesOf, momentOver3, momentUnder3, placesOf } from './moment-items';
import { pickSpace } from './pick';
import { makeSpaceUniforms, setSpaceView, triangleShader } from './shaders';
import {
  defaultLook,
  type SpaceHit,
  type SpaceLook,
  type SpacePicture,
  type SpaceView,
  type StandardView,
} from './types';
import {
  type Basis,
  type Bounds3,
  basisOf,
  between,
  boundsOf3,
  centerOf,
  clampScale,
  cornersOf,
  extentOf,
  fitView,
  include,
  makeWindow3,
  orbit,
  type Plane,
  pan,
  planeThrough,
  project,
  type Size,
  serves3,
  standardView,
  type Window3,
  zoomAt,
} from './view';

const FLIGHT_MS = 260;
/** Fewer labels than this can be read. */
const MOST_LABELS = 400;

interface Stale {
  complex: boolean;
  mesh: boolean;
  rows: boolean; // every row of the mesh
  cells: boolean;
  moment: boolean;
  look: boolean;
}

const everything: Stale = {
  complex: true,
  mesh: true,
  rows: true,
  cells: true,
  moment: true,
  look: true,
};

export class CanvasSpacePicture implements SpacePicture {
  readonly canvas: HTMLCanvasElement;
  private readonly renderer: WebGLRenderer;
  private readonly three = new ThreeScene();
  private readonly camera = new OrthographicCamera();
  private readonly uniforms = makeSpaceUniforms();
  private readonly glyphs: Glyphs;
  private readonly mesh: SpaceMeshLayer;
  private readonly coloring = new SpaceColoring();
  private readonly faceUniforms = {
    uEdge: { value: new Vector4() },
    uEdgeWidth: { value: 1 },
    uOpacity: { value: 1 },
    uLit: { value: 1 },
    uClips: { value: 1 },
    uLift: { value: 0.75 },
  };
  private readonly faces: Batch;
  private readonly layers: { under: SpaceLayer; input: SpaceLayer; over: SpaceLayer };
  private readonly viewListeners = new Set<(view: SpaceView) => void>();
  private readonly scaleListeners = new Set<(scale: ColorScale | null) => void>();
  private view: SpaceView = { target: [0, 0, 0], azimuth: -60, elevation: 24, scale: 100 };
  private basis: Basis = basisOf(this.view);
  private flight: { from: SpaceView; to: SpaceView; start: number } | null = null;
  private size: Size = { width: 1, height: 1 };
  private insets: Insets = { left: 8, top: 8, right: 8, bottom: 56 };
  private pixelRatio = 1;
  private window: Window3 = makeWindow3(this.view, null);
  private complex: Complex3 | null = null;
  private triangles = new Uint32Array(0);
  private defects: readonly DefectMark[] = [];
  private inputBounds: Bounds3 | null = null;
  private featureBounds: Bounds3 | null = null; // of segments and faces
  private spacing = 0; // mean length of subsegments
  private spacingOfInput = 0;
  private meshBounds: Bounds3 | null = null;
  private boundedVertices = 0;
  private state: MeshState | null = null;
  private run: object | null = null;
  private moment: Moment3 | null = null;
  private spaceLook: SpaceLook = defaultLook;
  private picked: SpaceHit | null = null;
  private extras: SpaceItems | null = null;
  private theme: PictureTheme;
  private stale: Stale = { ...everything };
  private lastScale: ColorScale | null = null;
  private frame = 0;
  private disposed = false;

  constructor(canvas: HTMLCanvasElement, options: PictureOptions) {
    this.canvas = canvas;
    this.theme = options.theme;
    this.renderer = new WebGLRenderer({
      canvas,
      antialias: options.antialias,
      alpha: true,
      premultipliedAlpha: true,
      preserveDrawingBuffer: true, // print and screenshots read the canvas between frames
      depth: true,
      stencil: false,
    });
    this.glyphs = makeGlyphs();
    this.mesh = new SpaceMeshLayer(this.three, this.uniforms);
    this.faces = new Batch(triangleShader(this.faceUniforms), this.uniforms, 11, 'test');
    this.three.add(this.faces.mesh);
    const layer = (order: number, depth: 'none' | 'test') =>
      new SpaceLayer(this.three, this.uniforms, this.glyphs, order, depth);
    this.layers = { under: layer(20, 'test'), input: layer(36, 'test'), over: layer(60, 'none') };
    this.three.matrixWorldAutoUpdate = false;
    canvas.addEventListener('webglcontextrestored', this.onRestored);
    this.resize(canvas.clientWidth || 1, canvas.clientHeight || 1, 1);
  }

  setComplex(
    complex: Complex3 | null,
    triangles: Uint32Array,
    defects: readonly DefectMark[],
  ): void {
    if (complex !== this.complex) {
      this.inputBounds = complex && boundsOf3([...complex.vertices, ...complex.holes]);
      this.featureBounds = complex && boundsOfFeatures(complex);
      this.spacingOfInput = complex ? meanLength(complex.vertices, complex.segments) : 0;
      if (!this.state) this.spacing = this.spacingOfInput;
    }
    Object.assign(this, { complex, triangles, defects });
    this.touch('complex');
  }

  setMesh(state: MeshState | null, run: object | null): void {
    // Before the first event there is nothing but the input.
    const shown = state && state.position > 0 ? state : null;
    if (run !== this.run || !shown) {
      this.run = run;
      this.mesh.clear();
      this.coloring.forget();
      this.meshBounds = null;
      this.boundedVertices = 0;
    }
    if ((shown === null) !== (this.state === null)) this.touch('complex');
    this.state = shown;
    this.spacing = shown ? this.mesh.spacing(shown) : this.spacingOfInput;
    this.touch('mesh', 'cells', 'moment');
  }

  setMoment(moment: Moment3 | null): void {
    this.moment = moment;
    this.touch('moment');
  }

  setLook(look: SpaceLook): void {
    const before = this.spaceLook;
    this.spaceLook = look;
    this.touch('look', 'cells', 'moment');
    if (before.color !== look.color || before.cells !== look.cells || before.faces !== look.faces)
      this.touch('rows', 'mesh', 'complex');
  }

  setPicked(hit: SpaceHit | null): void {
    this.picked = hit;
    this.touch('moment');
  }

  setExtras(items: SpaceItems | null): void {
    this.extras = items;
    this.touch('moment');
  }

  setTheme(theme: PictureTheme): void {
    this.theme = theme;
    this.touch('complex', 'mesh', 'rows', 'cells', 'moment', 'look');
  }

  setInsets(insets: Insets): void {
    this.insets = insets;
  }

  get scale(): ColorScale | null {
    return this.lastScale;
  }

  onScaleChange(listener: (scale: ColorScale | null) => void): () => void {
    this.scaleListeners.add(listener);
    return () => this.scaleListeners.delete(listener);
  }

  getView(): SpaceView {
    return this.flight?.to ?? this.view;
  }

  setView(view: SpaceView, smooth = false): void {
    if (![...view.target, view.azimuth, view.elevation, view.scale].every(Number.isFinite)) return;
    if (!(view.scale > 0)) return;
    const to = { ...view, scale: clampScale(view.scale, extentOf(this.contents())) };
    if (smooth && !this.theme.reducedMotion) {
      this.flight = { from: this.view, to, start: performance.now() };
    } else {
      this.flight = null;
      this.view = to;
      for (const listener of this.viewListeners) listener(to);
    }
    this.invalidate();
  }

  onViewChange(listener: (view: SpaceView) => void): () => void {
    this.viewListeners.add(listener);
    return () => this.viewListeners.delete(listener);
  }

  fit(smooth = false): void {
    const view = this.getView();
    const [features, all] = [this.featureBounds, this.contents()];
    const target = (bounds: Bounds3) => fitView(view, bounds, this.size, this.insets);
    const near = features && target(features);
    // Lonely vertices and the box may stand far around: once the features fill the picture, all of it is shown.
    if (near && !(smooth && isSame(near, view))) this.setView(near, smooth);
    else if (all) this.setView(target(all), smooth);
  }

  look(from: StandardView): void {
    const turned = standardView(this.getView(), from);
    const bounds = this.featureBounds ?? this.contents();
    this.setView(bounds ? fitView(turned, bounds, this.size, this.insets) : turned, true);
  }

  zoomBy(factor: number, at?: Point): void {
    const anchor = at ?? [this.size.width / 2, this.size.height / 2];
    const extent = extentOf(this.contents());
    const from = this.getView();
    const bounded = clampScale(from.scale * factor, extent) / from.scale;
    this.setView(zoomAt(from, this.size, bounded, anchor));
  }

  panBy(dx: number, dy: number): void {
    this.setView(pan(this.getView(), dx, dy));
  }

  orbitBy(dx: number, dy: number): void {
    this.setView(orbit(this.getView(), dx, dy));
  }

  lookAtMoment(): boolean {
    const { moment, state } = this;
    if (!moment || !state) return false;
    const bounds = boundsOf3(placesOf(moment, state));
    if (!bounds) return false;
    // A single vertex, or a tiny simplex, among what is around it.
    const least = 3 * this.spacing;
    const middle = centerOf(bounds);
    const reach = Math.max(extentOf(bounds), least) / 2;
    const grown = {
      min: plus(middle, [reach, reach, reach], -1),
      max: plus(middle, [reach, reach, reach]),
    };
    this.setView(fitView(this.getView(), grown, this.size, this.insets), true);
    return true;
  }

  centerOn(at: Point3): void {
    this.setView({ ...this.getView(), target: at }, true);
  }

  toScreen(p: Point3): Point {
    const [x, y] = project(this.view, basisOf(this.view), this.size, p);
    return [x, y];
  }

  direction(): Point3 {
    return basisOf(this.view).toEye;
  }

  pick(x: number, y: number): SpaceHit | null {
    this.prepare();
    return pickSpace(
      {
        view: this.view,
        basis: this.basis,
        size: this.size,
        look: this.spaceLook,
        plane: this.plane(),
        complex: this.complex,
        triangles: this.triangles,
        state: this.state,
        filledFaces: this.mesh.filledFaces,
        cut: this.mesh.cut,
      },
      x,
      y,
    );
  }

  resize(width: number, height: number, pixelRatio: number): void {
    this.size = { width: Math.max(width, 1), height: Math.max(height, 1) };
    this.pixelRatio = pixelRatio;
    this.renderer.setPixelRatio(pixelRatio);
    this.renderer.setSize(this.size.width, this.size.height, false);
    // A resized canvas is blank until it is drawn: at once, or it flickers.
    this.draw();
  }

  async toPNG(width: number, background: Background): Promise<Blob> {
    if (this.flight) this.view = this.flight.to;
    this.flight = null;
    this.prepare();
    const paper = background === 'white' ? '#ffffff' : this.theme.background;
    try {
      return await renderPng({
        renderer: this.renderer,
        scene: this.three,
        camera: this.camera,
        uniforms: this.uniforms,
        size: this.size,
        width,
        background: background === 'transparent' ? [0, 0, 0, 0] : parseColor(paper),
        depth: true,
      });
    } finally {
      this.invalidate();
    }
  }

  dispose(): void {
    this.disposed = true;
    cancelAnimationFrame(this.frame);
    this.canvas.removeEventListener('webglcontextrestored', this.onRestored);
    for (const layer of Object.values(this.layers)) layer.dispose();
    this.faces.dispose();
    this.mesh.dispose();
    this.glyphs.texture.dispose();
    this.renderer.dispose();
    this.viewListeners.clear();
    this.scaleListeners.clear();
  }

  private readonly onRestored = () => {
    this.mesh.clear();
    this.stale = { ...everything };
    this.invalidate();
  };

  /** The input, and the box about it once it is there. */
  private contents(): Bounds3 | null {
    if (!this.meshBounds) return this.inputBounds;
    if (!this.inputBounds) return this.meshBounds;
    return include(include(this.inputBounds, this.meshBounds.min), this.meshBounds.max);
  }

  private plane(): Plane | null {
    const { clip } = this.spaceLook;
    const bounds = this.contents();
    return clip && bounds ? planeThrough(bounds, clip.normal, clip.offset, clip.flipped) : null;
  }

  private touch(...what: (keyof Stale)[]): void {
    for (const key of what) this.stale[key] = true;
    this.invalidate();
  }

  private invalidate(): void {
    if (this.frame || this.disposed) return;
    this.frame = requestAnimationFrame(() => {
      this.frame = 0;
      this.draw();
    });
  }

  private draw(): void {
    if (this.disposed) return;
    if (this.flight) {
      const t = Math.min(1, (performance.now() - this.flight.start) / FLIGHT_MS);
      this.view =
        t === 1 ? this.flight.to : between(this.flight.from, this.flight.to, t * t * (3 - 2 * t));
      if (t === 1) this.flight = null;
      for (const listener of this.viewListeners) listener(this.view);
    }
    this.prepare();
    const [r, g, b] = parseColor(this.theme.background);
    this.renderer.setClearColor(
      (Math.round(r * 255) << 16) | (Math.round(g * 255) << 8) | Math.round(b * 255),
      1,
    );
    this.renderer.render(this.three, this.camera);
    if (this.flight) this.invalidate();
  }

  /** Brings the buffers up to what was set, and no further. */
  private prepare(): void {
    const { stale, state, view, size, theme, spaceLook } = this;
    this.includeVertices();
    const bounds = this.contents();
    if (!serves3(this.window, view, bounds)) {
      this.window = makeWindow3(view, bounds);
      Object.assign(stale, everything);
    }
    const { window, coloring } = this;
    const plane = this.plane();
    this.basis = setSpaceView(this.uniforms, view, size, window, this.depth(bounds), plane);
    this.uniforms.uPixel.value = this.pixelRatio;
    if (stale.mesh || stale.rows || stale.look) {
      const ofCells = spaceLook.cells;
      if (coloring.set(spaceLook.color, theme.dark, state, ofCells))
        stale.rows = stale.cells = true;
      this.tellScale();
    }
    const look: MeshLook = { theme, look: spaceLook, coloring, plane, window };
    if (stale.rows) {
      this.mesh.clear();
      stale.cells = true;
    }
    if (stale.look || stale.rows) this.mesh.setLook(look);
    if (state && (stale.mesh || stale.rows)) {
      const before = this.mesh.filledFaces.size;
      this.mesh.sync(state, look);
      if (this.mesh.filledFaces.size !== before) stale.complex = true;
    }
    if (state && spaceLook.cells && stale.cells) this.mesh.setCells(state, look);
    this.mesh.show(state !== null, spaceLook);
    if (stale.complex) this.prepareComplex();
    if (stale.complex || stale.look) this.showFaces();
    if (stale.moment || stale.complex) this.prepareMoment();
    const markSize = this.markSize();
    this.mesh.setVertexSize(markSize);
    // Vertices of the input stay larger than what is between them.
    this.layers.input.setMarkSize(Math.max(markSize, 0.6));
    Object.assign(stale, {
      complex: false,
      mesh: false,
      rows: false,
      cells: spaceLook.cells ? false : stale.cells,
      moment: false,
      look: false,
    });
  }

  private prepareComplex(): void {
    const { complex, theme, window, faces, triangles, view } = this;
    const meshed = this.state !== null;
    const items = complex ? complexItems3(complex, theme, meshed) : noSpaceItems();
    this.layers.input.set(items, window, view.scale);
    const color = rgbaOf(faceColor(theme));
    faces.reserve(triangles.length / 4);
    let row = 0;
    for (let t = 0; complex && t < triangles.length; t += 4) {
      if (meshed && this.mesh.filledFaces.has(triangles[t + 3]!)) continue;
      const at = row++ * faces.stride;
      for (let k = 0; k < 3; k++)
        putPoint3(faces.array, at + 3 * k, complex.vertices[triangles[t + k]!]!, window);
      faces.array.set(color, at + 9);
      faces.array[at + 13] = 0;
    }
    faces.touchAll();
    faces.flush(row);
  }

  private showFaces(): void {
    const { spaceLook, theme, faces } = this;
    const solid = spaceLook.faces === 'solid';
    this.faceUniforms.uOpacity.value = faceOpacity(spaceLook, theme);
    this.faceUniforms.uLit.value = solid ? 1 : 0.4;
    faces.mesh.material.depthWrite = solid;
    // Solid faces are drawn before what is translucent.
    faces.mesh.renderOrder = solid ? 1 : 11;
    faces.mesh.visible = faces.count > 0 && spaceLook.faces !== 'hidden';
  }

  private prepareMoment(): void {
    const { moment, state, theme, window, view, complex } = this;
    const under = moment && state ? momentUnder3(moment, state, theme) : noSpaceItems();
    const hides = this.spaceLook.faces === 'solid' || this.spaceLook.cells;
    const over = moment && state ? momentOver3(moment, state, theme, hides) : noSpaceItems();
    if (complex && this.defects.length > 0)
      append(over, defectItems3(complex, this.triangles, this.defects, theme));
    append(over, this.pickedItems());
    append(over, this.labels());
    if (this.extras) append(over, this.extras);
    this.layers.under.set(under, window, view.scale);
    this.layers.over.set(over, window, view.scale);
  }

  /** What is picked: outlined in the color of a selection. */
  private pickedItems(): SpaceItems {
    const items = noSpaceItems();
    const { picked, state, complex, theme } = this;
    if (!picked) return items;
    const color = theme.selection;
    const at = (v: number): Point3 | undefined =>
      state && v < state.vertexCount ? place(state, v) : complex?.vertices[v];
    const points = (list: Iterable<number>) =>
      [...list].map(at).filter((p): p is Point3 => p !== undefined);
    const outline = (corners: readonly Point3[]) => {
      for (const [a, b] of edgesOf(corners)) items.lines.push({ a, b, color, width: 2.6 });
    };
    if (picked.vertex !== null) {
      for (const p of points([picked.vertex]))
        items.marks.push({ at: p, shape: 'disc', size: 17, stroke: color, width: 2.6 });
    } else if (picked.subsegment !== null) {
      const n = picked.subsegment;
      const ends = state
        ? state.subsegments.subarray(3 * n, 3 * n + 2)
        : (complex?.segments[n] ?? []);
      for (const [a, b] of edgesOf(points(ends)))
        items.lines.push({ a, b, color, width: 8, opacity: 0.55 });
    } else if (picked.cell !== null && state) {
      outline(points(state.cells.subarray(4 * picked.cell, 4 * picked.cell + 4)));
    } else if (picked.facet !== null && state?.facets) {
      const n = picked.facet;
      outline(points(state.facets.triangles.subarray(4 * n, 4 * n + 3)));
    }
    if (picked.face !== null) {
      for (const loop of complex?.faces[picked.face]?.loops ?? []) {
        const corners = points(loop);
        for (const [i, a] of corners.entries()) {
          const b = corners[(i + 1) % corners.length]!;
          items.lines.push({ a, b, color, width: 3, opacity: 0.8 });
        }
      }
    }
    return items;
  }

  private labels(): SpaceItems {
    const items = noSpaceItems();
    const { state, complex, theme } = this;
    if (!this.spaceLook.labels) return items;
    const count = state ? state.vertexCount : (complex?.vertices.length ?? 0);
    let left = MOST_LABELS;
    for (let v = 0; v < count && left > 0; v++) {
      if (state && !(state.vertexBorn[v]! < state.position)) continue;
      const at = state ? place(state, v) : complex!.vertices[v]!;
      const text = { text: String(v), size: 12, color: theme.ink, halo: theme.background };
      items.texts.push({ at, ...text, dx: 0, dy: 8 });
      left--;
    }
    return items;
  }

  /** Vertices get smaller where they would crowd. */
  private markSize(): number {
    if (this.spacing === 0) return 1;
    return Math.min(1, Math.max(0.35, (this.spacing * this.view.scale) / 16));
  }

  private includeVertices(): void {
    const { state } = this;
    if (!state) return;
    for (; this.boundedVertices < state.vertexCount; this.boundedVertices++) {
      const v = this.boundedVertices;
      if (state.vertexBorn[v] === 0xffffffff) break; // not yet known
      this.meshBounds = include(this.meshBounds, place(state, v));
    }
  }

  /** World units that what there is reaches before or behind the target. */
  private depth(bounds: Bounds3 | null): number {
    if (!bounds) return 1;
    const { toEye } = basisOf(this.view);
    const depths = cornersOf(bounds).map((p) => Math.abs(dot(toEye, minus(p, this.view.target))));
    return 1.02 * Math.max(...depths) + 30 / this.view.scale;
  }

  private tellScale(): void {
    const scale = this.state ? this.coloring.scale : null;
    if (scale === this.lastScale) return;
    this.lastScale = scale;
    for (const listener of this.scaleListeners) listener(scale);
  }
}

/** Of segments and faces; of all vertices if there are none. */
function boundsOfFeatures(complex: Complex3): Bounds3 | null {
  const used = new Set<number>();
  for (const [a, b] of complex.segments) used.add(a).add(b);
  for (const { loops } of complex.faces)
    for (const loop of loops) for (const v of loop) used.add(v);
  const places = [...used].map((v) => complex.vertices[v]).filter((p) => p !== undefined);
  return boundsOf3(places.length > 1 ? places : complex.vertices);
}

function meanLength(
  vertices: readonly Point3[],
  segments: readonly (readonly [number, number])[],
): number {
  let sum = 0;
  let count = 0;
  for (const [a, b] of segments) {
    const [p, q] = [vertices[a], vertices[b]];
    if (!p || !q) continue;
    sum += distance3(p, q);
    count++;
  }
  return count > 0 ? sum / count : 0;
}

function isSame(a: SpaceView, b: SpaceView): boolean {
  const drift = distance3(a.target, b.target) * a.scale;
  return drift < 1 && Math.abs(a.scale / b.scale - 1) < 1e-3;
}

function append(to: SpaceItems, from: SpaceItems): void {
  to.triangles.push(...from.triangles);
  to.spheres.push(...from.spheres);
  to.lines.push(...from.lines);
  to.marks.push(...from.marks);
  to.texts.push(...from.texts);
}
