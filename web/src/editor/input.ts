/** Pointer, wheel and touch of the canvas: navigation first, then the editor or the inspector. */

import type { AttachInput, EditorPointer, Point } from '../shared/types';
import { isDrag } from './tools/tool';

/** Wheel of 100 (a notch of a mouse) zooms by e^0.2; a pinch of a trackpad comes as a wheel with Control, finer. */
const wheelRate = 0.002;
const pinchRate = 0.01;
const longPressMs = 550;
const doubleClickMs = 350;

interface Contact {
  readonly id: number;
  readonly touch: boolean;
  readonly start: Point;
  at: Point;
  moved: boolean;
}

export const attachInput: AttachInput = (picture, editor, options) => {
  const canvas = picture.canvas;
  const contacts = new Map<number, Contact>();
  let mode: 'none' | 'edit' | 'pan' | 'pinch' = 'none';
  let space = false;
  let longPress: ReturnType<typeof setTimeout> | undefined;
  let lastPress: { at: Point; time: number } | null = null;

  const place = (e: MouseEvent): Point => {
    const box = canvas.getBoundingClientRect();
    return [e.clientX - box.left, e.clientY - box.top];
  };

  function pointer(e: MouseEvent, screen: Point, touch: boolean, double = false): EditorPointer {
    return {
      at: picture.toWorld(screen[0], screen[1]),
      screen,
      unitsPerPixel: 1 / picture.getView().scale,
      touch,
      shift: e.shiftKey,
      alt: e.altKey,
      control: e.ctrlKey || e.metaKey,
      double,
    };
  }

  function isDouble(screen: Point, time: number, touch: boolean): boolean {
    const double =
      lastPress !== null &&
      time - lastPress.time < doubleClickMs &&
      !isDrag(lastPress.at, screen, touch);
    lastPress = double ? null : { at: screen, time };
    return double;
  }

  function down(e: PointerEvent): void {
    if (e.pointerType === 'mouse' && e.button === 2) return; // the menu
    const at = place(e);
    const touch = e.pointerType === 'touch';
    canvas.setPointerCapture(e.pointerId);
    contacts.set(e.pointerId, { id: e.pointerId, touch, start: at, at, moved: false });
    clearTimeout(longPress);
    if (contacts.size === 2) {
      if (mode === 'edit') editor.cancel();
      mode = 'pinch';
      return;
    }
    if (contacts.size > 2) return;
    const drawing = options.editing() && editor.tool !== 'pan';
    if (e.button === 1 || space || !drawing) {
      mode = 'pan';
      canvas.style.cursor = 'grabbing';
      if (e.button === 1) e.preventDefault();
    } else {
      mode = 'edit';
      editor.pointerDown(pointer(e, at, touch, isDouble(at, e.timeStamp, touch)));
    }
    if (touch) longPress = setTimeout(() => openMenu(e.pointerId, at), longPressMs);
  }

  function openMenu(id: number, at: Point): void {
    const contact = contacts.get(id);
    if (!contact || contact.moved || contacts.size !== 1) return;
    if (mode === 'edit') editor.cancel();
    mode = 'none';
    options.onMenu?.(picture.toWorld(at[0], at[1]), at);
  }

  function move(e: PointerEvent): void {
    const at = place(e);
    const contact = contacts.get(e.pointerId);
    options.onHover?.(picture.toWorld(at[0], at[1]));
    if (!contact) {
      if (options.editing() && e.pointerType !== 'touch') {
        editor.pointerMove(pointer(e, at, false));
      }
      setCursor();
      return;
    }
    const before = contact.at;
    if (isDrag(contact.start, at, contact.touch)) {
      contact.moved = true;
      clearTimeout(longPress);
    }
    if (mode === 'pinch') pinch(contact, at);
    contact.at = at;
    if (mode === 'pan' && contact.moved) picture.panBy(at[0] - before[0], at[1] - before[1]);
    else if (mode === 'edit') editor.pointerMove(pointer(e, at, contact.touch));
  }

  /** Two fingers pan by their middle and zoom by their distance, each kept under the finger that holds it. */
  function pinch(contact: Contact, at: Point): void {
    const other = [...contacts.values()].find((c) => c !== contact);
    if (!other) return;
    const distance = (p: Point) => Math.hypot(p[0] - other.at[0], p[1] - other.at[1]);
    const from = distance(contact.at);
    const middle = (p: Point): Point => [(p[0] + other.at[0]) / 2, (p[1] + other.at[1]) / 2];
    const [m0, m1] = [middle(contact.at), middle(at)];
    picture.panBy(m1[0] - m0[0], m1[1] - m0[1]);
    if (from > 8) picture.zoomBy(distance(at) / from, m1);
  }

  function up(e: PointerEvent): void {
    const contact = contacts.get(e.pointerId);
    if (!contact) return;
    clearTimeout(longPress);
    contacts.delete(e.pointerId);
    const at = place(e);
    if (mode === 'edit') editor.pointerUp(pointer(e, at, contact.touch));
    if (mode === 'pan' && !contact.moved && e.button === 0 && !options.editing()) {
      options.onPick(picture.pick(at[0], at[1]), picture.toWorld(at[0], at[1]));
    }
    // The finger that is left after a pinch goes on panning.
    mode = contacts.size === 1 && mode === 'pinch' ? 'pan' : contacts.size === 0 ? 'none' : mode;
    if (mode === 'pan') for (const left of contacts.values()) left.moved = true;
    setCursor();
  }

  function lost(e: PointerEvent): void {
    if (!contacts.delete(e.pointerId)) return;
    clearTimeout(longPress);
    if (mode === 'edit') editor.cancel();
    mode = 'none';
  }

  function wheel(e: WheelEvent): void {
    e.preventDefault();
    const unit = e.deltaMode === 1 ? 33 : e.deltaMode === 2 ? 300 : 1;
    if (e.shiftKey && !e.ctrlKey) {
      picture.panBy(-(e.deltaX || e.deltaY) * unit, 0);
      return;
    }
    const rate = e.ctrlKey ? pinchRate : wheelRate;
    picture.zoomBy(Math.exp(-e.deltaY * unit * rate), place(e));
  }

  function menu(e: MouseEvent): void {
    if (!options.onMenu) return;
    e.preventDefault();
    const at = place(e);
    options.onMenu(picture.toWorld(at[0], at[1]), at);
  }

  function key(e: KeyboardEvent): void {
    if (e.key === ' ') {
      space = e.type === 'keydown' && document.activeElement === canvas && options.editing();
      setCursor();
    }
  }

  function blur(): void {
    space = false;
  }

  function leave(): void {
    options.onHover?.(null);
  }

  function setCursor(): void {
    const tool = options.editing() ? editor.tool : 'pan';
    canvas.style.cursor =
      mode === 'pan'
        ? 'grabbing'
        : tool === 'pan' || space
          ? 'grab'
          : tool === 'select'
            ? 'default'
            : 'crosshair';
  }

  const stopTool = editor.subscribe((change) => {
    if (change.tool) setCursor();
  });
  canvas.style.touchAction = 'none';
  setCursor();
  const bindings: [EventTarget, string, (e: never) => void, AddEventListenerOptions?][] = [
    [canvas, 'pointerdown', down],
    [canvas, 'pointermove', move],
    [canvas, 'pointerup', up],
    [canvas, 'pointercancel', lost],
    [canvas, 'pointerleave', leave],
    [canvas, 'wheel', wheel, { passive: false }],
    [canvas, 'contextmenu', menu],
    [window, 'keydown', key],
    [window, 'keyup', key],
    [window, 'blur', blur],
  ];
  for (const [target, name, handler, how] of bindings) {
    target.addEventListener(name, handler as EventListener, how);
  }
  return () => {
    clearTimeout(longPress);
    stopTool();
    for (const [target, name, handler] of bindings) {
      target.removeEventListener(name, handler as EventListener);
    }
  };
};
