import type { MeshArrays } from 'circumball';
import { type Complex2, Label, type MeshState, NEVER, VertexKind } from '../shared/types.ts';

/** Meshes between the picture, which names triangles by number, and the core, which takes arrays. */

export interface MeasuredMesh {
  readonly mesh: MeshArrays;
  /** Number of the triangle that each cell is. */
  readonly numbers: Uint32Array;
}

/** What is in the domain at a position of a run: its triangles and no other vertices than theirs. */
export function meshOf(state: MeshState): MeasuredMesh {
  const vertexOf = new Map<number, number>();
  const coordinates: number[] = [];
  const cells: number[] = [];
  const numbers: number[] = [];
  for (let i = 0; i < state.liveCellCount; i++) {
    const t = state.liveCells[i]!;
    if (state.cellLabel[t] === Label.outside) continue;
    numbers.push(t);
    for (let k = 0; k < 3; k++) {
      const v = state.cells[3 * t + k]!;
      let own = vertexOf.get(v);
      if (own === undefined) {
        own = vertexOf.size;
        vertexOf.set(v, own);
        coordinates.push(state.coordinates[2 * v]!, state.coordinates[2 * v + 1]!);
      }
      cells.push(own);
    }
  }
  return {
    mesh: {
      dimension: 2,
      inputVertices: 0,
      boxVertices: 0,
      vertices: Float64Array.from(coordinates),
      cells: Uint32Array.from(cells),
      cellRegions: new Float64Array(0),
      vertexFeatures: new Uint32Array(0),
      edges: new Uint32Array(0),
      facets: new Uint32Array(0),
    },
    numbers: Uint32Array.from(numbers),
  };
}

/** A mesh that no run on the page has made, as the picture draws it. Cell i is triangle i. */
export function stillMesh(mesh: MeshArrays): MeshState {
  const vertexCount = mesh.vertices.length / 2;
  const cellCount = mesh.cells.length / 3;
  const subsegmentCount = mesh.edges.length / 3;
  const kinds = [VertexKind.input, VertexKind.onSegment, VertexKind.inFace, VertexKind.free];
  const vertexKind = Uint8Array.from({ length: vertexCount }, (_, v) => {
    const isBox = v >= mesh.inputVertices && v < mesh.inputVertices + mesh.boxVertices;
    return isBox ? VertexKind.box : (kinds[mesh.vertexFeatures[2 * v] ?? 3] ?? VertexKind.free);
  });
  const count = (n: number) => Uint32Array.from({ length: n }, (_, i) => i);
  return {
    dimension: 2,
    position: 1,
    vertexCount,
    coordinates: mesh.vertices,
    vertexKind,
    vertexBorn: new Uint32Array(vertexCount),
    vertexStep: new Uint8Array(vertexCount),
    cellCount,
    cells: mesh.cells,
    cellLabel: new Uint8Array(cellCount).fill(Label.inside),
    cellBorn: new Uint32Array(cellCount),
    cellDied: new Uint32Array(cellCount).fill(NEVER),
    liveCells: count(cellCount),
    liveCellCount: cellCount,
    subsegments: mesh.edges,
    subsegmentBorn: new Uint32Array(subsegmentCount),
    liveSubsegments: count(subsegmentCount),
    liveSubsegmentCount: subsegmentCount,
    facets: null,
  };
}

/** The domain of the families of Figure 7.1. */
export const unitSquare: Complex2 = {
  vertices: [
    [0, 0],
    [1, 0],
    [1, 1],
    [0, 1],
  ],
  segments: [
    [0, 1],
    [1, 2],
    [2, 3],
    [3, 0],
  ],
  holes: [],
  regions: [],
};
