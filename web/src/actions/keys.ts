/** Shortcuts: how they are written, matched and shown. */

export interface KeyPress {
  readonly key: string;
  readonly code: string;
  readonly ctrlKey: boolean;
  readonly metaKey: boolean;
  readonly shiftKey: boolean;
  readonly altKey: boolean;
}

/** Does a key press match "Mod+Shift+Z"? Mod is Control, or Command on a Mac. Digits match by place, so that Shift keeps them. */
export function matches(shortcut: string, e: KeyPress): boolean {
  const parts = split(shortcut);
  const key = parts.pop()!;
  const wants = (modifier: string) => parts.includes(modifier);
  if (wants('Mod') !== (e.ctrlKey || e.metaKey)) return false;
  if (wants('Alt') !== e.altKey) return false;
  if (/^[0-9]$/.test(key)) return e.code === `Digit${key}` && wants('Shift') === e.shiftKey;
  const isCharacter = key.length === 1 && !/^[A-Za-z]$/.test(key);
  // Signs such as "?" and "+" are reached with Shift on some keyboards and without on others.
  if (!isCharacter && wants('Shift') !== e.shiftKey) return false;
  if (key === 'Space') return e.key === ' ';
  return e.key.length === 1 ? e.key.toUpperCase() === key.toUpperCase() : e.key === key;
}

/** Without a modifier a shortcut is a single key, which speech input can trip over: it can be turned off (WCAG 2.1.4). */
export function isSingleCharacter(shortcut: string): boolean {
  const key = split(shortcut).at(-1)!;
  return key.length === 1 && !shortcut.includes('Mod+') && !shortcut.includes('Alt+');
}

/** "Mod+Z" in parts; "+" itself is a key. */
function split(shortcut: string): string[] {
  return shortcut.split(/\+(?=.)/);
}

const isMac = typeof navigator !== 'undefined' && /Mac|iPhone|iPad/.test(navigator.platform);

const names: Readonly<Record<string, string>> = {
  Mod: isMac ? '⌘' : 'Ctrl',
  Shift: '⇧',
  Alt: isMac ? '⌥' : 'Alt',
  ArrowLeft: '←',
  ArrowRight: '→',
  ArrowUp: '↑',
  ArrowDown: '↓',
  Delete: 'Del',
  Escape: 'Esc',
  Enter: '↵',
};

/** "Mod+Shift+Z" as keys to show. */
export function keyCaps(shortcut: string): string[] {
  return split(shortcut).map(
    (part) => names[part] ?? (part.length === 1 ? part.toUpperCase() : part),
  );
}
