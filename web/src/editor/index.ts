/** The editor of a 2D complex. See shared/types.ts. */

import type { CreateEditor } from '../shared/types';
import { ComplexEditor } from './editor';

export const createEditor: CreateEditor = (initial) => new ComplexEditor(initial);

export { attachInput } from './input';
export { editorActions, editorKeys } from './keys';
