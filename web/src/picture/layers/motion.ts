/**
 * The motion that explains an insertion: the cavity opens, the vertex lands, the new edges are drawn. It is an opaque
 * cover over the picture of the state after the event, so nothing below has to know of it; taken back, it runs
 * backwards.
 */

import type { MeshChange, MeshState, PictureTheme, Point } from '../../shared/types';
import { mix } from '../color';
import { type Items, noItems } from '../items';

export interface Motion {
  readonly dead: readonly (readonly [Point, Point, Point])[];
  readonly born: readonly (readonly [Point, Point, Point])[];
  readonly vertex: number;
  readonly at: Point | null;
  /** Ends of the new edges. */
  readonly spokes: readonly Point[];
  readonly forward: boolean;
  readonly milliseconds: number;
}

/** Between 150 and 250 ms the eye follows without waiting. */
const duration = 230;
/** Part of the time between two events that a motion may take, so that it rests before the next. */
const busy = 0.9;
/** Shorter than this a motion is only flicker. */
const shortest = 70;
/** Changes of more triangles are shown at once. */
const largest = 400;

/**
 * `speed` in events a second. Null if the change is not to be animated. Copies what it needs: the arrays belong to
 * the replay.
 */
export function makeMotion(state: MeshState, change: MeshChange, speed: number): Motion | null {
  const milliseconds = Math.min(duration, (busy * 1000) / speed);
  if (milliseconds < shortest) return null;
  if (change.vertex < 0 || change.died.length + change.born.length === 0) return null;
  if (change.died.length + change.born.length > largest) return null;
  const place = (v: number): Point => [state.coordinates[2 * v]!, state.coordinates[2 * v + 1]!];
  const corners = (t: number) => {
    const [a, b, c] = [0, 1, 2].map((k) => place(state.cells[3 * t + k]!));
    return [a!, b!, c!] as const;
  };
  const spokes = new Set<number>();
  for (const t of change.born) {
    for (let k = 0; k < 3; ++k) {
      const v = state.cells[3 * t + k]!;
      if (v !== change.vertex) spokes.add(v);
    }
  }
  return {
    dead: Array.from(change.died, corners),
    born: Array.from(change.born, corners),
    vertex: change.vertex,
    at: place(change.vertex),
    spokes: Array.from(spokes, place),
    forward: change.forward,
    milliseconds,
  };
}

const smooth = (t: number, from: number, to: number) => {
  const x = Math.min(Math.max((t - from) / (to - from), 0), 1);
  return x * x * (3 - 2 * x);
};

/** The cover at part t in [0, 1] of the way. */
export function motionItems(motion: Motion, t: number, theme: PictureTheme): Items {
  const items = noItems();
  const time = motion.forward ? t : 1 - t;
  const opening = smooth(time, 0, 0.4);
  const drawn = smooth(time, 0.35, 0.85);
  const cover = motion.forward ? 1 - smooth(time, 0.8, 1) : 1 - smooth(1 - time, 0.8, 1);
  const tint = mix(theme.fill, theme.died, 0.3 * (1 - 0.6 * drawn) * smooth(time, 0, 0.15));
  for (const points of motion.dead) items.polygons.push({ points, fill: tint, opacity: cover });
  if (opening < 1) {
    for (const [a, b, c] of motion.dead) {
      for (const [p, q] of [
        [a, b],
        [b, c],
        [c, a],
      ] as const) {
        items.lines.push({
          a: p,
          b: q,
          color: mix(theme.edge, theme.died, smooth(time, 0, 0.15)),
          width: 1.2,
          opacity: (1 - opening) * cover,
        });
      }
    }
  }
  if (motion.at && drawn > 0) {
    for (const spoke of motion.spokes) {
      items.lines.push({
        a: motion.at,
        b: [
          motion.at[0] + (spoke[0] - motion.at[0]) * drawn,
          motion.at[1] + (spoke[1] - motion.at[1]) * drawn,
        ],
        color: theme.born,
        width: 1.8,
        opacity: cover,
      });
    }
  }
  return items;
}

/** Size of the landing vertex: it comes down from above, a little past its size, and settles. */
export function landingSize(motion: Motion, t: number): number {
  const time = motion.forward ? t : 1 - t;
  const seen = smooth(time, 0.15, 0.4);
  return seen * (1 + 1.4 * (1 - smooth(time, 0.2, 0.75)));
}
