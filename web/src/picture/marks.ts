import { type PictureTheme, type Point, VertexKind } from '../shared/types';
import type { MarkItem } from './items';

/** How a mesh vertex of a kind looks, the same on canvas, paper and legend. */
export function vertexMark(kind: number, at: Point, theme: PictureTheme): MarkItem {
  const halo = { stroke: theme.background, width: 1.2 };
  switch (kind) {
    case VertexKind.input:
      return { at, shape: 'disc', size: 8, fill: theme.ink, ...halo };
    case VertexKind.box:
      return {
        at,
        shape: 'square',
        size: 7,
        fill: theme.background,
        stroke: theme.box,
        width: 1.4,
      };
    case VertexKind.onSegment:
      return { at, shape: 'square', size: 7.5, fill: theme.steinerSegment, ...halo };
    case VertexKind.inFace:
      return { at, shape: 'diamond', size: 8, fill: theme.steinerFree, ...halo };
    default:
      return { at, shape: 'disc', size: 6.5, fill: theme.steinerFree, ...halo };
  }
}
