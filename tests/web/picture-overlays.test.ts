import { inflateSync } from 'node:zlib';
import { describe, expect, it } from 'vitest';
import {
  contourLevels,
  contours,
  fieldOpacity,
  fieldPart,
  fieldPixels,
  fieldRange,
} from '../../web/src/picture/field';
import { arcPoints, neighborInBounds } from '../../web/src/picture/layers/overlay-layer';
import { pickMesh } from '../../web/src/picture/pick';
import { pngBytes } from '../../web/src/picture/png-bytes';
import { Scene } from '../../web/src/picture/scene';
import { SlotGrid } from '../../web/src/picture/slot-grid';
import { sceneToSvg } from '../../web/src/picture/svg';
import { fitView } from '../../web/src/picture/view';
import { type FeatureField, noFacts, type OverlayFacts } from '../../web/src/shared/overlay-facts';
import { type MeshState, NEVER, type Overlays, type Point } from '../../web/src/shared/types';
import { lattice, theme } from './picture-helpers';
import { random } from './small-trace';

const size = { width: 400, height: 300 };
const view = fitView({ minX: 0, minY: 0, maxX: 1, maxY: 1 }, size);

describe('a grid of boxes', () => {
  /** Boxes graded over twelve orders of magnitude about a few places. */
  function boxes(count: number, seed: number): number[][] {
    const next = random(seed);
    return Array.from({ length: count }, () => {
      const extent = 10 ** (-12 * next());
      const x = 1e3 * Math.round(next() * 3) + (next() - 0.5) * extent * 8;
      const y = (next() - 0.5) * extent * 8;
      return [x, y, x + extent * next(), y + extent * next()];
    });
  }

  it('finds every box that meets a box, however graded they are, while boxes come and go', () => {
    const all = boxes(400, 3);
    const grid = new SlotGrid();
    const live = new Map<number, number[]>();
    const next = random(5);
    for (let round = 0; round < 1200; round++) {
      const slot = Math.floor(next() * 300);
      if (next() < 0.35) {
        grid.remove(slot);
        live.delete(slot);
      } else {
        const box = all[Math.floor(next() * all.length)]!;
        grid.set(slot, box[0]!, box[1]!, box[2]!, box[3]!);
        live.set(slot, box);
      }
      if (round % 10 > 0) continue;
      const [a, b, c, d] = all[Math.floor(next() * all.length)]!;
      const found = new Set<number>();
      let visits = 0;
      grid.query(a!, b!, c!, d!, (s) => {
        found.add(s);
        visits++;
      });
      expect(visits).toBe(found.size);
      for (const [s, q] of live) {
        if (q[0]! <= c! && q[2]! >= a! && q[1]! <= d! && q[3]! >= b!) expect(found).toContain(s);
      }
      for (const s of found) expect(live.has(s)).toBe(true);
    }
  });

  it('looks at few boxes where there are many', () => {
    const grid = new SlotGrid();
    const n = 200;
    for (let i = 0; i < n; i++) {
      for (let j = 0; j < n; j++) grid.set(i * n + j, i / n, j / n, (i + 1) / n, (j + 1) / n);
    }
    let visits = 0;
    grid.query(0.5011, 0.3011, 0.5012, 0.3012, () => visits++);
    expect(visits).toBeGreaterThan(0);
    expect(visits).toBeLessThan(30);
  });

  it('takes any numbers', () => {
    const grid = new SlotGrid();
    grid.set(0, 1e300, 1e300, 1e300, 1e300);
    grid.set(1, 0, 0, 0, 0);
    grid.set(2, -1e-300, 0, 1e-300, 1);
    const found: number[] = [];
    grid.query(-1, -1, 1, 1, (s) => found.push(s));
    expect(found).toContain(1);
    expect(found).toContain(2);
    grid.query(-1e308, -1e308, 1e308, 1e308, () => {});
  });
});

describe('picking', () => {
  const reach = { vertex: 10, segment: 7 };

  it('meets what a scan over all of the mesh meets, while the mesh changes', () => {
    const n = 12;
    const whole = lattice(n);
    const s = new Scene(theme);
    const next = random(17);
    for (let round = 0; round < 30; round++) {
      // Some triangles are gone, in another order each time.
      const live = Array.from({ length: whole.cellCount }, (_, i) => i).filter(() => next() < 0.7);
      const state: MeshState = {
        ...whole,
        position: round + 1,
        liveCells: Uint32Array.from(live),
        liveCellCount: live.length,
      };
      s.model.sync(state);
      for (let k = 0; k < 20; k++) {
        const p: Point = [next(), next()];
        const hit = pickMesh(s.model, p, 200, reach, true);
        const i = Math.floor(p[0] * n);
        const j = Math.floor(p[1] * n);
        const upper = p[1] * n - j > p[0] * n - i;
        const t = 2 * (j * n + i) + (upper ? 1 : 0);
        expect(hit.triangle).toBe(live.includes(t) ? t : null);
        expect(hit.subsegment !== null).toBe(
          Math.min(p[0], p[1], 1 - p[0], 1 - p[1]) <= reach.segment / 200,
        );
      }
    }
  });

  it('prefers the nearest vertex', () => {
    const s = new Scene(theme);
    s.model.sync(lattice(4));
    expect(pickMesh(s.model, [0.26, 0.26], 100, reach, true).vertex).toBe(6);
    expect(pickMesh(s.model, [0.375, 0.375], 40, reach, true).vertex).not.toBeNull();
    expect(pickMesh(s.model, [0.375, 0.375], 1000, reach, true).vertex).toBeNull();
  });
});

/** A square with its bottom side as subsegment 0 and a vertex inside of that side's disk, or on its circle. */
function wedge(apex: Point): MeshState {
  const base = lattice(1);
  const coordinates = Float64Array.from([0, 0, 1, 0, apex[0], apex[1]]);
  return {
    ...base,
    vertexCount: 3,
    coordinates,
    vertexBorn: new Uint32Array(3),
    cellCount: 1,
    cells: Uint32Array.from([0, 1, 2]),
    cellBorn: new Uint32Array(1),
    cellDied: new Uint32Array(1).fill(NEVER),
    liveCells: Uint32Array.from([0]),
    liveCellCount: 1,
    subsegments: Uint32Array.from([0, 1, 0]),
    subsegmentBorn: new Uint32Array(1),
    liveSubsegments: Uint32Array.from([0]),
    liveSubsegmentCount: 1,
    facets: null,
  };
}

describe('encroachment', () => {
  it('is an apex inside of the disk; on the circle is not inside', () => {
    const found = (apex: Point) => {
      const s = new Scene(theme);
      s.model.sync(wedge(apex));
      return s.model.index.encroaching(0, 1);
    };
    expect(found([0.5, 0.49])).toBe(2);
    expect(found([0.5, 0.5])).toBe(-1);
    expect(found([0.2, 0.4])).toBe(-1);
    expect(found([0.2, 0.399])).toBe(2);
  });
});

const field: FeatureField = (() => {
  const columns = 41;
  const rows = 31;
  const step = 0.05;
  const values = Float64Array.from(
    { length: columns * rows },
    (_, i) => 0.01 + Math.hypot(step * (i % columns) - 1, step * Math.floor(i / columns) - 0.75),
  );
  return { x: 0, y: 0, step, columns, rows, values };
})();

describe('the field of lfs', () => {
  it('is tinted by its logarithm, strong where features are near', () => {
    const range = fieldRange(field)!;
    expect(range.min).toBeCloseTo(0.01, 12);
    expect(fieldPart(range.min, range)).toBe(0);
    expect(fieldPart(Math.sqrt(range.min * range.max), range)).toBeCloseTo(0.5, 12);
    expect(fieldPart(Number.POSITIVE_INFINITY, range)).toBe(1);
    expect(fieldOpacity(0)).toBeGreaterThan(fieldOpacity(0.5));
    expect(fieldOpacity(0.5)).toBeGreaterThan(fieldOpacity(1));
    expect(
      fieldRange({ ...field, values: new Float64Array(9).fill(Number.POSITIVE_INFINITY) }),
    ).toBe(null);
  });

  it('has contours where the value is the level, and all around', () => {
    for (const { level, segments } of contours(field)) {
      const ends = new Map<string, number>();
      for (const [a, b] of segments) {
        for (const p of [a, b]) {
          const value = 0.01 + Math.hypot(p[0] - 1, p[1] - 0.75);
          expect(Math.abs(value - level)).toBeLessThan(0.02);
          const key = p.map((x) => x.toFixed(9)).join();
          ends.set(key, (ends.get(key) ?? 0) + 1);
        }
      }
      // Closed where it does not leave the lattice: each end is met by another.
      if (level < 0.7) for (const count of ends.values()) expect(count % 2).toBe(0);
    }
    expect(contours(field).length).toBeGreaterThan(3);
  });

  it('has round levels, never too many', () => {
    expect(contourLevels({ min: 0.15, max: 3 })).toEqual([0.2, 0.5, 1, 2]);
    expect(contourLevels({ min: 1e-30, max: 1e30 }).length).toBeLessThanOrEqual(14);
  });

  it('has one texel for each point', () => {
    const pixels = fieldPixels(field, '#806000');
    expect(pixels).toHaveLength(4 * 41 * 31);
    const at = (column: number, row: number) => pixels[4 * (row * 41 + column) + 3]!;
    expect(at(20, 15)).toBeGreaterThan(at(0, 0));
  });
});

describe('a PNG', () => {
  it('is what the standard says: signature, chunks, rows from above', () => {
    const png = Buffer.from(pngBytes(Uint8Array.from([1, 2, 3, 4, 5, 6, 7, 8]), 1, 2));
    expect(png.subarray(0, 8).toString('latin1')).toBe('\x89PNG\r\n\x1a\n');
    expect(png.readUInt32BE(16)).toBe(1);
    expect(png.readUInt32BE(20)).toBe(2);
    const data = png.indexOf('IDAT');
    const raw = inflateSync(png.subarray(data + 4, data + 4 + png.readUInt32BE(data - 4)));
    expect([...raw]).toEqual([0, 5, 6, 7, 8, 0, 1, 2, 3, 4]);
    // The checksum of the empty last chunk is known.
    expect(png.subarray(-4).toString('hex')).toBe('ae426082');
  });
});

describe('overlays in an exported figure', () => {
  const facts: OverlayFacts = {
    field,
    ball: {
      center: [0.4, 0.6],
      radius: 0.21,
      witnesses: [
        { kind: 'vertex', index: 6, ends: [[0.25, 0.25]], at: [0.25, 0.25] },
        {
          kind: 'segment',
          index: 3,
          ends: [
            [0, 1],
            [0, 0],
          ],
          at: [0, 0.6],
        },
      ],
    },
    neighbors: [
      { vertex: 0, nearest: 0.2, lfs: 0.25, promised: true },
      { vertex: 4, nearest: 0.2, lfs: 0.5, promised: true },
    ],
    spindle: {
      subsegments: [
        [0, 4],
        [0, 20],
      ],
      apexes: [0],
    },
    collars: [{ center: 0, end: 1 }],
    intestines: [{ center: 0, radius: 0.25, arcs: [[1, 5]] }],
    ancestry: [
      { vertex: 12, parent: 7 },
      { vertex: 7, parent: 0 },
    ],
  };
  const draw = (overlays: Partial<Overlays>) => {
    const s = new Scene(theme);
    s.model.sync(lattice(4));
    s.meshed = true;
    s.facts = facts;
    s.overlays = { ...s.overlays, grid: false, ancestry: false, ...overlays };
    return sceneToSvg(s, view, size, 16);
  };

  it('nothing is drawn that is not switched on', () => {
    const svg = draw({});
    for (const color of [theme.featureSize, theme.collar, theme.intestine, theme.ancestry]) {
      expect(svg).not.toContain(color);
    }
    expect(svg).not.toContain('<image');
  });

  it('each has its tint and its dash', () => {
    const stroke = (color: string, dash = '') =>
      new RegExp(`stroke="${color}"[^>]*${dash ? `stroke-dasharray="${dash}"` : ''}`);
    const lfs = draw({ featureSize: true });
    expect(lfs).toMatch(/<image [^>]*href="data:image\/png;base64,[A-Za-z0-9+/=]+"/);
    expect(lfs).toMatch(stroke(theme.featureSize));
    expect(lfs.match(stroke(theme.witness, '0.01 5'))).not.toBeNull();
    expect(draw({ neighbors: true })).toMatch(stroke(theme.featureSize, '7 5'));
    expect(draw({ neighbors: true })).toMatch(stroke(theme.neighbor));
    expect(draw({ neighbors: true })).toContain('>0.80</text>');
    expect(draw({ spindles: true })).toMatch(stroke(theme.spindle, '7 5'));
    expect(draw({ collars: true })).toMatch(stroke(theme.collar, '7 5'));
    expect(draw({ intestines: true })).toMatch(stroke(theme.intestine, '0.01 5'));
    expect(draw({ ancestry: true })).toMatch(stroke(theme.ancestry));
  });

  it('flags N only outside of [1/2, sqrt 2]', () => {
    expect(draw({ neighbors: true })).toContain(`stroke="${theme.defect}"`);
    expect([0.5, 0.7, 1, Math.SQRT2].every(neighborInBounds)).toBe(true);
    expect([0.4999, 1.4143].some(neighborInBounds)).toBe(false);
  });

  it('has no coordinate far off the paper, at the deepest zoom', () => {
    const s = new Scene(theme);
    s.model.sync(lattice(4));
    s.meshed = true;
    s.facts = { ...facts, field: null };
    s.overlays = {
      ...s.overlays,
      diametral: true,
      featureSize: true,
      neighbors: true,
      spindles: true,
      collars: true,
      intestines: true,
    };
    const svg = sceneToSvg(s, { x: 0.5, y: 0.5, scale: 1e12 }, size, 16);
    expect(svg).not.toMatch(/NaN|Infinity|undefined/);
    expect(sceneToSvg(new Scene(theme), view, size, 16)).not.toContain('<image');
  });

  it('without facts there is nothing to draw', () => {
    const s = new Scene(theme);
    s.facts = noFacts;
    s.overlays = { ...s.overlays, featureSize: true };
    expect(s.image()).toBeNull();
  });
});

describe('an arc', () => {
  it('runs counter-clockwise on its circle from one end to the other', () => {
    const points = arcPoints([0, 0], 1, [1, 0], [0, 1], 0.001);
    expect(points[0]).toEqual([1, 0]);
    expect(points.at(-1)).toEqual([0, 1]);
    expect(points.length).toBeGreaterThan(20);
    for (const [x, y] of points) {
      expect(Math.hypot(x, y)).toBeCloseTo(1, 12);
      expect(x).toBeGreaterThanOrEqual(-1e-12);
      expect(y).toBeGreaterThanOrEqual(-1e-12);
    }
  });
});
