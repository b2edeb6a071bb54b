import createCircumball, { type CircumballModule, type FeatureSizesAnswer } from 'circumball';
import { beforeAll, describe, expect, it } from 'vitest';
import { complexToText } from '../../web/src/core/complex-json.ts';
import { unitSquare as square } from '../../web/src/numerics/meshes.ts';
import type { Complex2, Picture } from '../../web/src/shared/types.ts';
import { ballOf, FeatureStore } from '../../web/src/store/features.svelte.ts';

let core: CircumballModule;
beforeAll(async () => {
  core = await createCircumball();
});

/** A core that answers a moment later, as a worker does, and counts what it is asked. */
function slowCore() {
  const asked: number[] = [];
  const waiting: (() => void)[] = [];
  return {
    asked,
    release: async () => {
      for (const go of waiting.splice(0)) go();
      await new Promise((resolve) => setTimeout(resolve, 0));
    },
    featureSizes: async (text: string, points: Float64Array): Promise<FeatureSizesAnswer> => {
      asked.push(points.length / 2);
      await new Promise<void>((resolve) => waiting.push(resolve));
      return core.featureSizes(text, points);
    },
  };
}
const quickCore = () => ({
  featureSizes: async (text: string, points: Float64Array) => core.featureSizes(text, points),
});

const picture = {
  canvas: { clientWidth: 240, clientHeight: 120 },
  getView: () => ({ x: 0.5, y: 0.5, scale: 100 }),
  toWorld: (x: number, y: number) => [0.5 + (x - 120) / 100, 0.5 - (y - 60) / 100],
} as unknown as Picture;

describe('the ball at a point', () => {
  it('touches its two witnesses, which are disjoint', () => {
    const at = [0.3, 0.4] as const;
    const answer = core.featureSizes(complexToText(square), Float64Array.from(at));
    const ball = ballOf(square, at, answer);
    expect(ball.radius).toBeCloseTo(0.6, 12); // two opposite sides: below at 0.4, above at 0.6
    expect(ball.witnesses.map((w) => [w.kind, w.index])).toEqual([
      ['segment', 0],
      ['segment', 2],
    ]);
    const [, far] = ball.witnesses;
    expect(Math.hypot(far!.at[0] - at[0], far!.at[1] - at[1])).toBeCloseTo(ball.radius, 12);
    expect(far!.ends).toEqual([
      [1, 1],
      [0, 1],
    ]);
  });

  it('has no witnesses where no two features are disjoint', () => {
    const lone: Complex2 = { ...square, vertices: [[0, 0]], segments: [] };
    const answer = core.featureSizes(complexToText(lone), Float64Array.from([1, 1]));
    const ball = ballOf(lone, [1, 1], answer);
    expect(ball.radius).toBe(Number.POSITIVE_INFINITY);
    expect(ball.witnesses).toEqual([]);
  });

  it('follows the pointer, the newest place first, and stays where a point was picked', async () => {
    const slow = slowCore();
    const store = new FeatureStore(slow);
    store.setComplex(square);
    for (let i = 1; i <= 5; i++) store.hover([i / 10, 0.5]);
    expect(slow.asked).toHaveLength(1);
    await slow.release();
    await slow.release();
    expect(slow.asked).toHaveLength(2); // the first place and the last
    expect(store.ball?.center).toEqual([0.5, 0.5]);
    store.pin([0.2, 0.2]);
    await slow.release();
    store.hover([0.9, 0.9]);
    await slow.release();
    expect(store.ball?.center).toEqual([0.2, 0.2]);
    store.pin(null);
    expect(store.ball).toBeNull();
  });

  it('of a complex that was changed meanwhile is dropped', async () => {
    const slow = slowCore();
    const store = new FeatureStore(slow);
    store.setComplex(square);
    store.pin([0.2, 0.2]);
    store.setComplex({ ...square, segments: [] });
    await slow.release();
    expect(store.ball).toBeNull();
  });
});

describe('the field', () => {
  it('covers the view and beyond, and holds what the core says at each point', async () => {
    const store = new FeatureStore(quickCore());
    store.setComplex(square);
    store.watch(picture);
    await expect.poll(() => store.field?.step).toBe(0.06); // 6 pixels
    const { x, y, step, columns, rows, values } = store.field!;
    expect(x).toBeLessThan(-0.7);
    expect(y).toBeLessThan(-0.1);
    expect(x + step * (columns - 1)).toBeGreaterThan(1.7);
    expect(y + step * (rows - 1)).toBeGreaterThan(1.1);
    for (const i of [0, 17, columns * 3 + 2, columns * rows - 1]) {
      const at = [x + step * (i % columns), y + step * Math.floor(i / columns)];
      const { lfs } = core.featureSizes(complexToText(square), Float64Array.from(at));
      expect(values[i]).toBe(lfs[0]);
    }
    store.unwatch();
    expect(store.field).toBeNull();
  });

  it('lfs at the vertices is asked once', async () => {
    const slow = slowCore();
    const store = new FeatureStore(slow);
    store.setComplex(square);
    const done = store.measureVertices();
    await slow.release();
    await done;
    expect(Array.from(store.atVertices!)).toEqual([1, 1, 1, 1]);
    await store.measureVertices();
    expect(slow.asked).toEqual([4]);
  });

  it('says why there is none, where the core does', async () => {
    const store = new FeatureStore({
      featureSizes: async () => ({
        ok: false,
        error: 'no such complex',
        lfs: new Float64Array(0),
        mfs: new Float64Array(0),
        witnesses: new Uint32Array(0),
        at: new Float64Array(0),
      }),
    });
    store.setComplex(square);
    expect(await store.lfs([[0, 0]])).toBeNull();
    expect(store.error).toBe('no such complex');
  });
});
