import type { FemField, FemPoisson } from 'circumball';

/** A study: the error of a method on one mesh after another, and the order at which it falls. */

/** How a function becomes a continuous, piecewise linear one. */
export const methods = ['interpolation', 'poisson', 'averaged'] as const;
export type Method = (typeof methods)[number];
export const norms = ['h1', 'l2'] as const;
export type Norm = (typeof norms)[number];

/** What the meshes of a study differ in. */
export type Varied = 'size' | 'columns' | 'degeneration';

export interface Errors {
  readonly l2: number;
  readonly h1: number;
}

export interface StudyPoint {
  readonly value: number; // of what is varied
  readonly h: number;
  readonly maxCircumradius: number;
  readonly minAngle: number; // degrees
  readonly maxAngle: number;
  readonly vertices: number;
  readonly cells: number;
  readonly unknowns: number | null; // null: Poisson's equation was not solved
  readonly errors: Partial<Record<Method, Errors>>;
}

export function studyPoint(
  value: number,
  fields: Partial<Record<Method, FemField>>,
): StudyPoint | null {
  const entries = (Object.entries(fields) as [Method, FemField][]).filter(([, f]) => f.ok);
  const size = entries[0]?.[1].size;
  if (!size) return null;
  const poisson = fields.poisson as FemPoisson | undefined;
  return {
    value,
    h: size.h,
    maxCircumradius: size.maxCircumradius,
    minAngle: size.minAngle,
    maxAngle: size.maxAngle,
    vertices: size.vertices,
    cells: size.cells,
    unknowns: poisson?.ok ? poisson.unknowns : null,
    errors: Object.fromEntries(entries.map(([m, { l2, h1 }]) => [m, { l2, h1 }])),
  };
}

/** Errors below this part of the largest one are rounding: no order is read off them. */
const ROUNDING = 1e-12;

/** The points (x, error) of a method that logarithms can be taken of. */
export function errorsOf(
  points: readonly StudyPoint[],
  method: Method,
  norm: Norm,
  x: (p: StudyPoint) => number = (p) => p.h,
): [number, number][] {
  const all = points.flatMap((p): [number, number][] => {
    const error = p.errors[method]?.[norm];
    return error !== undefined && Number.isFinite(error) ? [[x(p), error]] : [];
  });
  const most = Math.max(0, ...all.map(([, e]) => e));
  return all.filter(([at, e]) => at > 0 && e > most * ROUNDING);
}

/** How many of the last points the order is read off: the first meshes are too coarse for it. */
const FITTED = 3;

/** Slope of the line through the logarithms of the last points, by least squares; null for fewer than two. */
export function observedOrder(points: readonly (readonly [number, number])[]): number | null {
  const last = points.slice(-FITTED).map(([x, e]) => [Math.log(x), Math.log(e)] as const);
  const n = last.length;
  if (n < 2) return null;
  const meanX = last.reduce((s, [x]) => s + x, 0) / n;
  const meanY = last.reduce((s, [, y]) => s + y, 0) / n;
  const above = last.reduce((s, [x, y]) => s + (x - meanX) * (y - meanY), 0);
  const below = last.reduce((s, [x]) => s + (x - meanX) ** 2, 0);
  return below > 0 ? above / below : null;
}

/** Between each point and the one before; null for the first, and where h did not change. */
export function ratesOf(points: readonly (readonly [number, number])[]): (number | null)[] {
  return points.map(([x, e], i) => {
    const before = points[i - 1];
    if (!before || before[0] === x) return null;
    return Math.log(e / before[1]) / Math.log(x / before[0]);
  });
}

/** A line of a slope in the log-log plot through (x, y), at the given places. */
export function slopeLine(
  xs: readonly number[],
  [x, y]: readonly [number, number],
  slope: number,
): number[] {
  return xs.map((at) => y * (at / x) ** slope);
}

/** The values that a study goes through: `first`, and doubled or halved. */
export function studyValues(first: number, count: number, factor: 2 | 0.5): number[] {
  return Array.from({ length: count }, (_, i) => first * factor ** i);
}

/** Comma-separated values with a line of names: what spreadsheets and Python read. */
export function studyCsv(points: readonly StudyPoint[], varied: Varied): string {
  const used = methods.filter((m) => points.some((p) => p.errors[m]));
  const names = [
    varied,
    'h',
    'max_circumradius',
    'min_angle',
    'max_angle',
    'vertices',
    'triangles',
    'unknowns',
    ...used.flatMap((m) => [`${m}_l2`, `${m}_h1`]),
  ];
  const rows = points.map((p) => [
    p.value,
    p.h,
    p.maxCircumradius,
    p.minAngle,
    p.maxAngle,
    p.vertices,
    p.cells,
    p.unknowns ?? '',
    ...used.flatMap((m) => [p.errors[m]?.l2 ?? '', p.errors[m]?.h1 ?? '']),
  ]);
  return [names, ...rows].map((row) => `${row.join()}\r\n`).join('');
}
