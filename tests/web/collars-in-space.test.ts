import createCircumball from 'circumball';
import { beforeAll, describe, expect, it } from 'vitest';
import { collarRegion, collarRegionAt } from '../../web/src/replay/collar-region.ts';
import { Kind } from '../../web/src/replay/event.ts';
import { facePlane } from '../../web/src/replay/face-plane.ts';
import { FaceReplay } from '../../web/src/replay/face-replay.ts';
import { circumball, distance3, point3 } from '../../web/src/replay/geometry3.ts';
import { momentAt } from '../../web/src/replay/moment.ts';
import { Replay } from '../../web/src/replay/replay.ts';
import { refusalOf, stoppersOf } from '../../web/src/replay/stoppers.ts';
import { Label, type MeshState, Protecting } from '../../web/src/shared/types.ts';
import { findSimplex } from '../../web/src/space/pick.ts';
import { random } from './small-trace.ts';
import { type SpaceRun, spaceRun } from './space-run.ts';

/** Collars in space as the page reads them off the trace. */

let run: SpaceRun;
let end: MeshState;
beforeAll(async () => {
  const core = await createCircumball();
  run = spaceRun(core, 'schoenhardt.json', { algorithm: 'collar' });
  const replay = new Replay(run.trace);
  replay.seek(run.trace.eventCount);
  end = replay.state();
});

const edge = (a: number, b: number) => (a < b ? `${a} ${b}` : `${b} ${a}`);

function elementsOf({ protection }: MeshState, ...kinds: readonly number[]): number[][] {
  const { live, liveCount, kind, elements } = protection!;
  return Array.from(live.subarray(0, liveCount))
    .filter((n) => kinds.includes(kind[n]!))
    .map((n) => [...elements.subarray(4 * n, 4 * n + 4)]);
}

describe('collars in space', () => {
  it('are edges of the triangulations of their faces when the run has ended', () => {
    const { facets } = end;
    const edges = new Set<string>();
    for (const n of facets!.live.subarray(0, facets!.liveCount)) {
      const [a, b, c, face] = facets!.triangles.subarray(4 * n, 4 * n + 4);
      for (const [p, q] of [
        [a, b],
        [b, c],
        [c, a],
      ])
        edges.add(`${edge(p!, q!)} ${face}`);
    }
    const bounds = elementsOf(end, Protecting.collarSegment, Protecting.collarArc);
    expect(bounds.length).toBeGreaterThan(20);
    for (const [a, b, , face] of bounds) expect(edges).toContain(`${edge(a!, b!)} ${face}`);
  });

  it('end where they were split, and no piece of a segment that is protected is split after', () => {
    const { trace } = run;
    const pieces = trace.protecting!.lives;
    for (let n = 0; n < pieces.count; n++)
      if (pieces.label.data[n] === Protecting.subsegment)
        expect(pieces.died.at(n)).toBe(0xffffffff);
    const live = new Set(
      Array.from(end.liveSubsegments.subarray(0, end.liveSubsegmentCount), (n) =>
        edge(end.subsegments[3 * n]!, end.subsegments[3 * n + 1]!),
      ),
    );
    for (const [a, b] of elementsOf(end, Protecting.subsegment))
      expect(live).toContain(edge(a!, b!));
  });

  it('hold the circumcenter of every tetrahedron that is left above tau (Theorem 6.11)', () => {
    const region = collarRegion(run.trace, end);
    expect(run.unresolved.length).toBeGreaterThan(5);
    for (const simplex of run.unresolved) {
      expect(simplex.length).toBe(4);
      const ball = circumball(simplex.map((v) => point3(end.coordinates, v)))!;
      expect(stoppersOf(end, region, ball.center).length).toBeGreaterThan(0);
      expect(refusalOf(run.trace, simplex)?.simplex.slice().sort()).toEqual(simplex.slice().sort());
      expect(findSimplex(end, simplex)?.cell).not.toBeNull();
    }
  });

  it('reach to the protected pieces in every face, and nowhere touch an unprotected one beyond an arc', () => {
    const region = collarRegion(run.trace, end);
    const { facets } = end;
    const pieces = new Set(elementsOf(end, Protecting.subsegment).map(([a, b]) => edge(a!, b!)));
    let found = 0;
    for (const n of facets!.live.subarray(0, facets!.liveCount)) {
      const [a, b, c] = facets!.triangles.subarray(4 * n, 4 * n + 3) as unknown as [
        number,
        number,
        number,
      ];
      const touches = [edge(a, b), edge(b, c), edge(c, a)].some((e) => pieces.has(e));
      if (!touches || facets!.label[n] === Label.outside) continue;
      found++;
      expect(region.holds[n]).toBe(1);
    }
    expect(found).toBeGreaterThan(20);
    expect(region.facets.length).toBeLessThan(facets!.liveCount);
  });

  it('are the same kept from moment to moment, forwards, backwards and by jumps, as found anew', () => {
    const { trace } = run;
    const replay = new Replay(trace);
    const next = random(5);
    let position = 0;
    for (let i = 0; i < 250; i++) {
      const jump = next() < 0.1;
      const step = jump
        ? Math.floor(next() * trace.eventCount) - position
        : Math.floor(next() * 9) - 3;
      position = Math.min(trace.eventCount, Math.max(0, position + step));
      replay.seek(position);
      const state = replay.state();
      const [kept, anew] = [collarRegionAt(trace, state), collarRegion(trace, state)];
      expect([...kept.facets].sort()).toEqual([...anew.facets].sort());
    }
  });

  it('are the same in the pane of a face: each triangle, segment and arc of it, and no other', () => {
    const region = collarRegion(run.trace, end);
    let triangles = 0;
    let curves = 0;
    for (const f of run.complex.faces.keys()) {
      const replay = new FaceReplay(run.trace, run.complex, f, facePlane(run.frames, f)!);
      const collar = replay.collar(end, region)!;
      triangles += collar.triangles.length;
      curves += collar.segments.length + collar.arcs.length;
      for (const v of [...collar.triangles.flat(), ...collar.segments.flat()])
        expect(replay.has(v)).toBe(true);
      for (const { center, ends } of collar.arcs) {
        const [p, q] = ends.map((v) => point3(end.coordinates, v)) as [never, never];
        const c = point3(end.coordinates, center);
        expect(distance3(p, c) / distance3(q, c)).toBeCloseTo(1, 9);
      }
    }
    expect(triangles).toBe(region.facets.length);
    expect(curves).toBe(elementsOf(end, Protecting.collarSegment, Protecting.collarArc).length);
  });

  it('are told in sentences that name the rule, the face and the element', () => {
    const { trace } = run;
    const replay = new Replay(trace);
    const words = [
      'Rule 1',
      'Rule 2',
      'is drawn',
      'is now two',
      'collar arc',
      'Theorem 6.11',
      'never split from now on',
    ];
    const said = new Set<string>();
    for (let i = 0; i < trace.eventCount; i++) {
      const kind = trace.kind(i);
      const isTold =
        kind === Kind.protection ||
        kind === Kind.yielded ||
        kind === Kind.refused ||
        (kind === Kind.inserted && trace.event(i).dimension <= 1);
      if (!isTold) continue;
      replay.seek(i + 1);
      const { sentence } = momentAt(replay, i + 1)!;
      expect(sentence).toMatch(/^[A-Z0-9].*\.$/);
      expect(sentence).not.toMatch(/4294967295|undefined|NaN/);
      for (const w of words) if (sentence.includes(w)) said.add(w);
    }
    expect(said).toEqual(new Set(words));
  });
});
