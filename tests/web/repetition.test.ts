import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import createCircumball, { type CircumballModule, type RunOptions } from 'circumball';
import { beforeAll, describe, expect, it } from 'vitest';
import { complexFromJson, complexToText } from '../../web/src/core/complex-json.ts';
import { between, fitView, toScreen, zoomAbout } from '../../web/src/picture/view.ts';
import { Kind, NONE, Reason } from '../../web/src/replay/event.ts';
import { point } from '../../web/src/replay/geometry.ts';
import { findRepetitions } from '../../web/src/replay/repetition.ts';
import { Trace } from '../../web/src/replay/trace.ts';
import type { Complex2, Point } from '../../web/src/shared/types.ts';
import { type Draft, encode } from './small-trace.ts';

/** Splits of the end segments at vertex 0, at given lengths in turn, on `rays` segments of length 1 around it. */
function splits(
  lengths: readonly { ray: number; length: number; cause?: Point }[],
  rays: number,
): Trace {
  const ends = Array.from({ length: rays }, (_, i): Point => {
    const angle = (2 * Math.PI * i) / rays;
    return [Math.cos(angle), Math.sin(angle)];
  });
  const trace = new Trace({
    vertexCount: rays + 1,
    segments: ends.map((_, i) => [0, i + 1] as const),
  });
  const drafts: Draft[] = [[0, 0] as Point, ...ends].map((at, subject) => ({
    kind: Kind.inserted,
    reason: Reason.input,
    subject,
    at,
    dead: [],
    born: [],
  }));
  const last = ends.map((_, i) => i + 1);
  let next = rays + 1;
  for (const { ray, length, cause } of lengths) {
    const simplex = [0, last[ray]!];
    if (cause)
      drafts.push({
        kind: Kind.yielded,
        dimension: 2,
        simplex: [0, 1, 2],
        other: [0, last[ray]!],
        subject: ray,
        at: cause,
      });
    drafts.push({
      kind: Kind.inserted,
      dimension: 1,
      reason: Reason.midpoint,
      simplex: [...simplex, NONE],
      segment: ray,
      subject: next,
      at: [length * ends[ray]![0], length * ends[ray]![1]],
      value: length,
      dead: [],
      born: [],
    });
    last[ray] = next++;
  }
  const { events, simplices } = encode(drafts);
  trace.append(events, simplices, ['0']);
  return trace;
}

/** Cycles of splits in the order of `rays`, each cycle `factor` times as large as the one before. */
function cycles(rays: readonly number[], factor: number, count: number) {
  return Array.from({ length: count }, (_, k) =>
    rays.map((ray, i) => ({ ray, length: 0.4 * factor ** (k + i / (2 * rays.length)) })),
  ).flat();
}

describe('a repetition', () => {
  for (const [name, rays, factor] of [
    ['two segments in turn', [0, 1], 0.5],
    ['a segment split twice in a cycle', [2, 0, 2], 0.25],
    ['any factor', [0, 1, 2, 3], 0.3],
  ] as const) {
    it(`of ${name} is found with its period, factor and cycles`, () => {
      const found = findRepetitions(splits(cycles(rays, factor, 7), 4));
      expect(found).toHaveLength(1);
      const [r] = found;
      expect(r!.vertex).toBe(0);
      expect(r!.splits).toBe(rays.length);
      expect(r!.factor).toBeCloseTo(factor, 9);
      expect(r!.cycles).toBe(6); // from the first split of the first cycle to that of the seventh
      expect(r!.starts).toHaveLength(7);
      for (const [k, radius] of r!.radii.entries())
        expect(radius).toBeCloseTo(r!.radii[0]! * factor ** k, 12);
      expect(r!.segments).toEqual([...new Set(rays)].sort());
    });
  }

  it('is found when other splits came before it, and when a limit cut off its last cycle', () => {
    const before = [
      { ray: 0, length: 0.5 },
      { ray: 3, length: 0.49 },
      { ray: 0, length: 0.45 },
    ];
    const all = [...before, ...cycles([1, 0, 3], 0.5, 6)];
    for (const cut of [0, 1, 2, 3]) {
      const [r] = findRepetitions(splits(all.slice(0, all.length - cut), 4));
      expect(r?.splits).toBe(3);
      expect(r?.factor).toBe(0.5);
    }
  });

  it('is none when the order changes, when sizes do not shrink alike, or when it stopped by itself', () => {
    const shuffled = cycles([0, 1], 0.5, 8).map((s, i) => (i % 5 === 3 ? { ...s, ray: 2 } : s));
    expect(findRepetitions(splits(shuffled, 4))).toEqual([]);
    const uneven = cycles([0, 1], 0.5, 8).map((s, i) => ({ ...s, length: s.length / (1 + i * i) }));
    expect(findRepetitions(splits(uneven, 4))).toEqual([]);
    const stopped = [
      ...cycles([0, 1], 0.5, 6),
      ...cycles([3], 0.99, 1),
      ...Array.from({ length: 9 }, (_, i) => ({ ray: i % 3, length: 1e-3 / (2 + i * i) })),
    ];
    expect(findRepetitions(splits(stopped, 4))).toEqual([]);
  });

  it('is none while what causes the splits stays where it is', () => {
    const drawn = cycles([0], 0.5, 8).map((s) => ({ ...s, cause: [1e-3, 1e-3] as Point }));
    expect(findRepetitions(splits(drawn, 4))).toEqual([]);
  });
});

const folder = fileURLToPath(new URL('../../examples/', import.meta.url));
let core: CircumballModule;
beforeAll(async () => {
  core = await createCircumball();
});

function example(name: string, offset: Point = [0, 0]): Complex2 {
  const bytes = new Uint8Array(readFileSync(folder + name));
  const complex = complexFromJson(core.read([{ name, bytes }]).complex);
  const vertices = complex.vertices.map(([x, y]): Point => [x + offset[0], y + offset[1]]);
  return { ...complex, vertices };
}

function run(complex: Complex2, options: RunOptions): Trace {
  const answer = core.start(complexToText(complex), JSON.stringify(options));
  expect(answer.error).toBe('');
  const trace = new Trace({ vertexCount: complex.vertices.length, segments: complex.segments });
  for (;;) {
    const progress = core.advance(answer.run, 2000, 0);
    const chunk = core.takeTrace(answer.run);
    trace.append(chunk.events, chunk.simplices, chunk.steps);
    if (progress.status !== 'running') break;
  }
  core.release(answer.run);
  return trace;
}

/** The table of docs/non-termination.md. */
const known = [
  { file: 'pav.json', minAngle: 31, midpoints: 4, circumcenters: 8, splits: 2, each: Math.SQRT1_2 },
  {
    file: 'pinwheel.json',
    minAngle: 20.7,
    midpoints: 7,
    circumcenters: 0,
    splits: 7,
    each: 2 ** (-1 / 7),
  },
  { file: 'fan.json', minAngle: 20.7, midpoints: 10, circumcenters: 0, splits: 6, each: null },
];

describe.each(known)('$file', ({ file, minAngle, midpoints, circumcenters, splits, each }) => {
  const options = { algorithm: 'ruppert', minAngle };

  it('repeats itself at half the size at vertex 0, with the period that is known', () => {
    for (const limit of [{ minEdge: 1e-4 }, { minEdge: 1e-9 }, { maxVertices: 400 }]) {
      const [r] = findRepetitions(run(example(file), { ...options, ...limit }));
      expect(r).toMatchObject({ vertex: 0, factor: 0.5, midpoints, circumcenters, splits });
      expect(r!.cycles).toBeGreaterThanOrEqual(12);
      if (each === null) expect(r!.each).toBeNull();
      else expect(r!.each).toBeCloseTo(each, 6);
    }
  });

  it('repeats itself alike away from the origin, until double precision ends', () => {
    const [r] = findRepetitions(run(example(file, [0.3, -0.6]), options));
    expect(r).toMatchObject({ vertex: 0, factor: 0.5, midpoints, circumcenters, splits });
    expect(r!.exhausted).toBe(true);
  });

  it('looks in every cycle as in the cycle before, down to 1e-12, to a tenth of a pixel', () => {
    for (const offset of [
      [0, 0],
      [0.3, -0.6],
    ] as const) {
      const trace = run(example(file, offset), { ...options, minEdge: 1e-12 });
      const [r] = findRepetitions(trace);
      const size = { width: 800, height: 600 };
      const base = fitView(r!.bounds, size);
      const deepest = Math.min(r!.cycles, Math.floor(Math.log(1e-12) / Math.log(r!.factor)));
      expect(deepest).toBeGreaterThan(30);
      const shown = (k: number) => {
        const view = zoomAbout(base, r!.at, r!.factor ** -k);
        expect(toScreen(view, size, r!.at)[0]).toBeCloseTo(toScreen(base, size, r!.at)[0], 1);
        return pulsesAt(trace, r!.starts[k]!, r!.starts[k + 1]!).map((v) =>
          toScreen(view, size, point(trace.coordinates.data, v)),
        );
      };
      const first = shown(1);
      expect(first).toHaveLength(r!.splits);
      for (let k = 2; k < Math.min(deepest, r!.cycles - 1); k++)
        for (const [i, [x, y]] of shown(k).entries())
          expect(Math.hypot(x - first[i]![0], y - first[i]![1])).toBeLessThan(0.1);
    }
  });

  it('ends with collars, and nothing repeats itself', () => {
    const protect = file === 'pav.json' ? { parameters: { protect: 'all' } } : {};
    const trace = run(example(file), { algorithm: 'collar', minAngle, minEdge: 1e-4, ...protect });
    expect(findRepetitions(trace)).toEqual([]);
  });
});

/** Vertices that split end subsegments at vertex 0 between two positions. */
function pulsesAt(trace: Trace, from: number, to: number): number[] {
  const found: number[] = [];
  for (let i = from; i < to; i++) {
    const e = trace.event(i);
    if (e.kind === Kind.inserted && e.dimension === 1 && e.simplex.includes(0))
      found.push(e.subject);
  }
  return found;
}

describe('what ends', () => {
  it('is not taken for what does not, however early a limit stops it', () => {
    for (const file of ['first-light.json', 'airfoil.poly', 'spiral.json', 'near-pair.json'])
      for (const limit of [{ minEdge: 0.01 }, { maxVertices: 80 }, { maxVertices: 170 }])
        expect(findRepetitions(run(example(file), { algorithm: 'ruppert', ...limit }))).toEqual([]);
  });

  it('halves segments thirty times towards a vertex a billionth away, which is no repetition', () => {
    const corners: Point[] = [
      [-1, -1],
      [1.1, -1],
      [1, 1.2],
      [-1, 1],
    ];
    for (const angle of [20, 80, 120, 175]) {
      const a = (angle * Math.PI) / 180;
      const near: Point = [1e-9 * Math.cos(a), 1e-9 * Math.sin(a)];
      const complex: Complex2 = {
        vertices: [...corners, [0, 0], [0.8, 0], near],
        segments: [
          [0, 1],
          [1, 2],
          [2, 3],
          [3, 0],
          [4, 5],
        ],
        holes: [],
        regions: [],
      };
      for (const limit of [{ minEdge: 1e-4 }, { minEdge: 1e-7 }, { maxVertices: 60 }])
        expect(findRepetitions(run(complex, { algorithm: 'ruppert', ...limit }))).toEqual([]);
    }
  });
});

describe('the way of the camera', () => {
  const a = { x: 0.2, y: 0.3, scale: 100 };
  it('begins at one view and ends at the other, ever nearer', () => {
    for (const b of [
      { x: 0.5, y: -0.25, scale: 1e7 },
      { x: 3, y: 1, scale: 100 },
      { x: 0, y: 0, scale: 2 },
    ]) {
      expect(between(a, b, 0)).toEqual(a);
      const end = between(a, b, 1);
      expect(end.x).toBeCloseTo(b.x, 9);
      expect(end.y).toBeCloseTo(b.y, 9);
      expect(end.scale / b.scale).toBeCloseTo(1, 9);
      let last = Math.hypot(a.x - b.x, a.y - b.y);
      for (let t = 0.1; t < 1; t += 0.1) {
        const v = between(a, b, t);
        const distance = Math.hypot(v.x - b.x, v.y - b.y);
        expect(distance).toBeLessThan(last);
        last = distance;
      }
    }
  });
});
