/** Beyond mesh and moment: the face that is shown alone, outlined; the balls of feature sizes at a subsegment; a chain of parents. */

import { sidesOf } from '../replay/face-replay';
import type { AncestryLink, FeatureBall3, Witness3 } from '../shared/overlay-facts';
import type { Complex3, PictureTheme, Point3 } from '../shared/types';
import { noSpaceItems, type SpaceItems } from './items';

export function faceItems(complex: Complex3, face: number, theme: PictureTheme): SpaceItems {
  const items = noSpaceItems();
  const f = complex.faces[face];
  if (!f) return items;
  for (const [v, w] of sidesOf(f)) {
    const [a, b] = [complex.vertices[v], complex.vertices[w]];
    if (a && b) items.lines.push({ a, b, color: theme.selection, width: 3.2, opacity: 0.85 });
  }
  return items;
}

const ballNames = { fs1: 'fs₁', lfs: 'lfs' };

/** A ball of a feature size at a subsegment of input segment `own`: the two features that it meets, and where. */
export function ballItems(
  complex: Complex3,
  { radius, center, witnesses }: FeatureBall3,
  name: 'fs1' | 'lfs',
  theme: PictureTheme,
  own: number,
): SpaceItems {
  const items = noSpaceItems();
  if (!Number.isFinite(radius) || witnesses.length < 2) return items;
  const color = theme.featureSize;
  // The rim tells the two apart: dashed where faces do not count.
  const dash = name === 'fs1' ? 'dashed' : 'solid';
  items.spheres.push({ center, radius, color, opacity: 0.11, width: 1.8, dash });
  for (const witness of witnesses) {
    // Its own input segment lies beneath it, and would cover it.
    if (witness.kind !== 'segment' || witness.index !== own)
      append(items, featureItems(complex, witness, color));
    items.lines.push({ a: center, b: witness.at, color, width: 1.8, dash: 'dotted' });
    const ring = { fill: theme.background, stroke: color, width: 2 };
    items.marks.push({ at: witness.at, shape: 'disc', size: 9, ...ring });
  }
  items.marks.push({ at: center, shape: 'disc', size: 6, fill: color });
  const text = { size: 13, color: theme.ink, halo: theme.background };
  items.texts.push({
    at: center,
    text: ballNames[name],
    ...text,
    dx: name === 'fs1' ? -22 : 22,
    dy: 14,
  });
  return items;
}

function featureItems(complex: Complex3, { kind, index }: Witness3, color: string): SpaceItems {
  const items = noSpaceItems();
  const line = (v: number, w: number, width: number) => {
    const [a, b] = [complex.vertices[v], complex.vertices[w]];
    if (a && b) items.lines.push({ a, b, color, width, opacity: 0.6 });
  };
  const segment = kind === 'segment' ? complex.segments[index] : undefined;
  if (segment) line(segment[0], segment[1], 5);
  const face = kind === 'face' ? complex.faces[index] : undefined;
  for (const [v, w] of face ? sidesOf(face) : []) line(v, w, 4);
  return items;
}

/** From a vertex to what made it necessary, and so on to the input. */
export function chainItems(
  chain: readonly AncestryLink[],
  place: (v: number) => Point3,
  theme: PictureTheme,
): SpaceItems {
  const items = noSpaceItems();
  const color = theme.ancestry;
  for (const { vertex, parent } of chain) {
    const [a, b] = [place(vertex), place(parent)];
    items.lines.push({ a, b, color, width: 2 });
    items.marks.push({ at: b, from: a, shape: 'arrow', size: 12, fill: color });
  }
  return items;
}

export function append(to: SpaceItems, from: SpaceItems): void {
  to.triangles.push(...from.triangles);
  to.spheres.push(...from.spheres);
  to.lines.push(...from.lines);
  to.marks.push(...from.marks);
  to.texts.push(...from.texts);
}
