/** The tools at hand, in the order of the bar. */

import type { ToolId, ToolInfo } from '../../shared/types';
import { createPanTool } from './pan';
import { createPointTool } from './point';
import { createPolygonTool } from './polygon';
import { createRectangleTool } from './rectangle';
import { createSeedTool } from './seed';
import { createSegmentTool } from './segment';
import { createSelectTool } from './select';
import type { Tool, ToolContext } from './tool';

export const tools: readonly ToolInfo[] = [
  {
    id: 'select',
    title: 'Select and move',
    hint: 'Click or draw a box to select; drag to move. Shift adds, arrow keys nudge, double-click a segment to split it.',
    key: 'V',
    icon: 'M5 3l14 8-6.2 1.6L9.6 19z',
  },
  {
    id: 'point',
    title: 'Point',
    hint: 'Click to set a vertex; on a segment it splits it.',
    key: 'P',
    icon: 'M12 8.5a3.5 3.5 0 1 0 0 7a3.5 3.5 0 1 0 0-7M12 2v3M12 19v3M2 12h3M19 12h3',
  },
  {
    id: 'segment',
    title: 'Segments',
    hint: 'Click from vertex to vertex, or drag one segment; Enter or double-click ends the chain.',
    key: 'S',
    icon: 'M6.6 17.4L17.4 6.6M5 17a2 2 0 1 0 0 4a2 2 0 1 0 0-4M19 3a2 2 0 1 0 0 4a2 2 0 1 0 0-4',
  },
  {
    id: 'polygon',
    title: 'Polygon',
    hint: 'Click the corners; click the first one again, or press Enter, to close. Backspace takes one back.',
    key: 'G',
    icon: 'M12 3l8.5 6.4-3.2 10.1H6.7L3.5 9.4z',
  },
  {
    id: 'rectangle',
    title: 'Rectangle',
    hint: 'Drag from corner to corner, or click both; Shift makes a square.',
    key: 'R',
    icon: 'M4 6h16v12H4z',
  },
  {
    id: 'hole',
    title: 'Hole',
    hint: 'Click inside a closed part to leave it out of the mesh.',
    key: 'H',
    icon: 'M12 4a8 8 0 1 0 0 16a8 8 0 1 0 0-16M9 9l6 6M15 9l-6 6',
  },
  {
    id: 'region',
    title: 'Region',
    hint: 'Click inside a closed part to give it a label and a size of its own.',
    key: 'L',
    icon: 'M12 3l9 9-9 9-9-9zM12 11.2v1.6',
  },
  {
    id: 'pan',
    title: 'Pan',
    hint: 'Drag to move the view; the wheel or two fingers zoom.',
    key: 'M',
    icon: 'M12 3v18M3 12h18M12 3L9.5 5.5M12 3l2.5 2.5M12 21l-2.5-2.5M12 21l2.5-2.5M3 12l2.5-2.5M3 12l2.5 2.5M21 12l-2.5-2.5M21 12l-2.5 2.5',
  },
];

export function createTool(id: ToolId, context: ToolContext): Tool {
  switch (id) {
    case 'select':
      return createSelectTool(context);
    case 'point':
      return createPointTool(context);
    case 'segment':
      return createSegmentTool(context);
    case 'polygon':
      return createPolygonTool(context);
    case 'rectangle':
      return createRectangleTool(context);
    case 'hole':
      return createSeedTool(context, 'holes');
    case 'region':
      return createSeedTool(context, 'regions');
    case 'pan':
      return createPanTool();
  }
}
