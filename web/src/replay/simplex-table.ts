/**
 * Finds the number of a live simplex by its vertices: open addressing with linear probing over three 32-bit keys.
 * A JavaScript Map would want a string or a bigint for each of a million triangles.
 */
export class SimplexTable {
  private keys = new Uint32Array(3 * 1024);
  private values = new Int32Array(1024).fill(-1);
  private mask = 1023;
  private size = 0;

  get(a: number, b: number, c: number): number {
    return this.values[this.slot(a, b, c)]!;
  }

  set(a: number, b: number, c: number, value: number): void {
    if (2 * (this.size + 1) > this.values.length) this.grow();
    const slot = this.slot(a, b, c);
    if (this.values[slot] === -1) {
      this.size++;
      this.keys[3 * slot] = a;
      this.keys[3 * slot + 1] = b;
      this.keys[3 * slot + 2] = c;
    }
    this.values[slot] = value;
  }

  /** Removes a simplex and returns its number, -1 if there is none. */
  take(a: number, b: number, c: number): number {
    let hole = this.slot(a, b, c);
    const value = this.values[hole]!;
    if (value === -1) return -1;
    this.size--;
    // Backward shift: entries after the hole that were pushed past it move up, so that no tombstones are needed.
    let next = hole;
    for (;;) {
      next = (next + 1) & this.mask;
      if (this.values[next] === -1) break;
      const home = this.hash(
        this.keys[3 * next]!,
        this.keys[3 * next + 1]!,
        this.keys[3 * next + 2]!,
      );
      if (((next - home) & this.mask) < ((next - hole) & this.mask)) continue;
      this.keys.copyWithin(3 * hole, 3 * next, 3 * next + 3);
      this.values[hole] = this.values[next]!;
      hole = next;
    }
    this.values[hole] = -1;
    return value;
  }

  private hash(a: number, b: number, c: number): number {
    let h = Math.imul(a, 0x9e3779b1) ^ Math.imul(b, 0x85ebca77) ^ Math.imul(c, 0xc2b2ae3d);
    h ^= h >>> 15;
    h = Math.imul(h, 0x2c1b3c6d);
    h ^= h >>> 13;
    return h & this.mask;
  }

  private slot(a: number, b: number, c: number): number {
    let i = this.hash(a, b, c);
    while (
      this.values[i] !== -1 &&
      (this.keys[3 * i] !== a || this.keys[3 * i + 1] !== b || this.keys[3 * i + 2] !== c)
    ) {
      i = (i + 1) & this.mask;
    }
    return i;
  }

  private grow(): void {
    const keys = this.keys;
    const values = this.values;
    this.keys = new Uint32Array(2 * keys.length);
    this.values = new Int32Array(2 * values.length).fill(-1);
    this.mask = this.values.length - 1;
    this.size = 0;
    for (let i = 0; i < values.length; i++) {
      if (values[i] !== -1) this.set(keys[3 * i]!, keys[3 * i + 1]!, keys[3 * i + 2]!, values[i]!);
    }
  }
}
