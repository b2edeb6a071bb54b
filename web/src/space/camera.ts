/** The view of a picture in space: moved at once or in a short flight, fitted to what there is, heard by listeners. */

import { distance3 } from '../replay/geometry3';
import type { Insets, Point, Point3 } from '../shared/types';
import type { SpaceView, StandardView } from './types';
import {
  type Bounds3,
  basisOf,
  between,
  clampScale,
  extentOf,
  fitView,
  orbit,
  pan,
  project,
  type Size,
  standardView,
  zoomAt,
} from './view';

const FLIGHT_MS = 260;

/** What the camera looks at. */
export interface Scenery {
  /** All there is. */
  all(): Bounds3 | null;
  /** Segments and faces of the input. */
  features(): Bounds3 | null;
}

export class SpaceCamera {
  view: SpaceView = { target: [0, 0, 0], azimuth: -60, elevation: 24, scale: 100 };
  size: Size = { width: 1, height: 1 };
  insets: Insets = { left: 8, top: 8, right: 8, bottom: 56 };
  private flight: { from: SpaceView; to: SpaceView; start: number } | null = null;
  private readonly listeners = new Set<(view: SpaceView) => void>();

  /** `moved`: a drawing is due. */
  constructor(
    private readonly scenery: Scenery,
    private readonly moved: () => void,
  ) {}

  onChange(listener: (view: SpaceView) => void): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  /** Where it is, or will be. */
  get(): SpaceView {
    return this.flight?.to ?? this.view;
  }

  set(view: SpaceView, smooth: boolean): void {
    if (![...view.target, view.azimuth, view.elevation, view.scale].every(Number.isFinite)) return;
    if (!(view.scale > 0)) return;
    const to = { ...view, scale: clampScale(view.scale, extentOf(this.scenery.all())) };
    if (smooth) {
      this.flight = { from: this.view, to, start: performance.now() };
    } else {
      this.flight = null;
      this.view = to;
      this.tell();
    }
    this.moved();
  }

  /** One frame of a flight; false if there is none, or it has ended with this frame. */
  fly(): boolean {
    if (!this.flight) return false;
    const { from, to, start } = this.flight;
    const t = Math.min(1, (performance.now() - start) / FLIGHT_MS);
    this.view = t === 1 ? to : between(from, to, t * t * (3 - 2 * t));
    if (t === 1) this.flight = null;
    this.tell();
    return this.flight !== null;
  }

  /** At its end at once. */
  land(): void {
    if (this.flight) this.view = this.flight.to;
    this.flight = null;
  }

  fit(smooth: boolean): void {
    const view = this.get();
    const [features, all] = [this.scenery.features(), this.scenery.all()];
    const near = features && this.framing(features, view);
    // Lonely vertices and the box may stand far around: once the features fill the picture, all of it is shown.
    if (near && !(smooth && isSame(near, view))) this.set(near, smooth);
    else if (all) this.set(this.framing(all, view), smooth);
  }

  /** The view that shows a box, in the direction of another view. */
  framing(bounds: Bounds3, view = this.get()): SpaceView {
    return fitView(view, bounds, this.size, this.insets);
  }

  look(from: StandardView, smooth: boolean): void {
    const turned = standardView(this.get(), from);
    const bounds = this.scenery.features() ?? this.scenery.all();
    this.set(bounds ? this.framing(bounds, turned) : turned, smooth);
  }

  zoomBy(factor: number, at: Point = [this.size.width / 2, this.size.height / 2]): void {
    const from = this.get();
    const bounded = clampScale(from.scale * factor, extentOf(this.scenery.all())) / from.scale;
    this.set(zoomAt(from, this.size, bounded, at), false);
  }

  panBy(dx: number, dy: number): void {
    this.set(pan(this.get(), dx, dy), false);
  }

  orbitBy(dx: number, dy: number): void {
    this.set(orbit(this.get(), dx, dy), false);
  }

  toScreen(p: Point3): Point {
    const [x, y] = project(this.view, basisOf(this.view), this.size, p);
    return [x, y];
  }

  dispose(): void {
    this.listeners.clear();
  }

  private tell(): void {
    for (const listener of this.listeners) listener(this.view);
  }
}

function isSame(a: SpaceView, b: SpaceView): boolean {
  const drift = distance3(a.target, b.target) * a.scale;
  return drift < 1 && Math.abs(a.scale / b.scale - 1) < 1e-3;
}
