import { describe, expect, it } from 'vitest';
import { createEditor, editorActions } from '../../web/src/editor/index';
import { type EditorChange, emptyComplex } from '../../web/src/shared/types';
import { complexOf, key, pointer, random, square } from './editor-helpers';

describe('history', () => {
  it('a thousand edits undo to the start and redo to the end', () => {
    const next = random(99);
    const editor = createEditor(square);
    const states = [JSON.stringify(editor.complex)];
    for (let i = 0; i < 1000; ++i) {
      const n = editor.complex.vertices.length;
      switch (Math.floor(next() * 6)) {
        case 0:
          editor.addPoint([next(), next()]);
          break;
        case 1:
          editor.addSegment(Math.floor(next() * n), Math.floor(next() * n));
          break;
        case 2:
          editor.select({ vertices: new Set([Math.floor(next() * n)]) });
          editor.moveSelection(next(), next());
          break;
        case 3:
          editor.select({ vertices: new Set([Math.floor(next() * n)]) });
          editor.duplicateSelection();
          break;
        case 4:
          editor.select({ vertices: new Set([Math.floor(next() * n)]) });
          if (n > 20) editor.deleteSelection();
          break;
        default:
          editor.setPosition('vertex', Math.floor(next() * n), [next(), next()]);
      }
      const state = JSON.stringify(editor.complex);
      if (state !== states.at(-1)) states.push(state);
    }
    for (let i = states.length - 2; i >= 0; --i) {
      editor.undo();
      expect(JSON.stringify(editor.complex)).toBe(states[i]);
    }
    expect(editor.canUndo).toBe(false);
    for (let i = 1; i < states.length; ++i) {
      editor.redo();
      expect(JSON.stringify(editor.complex)).toBe(states[i]);
    }
    expect(editor.canRedo).toBe(false);
  });

  it('a new edit ends what could be redone', () => {
    const editor = createEditor(emptyComplex);
    editor.addPoint([1, 2]);
    editor.undo();
    expect(editor.redoTitle).toBe('Add vertex');
    editor.addPoint([3, 4]);
    expect(editor.canRedo).toBe(false);
  });

  it('undo brings the selection back', () => {
    const editor = createEditor(square);
    editor.select({ vertices: new Set([1, 3]) });
    editor.deleteSelection();
    expect(editor.selection.vertices.size).toBe(0);
    editor.undo();
    expect([...editor.selection.vertices]).toEqual([1, 3]);
  });

  it('nudges in a row are one step; another selection starts another', () => {
    const editor = createEditor(square);
    editor.select({ vertices: new Set([0]) });
    editor.keyDown(key('ArrowLeft'));
    editor.keyDown(key('ArrowLeft'));
    editor.keyDown(key('ArrowUp'));
    expect(editor.complex.vertices[0]).toEqual([-0.4, 0.2]);
    editor.select({ vertices: new Set([1]) });
    editor.keyDown(key('ArrowLeft', { shift: true }));
    expect(editor.complex.vertices[1]).toEqual([0, 0]);
    editor.undo();
    expect(editor.complex.vertices[0]).toEqual([-0.4, 0.2]);
    editor.undo();
    expect(editor.complex).toEqual(square);
    expect(editor.canUndo).toBe(false);
  });

  it('is stored and restored, and goes on from there', () => {
    const editor = createEditor(square);
    editor.addPoint([0.5, 0.5]);
    editor.select({ vertices: new Set([0, 4]) });
    editor.joinSelection(false);
    editor.undo();
    const other = createEditor(emptyComplex);
    expect(other.restore(editor.serialize())).toBe(true);
    expect(other.complex).toEqual(editor.complex);
    other.redo();
    expect(other.complex.segments.at(-1)).toEqual([0, 4]);
    other.addPoint([9, 9]);
    other.undo();
    other.undo();
    other.undo();
    expect(other.complex).toEqual(square);
  });

  it('what is not its own text is refused and changes nothing', () => {
    const editor = createEditor(square);
    const good = JSON.parse(editor.serialize());
    for (const text of [
      '',
      'null',
      '{}',
      JSON.stringify({ ...good, version: 2 }),
      JSON.stringify({ ...good, document: { vertices: [{}] } }),
      JSON.stringify({ ...good, history: { done: [{ command: 1 }], undone: [] } }),
    ]) {
      expect(editor.restore(text)).toBe(false);
    }
    expect(editor.complex).toEqual(square);
  });
});

describe('keyboard', () => {
  it('draws a polygon with arrow keys and Enter alone', () => {
    const editor = createEditor(emptyComplex);
    editor.setTool('polygon');
    const walk = (name: string, times: number) => {
      for (let i = 0; i < times; ++i) editor.keyDown(key(name));
    };
    walk('ArrowRight', 1);
    editor.keyDown(key('Enter'));
    walk('ArrowRight', 3);
    editor.keyDown(key('Enter'));
    walk('ArrowUp', 3);
    editor.keyDown(key('Enter'));
    expect(editor.complex.vertices).toHaveLength(0);
    editor.keyDown(key('Enter')); // again at the same place: close
    expect(editor.complex.vertices).toHaveLength(3);
    expect(editor.complex.segments).toHaveLength(3);
  });

  it('selects and moves without a pointer', () => {
    const editor = createEditor(square);
    editor.keyDown(key(']'));
    editor.keyDown(key(']'));
    expect([...editor.selection.vertices]).toEqual([1]);
    editor.keyDown(key(']', { shift: true }));
    expect([...editor.selection.vertices]).toEqual([1, 2]);
    editor.keyDown(key('ArrowUp'));
    expect(editor.complex.vertices[1]).toEqual([1, 0.2]);
    editor.keyDown(key('Escape'));
    expect(editor.selection.vertices.size).toBe(0);
    editor.keyDown(key('['));
    expect([...editor.selection.vertices]).toEqual([3]);
  });

  it('leaves commands of the page alone', () => {
    const editor = createEditor(square);
    for (const name of ['z', 'a', 'Tab', 'F1', 'Delete']) {
      expect(editor.keyDown(key(name, { control: name.length === 1 }))).toBe(false);
    }
    expect(editor.keyDown(key('ArrowLeft', { control: true }))).toBe(false);
  });

  it('the cursor goes when the pointer comes', () => {
    const editor = createEditor(square);
    editor.setTool('point');
    editor.keyDown(key('ArrowRight'));
    expect(editor.sketch?.cursor).not.toBeNull();
    editor.pointerMove(pointer(0.2, 0.2));
    expect(editor.sketch?.cursor).toBeNull();
  });
});

describe('editor', () => {
  it('joins the selection in the order in which it was made', () => {
    const editor = createEditor(
      complexOf([
        [0, 0],
        [1, 0],
        [2, 0],
      ]),
    );
    editor.select({ vertices: new Set([2, 0, 1]) });
    editor.joinSelection(true);
    expect(editor.complex.segments).toEqual([
      [2, 0],
      [0, 1],
      [1, 2],
    ]);
  });

  it('tells what changed, and nothing after unsubscribing', () => {
    const editor = createEditor(square);
    const heard: EditorChange[] = [];
    const stop = editor.subscribe((change) => heard.push(change));
    editor.addPoint([3, 3]);
    editor.setTool('pan');
    expect(heard.some((c) => c.document)).toBe(true);
    expect(heard.some((c) => c.tool)).toBe(true);
    stop();
    const count = heard.length;
    editor.undo();
    expect(heard).toHaveLength(count);
  });

  it('gives the same complex and selection object until they change', () => {
    const editor = createEditor(square);
    const { complex, selection } = editor;
    expect(editor.complex).toBe(complex);
    expect(editor.selection).toBe(selection);
    editor.addPoint([3, 3]);
    expect(editor.complex).not.toBe(complex);
  });

  it('actions are enabled when they can do something', () => {
    const editor = createEditor(square);
    const join = editorActions(editor).find((a) => a.id === 'join')!;
    expect(join.enabled()).toBe(false);
    editor.select({ vertices: new Set([0, 2]) });
    expect(join.enabled()).toBe(true);
    join.perform();
    expect(editor.complex.segments).toHaveLength(5);
  });

  it('splits crossings on request, in one step', () => {
    const editor = createEditor(square);
    editor.paste(
      complexOf(
        [
          [-1, 0.5],
          [2, 0.5],
        ],
        [[0, 1]],
      ),
    );
    expect(editor.splitCrossings()).toBe(2);
    expect(editor.complex.segments).toHaveLength(4 + 2 + 3);
    expect(editor.splitCrossings()).toBe(0);
    editor.undo();
    editor.undo();
    expect(editor.complex).toEqual(square);
  });
});
