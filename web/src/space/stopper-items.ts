/** A tetrahedron that is left as it is: its ball, the circumcenter that was refused, and the collar simplices that stop it. */

import type { Ball3 } from '../replay/geometry3';
import type { Stopper } from '../replay/stoppers';
import type { PictureTheme, Point3 } from '../shared/types';
import { noSpaceItems, type SpaceItems } from './items';
import { edgesOf } from './moment-items';

/** More would hide each other. */
const MOST_STOPPERS = 3;

export function stopperItems(
  ball: Ball3,
  stoppers: readonly Stopper[],
  place: (v: number) => Point3,
  theme: PictureTheme,
): SpaceItems {
  const items = noSpaceItems();
  items.spheres.push({ ...ball, color: theme.ball, opacity: 0.08, width: 1.8 });
  const color = theme.collar;
  for (const [i, stopper] of stoppers.slice(0, MOST_STOPPERS).entries()) {
    const corners = stopper.vertices.map(place);
    if (corners.length === 3) {
      const triangle = corners as unknown as readonly [Point3, Point3, Point3];
      items.triangles.push({ corners: triangle, fill: color, opacity: 0.5 });
    }
    for (const [a, b] of edgesOf(corners))
      items.lines.push({ a, b, color, width: corners.length === 2 ? 6 : 2.6 });
    // The rims of all would be a tangle: the deepest one stands for them.
    if (i === 0)
      items.spheres.push({ ...stopper.ball, color, opacity: 0.1, width: 1.8, dash: 'dashed' });
  }
  const at = ball.center;
  const ring = { fill: theme.background, stroke: theme.ghost, width: 2 };
  items.marks.push({ at, shape: 'disc', size: 15, ...ring });
  items.marks.push({ at, shape: 'cross', size: 6, stroke: theme.ghost, width: 2 });
  return items;
}
