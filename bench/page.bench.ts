import { Object3D } from 'three';
import { bench } from 'vitest';
import { randomSpaceDrafts, spaceTrace } from '../tests/web/small-trace3.ts';
import { lattice, SIDE } from '../tests/web/lattice.ts';
import { Replay } from '../web/src/replay/replay.ts';
import { pictureTheme } from '../web/src/shared/theme.ts';
import { adjacencyOf } from '../web/src/space/adjacency.ts';
import { SpaceColoring } from '../web/src/space/coloring.ts';
import { cutCells } from '../web/src/space/cut.ts';
import { type MeshLook, SpaceMeshLayer } from '../web/src/space/mesh-layer.ts';
import { makeSpaceUniforms } from '../web/src/space/shaders.ts';
import { defaultLook } from '../web/src/space/types.ts';
import { makeWindow3 } from '../web/src/space/view.ts';

/**
 * What the page in space costs the processor: `npx vitest bench --run`. A mesh of 50,000 subsegments, 200,000 triangles of faces and
 * 200,000 tetrahedra.
 */
const state = lattice(SIDE);
const look: MeshLook = {
  theme: pictureTheme(false, true),
  look: defaultLook,
  coloring: new SpaceColoring(),
  plane: null,
  window: makeWindow3({ target: [0, 0, 0], azimuth: 0, elevation: 0, scale: 10 }, null),
};

const layer = new SpaceMeshLayer(new Object3D(), makeSpaceUniforms());
layer.sync(state, look);
let step = 0;

bench('a step: a triangle and a subsegment give way to others', () => {
  const facets = state.facets!;
  const live = facets.live.slice();
  const segments = state.liveSubsegments.slice();
  if (step++ % 2 === 0) {
    live[step] = facets.count - 1;
    segments[step] = state.subsegments.length / 3 - 1;
  }
  layer.sync({ ...state, liveSubsegments: segments, facets: { ...facets, live } }, look);
});

const adjacency = adjacencyOf(state);
bench('which tetrahedra share a facet', () => {
  adjacencyOf(state);
});

const options = { outside: true, only: null, exact: true, shrink: 0 };
const normal = [0.6, 0, 0.8] as const;
const cut = cutCells(state, { ...options, plane: { normal, offset: 20 } }, undefined, adjacency);
bench('the clip plane moves', () => {
  cutCells(state, { ...options, plane: { normal, offset: 21 } }, cut, adjacency);
});

const replay = new Replay(spaceTrace(randomSpaceDrafts(200, 9).drafts));
bench('a jump through 400 events', () => {
  replay.seek(401);
  replay.state();
  replay.seek(0);
  replay.state();
});
