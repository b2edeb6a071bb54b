import { app } from '../store/app.svelte.ts';
import { isSingleCharacter, matches } from './keys.ts';
import { actions } from './registry.ts';
import { isEnabled } from './types.ts';

/** One listener for the whole page. Fields keep their keys; a focused button or box to check keeps Space and Enter. */
export function handleKey(e: KeyboardEvent): void {
  if (e.defaultPrevented || app.dialog !== null || document.querySelector('.driver-active')) return;
  const target = e.target instanceof HTMLElement ? e.target : document.body;
  const isCommand = e.ctrlKey || e.metaKey;
  if (takesText(target) && !(isCommand && e.key === 'Enter')) return;
  if (
    target.closest('button, a, summary, [role=tab], input[type=checkbox], input[type=radio]') &&
    (e.key === ' ' || e.key === 'Enter') &&
    !isCommand
  )
    return;
  if (ownsArrows(target) && /^(Arrow|Home|End)/.test(e.key)) return;
  if (app.mode === 'draw' && isPictureOrPage(target) && editorTakes(e)) {
    e.preventDefault();
    return;
  }
  for (const action of actions) {
    if (
      !action.keys.some((k) => matches(k, e) && (app.settings.singleKeys || !isSingleCharacter(k)))
    )
      continue;
    if (!isEnabled(action)) continue; // the browser may have a use for the key
    e.preventDefault();
    action.perform();
    return;
  }
}

function editorTakes(e: KeyboardEvent): boolean {
  return app.doc.editor.keyDown({
    key: e.key,
    shift: e.shiftKey,
    alt: e.altKey,
    control: e.ctrlKey || e.metaKey,
    unitsPerPixel: 1 / (app.picture?.getView().scale ?? 1),
  });
}

function isPictureOrPage(target: HTMLElement): boolean {
  return target === document.body || target.tagName === 'CANVAS';
}

function takesText(target: HTMLElement): boolean {
  if (
    target.isContentEditable ||
    target instanceof HTMLTextAreaElement ||
    target instanceof HTMLSelectElement
  )
    return true;
  return (
    target instanceof HTMLInputElement &&
    !['checkbox', 'radio', 'range', 'button', 'file'].includes(target.type)
  );
}

function ownsArrows(target: HTMLElement): boolean {
  return (
    target.closest('[role=tab], [role=slider], [role=radiogroup], [role=listbox]') !== null ||
    (target instanceof HTMLInputElement && ['range', 'radio'].includes(target.type))
  );
}
