/** What a color mode measures of each simplex, and over which range. */

import { colorAt, cssColor, isCategorical, parseColor, type Rgba } from '../picture/color';
import { circumball, dihedralAngles, distance3, shortestEdge, volume } from '../replay/geometry3';
import type { ColorMode, ColorScale, MeshState, Point3 } from '../shared/types';

/** Measures of one sort of simplices, kept by number: they do not change while it lives. */
class Measures {
  private values = new Float32Array(0);

  of(n: number, count: number, measure: () => number): number {
    if (n >= this.values.length) {
      const next = new Float32Array(Math.max(count, n + 1, 2 * this.values.length));
      next.fill(Number.NaN);
      next.set(this.values);
      this.values = next;
    }
    let value = this.values[n]!;
    if (Number.isNaN(value)) {
      value = measure();
      this.values[n] = value;
    }
    return value;
  }
}

/** Colors of tetrahedra, or, where none are shown, of the triangles of the faces. */
export class SpaceColoring {
  mode: ColorMode = 'plain';
  private dark = false;
  private range: readonly [number, number] = [0, 1];
  private classes = 1;
  private ofCells = true;
  private cells = new Measures();
  private facets = new Measures();
  private lastScale: { key: string; scale: ColorScale } | null = null;

  private get logarithmic(): boolean {
    return this.mode === 'volume' || this.mode === 'radius';
  }

  /** Null in plain mode; the same object as long as nothing of it changed. */
  get scale(): ColorScale | null {
    const { mode, dark, classes, logarithmic } = this;
    if (mode === 'plain') return null;
    const [min, max] = this.range;
    const key = `${mode} ${dark} ${classes} ${min} ${max} ${this.ofCells}`;
    if (this.lastScale?.key !== key) {
      const scale: ColorScale = {
        mode: this.ofCells ? mode : (facetModes[mode] ?? mode),
        min: logarithmic ? 2 ** min : min,
        max: logarithmic ? 2 ** max : max,
        logarithmic,
        unit: mode === 'dihedral' ? '°' : '',
        at: (t) => cssColor(colorAt(mode, dark, t, classes)),
      };
      this.lastScale = { key, scale };
    }
    return this.lastScale.scale;
  }

  forget(): void {
    this.cells = new Measures();
    this.facets = new Measures();
  }

  /** True if every color may have changed. */
  set(mode: ColorMode, dark: boolean, state: MeshState | null, ofCells: boolean): boolean {
    const before = [this.mode, this.dark, ...this.range, this.classes, this.ofCells].join();
    if (mode !== this.mode) this.forget();
    Object.assign(this, { mode, dark, ofCells });
    this.range = state ? this.findRange(state) : [0, 1];
    return before !== [mode, dark, ...this.range, this.classes, ofCells].join();
  }

  cellColor(state: MeshState, n: number): Rgba {
    return this.color(this.cell(state, n));
  }

  facetColor(state: MeshState, n: number): Rgba {
    return this.color(this.facet(state, n));
  }

  private color(value: number): Rgba {
    const [min, max] = this.range;
    const t = max > min ? (value - min) / (max - min) : 0;
    return colorAt(this.mode, this.dark, Math.min(Math.max(t, 0), 1), this.classes);
  }

  private cell(state: MeshState, n: number): number {
    return this.cells.of(n, state.cellCount, () =>
      measure(this.mode, state, state.cells, 4, n, state.cellBorn[n]!),
    );
  }

  private facet(state: MeshState, n: number): number {
    const { facets } = state;
    if (!facets) return 0;
    return this.facets.of(n, facets.count, () =>
      measure(this.mode, state, facets.triangles, 3, n, facets.born[n]!),
    );
  }

  private findRange(state: MeshState): readonly [number, number] {
    this.classes = 1;
    if (this.mode === 'plain') return [0, 1];
    if (this.mode === 'dihedral') return [0, this.ofCells ? 70 : 60];
    if (this.mode === 'radiusEdge') return [0.5, 4];
    if (this.mode === 'age') return [0, Math.max(state.position, 1)];
    let min = Number.POSITIVE_INFINITY;
    let max = Number.NEGATIVE_INFINITY;
    const look = (value: number) => {
      if (value < min) min = value;
      if (value > max) max = value;
    };
    const { facets } = state;
    if (this.ofCells)
      for (let i = 0; i < state.liveCellCount; i++) look(this.cell(state, state.liveCells[i]!));
    else if (facets)
      for (let i = 0; i < facets.liveCount; i++) look(this.facet(state, facets.live[i]!));
    if (isCategorical(this.mode)) {
      this.classes = min <= max ? Math.floor(max) + 1 : 1;
      return [0, this.classes];
    }
    if (!(min <= max)) return [0, 1];
    // Whole powers of two, so that colors stay as they are while a few simplices change.
    return [Math.floor(min), Math.max(Math.ceil(max), Math.floor(min) + 1)];
  }
}

/** The same of triangles has another name. */
const facetModes: Partial<Record<ColorMode, ColorMode>> = { dihedral: 'quality', volume: 'size' };

function measure(
  mode: ColorMode,
  state: MeshState,
  list: Uint32Array,
  corners: 3 | 4,
  n: number,
  born: number,
): number {
  const at = (k: number): Point3 => {
    const v = list[4 * n + k]!;
    const xyz = state.coordinates;
    return [xyz[3 * v]!, xyz[3 * v + 1]!, xyz[3 * v + 2]!];
  };
  const [a, b, c] = [at(0), at(1), at(2)];
  const all = corners === 4 ? [a, b, c, at(3)] : [a, b, c];
  switch (mode) {
    case 'age':
      return born;
    case 'step': {
      // A simplex is as old as its youngest vertex.
      let youngest = list[4 * n]!;
      for (let k = 1; k < corners; k++) {
        const v = list[4 * n + k]!;
        if (state.vertexBorn[v]! > state.vertexBorn[youngest]!) youngest = v;
      }
      return state.vertexStep[youngest]! + 0.5;
    }
    case 'dihedral': {
      const angles = corners === 4 ? dihedralAngles(a, b, c, at(3)) : anglesOf(a, b, c);
      const least = Math.min(...angles);
      return Number.isNaN(least) ? 0 : least;
    }
    case 'radiusEdge':
      return Math.min((circumball(all)?.radius ?? 1e9) / shortestEdge(all), 1e9);
    case 'radius':
      return bounded(Math.log2(circumball(all)?.radius ?? 1e300));
    case 'volume':
      return bounded(Math.log2(corners === 4 ? volume(a, b, c, at(3)) : areaOf(a, b, c)));
    default:
      return 0;
  }
}

function bounded(x: number): number {
  return Math.min(Math.max(x, -1000), 1000);
}

function anglesOf(a: Point3, b: Point3, c: Point3): number[] {
  const [x, y, z] = [distance3(b, c), distance3(c, a), distance3(a, b)];
  const angle = (opposite: number, p: number, q: number) =>
    (Math.acos(Math.min(1, Math.max(-1, (p * p + q * q - opposite * opposite) / (2 * p * q)))) *
      180) /
    Math.PI;
  return [angle(x, y, z), angle(y, z, x), angle(z, x, y)];
}

function areaOf(a: Point3, b: Point3, c: Point3): number {
  const [x, y, z] = [distance3(b, c), distance3(c, a), distance3(a, b)];
  const s = (x + y + z) / 2;
  return Math.sqrt(Math.max(s * (s - x) * (s - y) * (s - z), 0));
}

export function rgbaOf(css: string, alpha = 1): Rgba {
  const [r, g, b, a] = parseColor(css);
  return [r, g, b, a * alpha];
}
