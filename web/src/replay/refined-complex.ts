import { type Complex2, VertexKind } from '../shared/types.ts';
import { point } from './geometry.ts';
import type { Trace } from './trace.ts';

/**
 * The complex that the theorems of a run are about: the input, and the box with its sides if there is one. The corners of the box
 * follow the input's vertices, as in the mesh.
 */
export function refinedComplex(complex: Complex2, trace: Trace | null): Complex2 {
  const first = complex.vertices.length;
  if (!trace || trace.vertexCount < first + 4) return complex;
  for (let v = first; v < first + 4; v++) {
    if (trace.vertexKind.data[v] !== VertexKind.box) return complex;
  }
  const corners = [0, 1, 2, 3].map((i) => point(trace.coordinates.data, first + i));
  const sides = [0, 1, 2, 3].map((i) => [first + i, first + ((i + 1) % 4)] as const);
  return {
    vertices: [...complex.vertices, ...corners],
    segments: [...complex.segments, ...sides],
    holes: [],
    regions: [],
  };
}
