import { describe, expect, it } from 'vitest';
import { clipPolygon, clipSegment } from '../../web/src/picture/clip';
import { formatLength, gridItems, gridStep } from '../../web/src/picture/layers/grid-layer';
import {
  clampScale,
  fitView,
  panBy,
  roundStep,
  toScreen,
  toWorld,
  visibleBounds,
  zoomAt,
} from '../../web/src/picture/view';
import { makeWindow, serves } from '../../web/src/picture/window';
import type { Point, View } from '../../web/src/shared/types';
import { random } from './editor-helpers';

const size = { width: 800, height: 600 };

describe('camera', () => {
  it('screen and world are inverse, and y points up', () => {
    const view: View = { x: 3, y: -2, scale: 40 };
    expect(toScreen(view, size, [3, -2])).toEqual([400, 300]);
    expect(toScreen(view, size, [3, -1])[1]).toBeLessThan(300);
    const [x, y] = toWorld(view, size, ...toScreen(view, size, [3.7, -1.2]));
    expect(x).toBeCloseTo(3.7, 12);
    expect(y).toBeCloseTo(-1.2, 12);
  });

  it('zooming keeps the place under the pointer', () => {
    let view: View = { x: 0.3, y: 0.7, scale: 500 };
    const at: Point = [713, 41];
    const world = toWorld(view, size, ...at);
    for (let i = 0; i < 60; ++i) view = zoomAt(view, size, 1.3, at, 1);
    const [x, y] = toScreen(view, size, world);
    expect(Math.hypot(x - at[0], y - at[1])).toBeLessThan(2);
    expect(view.scale).toBeGreaterThan(1e9);
  });

  it('the deepest zoom still tells pixels apart', () => {
    const scale = clampScale(1e300, { x: 1, y: 0, scale: 1 }, 1);
    const pixel = 1 / scale;
    expect(1 + pixel).toBeGreaterThan(1);
  });

  it('fit shows everything with a margin, one point and nothing as well', () => {
    const view = fitView({ minX: -5, minY: 2, maxX: 15, maxY: 4 }, size);
    const seen = visibleBounds(view, size);
    expect(seen.minX).toBeLessThan(-5);
    expect(seen.maxX).toBeGreaterThan(15);
    expect(view.x).toBe(5);
    expect(fitView({ minX: 1, minY: 1, maxX: 1, maxY: 1 }, size)).toEqual({
      x: 1,
      y: 1,
      scale: 100,
    });
  });

  it('panning moves the picture with the hand', () => {
    const view: View = { x: 0, y: 0, scale: 10 };
    const moved = panBy(view, 50, 20);
    const [x, y] = toScreen(moved, size, toWorld(view, size, 100, 100));
    expect([x, y]).toEqual([150, 120]);
  });
});

describe('grid and scale bar', () => {
  it('steps are 1, 2 or 5 times a power of ten', () => {
    expect([0.011, 0.02, 3, 5, 7, 1].map(roundStep)).toEqual([0.02, 0.02, 5, 5, 10, 1]);
  });

  it('lines are never closer than the eye can use, at any zoom', () => {
    for (let e = -12; e <= 12; ++e) {
      const view: View = { x: 0.2, y: 0.3, scale: 3.7 * 10 ** e };
      expect(gridStep(view.scale) * view.scale).toBeGreaterThanOrEqual(17.99);
      expect(gridItems(view, size, {} as never).lines.length).toBeLessThan(90);
    }
  });

  it('lengths are written short', () => {
    expect([0.2, 1000, 5e-9, 2e7].map(formatLength)).toEqual(['0.2', '1000', '5e-9', '2e7']);
  });
});

describe('clipping', () => {
  const box = { minX: 0, minY: 0, maxX: 10, maxY: 10 };

  it('leaves what is inside alone, bit for bit', () => {
    const a: Point = [1.1, 2.2];
    const b: Point = [3.3, 4.4];
    const clipped = clipSegment(a, b, box)!;
    expect(clipped[0]).toBe(a);
    expect(clipped[1]).toBe(b);
    expect(clipSegment([-1, -1], [-2, 20], box)).toBeNull();
  });

  it('a line whose far end is a billion boxes away still passes where it should', () => {
    const [, far] = clipSegment([5, 5], [5e9, 1e9 + 4], box)!;
    expect(far[0]).toBe(10);
    expect(far[1]).toBeCloseTo(5 + 5 * ((1e9 - 1) / (5e9 - 5)), 12);
  });

  it('a clipped triangle covers exactly the places of the triangle in the box', () => {
    const next = random(21);
    for (let round = 0; round < 50; ++round) {
      const corner = (): Point => [next() * 30 - 10, next() * 30 - 10];
      const triangle = [corner(), corner(), corner()];
      const clipped = clipPolygon(triangle, box);
      const inside = (polygon: readonly Point[], p: Point) => {
        const sides = polygon.map((a, i) => {
          const b = polygon[(i + 1) % polygon.length]!;
          return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
        });
        if (sides.some((s) => Math.abs(s) < 1e-6)) return null; // too near to say
        return polygon.length > 2 && (sides.every((s) => s > 0) || sides.every((s) => s < 0));
      };
      for (let i = 0; i < 40; ++i) {
        const p: Point = [next() * 10, next() * 10];
        const [before, after] = [inside(triangle, p), inside(clipped, p)];
        if (before !== null && after !== null) expect(after).toBe(before);
      }
    }
  });
});

describe('windows', () => {
  const contents = { minX: 0, minY: 0, maxX: 1, maxY: 1 };

  /** Pixels by which a place is off after it went through single precision as on the GPU. */
  function error(p: Point, view: View): number {
    const window = makeWindow(view, size, contents);
    const f = Math.fround;
    const at = (v: number, origin: number) => f((v - origin) * window.unit);
    const ratio = f(view.scale / window.unit);
    const x = f(f(at(p[0], window.originX) * ratio) - f((view.x - window.originX) * view.scale));
    const y = f(f(at(p[1], window.originY) * ratio) - f((view.y - window.originY) * view.scale));
    const [sx, sy] = toScreen(view, size, p);
    return Math.hypot(x - (sx - 400), y - (300 - sy));
  }

  it('what is seen is off by less than a tenth of a pixel at every zoom', () => {
    const next = random(2);
    for (let e = 2; e <= 13; e += 0.25) {
      const view: View = { x: 1 / 3, y: 1 / 7, scale: 10 ** e };
      for (let i = 0; i < 20; ++i) {
        const p = toWorld(view, size, next() * 800, next() * 600);
        expect(error(p, view)).toBeLessThan(0.1);
      }
    }
  });

  it('a whole window serves while panning and zooming over the contents', () => {
    const view = fitView(contents, size);
    const window = makeWindow(view, size, contents);
    expect(window.box).toBeNull();
    expect(serves(window, { ...view, x: 2, scale: view.scale * 20 }, size, contents)).toBe(true);
    expect(serves(window, { ...view, scale: view.scale * 1e6 }, size, contents)).toBe(false);
  });

  it('a deep window serves small moves, and is renewed when the view leaves it', () => {
    const view: View = { x: 0.25, y: 0.25, scale: 1e10 };
    const window = makeWindow(view, size, contents);
    expect(window.box).not.toBeNull();
    expect(serves(window, panBy(view, 500, -300), size, contents)).toBe(true);
    expect(serves(window, { ...view, scale: view.scale * 8 }, size, contents)).toBe(true);
    expect(serves(window, panBy(view, 5000, 0), size, contents)).toBe(false);
    expect(serves(window, { ...view, scale: view.scale / 100 }, size, contents)).toBe(false);
  });
});
