import { NONE } from './event.ts';

/**
 * Finds the number of a live simplex by its vertices: open addressing with linear probing over four 32-bit keys.
 * A JavaScript Map would want a string or a bigint for each of a million triangles.
 */
export class SimplexTable {
  private keys = new Uint32Array(4 * 1024);
  private values = new Int32Array(1024).fill(-1);
  private mask = 1023;
  private size = 0;

  get(a: number, b: number, c: number, d: number = NONE): number {
    return this.values[this.slot(a, b, c, d)]!;
  }

  set(a: number, b: number, c: number, value: number): void {
    this.set4(a, b, c, NONE, value);
  }

  set4(a: number, b: number, c: number, d: number, value: number): void {
    if (2 * (this.size + 1) > this.values.length) this.grow();
    const slot = this.slot(a, b, c, d);
    if (this.values[slot] === -1) {
      this.size++;
      this.keys[4 * slot] = a;
      this.keys[4 * slot + 1] = b;
      this.keys[4 * slot + 2] = c;
      this.keys[4 * slot + 3] = d;
    }
    this.values[slot] = value;
  }

  /** Removes a simplex and returns its number, -1 if there is none. */
  take(a: number, b: number, c: number, d: number = NONE): number {
    const { keys } = this;
    let hole = this.slot(a, b, c, d);
    const value = this.values[hole]!;
    if (value === -1) return -1;
    this.size--;
    // Backward shift: entries after the hole that were pushed past it move up, so that no tombstones are needed.
    let next = hole;
    for (;;) {
      next = (next + 1) & this.mask;
      if (this.values[next] === -1) break;
      const k = 4 * next;
      const home = this.hash(keys[k]!, keys[k + 1]!, keys[k + 2]!, keys[k + 3]!);
      if (((next - home) & this.mask) < ((next - hole) & this.mask)) continue;
      keys.copyWithin(4 * hole, k, k + 4);
      this.values[hole] = this.values[next]!;
      hole = next;
    }
    this.values[hole] = -1;
    return value;
  }

  private hash(a: number, b: number, c: number, d: number): number {
    let h = Math.imul(a, 0x9e3779b1) ^ Math.imul(b, 0x85ebca77) ^ Math.imul(c, 0xc2b2ae3d);
    h ^= Math.imul(d, 0x27d4eb2f);
    h ^= h >>> 15;
    h = Math.imul(h, 0x2c1b3c6d);
    h ^= h >>> 13;
    return h & this.mask;
  }

  private slot(a: number, b: number, c: number, d: number): number {
    const { keys } = this;
    let i = this.hash(a, b, c, d);
    while (this.values[i] !== -1) {
      const k = 4 * i;
      if (keys[k] === a && keys[k + 1] === b && keys[k + 2] === c && keys[k + 3] === d) break;
      i = (i + 1) & this.mask;
    }
    return i;
  }

  private grow(): void {
    const { keys, values } = this;
    this.keys = new Uint32Array(2 * keys.length);
    this.values = new Int32Array(2 * values.length).fill(-1);
    this.mask = this.values.length - 1;
    this.size = 0;
    for (let i = 0; i < values.length; i++) {
      if (values[i] === -1) continue;
      const k = 4 * i;
      this.set4(keys[k]!, keys[k + 1]!, keys[k + 2]!, keys[k + 3]!, values[i]!);
    }
  }
}
