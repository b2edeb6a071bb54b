/** Typed arrays that grow by doubling: a trace arrives in pieces and its length is not known beforehand. */

export class GrowU32 {
  data: Uint32Array;
  length = 0;
  constructor(capacity = 1024) {
    this.data = new Uint32Array(capacity);
  }
  reserve(length: number): void {
    if (length <= this.data.length) return;
    const next = new Uint32Array(Math.max(length, this.data.length * 2));
    next.set(this.data.subarray(0, this.length));
    this.data = next;
  }
  push(value: number): void {
    if (this.length === this.data.length) this.reserve(this.length + 1);
    this.data[this.length++] = value;
  }
  at(i: number): number {
    return this.data[i]!;
  }
}

export class GrowU8 {
  data: Uint8Array;
  length = 0;
  constructor(capacity = 1024) {
    this.data = new Uint8Array(capacity);
  }
  reserve(length: number): void {
    if (length <= this.data.length) return;
    const next = new Uint8Array(Math.max(length, this.data.length * 2));
    next.set(this.data.subarray(0, this.length));
    this.data = next;
  }
  push(value: number): void {
    if (this.length === this.data.length) this.reserve(this.length + 1);
    this.data[this.length++] = value;
  }
}

export class GrowF64 {
  data: Float64Array;
  length = 0;
  constructor(capacity = 1024) {
    this.data = new Float64Array(capacity);
  }
  reserve(length: number): void {
    if (length <= this.data.length) return;
    const next = new Float64Array(Math.max(length, this.data.length * 2));
    next.set(this.data.subarray(0, this.length));
    this.data = next;
  }
  /** Sets an entry beyond the end; what lies between is 0. */
  set(i: number, value: number): void {
    if (i >= this.length) {
      this.reserve(i + 1);
      this.length = i + 1;
    }
    this.data[i] = value;
  }
}
