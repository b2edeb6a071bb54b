import { type ColorMode, colorModes, type Point3 } from '../shared/types.ts';
import {
  type ClipAxis,
  type ClipLook,
  defaultLook,
  type SharedLook,
  type SpaceLook,
} from '../space/types.ts';

const axes: Record<'x' | 'y' | 'z', Point3> = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] };

/** Layers of tetrahedra that can be taken off. */
export const MOST_LAYERS = 12;

/** How space is looked at: what is drawn of faces and cells, the clip plane, how far cells are apart. */
export class SpaceSettings {
  look = $state.raw<SpaceLook>(defaultLook);
  private opened = false;

  set(change: Partial<SpaceLook>): void {
    this.look = { ...this.look, ...change };
  }

  /**
   * All tetrahedra together are a wall: with the first ones a plane across the second axis opens them, towards who looks from the
   * front.
   */
  showCells(shown: boolean): void {
    const { clip, cells } = this.look;
    this.set({ cells: shown });
    if (!shown || cells || clip || this.opened) return;
    this.opened = true;
    this.set({ clip: { axis: 'y', normal: axes.y, offset: 0.5, flipped: true, exact: false } });
  }

  /** `towards`: from what is looked at to the eye, for a plane across the line of sight. */
  clip(axis: ClipAxis | null, towards: Point3 = [0, 0, 1]): void {
    if (axis === null) {
      this.set({ clip: null });
      return;
    }
    const { clip } = this.look;
    const normal = axis === 'view' ? towards : axes[axis];
    const { offset, flipped, exact } = clip ?? { offset: 0.5, flipped: false, exact: false };
    this.set({ clip: { axis, normal, offset, flipped, exact } });
  }

  setClip(change: Partial<ClipLook>): void {
    const { clip } = this.look;
    if (clip) this.set({ clip: { ...clip, ...change } });
  }

  /** Moves the plane by a part of its way; false if there is none. */
  slide(by: number): boolean {
    const { clip } = this.look;
    if (!clip) return false;
    const offset = Math.min(1, Math.max(0, clip.offset + (clip.flipped ? -by : by)));
    if (by !== 0) this.setClip({ offset });
    return true;
  }

  shared(): SharedLook {
    const { highlight: _, ...look } = this.look;
    return look;
  }

  /** From a link: what is not as it should be stays as at a first visit. */
  adopt(shared: SharedLook): void {
    const { faces, clip, shrink, peel, color } = shared;
    const flag = (
      name: 'facets' | 'cells' | 'outside' | 'vertices' | 'collars' | 'surfaces' | 'labels',
    ) => (typeof shared[name] === 'boolean' ? shared[name] : defaultLook[name]);
    this.look = {
      faces: faces === 'solid' || faces === 'hidden' ? faces : 'translucent',
      facets: flag('facets'),
      cells: flag('cells'),
      outside: flag('outside'),
      vertices: flag('vertices'),
      collars: flag('collars'),
      surfaces: flag('surfaces'),
      labels: flag('labels'),
      clip: isClip(clip) ? clip : null,
      shrink: typeof shrink === 'number' && shrink >= 0 && shrink <= 1 ? shrink : 0,
      peel: Number.isInteger(peel) && peel! >= 0 && peel! <= MOST_LAYERS ? peel! : 0,
      color: colorModes[3].includes(color as ColorMode) ? (color as ColorMode) : 'plain',
      highlight: null,
    };
  }
}

function isClip(x: unknown): x is ClipLook {
  if (typeof x !== 'object' || x === null) return false;
  const { axis, normal, offset, flipped, exact } = x as Record<string, unknown>;
  return (
    ['x', 'y', 'z', 'view'].includes(axis as string) &&
    Array.isArray(normal) &&
    normal.length === 3 &&
    normal.every((n) => Number.isFinite(n)) &&
    typeof offset === 'number' &&
    offset >= 0 &&
    offset <= 1 &&
    typeof flipped === 'boolean' &&
    typeof exact === 'boolean'
  );
}
