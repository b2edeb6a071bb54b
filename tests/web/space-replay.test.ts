import { describe, expect, it } from 'vitest';
import { complexToText, inputFromJson } from '../../web/src/core/complex-json.ts';
import { circumball, dihedralAngles, distance3 } from '../../web/src/replay/geometry3.ts';
import {
  AngleCache,
  cellsAt,
  countBelow,
  histogram,
  measureTetrahedron,
} from '../../web/src/replay/measure.ts';
import { momentAt } from '../../web/src/replay/moment.ts';
import { Replay } from '../../web/src/replay/replay.ts';
import { Label, type Moment3, type Point3, VertexKind } from '../../web/src/shared/types.ts';
import { random } from './small-trace.ts';
import {
  faceDrafts,
  liveAfter3,
  orientation,
  randomSpaceDrafts,
  spaceTrace,
} from './small-trace3.ts';

function live(replay: Replay): string[] {
  const { liveCells, liveCellCount, cells } = replay.state();
  return Array.from(liveCells.subarray(0, liveCellCount), (n) =>
    [...cells.subarray(4 * n, 4 * n + 4)].sort((a, b) => a - b).join(),
  ).sort();
}

function facets(replay: Replay): string[] {
  const { facets } = replay.state();
  if (!facets) return [];
  return Array.from(facets.live.subarray(0, facets.liveCount), (n) =>
    facets.triangles.subarray(4 * n, 4 * n + 4).join(),
  ).sort();
}

describe('replay in space', () => {
  const { drafts, points } = randomSpaceDrafts(60, 5);
  const trace = spaceTrace(drafts);

  it('is the mesh of the trace at every position, forwards, backwards and by jumps', () => {
    const replay = new Replay(trace);
    const next = random(2);
    const goals = [
      ...Array.from({ length: drafts.length + 1 }, (_, i) => i),
      ...Array.from({ length: drafts.length + 1 }, (_, i) => drafts.length - i),
      ...Array.from({ length: 60 }, () => Math.floor(next() * (drafts.length + 1))),
    ];
    for (const goal of goals) {
      replay.seek(goal);
      expect(live(replay)).toEqual(liveAfter3(drafts, goal));
    }
  });

  it('tells the cells at any position without going there', () => {
    const replay = new Replay(trace);
    const cache = new AngleCache(trace);
    for (let position = 0; position <= drafts.length; position++) {
      replay.seek(position);
      const there = cellsAt(trace, position);
      expect(histogram(there, cache)).toEqual(histogram(replay.state(), cache));
      expect(countBelow(there, cache, 181)).toBe(histogram(there, cache).cells);
      expect(countBelow(there, cache, 0)).toBe(0);
    }
  });

  it('keeps coordinates bit for bit and tetrahedra positively oriented', () => {
    for (const [v, p] of points.entries())
      expect(Array.from(trace.coordinates.data.subarray(3 * v, 3 * v + 3))).toEqual(p);
    for (let n = 0; n < trace.cellCount; n++) {
      const corners = Array.from(trace.cells.data.subarray(4 * n, 4 * n + 4), (v) => points[v]!);
      const [a, b, c, d] = corners as [Point3, Point3, Point3, Point3];
      expect(orientation(a, b, c, d)).toBeGreaterThan(0);
    }
  });

  it('lets a tetrahedron leave the queue when it dies', () => {
    expect(trace.queue.at(trace.eventCount, 10).length).toBe(0);
    const queued = drafts.findIndex((d) => d.dimension === 3);
    expect(trace.queue.at(queued + 1, 10)).toMatchObject({ length: 1, segments: 0 });
  });
});

describe('faces', () => {
  const trace = spaceTrace(faceDrafts);
  const moment = (position: number) => momentAt(new Replay(trace), position) as Moment3;

  it('have triangulations of their own that follow space', () => {
    const replay = new Replay(trace);
    replay.seek(6);
    expect(facets(replay)).toEqual(['0,1,2,0']);
    replay.seek(trace.eventCount);
    expect(facets(replay)).toEqual(['0,4,2,0', '1,2,4,0']);
    replay.seek(10);
    expect(facets(replay)).toEqual(['0,1,2,0']);
    replay.seek(0);
    expect(facets(replay)).toEqual([]);
    replay.seek(trace.eventCount);
    const state = replay.state();
    expect([...state.facets!.label.subarray(0, 3)]).toEqual([1, 1, 1]);
    expect(state.vertexKind[4]).toBe(VertexKind.onSegment);
  });

  it('split subsegments with their input segment', () => {
    const replay = new Replay(trace);
    replay.seek(trace.eventCount);
    const state = replay.state();
    const pieces = Array.from(state.liveSubsegments.subarray(0, state.liveSubsegmentCount), (n) =>
      state.subsegments.subarray(3 * n, 3 * n + 3).join(),
    ).sort();
    expect(pieces).toEqual(['0,2,1', '0,4,0', '1,2,2', '4,1,0']);
  });

  it('are told of in the words of the rules', () => {
    expect(moment(6).sentence).toBe('Face 0 has its own Delaunay triangulation: 1 triangle.');
    expect(moment(9).sentence).toContain('1-feature size witness inside its diametral ball');
    expect(moment(9)).toMatchObject({ rule: 'unacceptability', simplex: [0, 1], witness: 2 });
    expect(moment(9).ball).toEqual({ center: [0.5, 0, 0], radius: 0.5 });
    expect(moment(11).sentence).toBe(
      'In the triangulation of face 0, 1 triangle became 2 triangles.',
    );
    expect(moment(11)).toMatchObject({ kind: 'face-changed', face: 0 });
    expect([...moment(11).facets]).toEqual([1, 2]);
    expect(moment(12).sentence).toContain('Triangle 0–4–2 of face 0 is not safe to split');
    expect(moment(12).ghost).toEqual([0.25, 0.25, 0]);
  });
});

describe('measures of tetrahedra', () => {
  const next = random(11);
  const point = (): Point3 => [next(), next(), next()];

  it('circumscribed balls have all corners on the sphere, for two to four corners', () => {
    for (let i = 0; i < 300; i++) {
      const corners = [point(), point(), point(), point()].slice(0, 2 + (i % 3));
      const ball = circumball(corners)!;
      for (const p of corners) {
        const error = Math.abs(distance3(p, ball.center) - ball.radius);
        expect(error).toBeLessThan(1e-9 * ball.radius * ball.radius + 1e-12);
      }
    }
  });

  it('the center of the ball of a triangle lies in its plane', () => {
    for (let i = 0; i < 50; i++) {
      const [a, b, c] = [point(), point(), point()];
      const { center, radius } = circumball([a, b, c])!;
      expect(Math.abs(orientation(a, b, c, center))).toBeLessThan(1e-12 * (1 + radius));
    }
  });

  it('dihedral angles of the regular tetrahedron and of the corner of a cube', () => {
    const regular = dihedralAngles([1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]);
    for (const angle of regular) expect(angle).toBeCloseTo((Math.acos(1 / 3) * 180) / Math.PI, 10);
    const corner = dihedralAngles([0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]).sort((x, y) => x - y);
    const slope = (Math.acos(1 / Math.sqrt(3)) * 180) / Math.PI;
    for (const [i, angle] of corner.entries()) expect(angle).toBeCloseTo(i < 3 ? slope : 90, 10);
  });

  it('the histogram counts six angles a cell inside the domain', () => {
    const trace = spaceTrace(faceDrafts);
    const replay = new Replay(trace);
    replay.seek(trace.eventCount);
    const { bins, cells } = histogram(replay.state(), new AngleCache(trace));
    expect(cells).toBe(2);
    expect(bins.reduce((a, b) => a + b)).toBe(12);
    const whole = measureTetrahedron(trace, 0);
    expect(whole.volume).toBeCloseTo(1 / 6, 15);
    expect(whole.radiusEdge).toBeCloseTo(Math.sqrt(3) / 2, 14);
    expect(replay.state().cellLabel[0]).toBe(Label.inside);
  });
});

it('a complex of space survives the way to text and back, bit for bit', () => {
  const json = {
    circumball: 1,
    dimension: 3,
    vertices: [
      [0.1, -0, 1e-300],
      [1 / 3, 2, 3],
      [0, 1, 0.1 + 0.2],
      [4, 4, 4],
    ],
    segments: [[0, 1]],
    faces: [{ loops: [[0, 1, 2], [3]], holes: [[0.5, 0.5, 0.5]], segments: [0], vertices: [3] }],
    holes: [[9, 9, 9]],
    regions: [{ at: [1, 1, 1], label: 2, max: 0.5 }],
    markers: { faces: [7] },
  };
  const complex = inputFromJson(json as never);
  const again = inputFromJson(JSON.parse(complexToText(complex)));
  expect(again).toEqual(complex);
  expect(Object.is(again.vertices[0]![1], -0)).toBe(true);
});
