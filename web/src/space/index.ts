/** The picture of space: what the page shows of a 3D complex, its mesh and its moment. See types.ts. */

import type { PictureOptions } from '../shared/types';
import { CanvasSpacePicture } from './picture';
import type { SpacePicture } from './types';

/** Throws if WebGL 2 is not to be had. */
export function createSpacePicture(
  canvas: HTMLCanvasElement,
  options: PictureOptions,
): SpacePicture {
  return new CanvasSpacePicture(canvas, options);
}

export { attachOrbit } from './input';
