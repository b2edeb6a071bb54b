import { type FacetState, type MeshState, NEVER } from '../../web/src/shared/types.ts';

/** Cubes of six tetrahedra along each axis. */
export const SIDE = 32;

/** Kuhn's division of a lattice of cubes: six tetrahedra each, face to face. */
export function lattice(side: number): MeshState {
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
