/** The local feature size as a field: its range, its tint, and its contours. Pure functions of the lattice of values. */

import type { FeatureField } from '../shared/overlay-facts';
import type { Point } from '../shared/types';
import { parseColor } from './color';

export interface FieldRange {
  readonly min: number;
  readonly max: number;
}

/** Of the finite values; null if there are none. A field of one value has a range all the same. */
export function fieldRange(field: FeatureField): FieldRange | null {
  let min = Number.POSITIVE_INFINITY;
  let max = 0;
  for (const value of field.values) {
    if (!(value > 0) || !Number.isFinite(value)) continue;
    if (value < min) min = value;
    if (value > max) max = value;
  }
  if (max === 0) return null;
  return max > min ? { min, max } : { min: min / 2, max: max * 2 };
}

/** Opacity of the tint at t in [0, 1], from the smallest feature size in sight to the largest. */
export function fieldOpacity(t: number): number {
  return 0.04 + 0.6 * (1 - Math.min(Math.max(t, 0), 1)) ** 1.4;
}

/** Where a value lies in a range, by its logarithm. */
export function fieldPart(value: number, { min, max }: FieldRange): number {
  if (!(value > min)) return 0;
  return value < max ? Math.log(value / min) / Math.log(max / min) : 1;
}

/** One texel for each point of the lattice, rows upwards, straight alpha. */
export function fieldPixels(field: FeatureField, color: string): Uint8Array {
  const pixels = new Uint8Array(4 * field.columns * field.rows);
  const range = fieldRange(field);
  if (!range) return pixels;
  const [r, g, b] = parseColor(color);
  for (const [i, value] of field.values.entries()) {
    pixels.set([255 * r, 255 * g, 255 * b], 4 * i);
    const shown = Number.isNaN(value) ? 0 : fieldOpacity(fieldPart(value, range));
    pixels[4 * i + 3] = Math.round(255 * shown);
  }
  return pixels;
}

export interface Contour {
  readonly level: number;
  readonly segments: readonly (readonly [Point, Point])[];
}

/** 1, 2 and 5 times powers of ten in the range; fewer where there would be many. */
export function contourLevels({ min, max }: FieldRange, most = 14): number[] {
  const low = Math.floor(Math.log10(min));
  const high = Math.ceil(Math.log10(max));
  for (const factors of [[1, 2, 5], [1, 3], [1]]) {
    const levels: number[] = [];
    for (let e = low; e <= high; ++e) {
      for (const f of factors) {
        const level = Number(`${f}e${e}`);
        if (level > min && level < max) levels.push(level);
      }
    }
    if (levels.length <= most) return levels;
  }
  const step = Math.ceil((high - low) / most);
  const levels: number[] = [];
  for (let e = low + 1; e < high; e += step) levels.push(Number(`1e${e}`));
  return levels;
}

const cache = new WeakMap<FeatureField, readonly Contour[]>();

/** Contours through linear interpolation over the two triangles of each cell: no ambiguous case, no gap. */
export function contours(field: FeatureField): readonly Contour[] {
  let found = cache.get(field);
  if (!found) {
    const range = fieldRange(field);
    found = range
      ? contourLevels(range).map((level) => ({ level, segments: contour(field, level) }))
      : [];
    cache.set(field, found);
  }
  return found;
}

function contour(field: FeatureField, level: number): (readonly [Point, Point])[] {
  const { columns, rows, values, x, y, step } = field;
  const segments: (readonly [Point, Point])[] = [];
  const cross = (i: number, j: number): Point | null => {
    const u = values[i]!;
    const v = values[j]!;
    if (u < level === v < level) return null;
    const t = (level - u) / (v - u);
    const xi = i % columns;
    const yi = Math.floor(i / columns);
    const xj = j % columns;
    const yj = Math.floor(j / columns);
    return [x + step * (xi + t * (xj - xi)), y + step * (yi + t * (yj - yi))];
  };
  for (let row = 0; row + 1 < rows; ++row) {
    for (let column = 0; column + 1 < columns; ++column) {
      const a = row * columns + column;
      const b = a + 1;
      const d = a + columns;
      const c = d + 1;
      if (![a, b, c, d].every((i) => Number.isFinite(values[i]!))) continue;
      for (const [p, q, r] of [
        [a, b, c],
        [a, c, d],
      ] as const) {
        const ends = [cross(p, q), cross(q, r), cross(r, p)].filter((e) => e !== null);
        if (ends.length === 2) segments.push([ends[0]!, ends[1]!]);
      }
    }
  }
  return segments;
}
