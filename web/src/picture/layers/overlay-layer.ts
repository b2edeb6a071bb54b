/**
 * Overlays as display lists: each a function of the facts it shows, of where vertices lie, and of the theme. What lies flat
 * (disks, bands) is drawn below the input's features, marks and words above all.
 */

import type {
  AncestryLink,
  CollarSimplex,
  FaceCollar,
  FeatureBall,
  FeatureField,
  Intestine,
  NeighborRing,
  Spindle,
} from '../../shared/overlay-facts';
import type { PictureTheme, Point } from '../../shared/types';
import { contours } from '../field';
import { type Items, noItems } from '../items';

export interface OverlayLook {
  readonly theme: PictureTheme;
  readonly pixel: number; // a CSS pixel in world units
  readonly place: (v: number) => Point | null;
}

/** N(q0) / lfs(q0) lies between (Theorem 3.2) and (Theorems 2.3 and 3.3); rounded lengths, so with kLengthSlack of the core. */
export function neighborInBounds(ratio: number): boolean {
  return ratio >= 0.5 * (1 - 1e-10) && ratio <= Math.SQRT2 * (1 + 1e-10);
}

/** Contours of lfs, each with its value once or twice. */
export function fieldItems(field: FeatureField, { theme, pixel }: OverlayLook): Items {
  const items = noItems();
  const taken: Point[] = [];
  for (const { level, segments } of contours(field)) {
    for (const [a, b] of segments) {
      items.lines.push({ a, b, color: theme.featureSize, width: 1, opacity: 0.6 });
    }
    // Words where there is room: at least a hand away from each other.
    let left = 2;
    for (let i = 0; i < segments.length && left > 0; ++i) {
      const at = segments[(Math.floor(segments.length / 3) + i) % segments.length]![0];
      if (taken.some((p) => Math.hypot(p[0] - at[0], p[1] - at[1]) < 48 * pixel)) continue;
      taken.push(at);
      --left;
      items.texts.push({
        at,
        text: String(level),
        size: 11,
        color: theme.ink,
        dx: 0,
        dy: -4,
        anchor: 'middle',
        halo: theme.background,
      });
    }
  }
  return items;
}

/** The ball: solid, its two witnesses ringed and joined to its center by dotted lines, segments that touch it in heavy stroke. */
export function ballItems(
  ball: FeatureBall,
  { theme }: OverlayLook,
): { under: Items; over: Items } {
  const under = noItems();
  const over = noItems();
  if (Number.isFinite(ball.radius)) {
    under.disks.push({
      center: ball.center,
      radius: ball.radius,
      stroke: theme.featureSize,
      width: 2.2,
      fill: theme.featureSize,
      fillOpacity: 0.1,
    });
  }
  for (const { kind, ends, at } of ball.witnesses) {
    const [a, b] = ends;
    if (kind === 'segment' && a && b) {
      under.lines.push({ a, b, color: theme.witness, width: 9, opacity: 0.35 });
    }
    over.lines.push({ a: ball.center, b: at, color: theme.witness, width: 2.2, dash: 'dotted' });
    over.marks.push({ at, shape: 'disc', size: 17, stroke: theme.witness, width: 2.4 });
  }
  over.marks.push({
    at: ball.center,
    shape: 'plus',
    size: 13,
    stroke: theme.ink,
    width: 2,
  });
  return { under, over };
}

/** Circles of fewer pixels say nothing. */
const smallestRing = 5;
const smallestLabel = 18;

/** Two circles about each input vertex: N solid, lfs dashed; the ratio as a number, in a triangle where it leaves its bounds. */
export function neighborItems(
  rings: readonly NeighborRing[],
  { theme, pixel, place }: OverlayLook,
): { under: Items; over: Items } {
  const under = noItems();
  const over = noItems();
  const taken: Point[] = [];
  for (const { vertex, nearest, lfs, promised } of rings) {
    const center = place(vertex);
    if (!center || !Number.isFinite(nearest)) continue;
    const known = Number.isFinite(lfs) && lfs > 0;
    const ratio = nearest / lfs;
    const flagged = known && !neighborInBounds(ratio);
    const flag = promised ? theme.defect : theme.warning;
    if (Math.max(nearest, known ? lfs : 0) > smallestRing * pixel) {
      under.disks.push({
        center,
        radius: nearest,
        stroke: theme.neighbor,
        width: 1.4,
      });
      if (known) {
        under.disks.push({
          center,
          radius: lfs,
          stroke: theme.featureSize,
          width: 1.6,
          dash: 'dashed',
        });
      }
    }
    if (flagged) {
      over.marks.push({ at: center, shape: 'triangle', size: 19, stroke: flag, width: 2.2 });
    }
    const roomy = nearest > smallestLabel * pixel || flagged;
    const free = !taken.some(
      (p) => Math.abs(p[0] - center[0]) < 40 * pixel && Math.abs(p[1] - center[1]) < 15 * pixel,
    );
    if (known && roomy && free) {
      taken.push(center);
      over.texts.push({
        at: center,
        text: ratio.toFixed(ratio < 10 ? 2 : 0),
        size: 12,
        color: flagged && promised ? theme.defect : theme.ink,
        dx: 11,
        dy: -13,
        anchor: 'start',
        halo: theme.background,
      });
    }
  }
  return { under, over };
}

/** A band along each subsegment of the spindle, s itself darker; its apexes ringed. */
export function spindleItems(
  spindle: Spindle,
  { theme, place }: OverlayLook,
): { under: Items; over: Items } {
  const under = noItems();
  const over = noItems();
  for (const [i, [v, w]] of spindle.subsegments.entries()) {
    const a = place(v);
    const b = place(w);
    if (!a || !b) continue;
    under.lines.push({ a, b, color: theme.spindle, width: i === 0 ? 15 : 11, opacity: 0.4 });
    if (i === 0) {
      under.disks.push({
        center: [a[0] + (b[0] - a[0]) / 2, a[1] + (b[1] - a[1]) / 2],
        radius: Math.hypot(b[0] - a[0], b[1] - a[1]) / 2,
        stroke: theme.spindle,
        width: 1.4,
        dash: 'dashed',
      });
    }
  }
  for (const v of spindle.apexes) {
    const at = place(v);
    if (at) over.marks.push({ at, shape: 'diamond', size: 17, stroke: theme.spindle, width: 2.4 });
  }
  return { under, over };
}

/** Collar simplices in heavy stroke, each with its diametral disk, which stays empty. */
export function collarItems(
  collars: readonly CollarSimplex[],
  { theme, place }: OverlayLook,
): Items {
  const items = noItems();
  for (const { center, end } of collars) {
    const a = place(center);
    const b = place(end);
    if (!a || !b) continue;
    items.disks.push({
      center: [a[0] + (b[0] - a[0]) / 2, a[1] + (b[1] - a[1]) / 2],
      radius: Math.hypot(b[0] - a[0], b[1] - a[1]) / 2,
      stroke: theme.collar,
      width: 1.6,
      dash: 'dashed',
      fill: theme.collar,
      fillOpacity: 0.09,
    });
    items.lines.push({ a, b, color: theme.collar, width: 8, opacity: 0.6 });
  }
  return items;
}

/** Pixels by which chords may leave an arc. */
const sagitta = 0.15;

/** The protecting disk dotted, the arcs that bound what is refined in heavy stroke, their ends as ticks. */
export function intestineItems(
  intestines: readonly Intestine[],
  { theme, pixel, place }: OverlayLook,
): Items {
  const items = noItems();
  for (const { center, radius, arcs } of intestines) {
    const at = place(center);
    if (!at) continue;
    items.disks.push({
      center: at,
      radius,
      stroke: theme.intestine,
      width: 1.2,
      dash: 'dotted',
      fill: theme.intestine,
      fillOpacity: 0.1,
    });
    for (const [v, w] of arcs) {
      const a = place(v);
      const b = place(w);
      if (!a || !b) continue;
      const points = arcPoints(at, radius, a, b, pixel);
      for (let i = 0; i + 1 < points.length; ++i) {
        const [p, q] = [points[i]!, points[i + 1]!];
        items.lines.push({ a: p, b: q, color: theme.intestine, width: 3.4 });
      }
      for (const p of [a, b]) {
        const dx = ((p[0] - at[0]) / radius) * 6 * pixel;
        const dy = ((p[1] - at[1]) / radius) * 6 * pixel;
        items.lines.push({
          a: [p[0] - dx, p[1] - dy],
          b: [p[0] + dx, p[1] + dy],
          color: theme.intestine,
          width: 2,
        });
      }
    }
  }
  return items;
}

/** Counter-clockwise from a to b about the center; so many points that the eye sees an arc. */
export function arcPoints(
  center: Point,
  radius: number,
  a: Point,
  b: Point,
  pixel: number,
): Point[] {
  const from = Math.atan2(a[1] - center[1], a[0] - center[0]);
  const to = Math.atan2(b[1] - center[1], b[0] - center[0]);
  const turn = (to - from + 2 * Math.PI) % (2 * Math.PI);
  const step = 2 * Math.acos(Math.max(1 - (sagitta * pixel) / radius, 0));
  const count = Math.min(Math.max(Math.ceil(turn / Math.max(step, 1e-9)), 1), 256);
  const points: Point[] = [a];
  for (let i = 1; i < count; ++i) {
    const angle = from + (turn * i) / count;
    points.push([center[0] + radius * Math.cos(angle), center[1] + radius * Math.sin(angle)]);
  }
  points.push(b);
  return points;
}

/** An arrow from each vertex to the parent that caused it, the oldest at the end of the chain ringed. */
export function ancestryItems(
  links: readonly AncestryLink[],
  { theme, pixel, place }: OverlayLook,
): Items {
  const items = noItems();
  for (const { vertex, parent } of links) {
    const a = place(vertex);
    const b = place(parent);
    if (!a || !b) continue;
    const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
    const visible = length > 14 * pixel;
    items.lines.push({ a, b, color: theme.ancestry, width: 2.6, opacity: 0.9 });
    if (visible) {
      // The tip stops at the rim of the mark, so that the mark stays to be seen.
      const t = 1 - (7 * pixel) / length;
      items.marks.push({
        at: [a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t],
        shape: 'arrow',
        size: 11,
        fill: theme.ancestry,
        angle: Math.atan2(b[1] - a[1], b[0] - a[0]),
      });
    }
  }
  const root = links.length > 0 ? place(links.at(-1)!.parent) : null;
  if (root) {
    items.marks.push({ at: root, shape: 'disc', size: 17, stroke: theme.ancestry, width: 2.6 });
  }
  return items;
}

/** The collar of one face: its triangles shaded, what bounds it in its color, arcs as arcs; protected pieces of segments as bands. */
export function faceCollarItems(
  { triangles, pieces, segments, arcs }: FaceCollar,
  { theme, pixel, place }: OverlayLook,
): Items {
  const items = noItems();
  const color = theme.collar;
  for (const corners of triangles) {
    const points = corners.map(place).filter((p): p is Point => p !== null);
    if (points.length === 3)
      items.polygons.push({ points, fill: color, opacity: theme.dark ? 0.3 : 0.22 });
  }
  const line = (a: Point | null, b: Point | null, width: number, opacity = 1) => {
    if (a && b) items.lines.push({ a, b, color, width, opacity });
  };
  for (const [a, b] of pieces) line(place(a), place(b), 9, 0.35);
  for (const [a, b] of segments) line(place(a), place(b), 2.4);
  for (const { center, ends } of arcs) {
    const [c, a, b] = [place(center), place(ends[0]), place(ends[1])];
    if (!c || !a || !b) continue;
    // The shorter way around.
    const turns = (a[0] - c[0]) * (b[1] - c[1]) > (a[1] - c[1]) * (b[0] - c[0]);
    const radius = Math.hypot(a[0] - c[0], a[1] - c[1]);
    const points = arcPoints(c, radius, turns ? a : b, turns ? b : a, pixel);
    for (let i = 1; i < points.length; ++i) line(points[i - 1]!, points[i]!, 2.4);
  }
  return items;
}
