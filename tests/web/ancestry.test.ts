import createCircumball, { type CircumballModule } from 'circumball';
import { beforeAll, describe, expect, it } from 'vitest';
import { Ancestry } from '../../web/src/replay/ancestry.ts';
import { NONE, Reason } from '../../web/src/replay/event.ts';
import { distance, point } from '../../web/src/replay/geometry.ts';
import { Protection } from '../../web/src/replay/protection.ts';
import { ratioBound } from '../../web/src/replay/theorem.ts';
import type { Trace } from '../../web/src/replay/trace.ts';
import { VertexKind } from '../../web/src/shared/types.ts';
import { exampleFiles, lfsOf, readExample, traceOf } from './core-run.ts';
import { squareTrace } from './small-trace.ts';

let core: CircumballModule;
beforeAll(async () => {
  core = await createCircumball();
});

const ancestryOf = (trace: Trace) => new Ancestry(trace, new Protection(trace));
const place = (trace: Trace, v: number) => point(trace.coordinates.data, v);

describe('a trace by hand', () => {
  it('a midpoint that a circumcenter yielded to descends from the triangle that proposed it', () => {
    const ancestry = ancestryOf(squareTrace());
    const cause = ancestry.cause(4);
    expect(cause.kind).toBe('yielded');
    expect(cause).toMatchObject({ triangle: [0, 1, 2] });
    // Both legs are shortest: the younger end of either was born after 0.
    expect([1, 2]).toContain(cause.parent);
    expect(ancestry.chain(4)).toEqual([{ vertex: 4, parent: cause.parent }]);
    expect(ancestry.chain(0)).toEqual([]);
  });
});

describe.each(exampleFiles)('%s', (file) => {
  const algorithms = ['ruppert', 'collar', 'intestine', 'feature-size', 'chew'];

  it.each(algorithms)(
    'every ancestry under %s leads by older vertices to the input',
    (algorithm) => {
      const complex = readExample(core, file);
      const { trace } = traceOf(core, complex, { algorithm, maxVertices: 1500 });
      const ancestry = ancestryOf(trace);
      for (let v = 0; v < trace.vertexCount; v++) {
        const chain = ancestry.chain(v);
        for (const { vertex, parent } of chain) {
          // Vertices of the input come all at once: among them there is no older and younger.
          if (parent < complex.vertices.length) continue;
          expect(trace.vertexBorn.at(parent)).toBeLessThan(trace.vertexBorn.at(vertex));
        }
        const last = chain.at(-1)?.parent ?? v;
        expect(['input', 'box', 'division']).toContain(ancestry.cause(last).kind);
      }
    },
  );

  it('parents under ruppert are those of the cases of the proof of Theorem 2.2', () => {
    const complex = readExample(core, file);
    const { trace } = traceOf(core, complex, { algorithm: 'ruppert', maxVertices: 1500 });
    const ancestry = ancestryOf(trace);
    for (let v = complex.vertices.length; v < trace.vertexCount; v++) {
      const cause = ancestry.cause(v);
      if (cause.kind === 'encroached') {
        // Seen from a vertex in the disk the ends are a right angle apart or more. Differences of close doubles are exact,
        // so this holds down to where double precision ends.
        const p = place(trace, cause.parent);
        const [a, b] = cause.split.map((w) => place(trace, w));
        const dot = (a![0] - p[0]) * (b![0] - p[0]) + (a![1] - p[1]) * (b![1] - p[1]);
        expect(dot).toBeLessThanOrEqual(1e-10 * distance(a!, p) * distance(b!, p));
      }
      if (cause.kind !== 'triangle' && cause.kind !== 'yielded') continue;
      // r_p is at most the length of the shortest edge (case 2).
      const [p, q] = cause.edge.map((w) => place(trace, w));
      expect(cause.edge[1]).toBe(cause.parent);
      const radius = trace.vertexRadius.data[cause.parent]!;
      expect(radius).toBeLessThanOrEqual(distance(p!, q!) * (1 + 1e-12));
    }
  });

  it('a vertex is inserted for a reason that the trace tells', () => {
    const complex = readExample(core, file);
    const { trace } = traceOf(core, complex, { algorithm: 'intestine', maxVertices: 1500 });
    const ancestry = ancestryOf(trace);
    for (let v = 0; v < trace.vertexCount; v++) {
      const { reason } = trace.event(trace.vertexBorn.at(v));
      if (reason === Reason.collar || reason === Reason.circle || reason === Reason.arcMidpoint) {
        expect(ancestry.cause(v).parent).not.toBe(NONE);
      }
    }
  });
});

describe('Theorem 2.2', () => {
  it.each(['castle.obj', 'square-hole.poly'])(
    'lfs(q) / r_q stays below C1 and C2 at every vertex of %s, whose angles are right',
    (file) => {
      const complex = readExample(core, file);
      const { trace, tau } = traceOf(core, complex, { algorithm: 'ruppert', tau: 1.5 });
      expect(tau).toBe(1.5);
      const n = trace.vertexCount;
      const lfs = lfsOf(core, complex, trace.coordinates.data.slice(0, 2 * n));
      expect(n).toBeGreaterThan(complex.vertices.length);
      for (let v = complex.vertices.length; v < n; v++) {
        const bound = ratioBound('ruppert', tau, trace.vertexKind.data[v]!)!.bound!;
        expect(lfs[v]! / trace.vertexRadius.data[v]!).toBeLessThanOrEqual(bound);
      }
    },
  );

  it('has the constants of its proof', () => {
    const tau = 2;
    const c2 = ratioBound('ruppert', tau, VertexKind.free)!.bound!;
    const c1 = ratioBound('ruppert', tau, VertexKind.onSegment)!.bound!;
    expect(c2).toBeGreaterThanOrEqual(c1 / tau + 1 - 1e-12); // (2.1)
    expect(c1).toBeCloseTo(Math.SQRT2 * c2 + 1, 12); // (2.2)
    expect(ratioBound('ruppert', 1.4, VertexKind.free)!.bound).toBeNull();
    expect(ratioBound('delaunay', tau, VertexKind.free)).toBeNull();
  });
});
