import { beforeEach, describe, expect, it } from 'vitest';
import { createEditor } from '../../web/src/editor/index';
import { type Editor, emptyComplex, type ToolId } from '../../web/src/shared/types';
import { complexOf, key, noSnap, pointer, square } from './editor-helpers';

let editor: Editor;

function start(tool: ToolId, complex = emptyComplex) {
  editor = createEditor(complex);
  editor.setTool(tool);
}

function click(x: number, y: number, more = {}) {
  editor.pointerMove(pointer(x, y, more));
  editor.pointerDown(pointer(x, y, more));
  editor.pointerUp(pointer(x, y, more));
}

function drag(from: [number, number], to: [number, number], more = {}) {
  editor.pointerDown(pointer(...from, more));
  editor.pointerMove(pointer((from[0] + to[0]) / 2, (from[1] + to[1]) / 2, more));
  editor.pointerMove(pointer(...to, more));
  editor.pointerUp(pointer(...to, more));
}

describe('point tool', () => {
  beforeEach(() => start('point'));

  it('sets a vertex where it is released', () => {
    drag([0.2, 0.2], [0.4, 0.6]);
    expect(editor.complex.vertices).toEqual([[0.4, 0.6]]);
    expect([...editor.selection.vertices]).toEqual([0]);
  });

  it('sets none where one is', () => {
    click(0.4, 0.4);
    click(0.41, 0.39);
    expect(editor.complex.vertices).toHaveLength(1);
  });

  it('splits the segment it is set on', () => {
    start('point', square);
    click(0.6, 0.01);
    expect(editor.complex.vertices[4]).toEqual([0.6, 0]);
    expect(editor.complex.segments).toHaveLength(5);
    editor.undo();
    expect(editor.complex).toEqual(square);
  });
});

describe('segment tool', () => {
  beforeEach(() => start('segment'));

  it('draws a chain by clicks, one step of undo each', () => {
    click(0, 0);
    click(1, 0);
    click(1, 1);
    expect(editor.complex.segments).toEqual([
      [0, 1],
      [1, 2],
    ]);
    editor.undo();
    expect(editor.complex.segments).toEqual([[0, 1]]);
    editor.undo();
    expect(editor.complex).toEqual(emptyComplex);
  });

  it('one click alone leaves nothing behind', () => {
    click(0, 0);
    expect(editor.sketch?.points).toHaveLength(2);
    editor.cancel();
    expect(editor.complex).toEqual(emptyComplex);
    expect(editor.canUndo).toBe(false);
  });

  it('draws one segment by drag', () => {
    drag([0, 0], [1, 0.6]);
    click(3, 3);
    editor.cancel();
    expect(editor.complex.segments).toEqual([[0, 1]]);
    expect(editor.complex.vertices).toHaveLength(2);
  });

  it('ends where the chain began', () => {
    click(0, 0);
    click(1, 0);
    click(0.4, 1);
    click(0.02, 0.02);
    expect(editor.complex.segments).toHaveLength(3);
    click(2, 2);
    expect(editor.complex.vertices).toHaveLength(3);
  });

  it('ends with Enter and with a double click', () => {
    click(0, 0);
    click(1, 0);
    expect(editor.keyDown(key('Enter'))).toBe(true);
    click(2, 2);
    click(3, 2);
    click(3, 2, { double: true });
    click(4, 4);
    editor.cancel();
    expect(editor.complex.segments).toHaveLength(2);
  });

  it('shows the crossings it would make', () => {
    start('segment', square);
    editor.setSnap(noSnap);
    click(0.5, -0.5);
    editor.pointerMove(pointer(0.5, 1.5));
    expect(editor.sketch?.crossings).toEqual([
      [0.5, 0],
      [0.5, 1],
    ]);
  });
});

describe('polygon tool', () => {
  beforeEach(() => start('polygon'));

  it('closes on its first corner, in one step of undo', () => {
    click(0, 0);
    click(1, 0);
    click(1, 1);
    expect(editor.complex).toEqual(emptyComplex);
    click(0.03, 0.04);
    expect(editor.complex.segments).toEqual([
      [0, 1],
      [1, 2],
      [2, 0],
    ]);
    editor.undo();
    expect(editor.complex).toEqual(emptyComplex);
  });

  it('closes with Enter, but not with two corners', () => {
    click(0, 0);
    click(1, 0);
    expect(editor.keyDown(key('Enter'))).toBe(false);
    click(1, 1);
    expect(editor.keyDown(key('Enter'))).toBe(true);
    expect(editor.complex.segments).toHaveLength(3);
  });

  it('takes a corner back with Backspace and drops all with Escape', () => {
    click(0, 0);
    click(1, 0);
    click(1, 1);
    editor.keyDown(key('Backspace'));
    click(0.6, 1);
    editor.keyDown(key('Enter'));
    expect(editor.complex.vertices[2]).toEqual([0.6, 1]);
    click(5, 5);
    expect(editor.keyDown(key('Escape'))).toBe(true);
    expect(editor.complex.vertices).toHaveLength(3);
    expect(editor.keyDown(key('Escape'))).toBe(false);
  });

  it('uses vertices and segments that are there', () => {
    start('polygon', square);
    click(1, 0);
    click(1.6, 0.4);
    click(1, 0.4);
    editor.keyDown(key('Enter'));
    expect(editor.complex.vertices).toHaveLength(6);
    // side 1-2 is now two pieces, one of them a side of the new polygon
    expect(editor.complex.segments).toHaveLength(7);
  });

  it('shows where it crosses itself', () => {
    click(0, 0);
    click(1, 0);
    click(1, 1);
    editor.pointerMove(pointer(0.4, -1));
    expect(editor.sketch?.crossings).toEqual([[expect.closeTo(0.7, 12), 0]]);
  });

  it('two corners on one segment cut it in three', () => {
    start('polygon', square);
    click(0.2, 0);
    click(0.8, 0);
    click(0.4, 0.4);
    editor.keyDown(key('Enter'));
    expect(editor.complex.vertices).toHaveLength(7);
    expect(editor.complex.segments).toHaveLength(8);
  });
});

describe('rectangle tool', () => {
  beforeEach(() => start('rectangle'));

  it('is drawn by drag or by two clicks, alike', () => {
    drag([0, 0], [2, 1]);
    const dragged = editor.complex;
    start('rectangle');
    click(0, 0);
    click(2, 1);
    expect(editor.complex).toEqual(dragged);
    expect(dragged.segments).toHaveLength(4);
  });

  it('is a square with Shift, and nothing if flat', () => {
    drag([0, 0], [2, 1], { shift: true });
    expect(editor.complex.vertices[2]).toEqual([2, 2]);
    start('rectangle');
    drag([0, 0], [2, 0]);
    editor.cancel();
    expect(editor.complex).toEqual(emptyComplex);
  });
});

describe('seeds', () => {
  it('lie where they are set, near a vertex too; regions count up', () => {
    start('hole', square);
    click(0.04, 0.03);
    expect(editor.complex.holes).toEqual([[0.04, 0.03]]);
    editor.setTool('region');
    click(0.5, 0.5);
    click(0.7, 0.7);
    expect(editor.complex.regions.map((r) => r.label)).toEqual([1, 2]);
  });
});

describe('select tool', () => {
  beforeEach(() => start('select', square));

  it('selects by click, adds and removes with Shift, clears on empty ground', () => {
    click(0, 0);
    expect([...editor.selection.vertices]).toEqual([0]);
    click(1, 1, { shift: true });
    expect([...editor.selection.vertices]).toEqual([0, 2]);
    click(0, 0, { shift: true });
    expect([...editor.selection.vertices]).toEqual([2]);
    click(0.5, 0.5);
    expect(editor.selection.vertices.size).toBe(0);
  });

  it('a box selects what is wholly inside', () => {
    drag([-0.5, -0.5], [1.5, 0.5]);
    expect([...editor.selection.vertices]).toEqual([0, 1]);
    expect([...editor.selection.segments]).toEqual([0]);
  });

  it('moves a vertex by drag, in one step of undo, and lands on the snap bit for bit', () => {
    drag([1, 1], [1.303, 1.298]);
    expect(editor.complex.vertices[2]).toEqual([1.4, 1.2]);
    editor.undo();
    expect(editor.complex).toEqual(square);
    expect(editor.canUndo).toBe(false);
  });

  it('moves both ends of a segment', () => {
    drag([0.5, 1], [0.5, 1.4]);
    expect(editor.complex.vertices[2]).toEqual([1, 1.4]);
    expect(editor.complex.vertices[3]).toEqual([0, 1.4]);
  });

  it('a vertex dropped on another becomes one with it', () => {
    drag([0, 1], [0.98, 0.99]);
    expect(editor.complex.vertices).toHaveLength(3);
    expect(editor.complex.segments).toHaveLength(3);
    editor.undo();
    expect(editor.complex).toEqual(square);
  });

  it('Escape in the middle of a drag puts everything back', () => {
    editor.pointerDown(pointer(1, 1));
    editor.pointerMove(pointer(1.5, 1.5));
    expect(editor.complex.vertices[2]).not.toEqual([1, 1]);
    editor.keyDown(key('Escape'));
    expect(editor.complex).toEqual(square);
    editor.pointerUp(pointer(1.5, 1.5));
    expect(editor.complex).toEqual(square);
    expect(editor.canUndo).toBe(false);
  });

  it('a press that trembles is a click, more so by finger', () => {
    drag([1, 1], [1.03, 1.0]);
    expect(editor.complex).toEqual(square);
    drag([1, 1], [1.08, 1.0], { touch: true });
    expect(editor.complex).toEqual(square);
  });

  it('a double click splits a segment', () => {
    click(0.4, 0);
    click(0.4, 0, { double: true });
    expect(editor.complex.vertices[4]).toEqual([0.4, 0]);
    expect(editor.complex.segments).toHaveLength(5);
  });

  it('moves a hole', () => {
    start('select', complexOf([], [], { holes: [[0.5, 0.5]] }));
    drag([0.5, 0.5], [0.8, 0.6]);
    expect(editor.complex.holes).toEqual([[0.8, 0.6]]);
    expect(editor.undoTitle).toBe('Move hole');
  });
});
