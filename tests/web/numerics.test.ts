import createCircumball, { type CircumballModule } from 'circumball';
import { beforeAll, describe, expect, it } from 'vitest';
import { isOutline, scaledTo } from '../../web/src/numerics/functions.ts';
import { logRange, logTicks } from '../../web/src/numerics/log-plot.ts';
import { meshOf, stillMesh } from '../../web/src/numerics/meshes.ts';
import {
  errorsOf,
  observedOrder,
  ratesOf,
  type StudyPoint,
  slopeLine,
  studyCsv,
  studyPoint,
  studyValues,
} from '../../web/src/numerics/study.ts';
import { Coloring } from '../../web/src/picture/coloring.ts';
import { MeshModel } from '../../web/src/picture/mesh-model.ts';
import { boundsOf } from '../../web/src/picture/view.ts';
import { Label } from '../../web/src/shared/types.ts';
import { formatTick } from '../../web/src/words.ts';
import { lattice } from './picture-helpers.ts';

let core: CircumballModule;
beforeAll(async () => {
  core = await createCircumball();
});

const box = (minX: number, minY: number, maxX: number, maxY: number) => ({
  minX,
  minY,
  maxX,
  maxY,
});

describe('a function moved to another input', () => {
  const unit = box(0, 0, 1, 1);

  it('is what it was where the input is the same', () => {
    expect(scaledTo('sin(pi*x) + exp(y)', unit, unit)).toBe('sin(pi*x) + exp(y)');
  });

  it('takes only the names x and y, not letters of others', () => {
    expect(scaledTo('exp(x) + max(y, 0)', unit, box(3, -2, 5, -1))).toBe(
      'exp(((x - 3)/2)) + max(((y + 2)/2), 0)',
    );
  });

  it('has the same value at corresponding points, for every function of the core', () => {
    const to = box(-3, 7, 5, 11); // moved, 8 by 4
    for (const { expression, outline } of core.femFunctions()) {
      const from = boundsOf(outline)!;
      const moved = scaledTo(expression, from, to);
      const scale = 8 / Math.max(from.maxX - from.minX, from.maxY - from.minY);
      const there = (x: number, y: number) => [
        to.minX + scale * (x - from.minX),
        to.minY + scale * (y - from.minY),
      ];
      const corners = [0.2, 0.3, 0.8, 0.35, 0.4, 0.7];
      const [a, b, c, d, e, f] = corners as [number, number, number, number, number, number];
      const here = core.femTriangle(a, b, c, d, e, f, expression);
      const [p, q, r] = [there(a, b), there(c, d), there(e, f)];
      const far = core.femTriangle(p[0]!, p[1]!, q[0]!, q[1]!, r[0]!, r[1]!, moved);
      expect(far.interpolationError).toBe('');
      // The seminorm in H1 does not change when the plane is scaled evenly.
      expect(far.interpolation!.h1).toBeCloseTo(here.interpolation!.h1, 6);
    }
  });

  it('knows its own domain, from whichever corner it was drawn', () => {
    const outline = [
      [0, 0],
      [1, 0],
      [1, 1],
    ] as const;
    expect(isOutline(outline, [outline[2], outline[0], outline[1]])).toBe(true);
    expect(isOutline(outline, [[0, 0], outline[1]])).toBe(false);
  });
});

describe('a mesh between picture and core', () => {
  it('leaves out what lies outside, and names each cell by its triangle', () => {
    const state = lattice(4);
    state.cellLabel[0] = Label.outside;
    const { mesh, numbers } = meshOf(state);
    expect(numbers.length).toBe(31);
    expect(numbers[0]).toBe(1);
    const field = core.femInterpolate(mesh, 'x^2');
    expect(field.error).toBe('');
    expect(field.size.area).toBeCloseTo(1 - 1 / 32, 12);
    expect(field.cellH1.length).toBe(31);
  });

  it('of a family is drawn as it is: what the picture measures is what the core made', () => {
    const { mesh } = core.femFamily('large-angles', 4, 3);
    const state = stillMesh(mesh!);
    const { mesh: again } = meshOf(state);
    const before = core.femInterpolate(mesh!, 'sin(x)*y');
    const after = core.femInterpolate(again, 'sin(x)*y');
    expect(after.h1).toBe(before.h1);
    expect(state.liveCellCount).toBe(before.size.cells);
  });
});

describe('the color of an error', () => {
  it('follows its logarithm, and what was not measured is not counted', () => {
    const model = new MeshModel();
    model.sync(lattice(2));
    const coloring = new Coloring(model);
    coloring.setMode('error', false);
    expect(coloring.scale).toBeNull();
    coloring.values = Float64Array.of(1, 0.5, 0.25, 0.125, 1e-9);
    coloring.updateRange();
    const { min, max, logarithmic } = coloring.scale!;
    expect(logarithmic).toBe(true);
    expect(max).toBe(1);
    expect(min).toBe(2 ** -8); // errors far below the largest are all alike
    expect(coloring.value(1) - coloring.value(2)).toBe(1);
    expect(coloring.css(0)).toBe(coloring.scale!.at(1));
    expect(coloring.css(7)).toBe(coloring.scale!.at(0));
  });
});

const pointOf = (h: number, l2: number, h1: number): StudyPoint => ({
  value: h,
  h,
  maxCircumradius: h,
  minAngle: 45,
  maxAngle: 90,
  vertices: 9,
  cells: 8,
  unknowns: null,
  errors: { interpolation: { l2, h1 } },
});

describe('the order of a study', () => {
  it('is the exponent, whatever the factor', () => {
    const points = [1, 0.5, 0.25, 0.125].map((h) => pointOf(h, 7 * h * h, 3 * h));
    const of = (norm: 'h1' | 'l2') => errorsOf(points, 'interpolation', norm);
    expect(observedOrder(of('h1'))).toBeCloseTo(1, 12);
    expect(observedOrder(of('l2'))).toBeCloseTo(2, 12);
    expect(ratesOf(of('l2')).map((r) => r?.toFixed(9))).toEqual([
      undefined,
      ...Array(3).fill('2.000000000'),
    ]);
  });

  it('is read off the last three meshes', () => {
    const coarse: [number, number] = [1, 1e6];
    const fine = [0.5, 0.25, 0.125].map((h): [number, number] => [h, h]);
    expect(observedOrder([coarse, ...fine])).toBeCloseTo(1, 12);
  });

  it('is none for one mesh, for one h, and where the error is rounding', () => {
    expect(observedOrder([[1, 1]])).toBeNull();
    expect(
      observedOrder([
        [1, 1],
        [1, 2],
      ]),
    ).toBeNull();
    const points = [pointOf(1, 0, 1), pointOf(0.5, 0, 1e-15)];
    expect(errorsOf(points, 'interpolation', 'l2')).toEqual([]);
    expect(errorsOf(points, 'interpolation', 'h1').length).toBe(1);
    expect(errorsOf(points, 'averaged', 'h1')).toEqual([]);
  });

  it('is 1 in H1 and 2 in L2 for what the core measures on Figure 7.1(a)', () => {
    const points = studyValues(4, 4, 2).map((n) => {
      const { mesh } = core.femFamily('narrow', n, 8);
      const fields = {
        interpolation: core.femInterpolate(mesh!, 'sin(pi*x)*sin(pi*y)'),
        poisson: core.femPoisson(mesh!, 'sin(pi*x)*sin(pi*y)'),
      };
      return studyPoint(n, fields)!;
    });
    for (const method of ['interpolation', 'poisson'] as const) {
      expect(observedOrder(errorsOf(points, method, 'h1'))).toBeCloseTo(1, 1);
      expect(observedOrder(errorsOf(points, method, 'l2'))).toBeCloseTo(2, 1);
    }
    expect(points.at(-1)!.unknowns).toBe(31 * 255);
  });

  it('against the degeneration of Figure 7.1(b) is that of the circumradius', () => {
    const points = studyValues(8, 4, 2).map((k) => {
      const { mesh } = core.femFamily('large-angles', 4, k);
      return studyPoint(k, { interpolation: core.femInterpolate(mesh!, 'sin(pi*x)*sin(pi*y)') })!;
    });
    const growth = observedOrder(errorsOf(points, 'interpolation', 'h1', (p) => p.value))!;
    const ofR = observedOrder(points.map((p) => [p.value, p.maxCircumradius]))!;
    expect(growth).toBeCloseTo(ofR, 1);
    expect(growth).toBeGreaterThan(0.95);
  });

  it('is told of no point where a field could not be had', () => {
    const { mesh } = core.femFamily('narrow', 2, 1);
    const field = core.femInterpolate(mesh!, '1/x');
    expect(field.ok).toBe(false);
    expect(studyPoint(1, { interpolation: field })).toBeNull();
  });
});

describe('a study as comma-separated values', () => {
  it('has a name for every column, and every double in full', () => {
    const [names, row, end] = studyCsv([pointOf(1 / 3, 0.1, 0.2)], 'size').split('\r\n');
    expect(names!.split(',').length).toBe(row!.split(',').length);
    expect(names).toContain('interpolation_l2,interpolation_h1');
    expect(names).not.toContain('poisson');
    expect(Number(row!.split(',')[1])).toBe(1 / 3);
    expect(end).toBe('');
  });
});

describe('a plot by logarithms', () => {
  it('has as many ticks as there is room for, and at least one', () => {
    for (const [min, max] of [
      [0.9, 1.1],
      [0.03, 4],
      [1e-9, 1e3],
      [1e-300, 1e300],
    ] as const) {
      const ticks = logTicks(min, max, 7);
      expect(ticks.length).toBeGreaterThan(0);
      expect(ticks.length).toBeLessThanOrEqual(9);
      for (const t of ticks) expect(t >= min && t <= max).toBe(true);
    }
    expect(logTicks(0, 1, 7)).toEqual([]);
    expect(logTicks(0.03, 4, 7)).toEqual([0.05, 0.1, 0.2, 0.5, 1, 2]);
  });

  it('has a range around all positive numbers', () => {
    const [min, max] = logRange([null, 2, 0, Number.NaN, 8]);
    expect(min).toBeLessThan(2);
    expect(max).toBeGreaterThan(8);
    expect(logRange([])).toEqual([0.1, 1]);
  });

  it('draws a slope as a straight line', () => {
    const line = slopeLine([1, 16, 256], [16, 3], 0.5);
    expect(line).toEqual([0.75, 3, 12]);
  });

  it('writes ticks shortly', () => {
    expect([0.002, 50, 1e-4, 2e-5, 1e6].map(formatTick)).toEqual([
      '0.002',
      '50',
      '10⁻⁴',
      '2 · 10⁻⁵',
      '10⁶',
    ]);
  });
});
