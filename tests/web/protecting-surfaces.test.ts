import { Object3D } from 'three';
import { describe, expect, it } from 'vitest';
import { noRegion } from '../../web/src/replay/collar-region.ts';
import { Kind, Reason } from '../../web/src/replay/event.ts';
import { cross, distance3, dot, minus } from '../../web/src/replay/geometry3.ts';
import { momentAt } from '../../web/src/replay/moment.ts';
import { Replay } from '../../web/src/replay/replay.ts';
import { pictureTheme } from '../../web/src/shared/theme.ts';
import {
  type Complex3,
  type Moment3,
  type Point3,
  Protecting,
  VertexKind,
} from '../../web/src/shared/types.ts';
import {
  ARC_PIECES,
  arcPoints,
  curvePoints,
  patchCorners,
} from '../../web/src/space/protection-geometry.ts';
import { ProtectionLayer } from '../../web/src/space/protection-layer.ts';
import { makeSpaceUniforms } from '../../web/src/space/shaders.ts';
import { defaultLook } from '../../web/src/space/types.ts';
import { type Draft, random } from './small-trace.ts';
import { spaceTrace } from './small-trace3.ts';

/** Spheres and tubes that protect, by a trace made by hand: a segment with two rings about it, and a sphere about its end. */

const points: readonly Point3[] = [
  [0, 0, 0],
  [4, 0, 0],
  [2, 0, 0],
  [1, 0, 0],
  // A ring about vertex 3 of radius 0.6, and one about vertex 2.
  [1, 0.6, 0],
  [1, 0, 0.6],
  [2, 0.6, 0],
  [2, 0, 0.6],
];
const complex: Complex3 = {
  dimension: 3,
  vertices: points.slice(0, 2),
  segments: [[0, 1]],
  faces: [],
  holes: [],
  regions: [],
};
const { ringArc, spherePatch, tubePatch } = Protecting;
const drafts: readonly Draft[] = [
  { kind: Kind.stepBegan },
  ...points.map(
    (at, v): Draft => ({
      kind: Kind.inserted,
      reason: Reason.input,
      subject: v,
      at,
      dead: [],
      born: [],
    }),
  ),
  {
    kind: Kind.protection,
    born: [
      [4, 5, 3, 0, ringArc],
      [6, 7, 2, 0, ringArc],
      [3, 4, 5, 0, spherePatch],
    ],
  },
  {
    kind: Kind.protection,
    born: [
      [4, 5, 7, 0, tubePatch],
      [4, 6, 7, 0, tubePatch],
    ],
  },
  // Corners in another order name the same patch.
  { kind: Kind.protection, dead: [[7, 4, 6, 0, tubePatch]], born: [] },
];
const trace = spaceTrace(drafts, { dimension: 3, vertexCount: 2, segments: [[0, 1]] });
const place = (v: number) => points[v]!;

describe('spheres and tubes that protect', () => {
  it('live between the events that begin and end them, forwards and backwards', () => {
    const replay = new Replay(trace);
    const counts = (position: number) => {
      replay.seek(position);
      return replay.state().protection!.liveCount;
    };
    const all = [9, 10, 11, 12];
    expect(all.map(counts)).toEqual([0, 3, 5, 4]);
    expect([...all].reverse().map(counts)).toEqual([4, 5, 3, 0]);
  });

  it('a patch that was never there cannot end', () => {
    const lying: readonly Draft[] = [
      ...drafts,
      { kind: Kind.protection, dead: [[4, 6, 7, 0, tubePatch]], born: [] },
    ];
    expect(() => spaceTrace(lying, { dimension: 3, vertexCount: 2, segments: [[0, 1]] })).toThrow(
      /never began/,
    );
  });

  it('have vertices that lie in no face, though they split triangles', () => {
    const split: Draft = {
      kind: Kind.inserted,
      dimension: 2,
      reason: Reason.circumcenter,
      simplex: [4, 5, 7],
      subject: 8,
      at: [1.5, 0.5, 0.5],
      dead: [],
      born: [],
    };
    const trace8 = spaceTrace([...drafts, split], {
      dimension: 3,
      vertexCount: 2,
      segments: [[0, 1]],
    });
    expect(trace8.vertexKind.data[8]).toBe(VertexKind.free);
  });

  it('are told and pointed to', () => {
    const replay = new Replay(trace);
    replay.seek(12);
    const moment = momentAt(replay, 12) as Moment3;
    expect(moment).toMatchObject({ kind: 'protection' });
    expect(moment.sentence).toMatch(/^What protects the input changes/);
    expect(trace.protecting!.find([7, 5, 4])).toBe(3);
  });

  it('are drawn: each curve and each patch in rows of its own, and what ends is gone', () => {
    const parent = new Object3D();
    const layer = new ProtectionLayer(parent, makeSpaceUniforms());
    const replay = new Replay(trace);
    const what = {
      theme: pictureTheme(false, true),
      look: defaultLook,
      window: { origin: [0, 0, 0] as Point3, unit: 1, reach: Number.POSITIVE_INFINITY },
      complex,
    };
    const rows = (position: number) => {
      replay.seek(position);
      layer.sync(replay.state(), noRegion, what);
      layer.show(true, defaultLook);
      const visible = parent.children.filter((c) => c.visible) as unknown as {
        geometry: { instanceCount: number };
      }[];
      return visible.map((c) => c.geometry.instanceCount).sort((a, b) => a - b);
    };
    // Arcs; and patches twice, as their far sides are drawn before their near ones.
    expect(rows(11)).toEqual([3, 3, 2 * ARC_PIECES]);
    expect(rows(12)).toEqual([2, 2, 2 * ARC_PIECES]);
    expect(rows(9)).toEqual([]);
    layer.show(true, { ...defaultLook, surfaces: false });
    layer.dispose();
  });
});

describe('where they lie', () => {
  const next = random(11);
  const somewhere = (): Point3 => [next() - 0.5, next() - 0.5, next() - 0.5];

  it('arcs keep their distance from the center, in steps of one angle', () => {
    for (let i = 0; i < 40; i++) {
      const center = somewhere();
      const u = somewhere();
      const a: Point3 = [center[0] + u[0], center[1] + u[1], center[2] + u[2]];
      const w = cross(u, somewhere());
      const scale = Math.hypot(...u) / Math.hypot(...w);
      const b: Point3 = [
        center[0] + w[0] * scale,
        center[1] + w[1] * scale,
        center[2] + w[2] * scale,
      ];
      const arc = arcPoints(center, a, b);
      expect(arc[0]).toEqual(a);
      expect(arc.at(-1)).toEqual(b);
      const chords = arc.slice(1).map((p, k) => distance3(p, arc[k]!));
      for (const p of arc) expect(distance3(p, center) / Math.hypot(...u)).toBeCloseTo(1, 12);
      for (const c of chords) expect(c / chords[0]!).toBeCloseTo(1, 9);
    }
  });

  it('ring arcs lie in planes across their segment, also where the ring is not about its vertex', () => {
    // At a tip the ring lies nearer to the input vertex than the tip.
    for (const record of [
      [4, 5, 3, 0],
      [4, 5, 2, 0],
    ])
      for (const p of curvePoints(ringArc, record, place, complex)) {
        expect(p[0]).toBeCloseTo(1, 12);
        expect(Math.hypot(p[1], p[2])).toBeCloseTo(0.6, 12);
      }
  });

  it('patches are seen from outside, in whatever order their corners come', () => {
    const orders = [
      [4, 5, 7],
      [5, 4, 7],
      [7, 5, 4],
    ];
    for (const corners of orders) {
      const [a, b, c] = patchCorners(tubePatch, [...corners, 0], place, complex);
      const normal = cross(minus(b, a), minus(c, a));
      expect(dot(normal, [0, 1, 1])).toBeGreaterThan(0);
      const [p, q, r] = patchCorners(spherePatch, [...corners, 0], place, complex);
      expect(dot(cross(minus(q, p), minus(r, p)), p)).toBeGreaterThan(0);
    }
  });
});
