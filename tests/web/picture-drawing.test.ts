import { describe, expect, it } from 'vitest';
import {
  categoryColor,
  colorAt,
  cssColor,
  parseColor,
  type Rgba,
} from '../../web/src/picture/color';
import { starShape } from '../../web/src/picture/layers/moment-layer';
import { makeMotion, motionItems } from '../../web/src/picture/layers/motion';
import { measureTriangle } from '../../web/src/picture/measures';
import { circumcenter, Scene } from '../../web/src/picture/scene';
import { sceneToSvg } from '../../web/src/picture/svg';
import { fitView } from '../../web/src/picture/view';
import type { Moment } from '../../web/src/shared/types';
import { lattice, theme } from './picture-helpers';

const size = { width: 400, height: 300 };
const view = fitView({ minX: 0, minY: 0, maxX: 1, maxY: 1 }, size);

const moment: Moment = {
  dimension: 2,
  kind: 'yielded',
  rule: 'action',
  simplex: [0, 1, 6],
  witness: 12,
  ball: { center: [0.2, 0.2], radius: 0.1 },
  ghost: [0.5, 0.1],
  yieldTo: [0, 4],
  vertex: null,
  change: null,
  sentence: '',
};

describe('colors', () => {
  /** Relative luminance (WCAG 2.2). */
  function luminance([r, g, b]: Rgba): number {
    const linear = (v: number) => (v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4);
    return 0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b);
  }

  it('ramps run one way in lightness, so they read without color vision', () => {
    for (const mode of ['quality', 'size', 'radius', 'age'] as const) {
      for (const dark of [false, true]) {
        const steps = Array.from({ length: 33 }, (_, i) =>
          luminance(colorAt(mode, dark, i / 32, 1)),
        );
        const sign = Math.sign(steps[32]! - steps[0]!);
        for (let i = 1; i < steps.length; ++i) {
          expect(Math.sign(steps[i]! - steps[i - 1]!)).toBe(sign);
        }
      }
    }
  });

  it('a bad triangle stands out from the paper more than a good one', () => {
    const paper = (dark: boolean) => luminance(parseColor(dark ? '#14181d' : '#ffffff'));
    for (const dark of [false, true]) {
      const off = (t: number) => Math.abs(luminance(colorAt('quality', dark, t, 1)) - paper(dark));
      expect(off(0)).toBeGreaterThan(off(0.5));
      expect(off(0.5)).toBeGreaterThan(off(1));
    }
  });

  it('classes next to each other are told apart', () => {
    for (let i = 0; i < 8; ++i) {
      expect(cssColor(categoryColor(i, false))).not.toBe(cssColor(categoryColor(i + 1, false)));
    }
  });

  it('CSS colors are read', () => {
    expect(parseColor('#fff')).toEqual([1, 1, 1, 1]);
    expect(parseColor('rgb(255 0 0 / 50%)')).toEqual([1, 0, 0, 0.5]);
    expect(cssColor(parseColor('#1a2b3c'))).toBe('#1a2b3c');
  });
});

describe('measures', () => {
  it('of the right triangle with legs 3 and 4', () => {
    const m = { minAngle: 0, circumradius: 0, longest: 0, height: 0 };
    measureTriangle(0, 0, 4, 0, 0, 3, m);
    expect(m.circumradius).toBeCloseTo(2.5, 14);
    expect(m.minAngle).toBeCloseTo((Math.atan2(3, 4) * 180) / Math.PI, 12);
    expect(m.longest).toBe(5);
    expect(m.height).toBeCloseTo(2.4, 14);
    const center = circumcenter([1e6, 1e6], [1e6 + 4, 1e6], [1e6, 1e6 + 3]);
    expect(center).toEqual([1e6 + 2, 1e6 + 1.5]);
  });
});

describe('motion', () => {
  const state = lattice(4);
  const change = {
    died: Uint32Array.from([0, 1]),
    born: Uint32Array.from([2, 3]),
    vertex: 2,
    forward: true,
  };

  it('takes 150 to 250 ms, less where events come faster, and none where it would flicker', () => {
    for (const speed of [1, 2, 6]) {
      const { milliseconds } = makeMotion(state, change, speed)!;
      expect(milliseconds).toBeGreaterThanOrEqual(150);
      expect(milliseconds).toBeLessThanOrEqual(250);
    }
    expect(makeMotion(state, change, 10)!.milliseconds).toBeLessThan(100);
    expect(makeMotion(state, change, 20)).toBeNull();
    expect(makeMotion(state, change, Number.POSITIVE_INFINITY)).toBeNull();
  });

  it('covers the change wholly until its end, and then not at all', () => {
    const motion = makeMotion(state, change, 1)!;
    for (const t of [0, 0.3, 0.6]) {
      const { polygons } = motionItems(motion, t, theme);
      expect(polygons.map((p) => p.opacity)).toEqual([1, 1]);
    }
    const end = motionItems(motion, 1, theme);
    expect([...end.polygons, ...end.lines].every((item) => item.opacity === 0)).toBe(true);
  });

  it('new edges grow from the vertex to the rim', () => {
    const motion = makeMotion(state, change, 1)!;
    const length = (t: number) =>
      motionItems(motion, t, theme)
        .lines.filter((l) => l.color === theme.born)
        .reduce((sum, { a, b }) => sum + Math.hypot(b[0] - a[0], b[1] - a[1]), 0);
    expect(length(0.2)).toBe(0);
    expect(length(0.5)).toBeLessThan(length(0.7));
  });
});

describe('rim of a cavity', () => {
  it('is the edges of one triangle only', () => {
    const star = starShape(
      [
        [0, 1, 2],
        [0, 2, 3],
      ],
      (v) => [v, v * v],
    );
    expect(star.rim).toHaveLength(4);
  });
});

describe('SVG', () => {
  function scene(): Scene {
    const s = new Scene(theme);
    s.model.sync(lattice(4));
    s.meshed = true;
    return s;
  }

  it('is a pure function, of a size that is asked for', () => {
    const s = scene();
    const svg = sceneToSvg(s, view, size, 16);
    expect(sceneToSvg(s, view, size, 16)).toBe(svg);
    expect(svg).toContain('width="16cm" height="12cm" viewBox="0 0 400 300"');
  });

  it('has the background that is asked for', () => {
    const s = scene();
    const paper = (fill: string) => `<rect width="100%" height="100%" fill="${fill}"/>`;
    expect(sceneToSvg(s, view, size, 16)).toContain(paper(theme.background));
    expect(sceneToSvg(s, view, size, 16, 'white')).toContain(paper('#ffffff'));
    expect(sceneToSvg(s, view, size, 16, 'transparent')).not.toContain('width="100%"');
  });

  it('draws each edge of the mesh once, each triangle once, each vertex once', () => {
    const s = scene();
    s.overlays = { ...s.overlays, grid: false };
    const svg = sceneToSvg(s, view, size, 400);
    const edges = svg.match(/<path d="([^"]*)" fill="none" stroke="#777777"/)![1]!;
    expect(edges.match(/M/g)).toHaveLength(56); // 2 * 4 * 5 + 16
    expect(svg.match(/fill="#eeeeff"/g)).toHaveLength(32);
    expect(svg.match(/fill="#0072b2"/g)).toHaveLength(25);
  });

  it('shows the moment: simplex, ball, witness by a dotted line, ghost with a cross, arrow', () => {
    const s = scene();
    s.setMoment(moment);
    const svg = sceneToSvg(s, view, size, 400);
    expect(svg).toContain(`fill="${theme.acting}" fill-opacity="0.5"`);
    expect(svg).toMatch(new RegExp(`<circle[^>]*stroke="${theme.ball}"`));
    expect(svg).toMatch(new RegExp(`stroke="${theme.witness}"[^>]*stroke-dasharray`));
    expect(svg).toMatch(new RegExp(`<circle[^>]*stroke="${theme.ghost}"`));
    expect(svg).toMatch(new RegExp(`fill="${theme.yielding}"`));
  });

  it('has no coordinate far off the paper, at the deepest zoom', () => {
    const s = scene();
    s.setMoment(moment);
    const svg = sceneToSvg(s, { x: 0.5, y: 0.5, scale: 1e12 }, size, 400);
    const numbers = [...svg.matchAll(/[ML ](-?\d+(?:\.\d+)?)(?= -?\d)/g)].map((m) => Number(m[1]));
    expect(numbers.length).toBeGreaterThan(4);
    expect(numbers.every((n) => Math.abs(n) < 1000)).toBe(true);
    expect(svg).not.toMatch(/NaN|Infinity|undefined/);
  });

  it('colors by quality as the scale says', () => {
    const s = scene();
    s.coloring.setMode('quality', false);
    const svg = sceneToSvg(s, view, size, 400);
    expect(svg).toContain(`fill="${s.coloring.scale!.at(0.75)}"`); // 45 of 60 degrees
  });

  it('draws holes, regions, selection and defects of the input', () => {
    const s = new Scene(theme);
    s.complex = {
      vertices: [
        [0, 0],
        [1, 1],
      ],
      segments: [[0, 1]],
      holes: [[0.2, 0.7]],
      regions: [{ at: [0.7, 0.2], label: 42 }],
    };
    s.selection = {
      vertices: new Set([0]),
      segments: new Set(),
      holes: new Set(),
      regions: new Set(),
    };
    s.defects = [
      {
        name: 'x',
        message: '',
        warning: false,
        at: [[0.5, 0.5]],
        features: [{ kind: 'segment', index: 0 }],
      },
    ];
    const svg = sceneToSvg(s, view, size, 400);
    for (const color of [theme.hole, theme.selection, theme.defect]) expect(svg).toContain(color);
    expect(svg).toContain('>42</text>');
  });
});
