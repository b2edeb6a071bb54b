/** What a color mode measures of each triangle, and over which range. */

import { type ColorMode, type ColorScale, Label } from '../shared/types';
import { colorAt, cssColor, isCategorical, type Rgba } from './color';
import { measureTriangle, type TriangleMeasures } from './measures';
import type { MeshModel } from './mesh-model';
import { regionsOf } from './regions';

/** Errors smaller than the largest by more than this power of two are all alike: what matters is where the large ones are. */
const ERROR_OCTAVES = 8;

/** Below every logarithm of a double, and finite on the GPU. */
const UNMEASURED = -1e4;

const scratch: TriangleMeasures = { minAngle: 0, circumradius: 0, longest: 0, height: 0 };

export class Coloring {
  mode: ColorMode = 'plain';
  range: readonly [number, number] = [0, 1]; // of the values; base-2 logarithms where the scale is logarithmic
  /** Measured elsewhere, by number of the triangle; what the mode 'error' shows. */
  values: Float64Array | null = null;
  private dark = false;
  private classes = 1;
  private measured = true; // some triangle has a value
  private regions: Int32Array | null = null;
  private lastScale: { key: string; scale: ColorScale } | null = null;
  private readonly model: MeshModel;

  constructor(model: MeshModel) {
    this.model = model;
  }

  get categorical(): boolean {
    return isCategorical(this.mode);
  }

  get logarithmic(): boolean {
    return this.mode === 'size' || this.mode === 'radius' || this.mode === 'error';
  }

  /** Null in plain mode, or if nothing was measured; the same object as long as nothing of it changed. */
  get scale(): ColorScale | null {
    if (this.mode === 'plain' || (this.mode === 'error' && !(this.values && this.measured)))
      return null;
    const { mode, dark, classes, logarithmic } = this;
    const [min, max] = this.range;
    const key = `${mode} ${dark} ${classes} ${min} ${max}`;
    if (this.lastScale?.key !== key) {
      const scale: ColorScale = {
        mode,
        min: logarithmic ? 2 ** min : min,
        max: logarithmic ? 2 ** max : max,
        logarithmic,
        unit: mode === 'quality' ? '°' : '',
        at: (t) => cssColor(colorAt(mode, dark, t, classes)),
      };
      this.lastScale = { key, scale };
    }
    return this.lastScale.scale;
  }

  rgba(t: number): Rgba {
    return colorAt(this.mode, this.dark, t, this.classes);
  }

  /** Color of a slot, for vectors. */
  css(slot: number): string {
    const [min, max] = this.range;
    return cssColor(this.rgba(max > min ? (this.value(slot) - min) / (max - min) : 0));
  }

  setMode(mode: ColorMode, dark: boolean): void {
    this.mode = mode;
    this.dark = dark;
    this.updateRange();
  }

  /** Measures again after the mesh changed; true if the range did, and `all` if every value may have. */
  updateRange(): { range: boolean; all: boolean } {
    const before = this.range;
    const classesBefore = this.classes;
    this.regions = null;
    if (this.mode === 'region') this.regions = regionsOf(this.model);
    this.range = this.findRange();
    const range =
      before[0] !== this.range[0] || before[1] !== this.range[1] || classesBefore !== this.classes;
    return { range, all: this.mode === 'region' };
  }

  value(slot: number): number {
    const { triangles, coordinates: xy, born, vertexStep, vertexBorn } = this.model;
    const a = triangles[3 * slot]!;
    const b = triangles[3 * slot + 1]!;
    const c = triangles[3 * slot + 2]!;
    switch (this.mode) {
      case 'plain':
        return 0;
      case 'age':
        return born[slot]!;
      case 'error': {
        // What was not measured yet is drawn like what has no error, and is not counted.
        const error = this.values?.[this.model.triangleSlots.numbers[slot]!] ?? 0;
        return error > 0 ? Math.log2(error) : UNMEASURED;
      }
      case 'region':
        return (this.regions?.[slot] ?? 0) + 0.5;
      case 'step': {
        // A triangle is as old as its youngest vertex.
        let youngest = a;
        if (vertexBorn[b]! > vertexBorn[youngest]!) youngest = b;
        if (vertexBorn[c]! > vertexBorn[youngest]!) youngest = c;
        return vertexStep[youngest]! + 0.5;
      }
    }
    measureTriangle(
      xy[2 * a]!,
      xy[2 * a + 1]!,
      xy[2 * b]!,
      xy[2 * b + 1]!,
      xy[2 * c]!,
      xy[2 * c + 1]!,
      scratch,
    );
    if (this.mode === 'quality') return scratch.minAngle;
    const size =
      this.mode === 'size' ? (scratch.longest / 2) * scratch.height : scratch.circumradius; // area
    return Math.log2(Math.min(Math.max(size, 1e-300), 1e300));
  }

  private findRange(): readonly [number, number] {
    const model = this.model;
    this.classes = 1;
    this.measured = true;
    switch (this.mode) {
      case 'plain':
        return [0, 1];
      case 'quality':
        return [0, 60];
      case 'age':
        return [0, Math.max(model.position, 1)];
      case 'step':
      case 'region': {
        let last = 0;
        for (let slot = 0; slot < model.triangleCount; ++slot) {
          last = Math.max(last, Math.floor(this.value(slot)));
        }
        this.classes = last + 1;
        return [0, this.classes];
      }
    }
    let min = Number.POSITIVE_INFINITY;
    let max = Number.NEGATIVE_INFINITY;
    for (let slot = 0; slot < model.triangleCount; ++slot) {
      if (model.labels[slot] === Label.outside) continue;
      const v = this.value(slot);
      if (v === UNMEASURED) continue;
      if (v < min) min = v;
      if (v > max) max = v;
    }
    this.measured = min <= max;
    if (!this.measured) return [0, 1];
    if (this.mode === 'error') min = Math.max(min, max - ERROR_OCTAVES);
    // Whole powers of two, so that colors stay as they are while a few triangles change.
    return [Math.floor(min), Math.max(Math.ceil(max), Math.floor(min) + 1)];
  }
}
