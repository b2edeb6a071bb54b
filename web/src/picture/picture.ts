/** The picture on a canvas: three.js draws the scene when something changed, and only then. */

import { OrthographicCamera, Scene as ThreeScene, WebGLRenderer } from 'three';
import type { OverlayFacts } from '../shared/overlay-facts';
import type {
  Background,
  Bounds,
  ColorMode,
  ColorScale,
  Complex2,
  DefectMark,
  Hit,
  Insets,
  MeshChange,
  MeshState,
  Moment,
  Overlays,
  Picture,
  PictureOptions,
  PictureTheme,
  Point,
  Selection,
  Sketch,
  View,
} from '../shared/types';
import { parseColor } from './color';
import { type Glyphs, makeGlyphs } from './gpu/glyphs';
import { ImageLayer } from './gpu/image';
import { Layer } from './gpu/layer';
import { MeshLayer } from './gpu/mesh-layer';
import { makeViewUniforms, setView } from './gpu/uniforms';
import { noItems } from './items';
import { landingSize, type Motion, makeMotion, motionItems } from './layers/motion';
import { pickComplex, pickMesh } from './pick';
import { renderPng } from './png';
import { Scene } from './scene';
import { sceneToSvg } from './svg';
import {
  boundsOf,
  clampScale,
  fitView,
  panBy,
  type Size,
  toScreen,
  toWorld,
  unite,
  zoomAt,
} from './view';
import { makeWindow, serves, type Window } from './window';

const reach = { vertex: 10, segment: 7 };

/** Where the page has its tools (left) and its zoom buttons (lower right), unless it says otherwise. */
const toolInsets: Insets = { left: 56, top: 8, right: 8, bottom: 56 };

/** What has to be drawn anew. */
interface Stale {
  triangles: boolean; // all rows
  vertices: boolean;
  middle: boolean;
  top: boolean;
  look: boolean;
}

export class CanvasPicture implements Picture {
  readonly canvas: HTMLCanvasElement;
  private readonly renderer: WebGLRenderer;
  private readonly three = new ThreeScene();
  private readonly camera = new OrthographicCamera();
  private readonly uniforms = makeViewUniforms();
  private readonly glyphs: Glyphs;
  private readonly scene: Scene;
  private readonly meshLayer: MeshLayer;
  private readonly layers: {
    background: Layer;
    field: Layer;
    under: Layer;
    features: Layer;
    motion: Layer;
    top: Layer;
  };
  private readonly image: ImageLayer;
  private readonly listeners = new Set<(view: View) => void>();
  private view: View = { x: 0, y: 0, scale: 100 };
  private size: Size = { width: 1, height: 1 };
  private pixelRatio = 1;
  private window: Window;
  private stale: Stale = { triangles: true, vertices: true, middle: true, top: true, look: true };
  private dirtyTriangles: number[] = [];
  private dirtyVertices: number[] = [];
  private motion: { motion: Motion; start: number } | null = null;
  private meshTouched = false;
  private detail = 1;
  private drawnScale = 0;
  private frame = 0;
  private disposed = false;

  constructor(canvas: HTMLCanvasElement, options: PictureOptions) {
    this.canvas = canvas;
    this.scene = new Scene(options.theme);
    this.scene.insets = toolInsets;
    this.renderer = new WebGLRenderer({
      canvas,
      antialias: options.antialias,
      alpha: true,
      premultipliedAlpha: true,
      preserveDrawingBuffer: true, // print and screenshots read the canvas between frames
      depth: false,
      stencil: false,
    });
    this.renderer.sortObjects = true;
    this.renderer.autoClear = true;
    this.glyphs = makeGlyphs();
    this.window = makeWindow(this.view, this.size, null);
    const add = (order: number) => new Layer(this.three, this.uniforms, this.glyphs, order);
    this.layers = {
      background: add(0),
      field: add(13),
      under: add(20),
      motion: add(30),
      features: add(40),
      top: add(60),
    };
    this.image = new ImageLayer(this.three, this.uniforms, 12);
    this.meshLayer = new MeshLayer(this.three, this.uniforms, this.scene.model, 10, 50);
    this.three.matrixWorldAutoUpdate = false;
    canvas.addEventListener('webglcontextrestored', this.onRestored);
    this.resize(canvas.clientWidth || 1, canvas.clientHeight || 1, 1);
  }

  setMesh(state: MeshState | null, change?: MeshChange | null, speed = 1): void {
    const { scene } = this;
    if (!state || !scene.meshed || state.position !== scene.model.position) this.motion = null;
    if (!state) {
      if (scene.meshed) {
        scene.meshed = false;
        this.touch('middle', 'top');
      }
      return;
    }
    if (!scene.meshed) {
      scene.meshed = true;
      this.touch('triangles', 'vertices');
    }
    const before = scene.model.position;
    const difference = scene.model.sync(state);
    if (difference.restarted) this.touch('triangles', 'vertices');
    this.meshTouched = true;
    for (const slot of difference.triangleSlots) this.dirtyTriangles.push(slot);
    for (const v of difference.vertices) this.dirtyVertices.push(v);
    const ranged = scene.coloring.updateRange();
    if (ranged.all) this.touch('triangles');
    if (ranged.range) this.touch('look');
    // The same state again (another speed, another color) is no news, and moves nothing.
    const moved = state.position !== before;
    if (change && moved) {
      scene.rememberChange(state, change);
      if (!scene.theme.reducedMotion && scene.overlays.mesh) {
        const motion = makeMotion(state, change, speed);
        if (motion) this.motion = { motion, start: performance.now() };
      }
    }
    scene.setMoment(null);
    this.touch('middle', 'top');
  }

  setMoment(moment: Moment | null): void {
    this.scene.setMoment(moment);
    this.touch('middle', 'top');
  }

  setComplex(complex: Complex2, selection: Selection | null, defects: readonly DefectMark[]): void {
    Object.assign(this.scene, { complex, selection, defects });
    this.touch('middle', 'top');
  }

  setSketch(sketch: Sketch | null): void {
    this.scene.sketch = sketch;
    this.touch('top');
  }

  /** Costs nothing if the mode is the same. The scale is another object only when it changed. */
  setColorMode(mode: ColorMode): ColorScale | null {
    if (mode === this.scene.coloring.mode) return this.scene.coloring.scale;
    this.scene.coloring.setMode(mode, this.scene.theme.dark);
    this.touch('triangles', 'look');
    return this.scene.coloring.scale;
  }

  setValues(values: Float64Array | null): void {
    const { coloring } = this.scene;
    if (values === coloring.values) return;
    coloring.values = values;
    if (coloring.mode !== 'error') return;
    coloring.updateRange();
    this.touch('triangles', 'look');
  }

  setOverlays(overlays: Overlays): void {
    const before = this.scene.overlays;
    this.scene.overlays = overlays;
    if (before.outside !== overlays.outside || before.highlight !== overlays.highlight) {
      this.touch('triangles');
    }
    this.touch('middle', 'top');
  }

  setFacts(facts: OverlayFacts): void {
    this.scene.facts = facts;
    this.touch('middle', 'top');
  }

  setTheme(theme: PictureTheme): void {
    this.scene.theme = theme;
    this.scene.coloring.setMode(this.scene.coloring.mode, theme.dark);
    this.touch('vertices', 'middle', 'top', 'look');
  }

  setPicked(hit: Hit | null): void {
    this.scene.picked = hit;
    this.touch('top');
  }

  getView(): View {
    return this.view;
  }

  setView(view: View): void {
    if (![view.x, view.y, view.scale].every(Number.isFinite) || view.scale <= 0) return;
    this.view = { ...view, scale: clampScale(view.scale, view, this.extent()) };
    this.invalidate();
    for (const listener of this.listeners) listener(this.view);
  }

  onViewChange(listener: (view: View) => void): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  fit(bounds?: Bounds): void {
    const target = bounds ?? this.contents();
    if (target) this.setView(fitView(target, this.size, this.scene.insets));
    else this.setView({ x: 0.5, y: 0.5, scale: Math.min(this.size.width, this.size.height) * 0.8 });
  }

  setInsets(insets: Insets): void {
    this.scene.insets = insets;
    this.touch('top');
  }

  zoomBy(factor: number, at?: Point): void {
    const anchor = at ?? [this.size.width / 2, this.size.height / 2];
    this.setView(zoomAt(this.view, this.size, factor, anchor, this.extent()));
  }

  panBy(dx: number, dy: number): void {
    this.setView(panBy(this.view, dx, dy));
  }

  toWorld(x: number, y: number): Point {
    return toWorld(this.view, this.size, x, y);
  }

  toScreen(p: Point): Point {
    return toScreen(this.view, this.size, p);
  }

  pick(x: number, y: number): Hit | null {
    const p = this.toWorld(x, y);
    const { scene } = this;
    const seeds = pickComplex(scene.complex, p, this.view.scale, reach);
    const hit = scene.meshed
      ? {
          ...pickMesh(scene.model, p, this.view.scale, reach, scene.overlays.outside),
          hole: seeds.hole,
          region: seeds.region,
        }
      : seeds;
    return Object.values(hit).some((value) => value !== null) ? hit : null;
  }

  resize(width: number, height: number, pixelRatio: number): void {
    this.size = { width: Math.max(width, 1), height: Math.max(height, 1) };
    this.pixelRatio = pixelRatio;
    this.renderer.setPixelRatio(pixelRatio);
    this.renderer.setSize(this.size.width, this.size.height, false);
    for (const listener of this.listeners) listener(this.view); // other places are in sight
    // A resized canvas is blank until it is drawn: at once, or it flickers.
    this.draw();
  }

  async toPNG(width: number, background: Background): Promise<Blob> {
    this.motion = null;
    this.prepare();
    try {
      return await renderPng({
        renderer: this.renderer,
        scene: this.three,
        camera: this.camera,
        uniforms: this.uniforms,
        size: this.size,
        width,
        background:
          background === 'transparent'
            ? [0, 0, 0, 0]
            : parseColor(background === 'white' ? '#ffffff' : this.scene.theme.background),
      });
    } finally {
      this.invalidate();
    }
  }

  toSVG(centimeters: number, background: Background): string {
    return sceneToSvg(this.scene, this.view, this.size, centimeters, background);
  }

  dispose(): void {
    this.disposed = true;
    cancelAnimationFrame(this.frame);
    this.canvas.removeEventListener('webglcontextrestored', this.onRestored);
    for (const layer of Object.values(this.layers)) layer.dispose();
    this.image.dispose();
    this.meshLayer.dispose();
    this.glyphs.texture.dispose();
    this.renderer.dispose();
    this.listeners.clear();
  }

  private readonly onRestored = () => {
    this.touch('triangles', 'vertices', 'middle', 'top', 'look');
  };

  private contents(): Bounds | null {
    const { scene } = this;
    const input = boundsOf([
      ...scene.complex.vertices,
      ...scene.complex.holes,
      ...scene.complex.regions.map((r) => r.at),
    ]);
    return unite(input, scene.meshed ? scene.model.bounds : null);
  }

  private extent(): number {
    const b = this.contents();
    return b ? Math.max(b.maxX - b.minX, b.maxY - b.minY) : 0;
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
    this.prepare();
    const [r, g, b] = parseColor(this.scene.theme.background);
    this.renderer.setClearColor(
      (Math.round(r * 255) << 16) | (Math.round(g * 255) << 8) | Math.round(b * 255),
      1,
    );
    this.renderer.render(this.three, this.camera);
    if (this.motion) this.invalidate();
  }

  /** Brings the buffers up to what was set, and no further. */
  private prepare(): void {
    const { scene, view, size, stale, layers } = this;
    const contents = this.contents();
    if (!serves(this.window, view, size, contents)) {
      this.window = makeWindow(view, size, contents);
      stale.triangles = stale.vertices = stale.middle = stale.top = true;
    }
    const { window } = this;
    setView(this.uniforms, view, size, window);
    this.uniforms.uPixel.value = this.pixelRatio;
    this.prepareMesh();
    layers.background.set(scene.background(view, size), window, view.scale);
    const detail = scene.detail(view);
    const { circumcircles, diametral, neighbors, intestines } = scene.overlays;
    const followsView = circumcircles || diametral || neighbors || intestines;
    this.image.set(scene.image(), window);
    if (stale.middle || view.scale !== this.drawnScale) {
      layers.field.set(scene.field(view), window, view.scale);
      this.drawnScale = view.scale;
    }
    if (stale.middle || detail !== this.detail || followsView) {
      const { under, features } = scene.middle(view, size);
      layers.under.set(under, window, view.scale);
      layers.features.set(features, window, view.scale);
      this.detail = detail;
    }
    // Labels, the scale bar and hints depend on the view: a few rows, every frame.
    layers.top.set(scene.top(view, size), window, view.scale);
    this.prepareMotion();
    this.stale = { triangles: false, vertices: false, middle: false, top: false, look: false };
  }

  private prepareMesh(): void {
    const { scene, stale, window, meshLayer } = this;
    const look = {
      theme: scene.theme,
      outside: scene.overlays.outside,
      highlight: scene.overlays.highlight,
    };
    if (stale.look) meshLayer.setLook(scene.theme, scene.coloring);
    else meshLayer.setRange(scene.coloring);
    if (scene.meshed) {
      const whole = window.box === null;
      if (stale.triangles || (!whole && this.meshTouched)) {
        meshLayer.rebuildTriangles(window, look, scene.coloring);
      } else {
        meshLayer.updateTriangles(this.dirtyTriangles, window, look, scene.coloring);
      }
      if (stale.vertices || (!whole && this.meshTouched)) {
        meshLayer.rebuildVertices(window, look);
      } else if (whole) {
        meshLayer.updateVertices(this.dirtyVertices, window, look);
      }
      this.meshTouched = false;
      this.dirtyTriangles = [];
      this.dirtyVertices = [];
      meshLayer.setVertexSize(scene.vertexSize(this.view, this.size));
    }
    meshLayer.show(scene.meshed && scene.overlays.mesh, scene.meshed && scene.overlays.vertices);
  }

  private prepareMotion(): void {
    const { motion, layers, meshLayer, scene, window } = this;
    if (motion) {
      const t = (performance.now() - motion.start) / motion.motion.milliseconds;
      if (t < 1) {
        layers.motion.set(motionItems(motion.motion, t, scene.theme), window, this.view.scale);
        if (!window.box) meshLayer.setLanding(motion.motion.vertex, landingSize(motion.motion, t));
        return;
      }
      this.motion = null;
    }
    layers.motion.set(noItems(), window, this.view.scale);
    meshLayer.setLanding(-1, 1);
  }
}
