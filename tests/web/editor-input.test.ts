import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { attachInput, createEditor } from '../../web/src/editor/index';
import * as camera from '../../web/src/picture/view';
import type { Editor, Picture, Point, View } from '../../web/src/shared/types';
import { emptyComplex } from '../../web/src/shared/types';

const size = { width: 400, height: 300 };

/** As much of a canvas as pointer handling touches. */
class FakeCanvas extends EventTarget {
  readonly style: Record<string, string> = {};
  getBoundingClientRect() {
    return { left: 10, top: 20, width: size.width, height: size.height };
  }
  setPointerCapture() {}
}

let view: View;
let canvas: FakeCanvas;
let editor: Editor;
let editing: boolean;
let picks: Point[];
let menus: Point[];
let detach: () => void;

beforeEach(() => {
  vi.useFakeTimers();
  vi.stubGlobal('window', new EventTarget());
  vi.stubGlobal('document', { activeElement: null });
  view = { x: 0, y: 0, scale: 100 };
  canvas = new FakeCanvas();
  editor = createEditor(emptyComplex);
  editing = true;
  picks = [];
  menus = [];
  const picture = {
    canvas,
    getView: () => view,
    toWorld: (x: number, y: number) => camera.toWorld(view, size, x, y),
    zoomBy: (factor: number, at: Point) => {
      view = camera.zoomAt(view, size, factor, at, 1);
    },
    panBy: (dx: number, dy: number) => {
      view = camera.panBy(view, dx, dy);
    },
    pick: () => null,
  } as unknown as Picture;
  detach = attachInput(picture, editor, {
    editing: () => editing,
    onPick: (_, at) => picks.push(at),
    onMenu: (_, screen) => menus.push(screen),
  });
});

afterEach(() => {
  detach();
  vi.unstubAllGlobals();
  vi.useRealTimers();
});

let time = 0;

function send(type: string, x: number, y: number, more: Record<string, unknown> = {}) {
  const event = new Event(type, { cancelable: true });
  const fields = {
    clientX: x + 10,
    clientY: y + 20,
    pointerId: 1,
    pointerType: 'mouse',
    button: 0,
    ...more,
  };
  time += 5000;
  for (const [name, value] of Object.entries({ ...fields, timeStamp: time })) {
    Object.defineProperty(event, name, { value });
  }
  canvas.dispatchEvent(event);
  return event;
}

function drag(from: Point, to: Point, more = {}) {
  send('pointerdown', ...from, more);
  send('pointermove', (from[0] + to[0]) / 2, (from[1] + to[1]) / 2, more);
  send('pointermove', ...to, more);
  send('pointerup', ...to, more);
}

describe('input', () => {
  it('the wheel zooms about the pointer, and the page does not scroll', () => {
    const before = camera.toWorld(view, size, 300, 100);
    const event = send('wheel', 300, 100, { deltaY: -100, deltaMode: 0, deltaX: 0 });
    expect(event.defaultPrevented).toBe(true);
    expect(view.scale).toBeGreaterThan(100);
    const [x, y] = camera.toScreen(view, size, before);
    expect(x).toBeCloseTo(300, 9);
    expect(y).toBeCloseTo(100, 9);
  });

  it('while editing a drag goes to the tool', () => {
    editor.setTool('rectangle');
    drag([200, 150], [300, 50]);
    expect(editor.complex.vertices).toHaveLength(4);
    expect(editor.complex.vertices[2]).toEqual([1, 1]);
    expect(view).toEqual({ x: 0, y: 0, scale: 100 });
  });

  it('while watching a drag pans and a click picks', () => {
    editing = false;
    drag([200, 150], [250, 150]);
    expect(view.x).toBeLessThan(-0.3);
    expect(picks).toHaveLength(0);
    send('pointerdown', 100, 100);
    send('pointerup', 100, 100);
    expect(picks).toHaveLength(1);
  });

  it('the middle button pans while editing', () => {
    editor.setTool('point');
    drag([200, 150], [250, 150], { button: 1 });
    expect(view.x).toBeLessThan(0);
    expect(editor.complex.vertices).toHaveLength(0);
  });

  it('two fingers pan and zoom, keep what is under them, and drop what the tool began', () => {
    editor.setTool('segment');
    const finger = (pointerId: number) => ({ pointerId, pointerType: 'touch' });
    send('pointerdown', 100, 150, finger(1));
    send('pointerdown', 200, 150, finger(2));
    const left = camera.toWorld(view, size, 100, 150);
    const right = camera.toWorld(view, size, 200, 150);
    send('pointermove', 300, 150, finger(2));
    send('pointermove', 80, 120, finger(1));
    send('pointermove', 280, 120, finger(2));
    expect(view.scale).toBeCloseTo(200, 6);
    const [x0, y0] = camera.toScreen(view, size, left);
    const [x1, y1] = camera.toScreen(view, size, right);
    expect(Math.hypot(x0 - 80, y0 - 120)).toBeLessThan(1e-6);
    expect(Math.hypot(x1 - 280, y1 - 120)).toBeLessThan(1e-6);
    send('pointerup', 80, 120, finger(1));
    send('pointerup', 280, 120, finger(2));
    expect(editor.complex).toEqual(emptyComplex);
    expect(editor.sketch?.lines ?? []).toEqual([]);
  });

  it('a long press opens the menu and sets no vertex; a drag is no long press', () => {
    editor.setTool('point');
    send('pointerdown', 100, 100, { pointerType: 'touch' });
    vi.advanceTimersByTime(700);
    send('pointerup', 100, 100, { pointerType: 'touch' });
    expect(menus).toEqual([[100, 100]]);
    expect(editor.complex.vertices).toHaveLength(0);
    send('pointerdown', 100, 100, { pointerType: 'touch' });
    send('pointermove', 150, 100, { pointerType: 'touch' });
    vi.advanceTimersByTime(700);
    send('pointerup', 150, 100, { pointerType: 'touch' });
    expect(menus).toHaveLength(1);
    expect(editor.complex.vertices).toHaveLength(1);
  });

  it('a pointer that is taken away drops the edit', () => {
    editor.setTool('rectangle');
    send('pointerdown', 100, 100);
    send('pointermove', 200, 200);
    send('pointercancel', 200, 200);
    send('pointerup', 200, 200);
    expect(editor.complex).toEqual(emptyComplex);
    expect(editor.sketch?.lines ?? []).toEqual([]);
  });

  it('two clicks in a short time at one place are a double click', () => {
    editor.replace(
      {
        ...emptyComplex,
        vertices: [
          [-1, 0],
          [1, 0],
        ],
        segments: [[0, 1]],
      },
      'Open',
    );
    const click = (timeStamp: number) => {
      time = timeStamp - 5000;
      send('pointerdown', 230, 150);
      time = timeStamp - 5000 + 10;
      send('pointerup', 230, 150);
    };
    click(10_000);
    click(20_000);
    expect(editor.complex.segments).toHaveLength(1);
    click(20_200);
    expect(editor.complex.segments).toHaveLength(2);
  });

  it('after detaching nothing is heard', () => {
    detach();
    editor.setTool('point');
    drag([100, 100], [100, 100]);
    expect(editor.complex.vertices).toHaveLength(0);
  });
});
