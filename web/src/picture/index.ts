/** The picture: what the page shows of a complex, its mesh and its moment. See shared/types.ts. */

import type { CreatePicture } from '../shared/types';
import { CanvasPicture } from './picture';

export const createPicture: CreatePicture = (canvas, options) => new CanvasPicture(canvas, options);

export { formatLength } from './layers/grid-layer';
