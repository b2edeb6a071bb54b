import createCircumball, { type CircumballModule } from 'circumball';
import { beforeAll, describe, expect, it } from 'vitest';
import { neighborInBounds } from '../../web/src/picture/layers/overlay-layer.ts';
import { distance, midpoint, point } from '../../web/src/replay/geometry.ts';
import { nearestNeighbor, nearestNeighbors } from '../../web/src/replay/nearest.ts';
import { Protection } from '../../web/src/replay/protection.ts';
import { refinedComplex } from '../../web/src/replay/refined-complex.ts';
import { Replay } from '../../web/src/replay/replay.ts';
import { spindleOf } from '../../web/src/replay/spindle.ts';
import { type Complex2, type MeshState, VertexKind } from '../../web/src/shared/types.ts';
import { exampleFiles, lfsOf, readExample, traceOf } from './core-run.ts';
import { random } from './small-trace.ts';

let core: CircumballModule;
beforeAll(async () => {
  core = await createCircumball();
});

function endOf(complex: Complex2, options: object) {
  const { trace } = traceOf(core, complex, { maxVertices: 2000, ...options });
  const replay = new Replay(trace);
  replay.seek(trace.eventCount);
  return { trace, replay, state: replay.state() };
}
const place = (state: MeshState, v: number) => point(state.coordinates, v);

/** Ten segments between 3 and 12 degrees apart, two of them short. */
const fan: Complex2 = (() => {
  const vertices: [number, number][] = [[0, 0]];
  for (let i = 0; i < 10; i++) {
    const angle = ((i * i + 20 * i) * Math.PI) / 1800;
    const length = i % 4 === 1 ? 0.3 : 1;
    vertices.push([length * Math.cos(angle), length * Math.sin(angle)]);
  }
  const segments = vertices.slice(1).map((_, i) => [0, i + 1] as const);
  return { vertices, segments, holes: [], regions: [] };
})();

describe('collars', () => {
  it('are one end segment at each end of an acute angle, equal at each vertex, their disks empty', () => {
    const { trace, state } = endOf(fan, { algorithm: 'collar' });
    const collars = new Protection(trace).collars(trace.eventCount);
    expect(collars.filter((c) => c.center === 0)).toHaveLength(10);
    const [first] = collars;
    const d = distance(place(state, 0), place(state, first!.end));
    for (const { center, end } of collars) {
      const a = place(state, center);
      const b = place(state, end);
      if (center === 0) expect(distance(a, b)).toBeCloseTo(d, 12);
      const m = midpoint(a, b);
      for (let v = 0; v < state.vertexCount; v++) {
        if (v === center || v === end) continue;
        expect(distance(place(state, v), m)).toBeGreaterThan((distance(a, b) / 2) * (1 - 1e-9));
      }
      const live = Array.from(state.liveSubsegments.subarray(0, state.liveSubsegmentCount), (n) =>
        [state.subsegments[3 * n]!, state.subsegments[3 * n + 1]!].sort((p, q) => p - q).join(),
      );
      expect(live).toContain([center, end].sort((p, q) => p - q).join());
    }
  });

  it('are there from the event that makes them', () => {
    const { trace } = endOf(fan, { algorithm: 'collar' });
    const protection = new Protection(trace);
    expect(protection.collars(0)).toEqual([]);
    for (const { end } of protection.collars(trace.eventCount)) {
      const born = trace.vertexBorn.at(end);
      const ends = (p: number) => protection.collars(p).map((c) => c.end);
      expect(ends(born)).not.toContain(end);
      expect(ends(born + 1)).toContain(end);
    }
  });
});

describe('intestines', () => {
  it.each(['fan.json', 'pav.json', 'lake.json', 'cracks.json'])(
    'of %s are cut into arcs of at most a quarter turn, each the base of a triangle of the fan',
    (file) => {
      const complex = readExample(core, file);
      const { trace, state } = endOf(complex, { algorithm: 'intestine' });
      const intestines = new Protection(trace).intestines(trace.eventCount, state);
      const triangles = new Set<string>();
      for (let i = 0; i < state.liveCellCount; i++) {
        const n = 3 * state.liveCells[i]!;
        triangles.add([...state.cells.subarray(n, n + 3)].sort((p, q) => p - q).join());
      }
      for (const { center, radius, arcs } of intestines) {
        const at = place(state, center);
        expect(radius).toBeGreaterThan(0);
        for (const [a, b] of arcs) {
          const p = place(state, a);
          const q = place(state, b);
          expect(distance(at, p) / radius).toBeCloseTo(1, 9);
          expect(distance(at, q) / radius).toBeCloseTo(1, 9);
          expect(distance(p, q)).toBeLessThanOrEqual(radius * Math.SQRT2 * (1 + 1e-9));
          expect(triangles).toContain([center, a, b].sort((u, v) => u - v).join());
        }
      }
    },
  );
});

describe('N', () => {
  it.each(exampleFiles)(
    'is the distance to the nearest other vertex at every moment of %s',
    (file) => {
      const complex = readExample(core, file);
      const { trace } = traceOf(core, complex, { algorithm: 'ruppert', maxVertices: 600 });
      const replay = new Replay(trace);
      const next = random(7);
      for (let k = 0; k < 6; k++) {
        replay.seek(k === 0 ? trace.eventCount : Math.floor(next() * trace.eventCount));
        const state = replay.state();
        const live: number[] = [];
        for (let v = 0; v < state.vertexCount; v++) {
          if (state.vertexBorn[v]! < state.position) live.push(v);
        }
        const count = Math.min(complex.vertices.length, 80);
        const nearest = nearestNeighbors(state, count);
        for (let v = 0; v < count; v++) {
          const others = live
            .filter((w) => w !== v)
            .map((w) => distance(place(state, v), place(state, w)));
          const brute = live.includes(v) ? Math.min(...others) : Number.POSITIVE_INFINITY;
          expect(nearest[v]).toBe(brute);
          if (live.includes(v)) expect(nearestNeighbor(state, v)).toBe(brute);
        }
      }
    },
  );

  it.each(exampleFiles)(
    'lies within its bounds after feature-size on %s (Theorems 3.2, 3.3)',
    (file) => {
      const complex = readExample(core, file);
      const { state, trace } = endOf(complex, { algorithm: 'feature-size', maxVertices: 20_000 });
      const refined = refinedComplex(complex, trace);
      const lfs = lfsOf(core, refined, Float64Array.from(refined.vertices.flat()));
      const nearest = nearestNeighbors(state, complex.vertices.length);
      for (const [v, n] of nearest.entries()) {
        if (Number.isFinite(lfs[v]!)) expect(neighborInBounds(n / lfs[v]!)).toBe(true);
      }
    },
  );
});

describe('the complex that feature sizes are about', () => {
  it('is the input, with the box where the run made one', () => {
    const open = readExample(core, 'cracks.json');
    const { trace } = endOf(open, { algorithm: 'ruppert' });
    const boxed = refinedComplex(open, trace);
    expect(boxed.vertices).toHaveLength(open.vertices.length + 4);
    expect(boxed.segments).toHaveLength(open.segments.length + 4);
    const closed = readExample(core, 'unit-square.json');
    expect(refinedComplex(closed, endOf(closed, { algorithm: 'ruppert' }).trace)).toBe(closed);
    expect(refinedComplex(closed, null)).toBe(closed);
  });
});

describe('Spind(s) (Definition 2.1.5)', () => {
  it('of an end segment holds all end segments at its input vertex, of another only itself', () => {
    const { state } = endOf(fan, { algorithm: 'collar' });
    let ends = 0;
    let others = 0;
    for (let i = 0; i < state.liveSubsegmentCount; i++) {
      const n = 3 * state.liveSubsegments[i]!;
      const [a, b] = [state.subsegments[n]!, state.subsegments[n + 1]!];
      const spindle = spindleOf(state, a, b)!;
      expect(spindle.subsegments[0]).toEqual([a, b]);
      const isInput = (v: number) =>
        state.vertexKind[v] === VertexKind.input || state.vertexKind[v] === VertexKind.box;
      expect(spindle.apexes).toEqual([a, b].filter(isInput));
      if (a === 0 || b === 0) {
        ends++;
        expect(spindle.subsegments.filter((s) => s.includes(0))).toHaveLength(10);
      }
      if (!isInput(a) && !isInput(b)) {
        others++;
        expect(spindle.subsegments).toHaveLength(1);
      }
    }
    expect(ends).toBe(10);
    expect(others).toBeGreaterThan(0);
    expect(spindleOf(state, 1, 2)).toBeNull();
  });
});
