import { Object3D } from 'three';
import { expect, it } from 'vitest';
import { pictureTheme } from '../../web/src/shared/theme.ts';
import { type FacetState, type MeshState, NEVER } from '../../web/src/shared/types.ts';
import { adjacencyOf } from '../../web/src/space/adjacency.ts';
import { SpaceColoring } from '../../web/src/space/coloring.ts';
import { cutCells } from '../../web/src/space/cut.ts';
import { type MeshLook, SpaceMeshLayer } from '../../web/src/space/mesh-layer.ts';
import { makeSpaceUniforms } from '../../web/src/space/shaders.ts';
import { defaultLook } from '../../web/src/space/types.ts';
import { makeWindow3 } from '../../web/src/space/view.ts';

/**
 * What a step costs the processor in large meshes: 50,000 subsegments and 200,000 triangles of faces, or 100,000 tetrahedra. The bounds
 * allow for machines of tests that are ten times slower than the one that the numbers beside them are from.
 */

const SIDE = 32; // cubes of six tetrahedra along each axis

/** Kuhn's division of a lattice of cubes: six tetrahedra each, face to face. */
function lattice(side: number): MeshState {
  const n = side + 1;
  const vertexCount = n ** 3;
  const coordinates = new Float64Array(3 * vertexCount);
  const at = (x: number, y: number, z: number) => x + n * (y + n * z);
  for (let z = 0; z < n; z++)
    for (let y = 0; y < n; y++)
      for (let x = 0; x < n; x++) coordinates.set([x, y, z], 3 * at(x, y, z));
  const cells: number[] = [];
  const orders = [
    [0, 1, 2],
    [1, 2, 0],
    [2, 0, 1],
    [1, 0, 2],
    [0, 2, 1],
    [2, 1, 0],
  ];
  for (let z = 0; z < side; z++)
    for (let y = 0; y < side; y++)
      for (let x = 0; x < side; x++)
        for (const [i, order] of orders.entries()) {
          const p = [x, y, z];
          const path = [at(x, y, z)];
          for (const k of order) {
            p[k]!++;
            path.push(at(p[0]!, p[1]!, p[2]!));
          }
          const [a, b, c, d] = path as [number, number, number, number];
          cells.push(...(i < 3 ? [a, b, c, d] : [a, c, b, d]));
        }
  const cellCount = cells.length / 4;
  const segments = 50_000;
  const triangles = 200_000;
  const facets: FacetState = {
    count: triangles + 2,
    triangles: Uint32Array.from({ length: 4 * (triangles + 2) }, (_, i) =>
      i % 4 === 3 ? (i >> 2) % 500 : (7 * (i >> 2) + i) % vertexCount,
    ),
    label: new Uint8Array(triangles + 2).fill(1),
    born: new Uint32Array(triangles + 2),
    live: Uint32Array.from({ length: triangles }, (_, i) => i),
    liveCount: triangles,
  };
  return {
    dimension: 3,
    position: 10,
    vertexCount,
    coordinates,
    vertexKind: new Uint8Array(vertexCount).fill(3),
    vertexBorn: new Uint32Array(vertexCount),
    vertexStep: new Uint8Array(vertexCount),
    cellCount,
    cells: Uint32Array.from(cells),
    cellLabel: new Uint8Array(cellCount),
    cellBorn: new Uint32Array(cellCount),
    cellDied: new Uint32Array(cellCount).fill(NEVER),
    liveCells: Uint32Array.from({ length: cellCount }, (_, i) => i),
    liveCellCount: cellCount,
    subsegments: Uint32Array.from({ length: 3 * (segments + 2) }, (_, i) =>
      i % 3 === 2 ? 0 : (3 * i) % vertexCount,
    ),
    subsegmentBorn: new Uint32Array(segments + 2),
    liveSubsegments: Uint32Array.from({ length: segments }, (_, i) => i),
    liveSubsegmentCount: segments,
    facets,
  };
}

const state = lattice(SIDE);
const look: MeshLook = {
  theme: pictureTheme(false, true),
  look: defaultLook,
  coloring: new SpaceColoring(),
  plane: null,
  window: makeWindow3({ target: [0, 0, 0], azimuth: 0, elevation: 0, scale: 10 }, null),
};

function milliseconds(act: () => void): number {
  const start = performance.now();
  act();
  return performance.now() - start;
}

it('a step writes what changed and no more', () => {
  const layer = new SpaceMeshLayer(new Object3D(), makeSpaceUniforms());
  const first = milliseconds(() => layer.sync(state, look));
  const facets = state.facets!;
  const steps: number[] = [];
  for (let i = 0; i < 20; i++) {
    // A triangle and a subsegment give way to two others each, back and forth.
    const live = facets.live.slice();
    const segments = state.liveSubsegments.slice();
    if (i % 2 === 0) {
      live[i] = facets.count - 1;
      segments[i] = state.subsegments.length / 3 - 1;
    }
    const next = { ...state, liveSubsegments: segments, facets: { ...facets, live } };
    steps.push(milliseconds(() => layer.sync(next, look)));
  }
  expect(first).toBeLessThan(3000); // 0.4 s
  steps.sort((a, b) => a - b);
  expect(steps[10]).toBeLessThan(80); // 3 ms
});

it('the clip plane moves through 200,000 tetrahedra', () => {
  expect(state.liveCellCount).toBeGreaterThan(190_000);
  let adjacency = adjacencyOf(state);
  const found = milliseconds(() => {
    adjacency = adjacencyOf(state);
  });
  const options = { outside: true, only: null, exact: true, shrink: 0 };
  const normal = [0.6, 0, 0.8] as const;
  const cut = cutCells(state, { ...options, plane: { normal, offset: 20 } }, undefined, adjacency);
  const moved = milliseconds(() => {
    cutCells(state, { ...options, plane: { normal, offset: 21 } }, cut, adjacency);
  });
  expect(found).toBeLessThan(1500); // 0.06 s
  expect(moved).toBeLessThan(500); // 0.05 s
  // Only what is seen is drawn: the hull, and the section.
  expect(cut.count).toBeLessThan(24 * SIDE * SIDE);
});
