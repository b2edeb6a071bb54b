import { EVENT_BYTES, Kind, NONE, Reason } from '../../web/src/replay/event.ts';
import { canonical } from '../../web/src/replay/lives.ts';
import { Trace } from '../../web/src/replay/trace.ts';

/** Traces made by hand, and long ones made by a brute-force incremental Delaunay triangulation. */

export interface Draft {
  kind: number;
  dimension?: number;
  reason?: number;
  step?: number;
  simplex?: readonly number[];
  segment?: number;
  subject?: number;
  other?: readonly [number, number];
  at?: readonly number[];
  value?: number;
  dead?: readonly (readonly number[])[]; // the vertices and the label, as in the simplex stream
  born?: readonly (readonly number[])[];
}

export function encode(drafts: readonly Draft[]): { events: Uint8Array; simplices: Uint32Array } {
  const events = new Uint8Array(drafts.length * EVENT_BYTES);
  const view = new DataView(events.buffer);
  const stream: number[] = [];
  for (const [i, d] of drafts.entries()) {
    const at = i * EVENT_BYTES;
    view.setUint8(at, d.kind);
    view.setUint8(at + 1, d.dimension ?? 0);
    view.setUint8(at + 2, d.reason ?? 0);
    view.setUint8(at + 3, d.step ?? 0);
    for (let k = 0; k < 4; k++) view.setUint32(at + 4 + 4 * k, d.simplex?.[k] ?? NONE, true);
    if (d.segment !== undefined) view.setUint32(at + 16, d.segment, true);
    view.setUint32(at + 20, d.subject ?? NONE, true);
    const changes =
      d.dead || d.born ? ([d.dead?.length ?? 0, d.born?.length ?? 0] as const) : d.other;
    view.setUint32(at + 24, changes?.[0] ?? NONE, true);
    view.setUint32(at + 28, changes?.[1] ?? NONE, true);
    view.setFloat64(at + 32, d.at?.[0] ?? 0, true);
    view.setFloat64(at + 40, d.at?.[1] ?? 0, true);
    view.setFloat64(at + 48, d.at?.[2] ?? 0, true);
    view.setFloat64(at + 56, d.value ?? 0, true);
    for (const t of [...(d.dead ?? []), ...(d.born ?? [])]) stream.push(...t);
  }
  return { events, simplices: Uint32Array.from(stream) };
}

export const unitSquare = {
  vertexCount: 4,
  segments: [
    [0, 1],
    [1, 2],
    [2, 3],
    [3, 0],
  ] as [number, number][],
};

/** A unit square: its four corners, the domain, then the bottom side split because a circumcenter yielded to it. */
export const squareDrafts: readonly Draft[] = [
  { kind: Kind.stepBegan },
  { kind: Kind.inserted, reason: Reason.input, subject: 0, at: [0, 0], dead: [], born: [] },
  { kind: Kind.inserted, reason: Reason.input, subject: 1, at: [1, 0], dead: [], born: [] },
  {
    kind: Kind.inserted,
    reason: Reason.input,
    subject: 2,
    at: [1, 1],
    dead: [],
    born: [[0, 1, 2, 0]],
  },
  {
    kind: Kind.inserted,
    reason: Reason.input,
    subject: 3,
    at: [0, 1],
    dead: [],
    born: [[2, 3, 0, 0]],
  },
  {
    kind: Kind.relabeled,
    dead: [
      [1, 2, 0, 0],
      [0, 2, 3, 0],
    ],
    born: [
      [0, 1, 2, 1],
      [0, 2, 3, 1],
    ],
  },
  { kind: Kind.stepEnded, subject: 4, other: [0, 0] },
  { kind: Kind.stepBegan, step: 1 },
  { kind: Kind.queued, step: 1, dimension: 2, reason: Reason.size, simplex: [0, 1, 2], value: 0.7 },
  { kind: Kind.queued, step: 1, dimension: 2, reason: Reason.size, simplex: [0, 2, 3], value: 0.7 },
  {
    kind: Kind.yielded,
    step: 1,
    dimension: 2,
    simplex: [0, 1, 2],
    subject: 0,
    other: [0, 1],
    at: [0.5, 0.5],
  },
  {
    kind: Kind.queued,
    step: 1,
    dimension: 1,
    reason: Reason.yieldedTo,
    simplex: [0, 1],
    segment: 0,
  },
  {
    kind: Kind.queued,
    step: 1,
    dimension: 2,
    reason: Reason.returned,
    simplex: [0, 1, 2],
    value: 0.7,
  },
  {
    kind: Kind.inserted,
    step: 1,
    dimension: 1,
    reason: Reason.midpoint,
    simplex: [0, 1],
    segment: 0,
    subject: 4,
    at: [0.5, 0],
    value: 0.5,
    dead: [[0, 1, 2, 1]],
    born: [
      [0, 4, 2, 1],
      [4, 1, 2, 1],
    ],
  },
  {
    kind: Kind.refused,
    step: 1,
    dimension: 2,
    reason: Reason.outsideDomain,
    simplex: [0, 2, 3],
    at: [0.5, 0.5],
  },
  { kind: Kind.stepEnded, step: 1, subject: 1, other: [1, 0] },
];

export function squareTrace(): Trace {
  const trace = new Trace(unitSquare);
  const { events, simplices } = encode(squareDrafts);
  trace.append(events, simplices, ['0', '2']);
  return trace;
}

/** splitmix32: the same points on every machine. */
export function random(seed: number): () => number {
  let s = seed >>> 0;
  return () => {
    s = (s + 0x9e3779b9) >>> 0;
    let z = s;
    z = Math.imul(z ^ (z >>> 16), 0x21f0aaad);
    z = Math.imul(z ^ (z >>> 15), 0x735a2d97);
    return ((z ^ (z >>> 15)) >>> 0) / 2 ** 32;
  };
}

/** Random points inserted one by one into a big triangle; brute force, so keep n modest. */
export function randomDrafts(n: number, seed: number): Draft[] {
  const next = random(seed);
  const points: [number, number][] = [
    [-10, -10],
    [10, -10],
    [0, 14],
  ];
  const drafts: Draft[] = [{ kind: Kind.stepBegan }];
  for (const [v, at] of points.entries()) {
    drafts.push({
      kind: Kind.inserted,
      reason: Reason.box,
      subject: v,
      at,
      dead: [],
      born: v === 2 ? [[0, 1, 2, 1]] : [],
    });
  }
  let live: number[][] = [[0, 1, 2]];
  for (let i = 0; i < n; i++) {
    const x = next();
    const y = next();
    const v = points.length;
    points.push([x, y]);
    const dead = live.filter(([a, b, c]) =>
      inCircle(points[a!]!, points[b!]!, points[c!]!, [x, y]),
    );
    const sides = new Map<string, [number, number]>();
    for (const [a, b, c] of dead as [number, number, number][]) {
      for (const [p, q] of [
        [a, b],
        [b, c],
        [c, a],
      ] as [number, number][]) {
        if (!sides.delete(`${q} ${p}`)) sides.set(`${p} ${q}`, [p, q]);
      }
    }
    const born = [...sides.values()].map(([p, q]) => [q, v, p]); // rotated: names must not depend on it
    const gone = new Set(dead);
    live = [...live.filter((t) => !gone.has(t)), ...born];
    const victim = dead[0]!;
    drafts.push({
      kind: Kind.queued,
      dimension: 2,
      reason: Reason.size,
      simplex: victim,
      value: 1,
    });
    drafts.push({
      kind: Kind.inserted,
      dimension: 2,
      reason: Reason.circumcenter,
      simplex: victim,
      subject: v,
      at: [x, y],
      value: 0.1,
      dead: dead.map((t) => [t[1]!, t[2]!, t[0]!, 1]),
      born: born.map((t) => [...t, 1]),
    });
  }
  return drafts;
}

/** The live triangles after each prefix of drafts, the slow and sure way. */
export function liveAfter(drafts: readonly Draft[], count: number): string[] {
  const live = new Set<string>();
  for (const d of drafts.slice(0, count)) {
    for (const t of d.dead ?? []) live.delete(canonical(t[0]!, t[1]!, t[2]!).join());
    for (const t of d.born ?? []) live.add(canonical(t[0]!, t[1]!, t[2]!).join());
  }
  return [...live].sort();
}

function inCircle(a: number[], b: number[], c: number[], d: number[]): boolean {
  const m = [a, b, c].map((p) => {
    const x = p[0]! - d[0]!;
    const y = p[1]! - d[1]!;
    return [x, y, x * x + y * y] as const;
  }) as [
    readonly [number, number, number],
    readonly [number, number, number],
    readonly [number, number, number],
  ];
  const det =
    m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
    m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
    m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  return det > 0;
}
