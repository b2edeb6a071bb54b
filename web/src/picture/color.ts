/** Colors: parsing CSS, and ramps that are even in OKLab. */

import type { ColorMode } from '../shared/types';

export type Rgba = readonly [number, number, number, number]; // sRGB, 0 to 1, not premultiplied

const cache = new Map<string, Rgba>();

/** A CSS color: #rgb, #rrggbb, #rrggbbaa, rgb() and rgba(); in a browser any other as well. */
export function parseColor(css: string): Rgba {
  let color = cache.get(css);
  if (!color) {
    color = parseHex(css) ?? parseRgb(css) ?? parseByCanvas(css) ?? [0.5, 0.5, 0.5, 1];
    cache.set(css, color);
  }
  return color;
}

function parseHex(css: string): Rgba | null {
  const match = /^#([0-9a-f]{3,8})$/i.exec(css.trim());
  if (!match) return null;
  let hex = match[1]!;
  if (hex.length <= 4) hex = [...hex].map((c) => c + c).join('');
  if (hex.length !== 6 && hex.length !== 8) return null;
  const at = (i: number) => Number.parseInt(hex.slice(2 * i, 2 * i + 2), 16) / 255;
  return [at(0), at(1), at(2), hex.length === 8 ? at(3) : 1];
}

function parseRgb(css: string): Rgba | null {
  const match = /^rgba?\(([^)]+)\)$/i.exec(css.trim());
  if (!match) return null;
  const parts = match[1]!.split(/[\s,/]+/).filter(Boolean);
  const value = (s: string, full: number) =>
    s.endsWith('%') ? Number.parseFloat(s) / 100 : Number.parseFloat(s) / full;
  const [r, g, b, a] = parts;
  if (r === undefined || g === undefined || b === undefined) return null;
  return [value(r, 255), value(g, 255), value(b, 255), a === undefined ? 1 : value(a, 1)];
}

function parseByCanvas(css: string): Rgba | null {
  if (typeof document === 'undefined') return null;
  const context = document.createElement('canvas').getContext('2d', { willReadFrequently: true });
  if (!context) return null;
  context.fillStyle = css;
  context.fillRect(0, 0, 1, 1);
  const [r, g, b, a] = context.getImageData(0, 0, 1, 1).data;
  return [r! / 255, g! / 255, b! / 255, a! / 255];
}

export function cssColor(c: Rgba): string {
  const hex = (v: number) =>
    Math.round(Math.min(Math.max(v, 0), 1) * 255)
      .toString(16)
      .padStart(2, '0');
  return `#${hex(c[0])}${hex(c[1])}${hex(c[2])}`;
}

/** `t` of b over a, straight in sRGB as the GPU blends. */
export function mix(a: string, b: string, t: number): string {
  const p = parseColor(a);
  const q = parseColor(b);
  return cssColor([
    p[0] + (q[0] - p[0]) * t,
    p[1] + (q[1] - p[1]) * t,
    p[2] + (q[2] - p[2]) * t,
    1,
  ]);
}

/** OKLCH to sRGB (B. Ottosson, "A perceptual color space for image processing", 2020), clipped to the gamut. */
function oklch(l: number, c: number, hue: number): Rgba {
  const a = c * Math.cos((hue * Math.PI) / 180);
  const b = c * Math.sin((hue * Math.PI) / 180);
  return oklab(l, a, b);
}

function oklab(l: number, a: number, b: number): Rgba {
  const l3 = (l + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m3 = (l - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s3 = (l - 0.0894841775 * a - 1.291485548 * b) ** 3;
  const gamma = (v: number) => {
    const u = Math.min(Math.max(v, 0), 1);
    return u <= 0.0031308 ? 12.92 * u : 1.055 * u ** (1 / 2.4) - 0.055;
  };
  return [
    gamma(4.0767416621 * l3 - 3.3077115913 * m3 + 0.2309699292 * s3),
    gamma(-1.2684380046 * l3 + 2.6097574011 * m3 - 0.3413193965 * s3),
    gamma(-0.0041960863 * l3 - 0.7034186147 * m3 + 1.707614701 * s3),
    1,
  ];
}

type Stop = readonly [number, number, number]; // lightness, chroma, hue in degrees

/**
 * Stops of the ramps. Lightness is monotone along each, so that they read without color vision and in print. Quality
 * runs from a strong color (bad: it should stand out) to one near the paper.
 */
const stops: Record<'quality' | 'size' | 'age', { light: readonly Stop[]; dark: readonly Stop[] }> =
  {
    quality: {
      light: [
        [0.54, 0.145, 30],
        [0.68, 0.13, 50],
        [0.81, 0.1, 78],
        [0.905, 0.045, 150],
        [0.955, 0.022, 225],
      ],
      dark: [
        [0.83, 0.125, 82],
        [0.69, 0.135, 56],
        [0.53, 0.105, 35],
        [0.385, 0.045, 310],
        [0.295, 0.032, 250],
      ],
    },
    size: {
      light: [
        [0.38, 0.11, 265],
        [0.53, 0.11, 235],
        [0.69, 0.1, 195],
        [0.83, 0.1, 145],
        [0.95, 0.1, 105],
      ],
      dark: [
        [0.92, 0.12, 105],
        [0.78, 0.11, 145],
        [0.63, 0.1, 195],
        [0.48, 0.1, 240],
        [0.33, 0.09, 270],
      ],
    },
    age: {
      light: [
        [0.95, 0.03, 250],
        [0.81, 0.08, 255],
        [0.67, 0.13, 285],
        [0.53, 0.17, 320],
        [0.4, 0.15, 350],
      ],
      dark: [
        [0.3, 0.04, 260],
        [0.42, 0.1, 275],
        [0.55, 0.15, 310],
        [0.69, 0.16, 350],
        [0.84, 0.11, 50],
      ],
    },
  };

function rampAt(list: readonly Stop[], t: number): Rgba {
  const x = Math.min(Math.max(t, 0), 1) * (list.length - 1);
  const i = Math.min(Math.floor(x), list.length - 2);
  const f = x - i;
  const lab = ([l, c, h]: Stop) =>
    [l, c * Math.cos((h * Math.PI) / 180), c * Math.sin((h * Math.PI) / 180)] as const;
  const p = lab(list[i]!);
  const q = lab(list[i + 1]!);
  return oklab(p[0] + (q[0] - p[0]) * f, p[1] + (q[1] - p[1]) * f, p[2] + (q[2] - p[2]) * f);
}

/** Distinct fills of regions and steps: hues of Okabe and Ito's palette, made quiet enough to carry lines. */
const categoryHues: readonly number[] = [245, 65, 165, 350, 105, 215, 35, 300];

export function categoryColor(index: number, dark: boolean): Rgba {
  const n = categoryHues.length;
  const hue = categoryHues[((index % n) + n) % n]!;
  const odd = index % 2 === 1 ? 0.05 : 0;
  return dark ? oklch(0.42 + odd, 0.075, hue) : oklch(0.88 - odd, 0.075, hue);
}

/** Is the mode a list of classes rather than a scale? */
export function isCategorical(mode: ColorMode): boolean {
  return mode === 'step' || mode === 'region';
}

/** Color of a mode at t in [0, 1]; `classes` is the number of classes of a categorical mode. */
export function colorAt(mode: ColorMode, dark: boolean, t: number, classes: number): Rgba {
  if (isCategorical(mode)) {
    return categoryColor(Math.min(Math.floor(t * classes), classes - 1), dark);
  }
  const isQuality =
    mode === 'quality' || mode === 'error' || mode === 'dihedral' || mode === 'radiusEdge';
  const name = isQuality ? 'quality' : mode === 'age' ? 'age' : 'size';
  // Large errors and ratios stand out as small angles do.
  const isWorstLast = mode === 'error' || mode === 'radiusEdge';
  return rampAt(dark ? stops[name].dark : stops[name].light, isWorstLast ? 1 - t : t);
}
