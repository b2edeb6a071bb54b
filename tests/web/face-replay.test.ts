import createCircumball, { type CircumballModule } from 'circumball';
import { beforeAll, describe, expect, it } from 'vitest';
import { Kind } from '../../web/src/replay/event.ts';
import { facePlane, heightOver, toPlane, toSpace } from '../../web/src/replay/face-plane.ts';
import { FaceReplay, sidesOf } from '../../web/src/replay/face-replay.ts';
import { circumcircle, distance, point } from '../../web/src/replay/geometry.ts';
import { point3 } from '../../web/src/replay/geometry3.ts';
import { momentAt } from '../../web/src/replay/moment.ts';
import { Replay } from '../../web/src/replay/replay.ts';
import {
  Label,
  type MeshState,
  type Moment3,
  NEVER,
  type Point,
} from '../../web/src/shared/types.ts';
import { type SpaceRun, spaceRun } from './space-run.ts';

let core: CircumballModule;
const runs = new Map<string, SpaceRun>();
beforeAll(async () => {
  core = await createCircumball();
  runs.set('pyramid', spaceRun(core, 'pyramid.json'));
  runs.set('holes', spaceRun(core, 'face-with-holes.json', { maxVertices: 500 }));
  runs.set('box', spaceRun(core, 'schoenhardt.json', { domain: 'box', maxVertices: 300 }));
});

function facesOf({ trace, complex, frames }: SpaceRun): FaceReplay[] {
  return complex.faces.map((_, f) => {
    const plane = facePlane(frames, f);
    if (!plane) throw new Error(`face ${f} has no plane`);
    return new FaceReplay(trace, complex, f, plane);
  });
}

const positions = ({ trace }: SpaceRun) =>
  Array.from({ length: 13 }, (_, i) => Math.round((i * trace.eventCount) / 12));

const place = (state: MeshState, v: number): Point => point(state.coordinates, v);

function trianglesOf(state: MeshState): [number, number, number][] {
  return Array.from(state.liveCells.subarray(0, state.liveCellCount), (k) => {
    const [a, b, c] = state.cells.subarray(3 * k, 3 * k + 3);
    return [a!, b!, c!];
  });
}

const twice = (p: Point, q: Point, r: Point) =>
  (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);

describe.each(['pyramid', 'holes', 'box'])('the faces of a run (%s)', (name) => {
  let run: SpaceRun;
  let faces: FaceReplay[];
  beforeAll(() => {
    run = runs.get(name)!;
    faces = facesOf(run);
  });

  it('the frame is orthonormal, and the vertices of the face lie in its plane', () => {
    for (const { complex, face, plane } of faces) {
      for (const v of complex.faces[face]!.loops.flat()) {
        const p = complex.vertices[v]!;
        expect(Math.abs(heightOver(plane, p))).toBeLessThan(1e-9);
        const back = toSpace(plane, toPlane(plane, p));
        for (const k of [0, 1, 2] as const) expect(back[k]).toBeCloseTo(p[k], 9);
      }
    }
  });

  it('together have every triangle of all faces at every position, each once', () => {
    const replay = new Replay(run.trace);
    for (const position of positions(run)) {
      replay.seek(position);
      const { facets } = replay.state();
      const all = Array.from(facets!.live.subarray(0, facets!.liveCount)).sort((a, b) => a - b);
      const own = faces.flatMap((face) => {
        const state = face.state(position);
        return Array.from(state.liveCells.subarray(0, state.liveCellCount), (k) => face.facetOf(k));
      });
      expect(own.sort((a, b) => a - b)).toEqual(all);
      for (const face of faces)
        for (const [k, n] of face.facets.entries()) expect(face.triangleOf(n)).toBe(k);
    }
  });

  it('are counter-clockwise, and Delaunay among the vertices of the face', () => {
    for (const position of positions(run)) {
      for (const face of faces) {
        const state = face.state(position);
        const triangles = trianglesOf(state);
        const vertices = [...new Set(triangles.flat())];
        for (const corners of triangles.slice(0, 60)) {
          const [a, b, c] = corners.map((v) => place(state, v)) as [Point, Point, Point];
          expect(twice(a, b, c)).toBeGreaterThan(-1e-12); // flat ones by the rounding of this line
          const circle = circumcircle(a, b, c);
          if (!circle || circle.radius > 1e4) continue;
          for (const v of vertices)
            expect(distance(place(state, v), circle.center)).toBeGreaterThan(
              circle.radius * (1 - 1e-7),
            );
        }
      }
    }
  });

  it('knows for every vertex in the face where it is, and of no other', () => {
    for (const face of faces) {
      const state = face.state(run.trace.eventCount);
      for (let v = 0; v < state.vertexCount; v++) {
        expect(state.vertexBorn[v] !== NEVER).toBe(face.has(v));
        if (!face.has(v)) expect(state.coordinates[2 * v]).toBeNaN();
        else {
          const p = point3(run.trace.coordinates.data, v);
          expect(Math.abs(heightOver(face.plane, p))).toBeLessThan(1e-9);
          expect(place(state, v)).toEqual(toPlane(face.plane, p));
        }
      }
    }
  });

  it('its subsegments cover its segments', () => {
    for (const position of positions(run).slice(1)) {
      for (const face of faces) {
        if (face.face >= run.input.faces.length) continue; // sides of the box are of no input segment
        const state = face.state(position);
        let covered = 0;
        for (let i = 0; i < state.liveSubsegmentCount; i++) {
          const n = state.liveSubsegments[i]!;
          const [a, b] = state.subsegments.subarray(3 * n, 3 * n + 2);
          covered += distance(place(state, a!), place(state, b!));
        }
        const { vertices, segments } = face.outline();
        let length = 0;
        for (const [a, b] of segments) length += distance(vertices[a]!, vertices[b]!);
        if (state.liveCellCount > 0) expect(covered).toBeCloseTo(length, 9);
      }
    }
  });

  it('a step changes what it says, forwards and backwards', () => {
    const changing = Array.from({ length: run.trace.eventCount }, (_, i) => i).filter(
      (i) => run.trace.kind(i) === Kind.faceChanged,
    );
    for (const i of changing.filter((_, k) => k % Math.ceil(changing.length / 40) === 0)) {
      for (const face of faces) {
        const before = new Set(face.state(i).liveCells.slice(0, face.state(i).liveCellCount));
        const after = face.state(i + 1);
        const now = new Set(after.liveCells.slice(0, after.liveCellCount));
        const change = face.change(i, true);
        const died = [...before].filter((k) => !now.has(k)).sort((a, b) => a - b);
        const born = [...now].filter((k) => !before.has(k)).sort((a, b) => a - b);
        expect([...(change?.died ?? [])].sort((a, b) => a - b)).toEqual(died);
        expect([...(change?.born ?? [])].sort((a, b) => a - b)).toEqual(born);
        const back = face.change(i, false);
        expect(back && [[...back.died], [...back.born]]).toEqual(
          change && [[...change.born], [...change.died]],
        );
      }
    }
  });
});

describe('a face of the pyramid', () => {
  it('is tiled by its triangles inside of the polygon, as soon as it has any', () => {
    const run = runs.get('pyramid')!;
    for (const face of facesOf(run)) {
      const { vertices } = face.outline();
      const [loop] = run.complex.faces[face.face]!.loops;
      let area = 0;
      for (const [a, b] of sidesOf({ loops: [loop!], holes: [], segments: [], vertices: [] })) {
        const [p, q] = [a, b].map((v) => toPlane(face.plane, run.complex.vertices[v]!));
        area += (p![0] * q![1] - p![1] * q![0]) / 2;
      }
      expect(vertices).toHaveLength(loop!.length);
      for (const position of positions(run)) {
        const state = face.state(position);
        if (state.liveCellCount === 0) continue;
        let sum = 0;
        for (let i = 0; i < state.liveCellCount; i++) {
          const k = state.liveCells[i]!;
          if (state.cellLabel[k] === Label.outside) continue;
          const corners = state.cells.subarray(3 * k, 3 * k + 3);
          const [a, b, c] = Array.from(corners, (v) => place(state, v)) as [Point, Point, Point];
          sum += twice(a, b, c) / 2;
        }
        expect(sum).toBeCloseTo(area, 9);
      }
    }
  });

  it('shows what acts in it: its triangles with their circles, refused points, and witnesses beside it', () => {
    const run = runs.get('pyramid')!;
    const faces = facesOf(run);
    const replay = new Replay(run.trace);
    const seen = { triangle: 0, ghost: 0, outsider: 0, follows: 0 };
    for (let position = 1; position <= run.trace.eventCount; position += 7) {
      replay.seek(position);
      const moment = momentAt(replay, position) as Moment3;
      const event = run.trace.event(position - 1);
      for (const face of faces) {
        const own = face.moment(moment, position);
        if (event.dimension === 2 && moment.simplex.length === 3 && event.kind !== Kind.inserted) {
          expect(own !== null && own.simplex.length === 3).toBe(event.face === face.face);
          if (!own || own.simplex.length < 3) continue;
          seen.triangle++;
          const state = face.state(position);
          const [a, b, c] = own.simplex.map((v) => place(state, v)) as [Point, Point, Point];
          if (!own.ball) {
            expect(Math.abs(twice(a, b, c))).toBeLessThan(1e-9); // three vertices of one side
            continue;
          }
          const circle = circumcircle(a, b, c);
          if (!circle || circle.radius > 1e4) continue;
          // About a corner while it is judged (Algorithm 4.3), else about the triangle.
          const { center, radius } = own.ball;
          if (event.kind === Kind.queued) {
            expect(radius).toBeCloseTo(2 * circle.radius, 9);
            expect(Math.min(...[a, b, c].map((p) => distance(p, center)))).toBeCloseTo(0, 9);
          } else {
            expect(radius).toBeCloseTo(circle.radius, 9);
            expect(distance(center, circle.center)).toBeCloseTo(0, 9);
          }
          if (own.ghost) seen.ghost++;
          const away = face.outsider(moment);
          // A vertex that makes a triangle of a face unacceptable lies outside of the face (Algorithm 4.3).
          if (moment.witness !== null) expect(away?.vertex).toBe(moment.witness);
          if (away) seen.outsider++;
        }
        if (event.kind === Kind.faceChanged && own) {
          expect(event.subject).toBe(face.face);
          expect(own.change?.born.length).toBe(event.other[1]);
          seen.follows++;
        }
      }
    }
    expect(Math.min(...Object.values(seen)), JSON.stringify(seen)).toBeGreaterThan(10);
  });
});
