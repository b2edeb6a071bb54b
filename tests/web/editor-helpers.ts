import type { Complex2, EditorPointer, Point } from '../../web/src/shared/types';

export const noSnap = { vertex: false, segment: false, grid: false, angle: false, gridStep: 0 };
export const allSnap = { vertex: true, segment: true, grid: true, angle: true, gridStep: 0 };

/** A pointer over a canvas of 100 pixels a unit. */
export function pointer(x: number, y: number, more: Partial<EditorPointer> = {}): EditorPointer {
  return {
    at: [x, y],
    screen: [100 * x, -100 * y],
    unitsPerPixel: 0.01,
    touch: false,
    shift: false,
    alt: false,
    control: false,
    double: false,
    ...more,
  };
}

export function key(
  name: string,
  more: { shift?: boolean; alt?: boolean; control?: boolean } = {},
) {
  return { key: name, shift: false, alt: false, control: false, unitsPerPixel: 0.01, ...more };
}

export function complexOf(
  vertices: Point[],
  segments: [number, number][] = [],
  more: Partial<Complex2> = {},
): Complex2 {
  return { vertices, segments, holes: [], regions: [], ...more };
}

export const square = complexOf(
  [
    [0, 0],
    [1, 0],
    [1, 1],
    [0, 1],
  ],
  [
    [0, 1],
    [1, 2],
    [2, 3],
    [3, 0],
  ],
);

/** Random numbers in [0, 1) that are the same everywhere. */
export function random(seed: number): () => number {
  let state = seed >>> 0;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 4294967296;
  };
}
