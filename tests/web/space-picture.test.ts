import { describe, expect, it } from 'vitest';
import { cross, dot, length3, minus } from '../../web/src/replay/geometry3.ts';
import { Replay } from '../../web/src/replay/replay.ts';
import type { MeshState, Point3 } from '../../web/src/shared/types.ts';
import { type Cut, cutCells } from '../../web/src/space/cut.ts';
import { pickSpace } from '../../web/src/space/pick.ts';
import { defaultLook, type SpaceView } from '../../web/src/space/types.ts';
import {
  basisOf,
  between,
  boundsOf3,
  clipToWindow,
  fitView,
  makeWindow3,
  orbit,
  pan,
  planeThrough,
  project,
  serves3,
  standardView,
  unproject,
  zoomAt,
} from '../../web/src/space/view.ts';
import { random } from './small-trace.ts';
import { randomSpaceDrafts, spaceTrace } from './small-trace3.ts';

const size = { width: 800, height: 600 };
const insets = { left: 50, top: 10, right: 10, bottom: 60 };
const view: SpaceView = { target: [1, 2, 3], azimuth: 30, elevation: 20, scale: 50 };

describe('the view in space', () => {
  it('has an orthonormal, right-handed basis in every direction', () => {
    for (const azimuth of [-170, -90, 0, 33, 180])
      for (const elevation of [-90, -10, 0, 45, 90]) {
        const { right, up, toEye } = basisOf({ ...view, azimuth, elevation });
        for (const axis of [right, up, toEye]) expect(length3(axis)).toBeCloseTo(1, 14);
        expect(length3(minus(cross(right, up), toEye))).toBeLessThan(1e-14);
        expect(up[2]).toBeGreaterThanOrEqual(-1e-15); // the third axis never points down
      }
  });

  it('finds the place under a pixel again', () => {
    const p = unproject(view, size, 123, 456);
    const [x, y, depth] = project(view, basisOf(view), size, p);
    expect(x).toBeCloseTo(123, 9);
    expect(y).toBeCloseTo(456, 9);
    expect(depth).toBeCloseTo(0, 9);
  });

  it('keeps what lies under the pointer there while zooming, and under the finger while panning', () => {
    const p = unproject(view, size, 200, 100);
    const zoomed = zoomAt(view, size, 3, [200, 100]);
    expect(project(zoomed, basisOf(zoomed), size, p).slice(0, 2)).toEqual([
      expect.closeTo(200, 9),
      expect.closeTo(100, 9),
    ]);
    const panned = pan(view, 17, -31);
    expect(project(panned, basisOf(panned), size, p).slice(0, 2)).toEqual([
      expect.closeTo(217, 9),
      expect.closeTo(69, 9),
    ]);
  });

  it('never turns over the poles, and stays about the target', () => {
    const over = orbit(view, 0, 10_000);
    expect(over.elevation).toBe(90);
    expect(orbit(over, 0, -20_000).elevation).toBe(-90);
    expect(over.target).toEqual(view.target);
  });

  it('fits every corner into what is free of the canvas, from every side', () => {
    const bounds = boundsOf3([
      [1e6, 0, 0],
      [1e6 + 1, 2, 0.001],
    ])!;
    for (const from of ['front', 'right', 'top', 'corner'] as const) {
      const fitted = fitView(standardView(view, from), bounds, size, insets);
      for (const corner of [bounds.min, bounds.max]) {
        const [x, y] = project(fitted, basisOf(fitted), size, corner);
        expect(x).toBeGreaterThan(insets.left);
        expect(x).toBeLessThan(size.width - insets.right);
        expect(y).toBeGreaterThan(insets.top);
        expect(y).toBeLessThan(size.height - insets.bottom);
      }
    }
  });

  it('takes the shorter way around', () => {
    const a = { ...view, azimuth: 170 };
    const b = { ...view, azimuth: -170, scale: 200 };
    expect(between(a, b, 0.5).azimuth).toBeCloseTo(180, 9);
    expect(between(a, b, 0.5).scale).toBeCloseTo(100, 9);
    expect(between(a, b, 1)).toEqual(b);
  });
});

describe('single precision', () => {
  const bounds = boundsOf3([
    [1e6, 1e6, 1e6],
    [1e6 + 1, 1e6 + 1, 1e6 + 1],
  ])!;
  const target: Point3 = [1e6 + 0.3, 1e6 + 0.3, 1e6 + 0.3];

  it('loses less than a fiftieth of a pixel near what is looked at, at every zoom', () => {
    for (const scale of [10, 1e4, 1e6, 1e9]) {
      const here = { ...view, target, scale };
      const window = makeWindow3(here, bounds);
      expect(serves3(window, here, bounds)).toBe(true);
      for (const pixels of [0, 100, 1000]) {
        const x = target[0] + pixels / scale;
        const single = Math.fround((x - window.origin[0]) * window.unit);
        const back = single / window.unit + window.origin[0];
        // Beyond what the double itself holds.
        expect(Math.abs(back - x) * scale).toBeLessThan(0.02 + 1e-9 * scale);
      }
    }
  });

  it('is renewed when the view leaves the window', () => {
    const deep = { ...view, target, scale: 1e9 };
    const window = makeWindow3(deep, bounds);
    const away = { ...deep, target: [target[0] + 1e-3, target[1], target[2]] as Point3 };
    expect(serves3(window, away, bounds)).toBe(false);
    expect(serves3(window, { ...deep, scale: 10 }, bounds)).toBe(false);
  });

  it('cuts lines off far away, on the same line', () => {
    const window = makeWindow3({ ...view, target, scale: 1e9 }, bounds);
    const ends = clipToWindow([1e6, 1e6, 1e6], [1e6 + 1, 1e6 + 1, 1e6 + 1], window)!;
    for (const p of ends) {
      expect(Math.abs(p[0] - target[0])).toBeLessThan(1.01 * window.reach);
      expect(p[0]).toBe(p[1]);
    }
    expect(clipToWindow([1e6, 1e6, 1e6], [1e6 + 1, 1e6, 1e6], window)).toBeNull();
  });
});

describe('cuts', () => {
  const { drafts, points } = randomSpaceDrafts(80, 21);
  const replay = new Replay(spaceTrace(drafts));
  replay.seek(drafts.length);
  const state = replay.state();
  const all = { outside: false, only: null, plane: null, exact: false, shrink: 0 };
  const origin: Point3 = [-9, -9, -9];
  const whole = 39 ** 3 / 6;

  it('of nothing are the hull: interior facets are not drawn', () => {
    const cut = cutCells(state, all);
    expect(cut.count).toBe(4);
    expect(volumeOf(cut, origin)).toBeCloseTo(whole, 9);
  });

  it('show the volume of the cells whose centroids are kept', () => {
    for (const t of [0.1, 0.3, 0.5]) {
      const plane = planeThrough(boundsOf3(points)!, [0.6, 0, 0.8], t, false);
      const cut = cutCells(state, { ...all, plane });
      let sum = 0;
      for (let i = 0; i < state.liveCellCount; i++) {
        const corners = cornersOf(state, state.liveCells[i]!);
        const middle = corners.reduce((s, p) => s + dot(plane.normal, p) / 4, 0);
        if (middle <= plane.offset) sum += volumeOfCell(corners);
      }
      expect(volumeOf(cut, origin)).toBeCloseTo(sum, 7);
    }
  });

  it('cut exactly: caps have the area of the section, and lie in the plane', () => {
    // The section of the big tetrahedron at height h is a right triangle with legs 39 - h.
    for (const h of [0.5, 9.3, 9.8, 20]) {
      const plane = { normal: [0, 0, 1] as Point3, offset: -9 + h };
      const cut = cutCells(state, { ...all, plane, exact: true });
      let area = 0;
      for (let row = 0; row < cut.count; row++) {
        if (cut.edges[row]! < 8) continue;
        const [a, b, c] = cornersOfRow(cut, row);
        for (const p of [a, b, c]) expect(p[2]).toBeCloseTo(plane.offset, 9);
        area += length3(cross(minus(b, a), minus(c, a))) / 2;
      }
      expect(area).toBeCloseTo((39 - h) ** 2 / 2, 7);
    }
  });

  it('of cells taken apart show four facets each, smaller by the cube', () => {
    const cut = cutCells(state, { ...all, shrink: 0.5 });
    expect(cut.count).toBe(4 * state.liveCellCount);
    expect(volumeOf(cut, origin)).toBeCloseTo(whole / 8, 8);
  });

  it('show the chosen cells alone, whatever the plane', () => {
    const plane = planeThrough(boundsOf3(points)!, [0, 0, 1], 0, false);
    const only = new Set([state.liveCells[3]!]);
    const cut = cutCells(state, { ...all, plane, only });
    expect(new Set(cut.cells.subarray(0, cut.count))).toEqual(only);
    expect(cut.count).toBe(4);
  });
});

describe('picking', () => {
  const { drafts, points } = randomSpaceDrafts(30, 4);
  const replay = new Replay(spaceTrace(drafts));
  replay.seek(drafts.length);
  const state = replay.state();
  const scene = {
    view: { ...view, target: [0, 0, 0] as Point3, scale: 100 },
    basis: basisOf({ ...view, target: [0, 0, 0] }),
    size,
    look: { ...defaultLook },
    plane: null,
    complex: {
      dimension: 3,
      vertices: [],
      segments: [],
      faces: [],
      holes: [],
      regions: [],
    } as const,
    triangles: new Uint32Array(0),
    state,
    filledFaces: new Set<number>(),
    cut: cutCells(state, { outside: false, only: null, plane: null, exact: false, shrink: 0 }),
  };

  it('finds the vertex under a place, of two in one place the nearer one', () => {
    const next = random(3);
    for (let i = 0; i < 20; i++) {
      const v = Math.floor(next() * points.length);
      const [x, y, depth] = project(scene.view, scene.basis, size, points[v]!);
      const hit = pickSpace(scene, x, y)!;
      const [hx, hy, hitDepth] = project(scene.view, scene.basis, size, points[hit.vertex!]!);
      expect(Math.hypot(hx - x, hy - y)).toBeLessThanOrEqual(10);
      if (hit.vertex !== v) expect(hitDepth).toBeGreaterThan(depth - 1e-9);
    }
  });

  it('finds nothing beyond the clip plane, and nothing hidden by cells', () => {
    const [x, y] = project(scene.view, scene.basis, size, points[10]!);
    const offset = dot([0, 0, 1], points[10]!) - 0.5;
    const cutOff = { ...scene, plane: { normal: [0, 0, 1] as Point3, offset } };
    const hit = pickSpace(cutOff, x, y);
    expect(hit?.vertex == null || points[hit.vertex]![2] <= offset).toBe(true);
    const hidden = pickSpace({ ...scene, look: { ...defaultLook, cells: true } }, x, y)!;
    expect(hidden.cell).not.toBeNull(); // the point is inside the big tetrahedron
  });
});

function cornersOf(state: MeshState, n: number): Point3[] {
  return Array.from(state.cells.subarray(4 * n, 4 * n + 4), (v) => {
    const p = state.coordinates.subarray(3 * v, 3 * v + 3);
    return [p[0]!, p[1]!, p[2]!] as const;
  });
}

function volumeOfCell([a, b, c, d]: readonly Point3[]): number {
  return dot(cross(minus(b!, a!), minus(c!, a!)), minus(d!, a!)) / 6;
}

function cornersOfRow(cut: Cut, row: number): [Point3, Point3, Point3] {
  const at = (i: number): Point3 => {
    const p = cut.corners.subarray(9 * row + 3 * i, 9 * row + 3 * i + 3);
    return [p[0]!, p[1]!, p[2]!];
  };
  return [at(0), at(1), at(2)];
}

/** What a closed surface encloses. */
function volumeOf(cut: Cut, origin: Point3): number {
  let sum = 0;
  for (let row = 0; row < cut.count; row++) {
    const [a, b, c] = cornersOfRow(cut, row).map((p) => minus(p, origin)) as [
      Point3,
      Point3,
      Point3,
    ];
    sum += dot(a, cross(b, c)) / 6;
  }
  return sum;
}
