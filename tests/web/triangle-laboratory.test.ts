import createCircumball, { type CircumballModule, type FemTriangle } from 'circumball';
import { beforeAll, describe, expect, it } from 'vitest';
import { fromHash, type Shared, toHash } from '../../web/src/link/link.ts';
import {
  type Corners,
  flattened,
  isCorners,
  presets,
  quadraticText,
  shapeOf,
  sweepHeights,
} from '../../web/src/numerics/triangle.ts';
import { emptyComplex } from '../../web/src/shared/types.ts';

let core: CircumballModule;
beforeAll(async () => {
  core = await createCircumball();
});

type Six = [number, number, number, number, number, number];
const study = (corners: Corners, u = ''): FemTriangle =>
  core.femTriangle(...(corners.flat() as Six), u);

describe('the shapes', () => {
  it('are what they are called', () => {
    expect(shapeOf(study(presets.equilateral))).toBe('fat');
    expect(shapeOf(study(presets.needle))).toBe('needle');
    expect(shapeOf(study(presets.flat))).toBe('flat');
    expect(shapeOf(study(presets.skew))).toBe('flat');
  });
});

describe('while the apex comes down (Theorem 7.10)', () => {
  for (const beta of [0.5, 0.35, 0.1]) {
    it(`over the foot ${beta} the constant is lost against h, and not against R`, () => {
      const all = sweepHeights().map((alpha) =>
        core.femTriangle(...(flattened(alpha, beta) as Six), ''),
      );
      const perR = all.map((t) => t.h1Constant / t.circumradius);
      const perH = all.map((t) => t.h1Constant / t.h);
      for (const t of all) expect(t.ok).toBe(true);
      expect(Math.max(...perR)).toBeLessThan(1);
      expect(Math.min(...perR)).toBeGreaterThan(0.4);
      expect(perH.at(-1)! / perH[0]!).toBeGreaterThan(100);
    });
  }

  it('over the end of the edge nothing is lost: a needle without a large angle', () => {
    for (const alpha of sweepHeights()) {
      const t = core.femTriangle(0, 0, 1, 0, 0, alpha, '');
      expect(t.h1Constant / t.h).toBeLessThan(0.5);
    }
  });

  it('heights fall evenly by logarithms', () => {
    const heights = sweepHeights();
    const ratio = heights[1]! / heights[0]!;
    for (let i = 1; i < heights.length; i++)
      expect(heights[i]! / heights[i - 1]!).toBeCloseTo(ratio, 12);
  });
});

describe('the worst quadratic', () => {
  it('as text attains the constant, within the digits that it is written with', () => {
    for (const corners of Object.values(presets)) {
      const t = study(corners);
      const again = study(corners, quadraticText(t.worstQuadratic));
      expect(again.interpolationError).toBe('');
      const { h1, u } = again.interpolation!;
      expect(h1 / u.h2 / t.h1Constant).toBeCloseTo(1, 4);
    }
  });

  it('is written with signs that the core reads', () => {
    expect(quadraticText([1, -0.5, 0])).toBe('1*x^2 - 0.5*x*y');
    expect(quadraticText([-2, 0, 1])).toBe('-1*x^2 + 0.5*y^2');
    expect(quadraticText([0, 0, 0])).toBe('0');
  });
});

describe('a link', () => {
  const shared: Shared = {
    complex: emptyComplex,
    options: {},
    moment: null,
    view: null,
  };

  it('reopens the triangle and the function, bit for bit', () => {
    const triangle = {
      corners: [
        [0.1, 1 / 3],
        [1, 0],
        [-2, 5e-324],
      ] as Corners,
      expression: 'x*y',
    };
    expect(fromHash(toHash({ ...shared, triangle }))).toEqual({ ...shared, triangle });
  });

  it('carries function, method, norm and family', () => {
    const numerics = {
      function: '',
      expression: 'x^2 + y',
      method: 'poisson',
      norm: 'l2',
      family: { id: 'large-angles', columns: 8, degeneration: 16 },
    };
    expect(fromHash(toHash({ ...shared, numerics }))).toEqual({ ...shared, numerics });
  });

  it('with something else for corners is opened without them', () => {
    const triangle = { corners: [[0, 'x']] as never, expression: '' };
    expect(fromHash(toHash({ ...shared, triangle }))).toEqual(shared);
    expect(
      isCorners([
        [0, 0],
        [1, 0],
        [0, Number.NaN],
      ]),
    ).toBe(false);
  });
});
