import { type MeshState, NEVER, type PictureTheme } from '../../web/src/shared/types';

export const theme: PictureTheme = {
  dark: false,
  reducedMotion: false,
  background: '#ffffff',
  ink: '#111111',
  inkFaint: '#cccccc',
  edge: '#777777',
  fill: '#eeeeff',
  fillOutside: '#fafafa',
  steinerSegment: '#d55e00',
  steinerFree: '#0072b2',
  box: '#999999',
  acting: '#e69f00',
  witness: '#cc79a7',
  ball: '#56b4e9',
  ghost: '#aa3366',
  born: '#009e73',
  died: '#d55e01',
  yielding: '#8844aa',
  hole: '#aa0000',
  selection: '#0066cc',
  snap: '#cc00aa',
  defect: '#cc0000',
  warning: '#bb7700',
  featureSize: '#8a7401',
  neighbor: '#0072b3',
  spindle: '#b36b01',
  collar: '#b04780',
  intestine: '#00808b',
  ancestry: '#6a3d9b',
};

/** The unit square cut into n by n squares of two triangles each; its four sides are the subsegments. */
export function lattice(n: number): MeshState {
  const coordinates: number[] = [];
  for (let j = 0; j <= n; ++j) for (let i = 0; i <= n; ++i) coordinates.push(i / n, j / n);
  const triangles: number[] = [];
  for (let j = 0; j < n; ++j) {
    for (let i = 0; i < n; ++i) {
      const a = j * (n + 1) + i;
      triangles.push(a, a + 1, a + n + 2, a, a + n + 2, a + n + 1);
    }
  }
  const count = triangles.length / 3;
  const vertices = coordinates.length / 2;
  const last = vertices - 1;
  const subsegments = [0, n, 0, n, last, 1, last, last - n, 2, last - n, 0, 3];
  return {
    dimension: 2,
    position: 1,
    vertexCount: vertices,
    coordinates: Float64Array.from(coordinates),
    vertexKind: new Uint8Array(vertices).fill(4),
    vertexBorn: new Uint32Array(vertices),
    vertexStep: new Uint8Array(vertices),
    cellCount: count,
    cells: Uint32Array.from(triangles),
    cellLabel: new Uint8Array(count).fill(1),
    cellBorn: new Uint32Array(count),
    cellDied: new Uint32Array(count).fill(NEVER),
    liveCells: Uint32Array.from({ length: count }, (_, i) => i),
    liveCellCount: count,
    subsegments: Uint32Array.from(subsegments),
    subsegmentBorn: new Uint32Array(4),
    liveSubsegments: Uint32Array.from([0, 1, 2, 3]),
    liveSubsegmentCount: 4,
    facets: null,
  };
}
