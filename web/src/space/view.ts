/** The view in space: a parallel projection about a target, in double precision. */

import { cross, dot, minus, plus, scaled } from '../replay/geometry3';
import type { Insets, Point, Point3 } from '../shared/types';
import type { SpaceView, StandardView } from './types';

export interface Size {
  readonly width: number;
  readonly height: number;
}

export interface Bounds3 {
  readonly min: Point3;
  readonly max: Point3;
}

/** Axes of the screen in the world: to the right, up, and towards the eye. Orthonormal, right-handed. */
export interface Basis {
  readonly right: Point3;
  readonly up: Point3;
  readonly toEye: Point3;
}

const radians = Math.PI / 180;
/** A drag across so many pixels is a half turn. */
const HALF_TURN = 420;

export function basisOf({ azimuth, elevation }: SpaceView): Basis {
  const [ca, sa] = [Math.cos(azimuth * radians), Math.sin(azimuth * radians)];
  const [ce, se] = [Math.cos(elevation * radians), Math.sin(elevation * radians)];
  return {
    right: [-sa, ca, 0],
    up: [-se * ca, -se * sa, ce],
    toEye: [ce * ca, ce * sa, se],
  };
}

/** CSS pixels of the canvas (y downwards), and the depth in pixels: larger is nearer. */
export function project(view: SpaceView, basis: Basis, size: Size, p: Point3): Point3 {
  const d = minus(p, view.target);
  return [
    size.width / 2 + dot(basis.right, d) * view.scale,
    size.height / 2 - dot(basis.up, d) * view.scale,
    dot(basis.toEye, d) * view.scale,
  ];
}

/** The point of the plane through the target, across the line of sight, under a place of the canvas. */
export function unproject(view: SpaceView, size: Size, x: number, y: number): Point3 {
  const { right, up } = basisOf(view);
  const across = (x - size.width / 2) / view.scale;
  const upwards = (size.height / 2 - y) / view.scale;
  return plus(plus(view.target, right, across), up, upwards);
}

export function orbit(view: SpaceView, dx: number, dy: number): SpaceView {
  const azimuth = view.azimuth - (dx / HALF_TURN) * 180;
  const elevation = view.elevation + (dy / HALF_TURN) * 180;
  return {
    ...view,
    azimuth: azimuth - 360 * Math.floor((azimuth + 180) / 360),
    elevation: Math.min(90, Math.max(-90, elevation)),
  };
}

export function pan(view: SpaceView, dx: number, dy: number): SpaceView {
  const { right, up } = basisOf(view);
  const target = plus(plus(view.target, right, -dx / view.scale), up, dy / view.scale);
  return { ...view, target };
}

/** What lies under `at` stays there. */
export function zoomAt(view: SpaceView, size: Size, factor: number, at: Point): SpaceView {
  const anchor = unproject(view, size, at[0], at[1]);
  const target = plus(anchor, minus(view.target, anchor), 1 / factor);
  return { ...view, scale: view.scale * factor, target };
}

/** Beyond these a double has no digits left, or nothing is to be seen. */
export function clampScale(scale: number, extent: number): number {
  if (!(extent > 0)) return scale;
  return Math.min(Math.max(scale, 4 / extent), 1e13 / extent);
}

export function boundsOf3(points: Iterable<Point3>): Bounds3 | null {
  let bounds: Bounds3 | null = null;
  for (const p of points) if (p.every(Number.isFinite)) bounds = include(bounds, p);
  return bounds;
}

export function include(bounds: Bounds3 | null, p: Point3): Bounds3 {
  if (!bounds) return { min: p, max: p };
  const { min, max } = bounds;
  return {
    min: [Math.min(min[0], p[0]), Math.min(min[1], p[1]), Math.min(min[2], p[2])],
    max: [Math.max(max[0], p[0]), Math.max(max[1], p[1]), Math.max(max[2], p[2])],
  };
}

export function centerOf({ min, max }: Bounds3): Point3 {
  return plus(min, minus(max, min), 0.5);
}

export function extentOf(bounds: Bounds3 | null): number {
  return bounds ? Math.max(...minus(bounds.max, bounds.min)) : 0;
}

export function cornersOf({ min, max }: Bounds3): Point3[] {
  const corners: Point3[] = [];
  for (let i = 0; i < 8; i++)
    corners.push([(i & 1 ? max : min)[0], (i & 2 ? max : min)[1], (i & 4 ? max : min)[2]]);
  return corners;
}

/** The same direction, so that the box fills what is free of the canvas. */
export function fitView(view: SpaceView, bounds: Bounds3, size: Size, insets: Insets): SpaceView {
  const { right, up } = basisOf(view);
  const center = centerOf(bounds);
  let halfWidth = 0;
  let halfHeight = 0;
  for (const corner of cornersOf(bounds)) {
    const d = minus(corner, center);
    halfWidth = Math.max(halfWidth, Math.abs(dot(right, d)));
    halfHeight = Math.max(halfHeight, Math.abs(dot(up, d)));
  }
  const margin = 0.06 * Math.min(size.width, size.height);
  const width = Math.max(size.width - insets.left - insets.right - 2 * margin, 20);
  const height = Math.max(size.height - insets.top - insets.bottom - 2 * margin, 20);
  const scale = Math.min(width / (2 * halfWidth), height / (2 * halfHeight));
  const centered = {
    ...view,
    target: center,
    scale: Number.isFinite(scale) && scale > 0 ? scale : 100,
  };
  return pan(centered, (insets.left - insets.right) / 2, (insets.top - insets.bottom) / 2);
}

const standard: Record<StandardView, readonly [number, number]> = {
  front: [-90, 0],
  right: [0, 0],
  top: [-90, 90],
  corner: [-60, 24],
};

export function standardView(view: SpaceView, from: StandardView): SpaceView {
  const [azimuth, elevation] = standard[from];
  return { ...view, azimuth, elevation };
}

/** On the way from one view to another, the shorter way around. */
export function between(a: SpaceView, b: SpaceView, t: number): SpaceView {
  const turn = ((((b.azimuth - a.azimuth) % 360) + 540) % 360) - 180;
  const mix = (x: number, y: number) => x + (y - x) * t;
  return {
    target: plus(a.target, minus(b.target, a.target), t),
    azimuth: t === 1 ? b.azimuth : a.azimuth + turn * t,
    elevation: mix(a.elevation, b.elevation),
    scale: a.scale * (b.scale / a.scale) ** t,
  };
}

/**
 * How doubles become the single precision of the GPU: coordinates are taken relative to an origin and scaled by a unit before they are
 * rounded. While all there is is less than `preciseSpan` pixels wide one window serves every view (an error below 0.012
 * pixels); deeper, the origin is near what is looked at, and lines are cut off in double precision `reach` pixels from it.
 */
export interface Window3 {
  readonly origin: Point3;
  readonly unit: number;
  readonly reach: number; // world units; infinite: nothing is cut off
}

const preciseSpan = 2e5;

export function makeWindow3(view: SpaceView, bounds: Bounds3 | null): Window3 {
  const extent = extentOf(bounds);
  if (bounds && spanFrom(view, bounds) * view.scale <= preciseSpan / 2) {
    const unit = extent > 0 ? 1000 / extent : view.scale;
    return { origin: centerOf(bounds), unit, reach: Number.POSITIVE_INFINITY };
  }
  return { origin: view.target, unit: view.scale, reach: preciseSpan / 2 / view.scale };
}

export function serves3(window: Window3, view: SpaceView, bounds: Bounds3 | null): boolean {
  const drift = Math.max(...minus(view.target, window.origin).map(Math.abs)) * view.scale;
  if (!Number.isFinite(window.reach)) {
    if (!bounds) return true;
    const offset = Math.max(...minus(centerOf(bounds), window.origin).map(Math.abs));
    return (spanFrom(view, bounds) + offset) * view.scale <= preciseSpan;
  }
  const ratio = view.scale / window.unit;
  return ratio < 16 && ratio > 1 / 16 && drift < (window.reach * view.scale) / 2;
}

function spanFrom(view: SpaceView, { min, max }: Bounds3): number {
  return Math.max(
    ...minus(max, min),
    ...minus(view.target, min).map(Math.abs),
    ...minus(view.target, max).map(Math.abs),
  );
}

/** The part of segment ab in a cube about the window's origin; null if there is none. */
export function clipToWindow(
  a: Point3,
  b: Point3,
  window: Window3,
): readonly [Point3, Point3] | null {
  const { origin, reach } = window;
  if (!Number.isFinite(reach)) return [a, b];
  const d = minus(b, a);
  let [from, to] = [0, 1];
  for (let k = 0; k < 3; k++) {
    const start = a[k]! - origin[k]!;
    const along = d[k]!;
    if (along === 0) {
      if (Math.abs(start) > reach) return null;
      continue;
    }
    const t0 = (-reach - start) / along;
    const t1 = (reach - start) / along;
    from = Math.max(from, Math.min(t0, t1));
    to = Math.min(to, Math.max(t0, t1));
  }
  return from < to ? [plus(a, d, from), plus(a, d, to)] : null;
}

/** A plane: what has dot(normal, p) > offset lies beyond it. */
export interface Plane {
  readonly normal: Point3;
  readonly offset: number;
}

/** The plane at `t` in [0, 1] through the box, along a direction. */
export function planeThrough(bounds: Bounds3, normal: Point3, t: number, flipped: boolean): Plane {
  const depths = cornersOf(bounds).map((p) => dot(normal, p));
  const [low, high] = [Math.min(...depths), Math.max(...depths)];
  // Slightly beyond the box at both ends, so that all of it is seen there, or none.
  const offset = low + (high - low) * (1.002 * t - 0.001);
  return flipped ? { normal: scaled(normal, -1), offset: -offset } : { normal, offset };
}

/** Two unit vectors that span a plane. */
export function frameOf(normal: Point3): readonly [Point3, Point3] {
  const least = normal.map(Math.abs).reduce((best, x, i, all) => (x < all[best]! ? i : best), 0);
  const axis = [0, 1, 2].map((k) => (k === least ? 1 : 0)) as unknown as Point3;
  const u = cross(normal, axis);
  const unit = scaled(u, 1 / Math.hypot(...u));
  return [unit, cross(normal, unit)];
}
