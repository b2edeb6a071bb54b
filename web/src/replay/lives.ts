import { NEVER } from '../shared/types.ts';
import { GrowU8, GrowU32 } from './grow.ts';
import { SimplexTable } from './simplex-table.ts';

/**
 * Simplices of one sort that ever lived, numbered by birth, each with its label and the events that it lived between; and what
 * each event changed: the dead, then the born. A record is four numbers wide at most.
 */
export class Lives {
  /** `stride` numbers a simplex. */
  readonly vertices = new GrowU32();
  readonly label = new GrowU8();
  readonly born = new GrowU32();
  readonly died = new GrowU32();
  /** Event i changed those from `changeStart[i]` to `changeStart[i + 1]`, the first `changeDead[i]` of them died. */
  readonly changes = new GrowU32();
  readonly changeStart = new GrowU32();
  readonly changeDead = new GrowU32();
  private dead = 0;
  private readonly alive = new SimplexTable();

  constructor(readonly stride: 3 | 4) {
    this.changeStart.push(0);
  }

  get count(): number {
    return this.label.length;
  }

  /** The record r names one simplex: it lies in its canonical order (`canonical` below). */
  bear(r: Readonly<Record4>, key: Readonly<Record4>, label: number, event: number): void {
    const number = this.count;
    for (let k = 0; k < this.stride; k++) this.vertices.push(r[k]!);
    this.label.push(label);
    this.born.push(event);
    this.died.push(NEVER);
    this.alive.set4(key[0], key[1], key[2], key[3], number);
    this.changes.push(number);
  }

  /** False if there is no such simplex. */
  kill(key: Readonly<Record4>, event: number): boolean {
    const number = this.alive.take(key[0], key[1], key[2], key[3]);
    if (number < 0) return false;
    this.died.data[number] = event;
    this.changes.push(number);
    this.dead++;
    return true;
  }

  /** Ends the changes of an event; to be called once for each. */
  close(): void {
    this.changeDead.push(this.dead);
    this.changeStart.push(this.changes.length);
    this.dead = 0;
  }

  changed(event: number): { died: Uint32Array; born: Uint32Array } {
    const start = this.changeStart.at(event);
    const middle = start + this.changeDead.at(event);
    const end = this.changeStart.at(event + 1);
    return {
      died: this.changes.data.slice(start, middle),
      born: this.changes.data.slice(middle, end),
    };
  }
}

export type Record4 = [number, number, number, number];

/** Rotated so that the smallest vertex comes first: one name for a triangle, orientation kept. */
export function canonical(a: number, b: number, c: number): [number, number, number] {
  if (a < b && a < c) return [a, b, c];
  return b < c ? [b, c, a] : [c, a, b];
}

/** The vertices of a tetrahedron in ascending order: its name. Its orientation is always positive, and kept elsewhere. */
export function ascending(a: number, b: number, c: number, d: number): Record4 {
  // Five comparisons sort four numbers.
  let [p, q, r, s] = [a, b, c, d];
  if (p > q) [p, q] = [q, p];
  if (r > s) [r, s] = [s, r];
  if (p > r) [p, r] = [r, p];
  if (q > s) [q, s] = [s, q];
  if (q > r) [q, r] = [r, q];
  return [p, q, r, s];
}

/** Which of them live at a position, as a dense list: moved by changes when the goal is near, else scanned. */
export class LiveSet {
  list = new Uint32Array(1024);
  count = 0;
  private slot = new Int32Array(1024).fill(-1);

  constructor(private readonly lives: Lives) {}

  apply(event: number, forward: boolean): void {
    this.reserve();
    const { died, born } = this.lives.changed(event);
    for (const n of forward ? died : born) this.remove(n);
    for (const n of forward ? born : died) this.add(n);
  }

  /** O(ever born). */
  scan(position: number): void {
    this.reserve();
    const born = this.lives.born.data;
    const died = this.lives.died.data;
    const { count } = this.lives;
    this.slot.fill(-1);
    this.count = 0;
    for (let n = 0; n < count; n++) {
      if (born[n]! >= position) break; // numbers are in order of birth
      if (died[n] === NEVER || position <= died[n]!) this.add(n);
    }
  }

  private add(n: number): void {
    this.slot[n] = this.count;
    this.list[this.count++] = n;
  }

  private remove(n: number): void {
    const hole = this.slot[n]!;
    const last = this.list[--this.count]!;
    this.list[hole] = last;
    this.slot[last] = hole;
    this.slot[n] = -1;
  }

  private reserve(): void {
    const need = this.lives.count;
    if (need <= this.slot.length) return;
    const size = Math.max(need, 2 * this.slot.length);
    const slot = new Int32Array(size).fill(-1);
    slot.set(this.slot);
    this.slot = slot;
    const list = new Uint32Array(size);
    list.set(this.list.subarray(0, this.count));
    this.list = list;
  }
}
