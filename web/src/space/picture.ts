/** The picture of space on a canvas: three.js draws when something changed, and only then. */

import { OrthographicCamera, Scene as ThreeScene, Vector4, WebGLRenderer } from 'three';
import { parseColor } from '../picture/color';
import { Batch } from '../picture/gpu/batch';
import { type Glyphs, makeGlyphs } from '../picture/gpu/glyphs';
import { renderPng } from '../picture/png';
import { type CollarRegion, noRegion } from '../replay/collar-region';
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
import { SpaceCamera } from './camera';
import { rgbaOf, SpaceColoring } from './coloring';
import { complexItems3, defectItems3 } from './complex-items';
import { append } from './face-items';
import { noSpaceItems, type SpaceItems } from './items';
import { putPoint3, SpaceLayer } from './layer';
import { faceColor, faceOpacity, type MeshLook, place, SpaceMeshLayer } from './mesh-layer';
import { momentOver3, momentUnder3, placesOf } from './moment-items';
import { labelItems3, pickedItems3 } from './overlay-items';
import { pickSpace } from './pick';
import { ProtectionLayer } from './protection-layer';
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
  boundsOf3,
  centerOf,
  cornersOf,
  extentOf,
  include,
  makeWindow3,
  type Plane,
  planeThrough,
  serves3,
  type Window3,
} from './view';

interface Stale {
  complex: boolean;
  mesh: boolean;
  rows: boolean; // every row of the mesh
  cells: boolean;
  moment: boolean;
  look: boolean;
  protection: boolean;
}

const everything: Stale = {
  complex: true,
  mesh: true,
  rows: true,
  cells: true,
  moment: true,
  look: true,
  protection: true,
};

export class CanvasSpacePicture implements SpacePicture {
  readonly canvas: HTMLCanvasElement;
  private readonly renderer: WebGLRenderer;
  private readonly three = new ThreeScene();
  private readonly eye = new OrthographicCamera(); // shaders project by themselves
  private readonly uniforms = makeSpaceUniforms();
  private readonly glyphs: Glyphs;
  private readonly mesh: SpaceMeshLayer;
  private readonly protection: ProtectionLayer;
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
  private readonly scaleListeners = new Set<(scale: ColorScale | null) => void>();
  private readonly camera = new SpaceCamera(
    { all: () => this.contents(), features: () => this.featureBounds },
    () => this.invalidate(),
  );
  private basis: Basis = basisOf(this.camera.view);
  private pixelRatio = 1;
  private window: Window3 = makeWindow3(this.camera.view, null);
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
  private region: (() => CollarRegion) | null = null;
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
    this.protection = new ProtectionLayer(this.three, this.uniforms);
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

  setMesh(
    state: MeshState | null,
    run: object | null,
    region: (() => CollarRegion) | null = null,
  ): void {
    // Before the first event there is nothing but the input.
    const shown = state && state.position > 0 ? state : null;
    if (run !== this.run || !shown) {
      this.run = run;
      this.mesh.clear();
      this.protection.clear();
      this.coloring.forget();
      this.meshBounds = null;
      this.boundedVertices = 0;
    }
    if ((shown === null) !== (this.state === null)) this.touch('complex');
    this.state = shown;
    this.region = region;
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
    this.camera.insets = insets;
  }

  get scale(): ColorScale | null {
    return this.lastScale;
  }

  onScaleChange(listener: (scale: ColorScale | null) => void): () => void {
    this.scaleListeners.add(listener);
    return () => this.scaleListeners.delete(listener);
  }

  getView(): SpaceView {
    return this.camera.get();
  }

  setView(view: SpaceView, smooth = false): void {
    this.camera.set(view, smooth && !this.theme.reducedMotion);
  }

  onViewChange(listener: (view: SpaceView) => void): () => void {
    return this.camera.onChange(listener);
  }

  fit(smooth = false): void {
    this.camera.fit(smooth && !this.theme.reducedMotion);
  }

  look(from: StandardView): void {
    this.camera.look(from, !this.theme.reducedMotion);
  }

  zoomBy(factor: number, at?: Point): void {
    this.camera.zoomBy(factor, at);
  }

  panBy(dx: number, dy: number): void {
    this.camera.panBy(dx, dy);
  }

  orbitBy(dx: number, dy: number): void {
    this.camera.orbitBy(dx, dy);
  }

  lookAtMoment(): boolean {
    const { moment, state } = this;
    return moment !== null && state !== null && this.lookAt(placesOf(moment, state));
  }

  lookAt(places: readonly Point3[]): boolean {
    const bounds = boundsOf3(places);
    if (!bounds) return false;
    // A single vertex, or a tiny simplex, among what is around it.
    const least = 3 * this.spacing;
    const middle = centerOf(bounds);
    const reach = Math.max(extentOf(bounds), least) / 2;
    const grown = {
      min: plus(middle, [reach, reach, reach], -1),
      max: plus(middle, [reach, reach, reach]),
    };
    this.setView(this.camera.framing(grown), true);
    return true;
  }

  centerOn(at: Point3): void {
    this.setView({ ...this.getView(), target: at }, true);
  }

  toScreen(p: Point3): Point {
    return this.camera.toScreen(p);
  }

  direction(): Point3 {
    return basisOf(this.camera.view).toEye;
  }

  pick(x: number, y: number): SpaceHit | null {
    this.prepare();
    return pickSpace(
      {
        view: this.camera.view,
        basis: this.basis,
        size: this.camera.size,
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
    const size = { width: Math.max(width, 1), height: Math.max(height, 1) };
    this.camera.size = size;
    this.pixelRatio = pixelRatio;
    this.renderer.setPixelRatio(pixelRatio);
    this.renderer.setSize(size.width, size.height, false);
    // A resized canvas is blank until it is drawn: at once, or it flickers.
    this.draw();
  }

  async toPNG(width: number, background: Background): Promise<Blob> {
    this.camera.land();
    this.prepare();
    const paper = background === 'white' ? '#ffffff' : this.theme.background;
    try {
      return await renderPng({
        renderer: this.renderer,
        scene: this.three,
        camera: this.eye,
        uniforms: this.uniforms,
        size: this.camera.size,
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
    this.protection.dispose();
    this.glyphs.texture.dispose();
    this.renderer.dispose();
    this.camera.dispose();
    this.scaleListeners.clear();
  }

  private readonly onRestored = () => {
    this.mesh.clear();
    this.protection.clear();
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
    const isFlying = this.camera.fly();
    this.prepare();
    const [r, g, b] = parseColor(this.theme.background);
    this.renderer.setClearColor(
      (Math.round(r * 255) << 16) | (Math.round(g * 255) << 8) | Math.round(b * 255),
      1,
    );
    this.renderer.render(this.three, this.eye);
    if (isFlying) this.invalidate();
  }

  /** Brings the buffers up to what was set, and no further. */
  private prepare(): void {
    const { stale, state, theme, spaceLook } = this;
    const { view, size } = this.camera;
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
      this.protection.clear();
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
    this.prepareProtection();
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

  private prepareProtection(): void {
    const { stale, state, spaceLook, theme, window, complex } = this;
    const wanted = spaceLook.collars || spaceLook.surfaces;
    if (state && wanted && (stale.mesh || stale.rows || stale.protection)) {
      const region = this.region?.() ?? noRegion;
      this.protection.sync(state, region, { theme, look: spaceLook, window, complex });
    }
    stale.protection = !wanted;
    this.protection.show(state !== null, spaceLook);
  }

  private prepareComplex(): void {
    const { complex, theme, window, faces, triangles } = this;
    const meshed = this.state !== null;
    const items = complex ? complexItems3(complex, theme, meshed) : noSpaceItems();
    this.layers.input.set(items, window, this.camera.view.scale);
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
    const { moment, state, theme, window, complex, picked } = this;
    const { scale } = this.camera.view;
    const under = moment && state ? momentUnder3(moment, state, theme, complex) : noSpaceItems();
    const hides = this.spaceLook.faces === 'solid' || this.spaceLook.cells;
    const over = moment && state ? momentOver3(moment, state, theme, hides) : noSpaceItems();
    if (complex && this.defects.length > 0)
      append(over, defectItems3(complex, this.triangles, this.defects, theme));
    append(over, pickedItems3(picked, state, complex, theme));
    if (this.spaceLook.labels) append(over, labelItems3(state, complex, theme));
    if (this.extras) append(over, this.extras);
    this.layers.under.set(under, window, scale);
    this.layers.over.set(over, window, scale);
  }

  /** Vertices get smaller where they would crowd. */
  private markSize(): number {
    if (this.spacing === 0) return 1;
    return Math.min(1, Math.max(0.35, (this.spacing * this.camera.view.scale) / 16));
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
    const { view } = this.camera;
    const { toEye } = basisOf(view);
    const depths = cornersOf(bounds).map((p) => Math.abs(dot(toEye, minus(p, view.target))));
    return 1.02 * Math.max(...depths) + 30 / view.scale;
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
