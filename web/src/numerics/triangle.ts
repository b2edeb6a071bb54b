import type { FemTriangle } from 'circumball';
import type { Point } from '../shared/types.ts';

/** The triangle laboratory: triangles worth seeing, the flattening of one, and what is to be seen in it. */

export type Corners = readonly [Point, Point, Point];

export const defaultCorners: Corners = [
  [0, 0],
  [1, 0],
  [0.35, 0.6],
];

/** By the longest edge (0, 0) – (1, 0) and the apex: Figure 7.2. */
export const presets = {
  equilateral: [
    [0, 0],
    [1, 0],
    [0.5, 0.8660254037844386],
  ],
  needle: [
    [0, 0],
    [1, 0],
    [0, 0.05],
  ],
  flat: [
    [0, 0],
    [1, 0],
    [0.5, 0.05],
  ],
  skew: [
    [0, 0],
    [1, 0],
    [0.2, 0.05],
  ],
} as const satisfies Record<string, Corners>;
export type Preset = keyof typeof presets;

/** The apex may not come nearer to the longest edge than this part of its length: beyond, doubles say little. */
const FLATTEST = 1e-4;
const HIGHEST = 0.8;
export const SWEEP = 33;

/** Heights of the apex over the longest edge, by its length, from high to flat in even ratios. */
export function sweepHeights(count = SWEEP): number[] {
  const ratio = (FLATTEST / HIGHEST) ** (1 / (count - 1));
  return Array.from({ length: count }, (_, i) => HIGHEST * ratio ** i);
}

/** T_h(alpha, beta) of Figure 7.2 with h = 1, six coordinates. */
export function flattened(alpha: number, beta: number): number[] {
  return [0, 0, 1, 0, beta, alpha];
}

/** What a triangle is to linear interpolation. */
export type Shape = 'fat' | 'needle' | 'flat';

/** Beyond this angle the circumradius leaves the longest edge behind: R / h = 1 / (2 sin) > 0.57. */
const LARGE = 120;
/** Below this one a triangle is called narrow. */
const SMALL = 20;

export function shapeOf(t: Pick<FemTriangle, 'angles'>): Shape {
  if (Math.max(...t.angles) > LARGE) return 'flat';
  return Math.min(...t.angles) < SMALL ? 'needle' : 'fat';
}

/** "0.7*x^2 - 0.71*x*y + 0.004*y^2", as the core reads it. */
export function quadraticText([a = 0, b = 0, c = 0]: readonly number[]): string {
  const scale = Math.max(Math.abs(a), Math.abs(b), Math.abs(c)) || 1;
  const terms = [
    [a, 'x^2'],
    [b, 'x*y'],
    [c, 'y^2'],
  ] as const;
  let text = '';
  for (const [value, name] of terms) {
    const part = Number((value / scale).toPrecision(6));
    if (part === 0) continue;
    const sign = part < 0 ? (text ? ' - ' : '-') : text ? ' + ' : '';
    text += `${sign}${Math.abs(part)}*${name}`;
  }
  return text || '0';
}

/** A triangle as a link may carry it: three corners that are not in line. */
export function isCorners(x: unknown): x is Corners {
  if (!Array.isArray(x) || x.length !== 3) return false;
  return x.every((p) => Array.isArray(p) && p.length === 2 && p.every((c) => Number.isFinite(c)));
}
