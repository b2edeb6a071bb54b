/** An action: one record behind buttons, shortcuts and menus. */
export interface Action {
  readonly id: string;
  readonly title: string;
  /** What it would do now, where that says more than the title ("Undo: move 3 vertices"). */
  readonly now?: () => string;
  readonly group:
    | 'Play'
    | 'Jump'
    | 'Edit'
    | 'Tools'
    | 'View'
    | 'Space'
    | 'Overlays'
    | 'File'
    | 'Help';
  /** Shortcuts, the first one is shown: "Space", "ArrowLeft", "Mod+Z", "Shift+2", "?". */
  readonly keys: readonly string[];
  readonly enabled?: () => boolean;
  readonly pressed?: () => boolean;
  readonly perform: () => void;
}

export function titleOf(action: Action): string {
  return action.now?.() ?? action.title;
}

export function isEnabled(action: Action): boolean {
  return action.enabled?.() ?? true;
}
