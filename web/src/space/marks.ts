import { vertexMark } from '../picture/marks';
import type { PictureTheme, Point3 } from '../shared/types';
import type { Mark3Item } from './items';

/** How a mesh vertex of a kind looks: as in the plane. */
export function vertexMark3(kind: number, at: Point3, theme: PictureTheme): Mark3Item {
  const { angle: _, ...mark } = vertexMark(kind, [at[0], at[1]], theme);
  return { ...mark, at };
}
