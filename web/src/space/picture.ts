/** The picture of space on a canvas: three.js draws when something changed, and only then. */

import { OrthographicCamera, WebGLRenderer } from 'three';
import { parseColor } from '../picture/color';
import { renderPng } from '../picture/png';
import type { CollarRegion } from '../replay/collar-region';
import { plus } from '../replay/geometry3';
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
import type { SpaceItems } from './items';
import { pickSpace } from './pick';
import { SpaceScene } from './scene';
import type { SpaceHit, SpaceLook, SpacePicture, SpaceView, StandardView } from './types';
import { basisOf, boundsOf3, centerOf, extentOf } from './view';

export class CanvasSpacePicture implements SpacePicture {
  readonly canvas: HTMLCanvasElement;
  private readonly renderer: WebGLRenderer;
  private readonly eye = new OrthographicCamera(); // shaders project by themselves
  private readonly scaleListeners = new Set<(scale: ColorScale | null) => void>();
  private readonly camera: SpaceCamera;
  private readonly scene: SpaceScene;
  private pixelRatio = 1;
  private lastScale: ColorScale | null = null;
  private frame = 0;
  private disposed = false;

  constructor(canvas: HTMLCanvasElement, options: PictureOptions) {
    this.canvas = canvas;
    this.renderer = new WebGLRenderer({
      canvas,
      antialias: options.antialias,
      alpha: true,
      premultipliedAlpha: true,
      preserveDrawingBuffer: true, // print and screenshots read the canvas between frames
      depth: true,
      stencil: false,
    });
    const touched = () => this.invalidate();
    const scenery = { all: () => this.scene.contents(), features: () => this.scene.featureBounds };
    this.camera = new SpaceCamera(scenery, touched);
    this.scene = new SpaceScene(this.camera.view, options.theme, touched);
    canvas.addEventListener('webglcontextrestored', this.onRestored);
    this.resize(canvas.clientWidth || 1, canvas.clientHeight || 1, 1);
  }

  setComplex(
    complex: Complex3 | null,
    triangles: Uint32Array,
    defects: readonly DefectMark[],
  ): void {
    this.scene.setComplex(complex, triangles, defects);
  }

  setMesh(
    state: MeshState | null,
    run: object | null,
    region: (() => CollarRegion) | null = null,
  ): void {
    this.scene.setMesh(state, run, region);
  }

  setMoment(moment: Moment3 | null): void {
    this.scene.setMoment(moment);
  }

  setLook(look: SpaceLook): void {
    this.scene.setLook(look);
  }

  setPicked(hit: SpaceHit | null): void {
    this.scene.setPicked(hit);
  }

  setExtras(items: SpaceItems | null): void {
    this.scene.setExtras(items);
  }

  setTheme(theme: PictureTheme): void {
    this.scene.setTheme(theme);
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
    this.camera.set(view, smooth && !this.scene.theme.reducedMotion);
  }

  onViewChange(listener: (view: SpaceView) => void): () => void {
    return this.camera.onChange(listener);
  }

  fit(smooth = false): void {
    this.camera.fit(smooth && !this.scene.theme.reducedMotion);
  }

  look(from: StandardView): void {
    this.camera.look(from, !this.scene.theme.reducedMotion);
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
    return this.lookAt(this.scene.momentPlaces());
  }

  lookAt(places: readonly Point3[]): boolean {
    const bounds = boundsOf3(places);
    if (!bounds) return false;
    // A single vertex, or a tiny simplex, among what is around it.
    const least = 3 * this.scene.spacing;
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
    return pickSpace(this.scene.pickScene(this.camera), x, y);
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
    const paper = background === 'white' ? '#ffffff' : this.scene.theme.background;
    try {
      return await renderPng({
        renderer: this.renderer,
        scene: this.scene.three,
        camera: this.eye,
        uniforms: this.scene.uniforms,
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
    this.scene.dispose();
    this.renderer.dispose();
    this.camera.dispose();
    this.scaleListeners.clear();
  }

  private readonly onRestored = () => this.scene.restore();

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
    const [r, g, b] = parseColor(this.scene.theme.background);
    this.renderer.setClearColor(
      (Math.round(r * 255) << 16) | (Math.round(g * 255) << 8) | Math.round(b * 255),
      1,
    );
    this.renderer.render(this.scene.three, this.eye);
    if (isFlying) this.invalidate();
  }

  private prepare(): void {
    this.scene.prepare(this.camera, this.pixelRatio);
    const { scale } = this.scene;
    if (scale === this.lastScale) return;
    this.lastScale = scale;
    for (const listener of this.scaleListeners) listener(scale);
  }
}
