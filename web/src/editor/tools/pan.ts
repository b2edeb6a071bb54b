/** The hand: pans the view. The navigation does it; the tool only keeps clicks from doing anything else. */

import type { Tool } from './tool';

export function createPanTool(): Tool {
  return {
    down: () => false,
    move: () => false,
    up: () => false,
    key: () => false,
    cancel: () => false,
    sketch: null,
  };
}
