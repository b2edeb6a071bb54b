/** What the keyboard does in the editor: actions for the page's registry, and keys for its help sheet. */

import type { Editor } from '../shared/types';

/** Has the shape of the page's own actions. */
export interface EditorAction {
  readonly id: string;
  readonly title: string;
  readonly group: 'Edit';
  readonly keys: readonly string[];
  readonly enabled: () => boolean;
  readonly perform: () => void;
}

/** Edits that have no other home: each drag of the mouse has one of these, or a key below, beside it. */
export function editorActions(editor: Editor): EditorAction[] {
  const group = 'Edit';
  const vertices = () => editor.selection.vertices.size;
  const any = () => {
    const { segments, holes, regions } = editor.selection;
    return vertices() + segments.size + holes.size + regions.size > 0;
  };
  return [
    {
      id: 'join',
      title: 'Join selected vertices by segments',
      group,
      keys: ['j'],
      enabled: () => vertices() >= 2,
      perform: () => editor.joinSelection(false),
    },
    {
      id: 'close',
      title: 'Join selected vertices to a polygon',
      group,
      keys: ['Shift+j'],
      enabled: () => vertices() >= 3,
      perform: () => editor.joinSelection(true),
    },
    {
      id: 'clear-selection',
      title: 'Clear the selection',
      group,
      keys: [],
      enabled: any,
      perform: () => editor.clearSelection(),
    },
  ];
}

/** Keys that `Editor.keyDown` takes while the picture has the focus. */
export const editorKeys: readonly { readonly keys: readonly string[]; readonly does: string }[] = [
  {
    keys: ['ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown'],
    does: 'Move the selection by a step of the grid, or the cursor if nothing is selected',
  },
  { keys: ['Shift+ArrowRight'], does: 'Five steps' },
  { keys: ['Alt+ArrowRight'], does: 'A tenth of a step' },
  {
    keys: ['Enter'],
    does: 'Press at the cursor; once more at the same place ends a chain or closes a polygon',
  },
  { keys: ['['], does: 'Select the previous vertex (Shift: as well)' },
  { keys: [']'], does: 'Select the next vertex (Shift: as well)' },
  { keys: ['Backspace'], does: 'Take back the last corner of a polygon' },
  { keys: ['Escape'], does: 'Drop what the tool is doing; then clear the selection' },
  { keys: ['Shift'], does: 'While drawing: keep to 45 degrees' },
  { keys: ['Alt'], does: 'While drawing: snap to nothing' },
];
