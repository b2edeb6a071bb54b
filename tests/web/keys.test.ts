import { describe, expect, it } from 'vitest';
import { isSingleCharacter, type KeyPress, keyCaps, matches } from '../../web/src/actions/keys.ts';

function press(key: string, more: Partial<KeyPress> = {}): KeyPress {
  return { key, code: '', ctrlKey: false, metaKey: false, shiftKey: false, altKey: false, ...more };
}

describe('shortcuts', () => {
  it('match their key and nothing with another modifier', () => {
    expect(matches('k', press('k'))).toBe(true);
    expect(matches('k', press('k', { ctrlKey: true }))).toBe(false);
    expect(matches('Mod+Z', press('z', { ctrlKey: true }))).toBe(true);
    expect(matches('Mod+Z', press('z', { metaKey: true }))).toBe(true);
    expect(matches('Mod+Z', press('Z', { ctrlKey: true, shiftKey: true }))).toBe(false);
    expect(matches('Mod+Shift+Z', press('Z', { ctrlKey: true, shiftKey: true }))).toBe(true);
    expect(matches('Space', press(' '))).toBe(true);
  });

  it('match digits by place, with and without Shift, on every layout', () => {
    expect(matches('2', press('2', { code: 'Digit2' }))).toBe(true);
    expect(matches('Shift+2', press('"', { code: 'Digit2', shiftKey: true }))).toBe(true);
    expect(matches('2', press('"', { code: 'Digit2', shiftKey: true }))).toBe(false);
    expect(matches('2', press('é', { code: 'Digit2' }))).toBe(true);
  });

  it('match signs whether or not the layout needs Shift for them', () => {
    expect(matches('?', press('?', { shiftKey: true }))).toBe(true);
    expect(matches('+', press('+'))).toBe(true);
    expect(matches('+', press('+', { shiftKey: true }))).toBe(true);
  });

  it('know which of them are a single character', () => {
    expect(isSingleCharacter('k')).toBe(true);
    expect(isSingleCharacter('Shift+D')).toBe(true);
    expect(isSingleCharacter('Mod+S')).toBe(false);
    expect(isSingleCharacter('Space')).toBe(false);
    expect(isSingleCharacter('ArrowLeft')).toBe(false);
  });

  it('are shown as key caps', () => {
    expect(keyCaps('Mod+Shift+Z')).toEqual(['Ctrl', '⇧', 'Z']);
    expect(keyCaps('ArrowLeft')).toEqual(['←']);
  });
});
