import { Kind, NONE, Reason } from '../../web/src/replay/event.ts';
import { cross, dot, minus } from '../../web/src/replay/geometry3.ts';
import { ascending } from '../../web/src/replay/lives.ts';
import { Trace } from '../../web/src/replay/trace.ts';
import type { Point3 } from '../../web/src/shared/types.ts';
import { type Draft, encode, random } from './small-trace.ts';

/** Traces of space made by hand: points inserted one by one into a big tetrahedron, by brute force; and one with a face. */

export interface SpaceDrafts {
  readonly drafts: readonly Draft[];
  readonly points: readonly Point3[];
}

export function orientation(a: Point3, b: Point3, c: Point3, d: Point3): number {
  return dot(cross(minus(b, a), minus(c, a)), minus(d, a));
}

/** Is p inside the circumscribed sphere of a positively oriented tetrahedron? */
export function inSphere(corners: readonly Point3[], p: Point3): boolean {
  const rows = corners.map((q) => {
    const d = minus(q, p);
    return [...d, dot(d, d)];
  });
  return determinant(rows) < 0;
}

function determinant(m: readonly (readonly number[])[]): number {
  if (m.length === 1) return m[0]![0]!;
  return m[0]!.reduce((sum, x, k) => {
    const minor = m.slice(1).map((row) => row.filter((_, j) => j !== k));
    return sum + (k % 2 === 0 ? 1 : -1) * x * determinant(minor);
  }, 0);
}

/** Random points in the unit cube. Brute force, so keep n modest. */
export function randomSpaceDrafts(n: number, seed: number): SpaceDrafts {
  const next = random(seed);
  const points: Point3[] = [
    [-9, -9, -9],
    [30, -9, -9],
    [-9, 30, -9],
    [-9, -9, 30],
  ];
  const drafts: Draft[] = [{ kind: Kind.stepBegan }];
  for (const [v, at] of points.entries()) {
    const born = v === 3 ? [[0, 1, 2, 3, 1]] : [];
    drafts.push({ kind: Kind.inserted, reason: Reason.input, subject: v, at, dead: [], born });
  }
  let live: number[][] = [[0, 1, 2, 3]];
  for (let i = 0; i < n; i++) {
    const at: Point3 = [next(), next(), next()];
    const v = points.length;
    points.push(at);
    const isDead = (cell: readonly number[]) =>
      inSphere(
        cell.map((w) => points[w]!),
        at,
      );
    const dead = live.filter(isDead);
    const sides = new Map<string, number[]>();
    for (const cell of dead) {
      for (let k = 0; k < 4; k++) {
        const side = cell.filter((_, j) => j !== k);
        const name = [...side].sort((a, b) => a - b).join();
        if (!sides.delete(name)) sides.set(name, side);
      }
    }
    const born = [...sides.values()].map(([a, b, c]) =>
      orientation(points[a!]!, points[b!]!, points[c!]!, at) > 0
        ? [a!, b!, c!, v]
        : [b!, a!, c!, v],
    );
    live = [...live.filter((cell) => !isDead(cell)), ...born];
    const [victim] = dead;
    const acting = { dimension: 3, simplex: victim! };
    drafts.push({ kind: Kind.queued, reason: Reason.radiusEdge, value: 3, ...acting });
    drafts.push({
      kind: Kind.inserted,
      reason: Reason.circumcenter,
      subject: v,
      at,
      value: 0.1,
      // Turned by an even permutation: names must not depend on it.
      dead: dead.map(([a, b, c, d]) => [b!, c!, a!, d!, 1]),
      born: born.map((cell) => [...cell, 1]),
      ...acting,
    });
  }
  return { drafts, points };
}

/** Names of the live cells after each prefix of drafts, the slow and sure way. */
export function liveAfter3(drafts: readonly Draft[], count: number): string[] {
  const live = new Set<string>();
  const name = (r: readonly number[]) => ascending(r[0]!, r[1]!, r[2]!, r[3]!).join();
  for (const d of drafts.slice(0, count)) {
    if (d.kind === Kind.faceChanged) continue;
    for (const cell of d.dead ?? []) live.delete(name(cell));
    for (const cell of d.born ?? []) live.add(name(cell));
  }
  return [...live].sort();
}

export function spaceTrace(drafts: readonly Draft[], input = tetrahedronInput): Trace {
  const trace = new Trace(input);
  const { events, simplices } = encode(drafts);
  trace.append(events, simplices, ['0', '1a']);
  return trace;
}

export const tetrahedronInput = {
  dimension: 3 as const,
  vertexCount: 4,
  segments: [
    [0, 1],
    [0, 2],
    [1, 2],
  ] as [number, number][],
};

/** A tetrahedron whose bottom is face 0 of the input; its side 0–1 is split, and the face follows. */
export const faceDrafts: readonly Draft[] = [
  { kind: Kind.stepBegan },
  ...(
    [
      [0, 0, 0],
      [1, 0, 0],
      [0, 1, 0],
      [0, 0, 1],
    ] as const
  ).map(
    (at, v): Draft => ({
      kind: Kind.inserted,
      reason: Reason.input,
      subject: v,
      at,
      dead: [],
      born: v === 3 ? [[0, 1, 2, 3, 1]] : [],
    }),
  ),
  { kind: Kind.faceChanged, subject: 0, dead: [], born: [[0, 1, 2, NONE, 0 * 4 + 1]] },
  { kind: Kind.stepEnded, subject: 4, other: [0, 0] },
  { kind: Kind.stepBegan, step: 1 },
  {
    kind: Kind.queued,
    step: 1,
    dimension: 1,
    reason: Reason.witness,
    simplex: [0, 1],
    segment: 0,
    subject: 2,
  },
  {
    kind: Kind.inserted,
    step: 1,
    dimension: 1,
    reason: Reason.midpoint,
    simplex: [0, 1],
    segment: 0,
    subject: 4,
    at: [0.5, 0, 0],
    value: 0.5,
    dead: [[0, 1, 2, 3, 1]],
    born: [
      [0, 4, 2, 3, 1],
      [4, 1, 2, 3, 1],
    ],
  },
  {
    kind: Kind.faceChanged,
    step: 1,
    subject: 0,
    dead: [[1, 2, 0, NONE, 1]],
    born: [
      [0, 4, 2, NONE, 1],
      [4, 1, 2, NONE, 1],
    ],
  },
  {
    kind: Kind.refused,
    step: 1,
    dimension: 2,
    reason: Reason.precision,
    simplex: [0, 4, 2],
    segment: 0,
    at: [0.25, 0.25, 0],
  },
  { kind: Kind.stepEnded, step: 1, subject: 1, other: [1, 0] },
];
