/** Pointer, wheel and touch of the canvas in space. */

import { isDrag } from '../editor/tools/tool';
import type { Point } from '../shared/types';
import type { SpaceHit, SpacePicture } from './types';

/** Wheel of 100 (a notch of a mouse) zooms by e^0.2; a pinch of a trackpad comes as a wheel with Control, finer. */
const wheelRate = 0.002;
const pinchRate = 0.01;

interface Contact {
  readonly id: number;
  readonly touch: boolean;
  readonly start: Point;
  at: Point;
  moved: boolean;
}

export interface OrbitOptions {
  readonly onPick: (hit: SpaceHit | null) => void;
  /** A drag with Alt moves the clip plane, if there is one: pixels upwards. False: there is none. */
  readonly onSlide: (by: number) => boolean;
}

/**
 * A drag orbits; with the right or middle button or Shift it pans; two fingers pan by their middle and zoom by their distance; the
 * wheel zooms at the pointer. Returns a function that unbinds.
 */
export function attachOrbit(picture: SpacePicture, options: OrbitOptions): () => void {
  const { canvas } = picture;
  const contacts = new Map<number, Contact>();
  let mode: 'none' | 'orbit' | 'pan' | 'slide' | 'pinch' = 'none';

  const place = (e: MouseEvent): Point => {
    const box = canvas.getBoundingClientRect();
    return [e.clientX - box.left, e.clientY - box.top];
  };

  function down(e: PointerEvent): void {
    const at = place(e);
    const touch = e.pointerType === 'touch';
    canvas.setPointerCapture(e.pointerId);
    contacts.set(e.pointerId, { id: e.pointerId, touch, start: at, at, moved: false });
    if (contacts.size > 1) {
      mode = 'pinch';
      return;
    }
    if (e.button === 1) e.preventDefault();
    mode =
      e.button !== 0 || e.shiftKey ? 'pan' : e.altKey && options.onSlide(0) ? 'slide' : 'orbit';
    canvas.style.cursor = mode === 'slide' ? 'ns-resize' : 'grabbing';
  }

  function move(e: PointerEvent): void {
    const contact = contacts.get(e.pointerId);
    if (!contact) return;
    const at = place(e);
    const before = contact.at;
    if (isDrag(contact.start, at, contact.touch)) contact.moved = true;
    if (mode === 'pinch') pinch(contact, at);
    contact.at = at;
    if (!contact.moved) return;
    const [dx, dy] = [at[0] - before[0], at[1] - before[1]];
    if (mode === 'orbit') picture.orbitBy(dx, dy);
    else if (mode === 'pan') picture.panBy(dx, dy);
    else if (mode === 'slide') options.onSlide(-dy);
  }

  function pinch(contact: Contact, at: Point): void {
    const other = [...contacts.values()].find((c) => c !== contact);
    if (!other) return;
    const distance = (p: Point) => Math.hypot(p[0] - other.at[0], p[1] - other.at[1]);
    const middle = (p: Point): Point => [(p[0] + other.at[0]) / 2, (p[1] + other.at[1]) / 2];
    const from = distance(contact.at);
    const [m0, m1] = [middle(contact.at), middle(at)];
    picture.panBy(m1[0] - m0[0], m1[1] - m0[1]);
    if (from > 8) picture.zoomBy(distance(at) / from, m1);
  }

  function up(e: PointerEvent): void {
    const contact = contacts.get(e.pointerId);
    if (!contact) return;
    contacts.delete(e.pointerId);
    const at = place(e);
    if (mode !== 'pinch' && !contact.moved && e.button === 0)
      options.onPick(picture.pick(at[0], at[1]));
    // The finger that is left after a pinch goes on turning.
    mode = contacts.size === 0 ? 'none' : contacts.size === 1 ? 'orbit' : 'pinch';
    for (const left of contacts.values()) left.moved = true;
    if (mode === 'none') canvas.style.cursor = 'grab';
  }

  function lost(e: PointerEvent): void {
    contacts.delete(e.pointerId);
    if (contacts.size === 0) mode = 'none';
  }

  function wheel(e: WheelEvent): void {
    e.preventDefault();
    const unit = e.deltaMode === 1 ? 33 : e.deltaMode === 2 ? 300 : 1;
    if (e.altKey && options.onSlide((-e.deltaY * unit) / 4)) return;
    const rate = e.ctrlKey ? pinchRate : wheelRate;
    picture.zoomBy(Math.exp(-e.deltaY * unit * rate), place(e));
  }

  const menu = (e: MouseEvent) => e.preventDefault(); // the right button pans

  canvas.style.touchAction = 'none';
  canvas.style.cursor = 'grab';
  const bindings: [string, (e: never) => void, AddEventListenerOptions?][] = [
    ['pointerdown', down],
    ['pointermove', move],
    ['pointerup', up],
    ['pointercancel', lost],
    ['wheel', wheel, { passive: false }],
    ['contextmenu', menu],
  ];
  for (const [name, handler, how] of bindings)
    canvas.addEventListener(name, handler as EventListener, how);
  return () => {
    for (const [name, handler] of bindings)
      canvas.removeEventListener(name, handler as EventListener);
  };
}
