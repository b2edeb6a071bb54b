import { NEVER, VertexKind } from '../shared/types.ts';
import { EVENT_BYTES, Kind, NONE, Reason, type TraceEvent } from './event.ts';
import { GrowF64, GrowU8, GrowU32 } from './grow.ts';
import { QueueHistory } from './queue.ts';
import { SimplexTable } from './simplex-table.ts';

/** What the trace is about: the input that the numbers refer to. */
export interface TraceInput {
  readonly vertexCount: number;
  readonly segments: readonly (readonly [number, number])[];
}

/**
 * A trace as it arrives from the core, decoded once. Everything that ever lived gets a number and the interval of
 * positions in which it lived, so that the state at any position is a scan over intervals and needs no keyframes:
 * a thing is alive at position p iff born < p <= died.
 */
export class Trace {
  readonly steps: string[] = [];
  eventCount = 0;

  readonly coordinates = new GrowF64();
  readonly vertexKind = new GrowU8();
  readonly vertexBorn = new GrowU32();
  readonly vertexStep = new GrowU8();
  /** Insertion radius of each vertex (thesis 2.3), and the event that made it tells the parent simplex. */
  readonly vertexRadius = new GrowF64();
  vertexCount = 0;

  readonly triangles = new GrowU32();
  readonly triangleLabel = new GrowU8();
  readonly triangleBorn = new GrowU32();
  readonly triangleDied = new GrowU32();
  get triangleCount(): number {
    return this.triangleLabel.length;
  }

  readonly subsegments = new GrowU32();
  readonly subsegmentBorn = new GrowU32();
  readonly subsegmentDied = new GrowU32();
  get subsegmentCount(): number {
    return this.subsegmentBorn.length;
  }

  /** Numbers of the triangles that event i changed: the dead, then the born; `changeStart[i]` … `changeStart[i + 1]`. */
  readonly changes = new GrowU32();
  readonly changeStart = new GrowU32();
  readonly changeDead = new GrowU32();

  /** How many events of a kind lie before event i: counts, density and jumps are differences of these. */
  readonly insertedBefore = new GrowU32();
  readonly refusedBefore = new GrowU32();
  readonly yieldedBefore = new GrowU32();

  /** First event of each stretch of one step. */
  readonly stepStarts: { step: number; event: number }[] = [];
  readonly queue = new QueueHistory();

  private boxCorners = 0;
  private bytes = new Uint8Array(64 * 1024);
  private words = new Uint32Array(this.bytes.buffer);
  private doubles = new Float64Array(this.bytes.buffer);
  private readonly liveTriangles = new SimplexTable();
  private readonly liveSubsegments = new SimplexTable();

  constructor(readonly input: TraceInput) {
    for (const [i, [a, b]] of input.segments.entries()) this.bearSubsegment(a, b, i, 0);
    this.insertedBefore.push(0);
    this.refusedBefore.push(0);
    this.yieldedBefore.push(0);
    this.changeStart.push(0);
  }

  /** Takes the next part. The simplex stream holds (dimension + 2) numbers for each simplex. */
  append(events: Uint8Array, simplices: Uint32Array, steps: readonly string[]): void {
    const count = Math.floor(events.byteLength / EVENT_BYTES);
    this.reserveEvents(this.eventCount + count);
    this.bytes.set(events.subarray(0, count * EVENT_BYTES), this.eventCount * EVENT_BYTES);
    for (const [i, step] of steps.entries()) this.steps[i] = step;
    let stream = 0;
    for (let i = 0; i < count; i++) stream = this.decode(this.eventCount++, simplices, stream);
  }

  kind(i: number): number {
    return this.bytes[i * EVENT_BYTES]!;
  }
  step(i: number): number {
    return this.bytes[i * EVENT_BYTES + 3]!;
  }
  reason(i: number): number {
    return this.bytes[i * EVENT_BYTES + 2]!;
  }

  event(index: number): TraceEvent {
    const byte = index * EVENT_BYTES;
    const word = index * 16;
    const double = index * 8;
    const dimension = this.bytes[byte + 1]!;
    const simplex: number[] = [];
    for (let k = 0; k <= dimension && dimension > 0 && k < 3; k++) {
      const v = this.words[word + 1 + k]!;
      if (v !== NONE) simplex.push(v);
    }
    return {
      index,
      kind: this.bytes[byte]!,
      dimension,
      reason: this.bytes[byte + 2]!,
      step: this.bytes[byte + 3]!,
      simplex,
      segment: dimension === 1 ? this.words[word + 4]! : NONE,
      center: dimension === 1 ? this.words[word + 3]! : NONE,
      subject: this.words[word + 5]!,
      other: [this.words[word + 6]!, this.words[word + 7]!],
      at: [this.doubles[double + 4]!, this.doubles[double + 5]!],
      value: this.doubles[double + 7]!,
    };
  }

  private decode(i: number, simplices: Uint32Array, start: number): number {
    const event = this.event(i);
    const last = this.stepStarts.at(-1);
    if (!last || last.step !== event.step) this.stepStarts.push({ step: event.step, event: i });
    let stream = start;
    let dead = 0;
    this.queue.record(event);
    if (event.kind === Kind.inserted || event.kind === Kind.relabeled) {
      if (event.kind === Kind.inserted) this.bearVertex(event);
      const [deadCount, bornCount] = event.other;
      const isRelabel = event.kind === Kind.relabeled;
      const skipped = new Set<number>();
      for (let k = 0; k < deadCount; k++, stream += 4) {
        if (this.killTriangle(simplices, stream, i)) dead++;
        // A relabeled triangle may be listed twice; it is one change.
        else if (isRelabel) skipped.add(k);
        else throw new Error(`event ${i}: a triangle died that never lived`);
      }
      for (let k = 0; k < bornCount; k++, stream += 4) {
        if (!skipped.has(k)) this.bearTriangle(simplices, stream, i);
      }
    }
    this.changeDead.push(dead);
    this.changeStart.push(this.changes.length);
    this.insertedBefore.push(this.insertedBefore.at(i) + (event.kind === Kind.inserted ? 1 : 0));
    this.refusedBefore.push(this.refusedBefore.at(i) + (event.kind === Kind.refused ? 1 : 0));
    this.yieldedBefore.push(this.yieldedBefore.at(i) + (event.kind === Kind.yielded ? 1 : 0));
    return stream;
  }

  private bearVertex(event: TraceEvent): void {
    const v = event.subject;
    while (this.vertexBorn.length <= v) {
      this.vertexBorn.push(NEVER);
      this.vertexKind.push(VertexKind.free);
      this.vertexStep.push(0);
    }
    this.vertexCount = this.vertexBorn.length;
    this.vertexBorn.data[v] = event.index;
    this.vertexStep.data[v] = event.step;
    this.vertexKind.data[v] = vertexKindOf(event);
    this.coordinates.set(2 * v, event.at[0]);
    this.coordinates.set(2 * v + 1, event.at[1]);
    this.vertexRadius.set(v, event.value);
    if (event.reason === Reason.box && ++this.boxCorners === 4) this.bearBox(event.index);
    // Arcs of protecting circles are no subsegments of the input.
    if (event.dimension === 1 && event.simplex.length === 2 && event.center === NONE) {
      const [a, b] = event.simplex as [number, number];
      this.killSubsegment(a, b, event.segment, event.index);
      this.bearSubsegment(a, v, event.segment, event.index);
      this.bearSubsegment(v, b, event.segment, event.index);
    }
  }

  /** The sides of the box are segments, too; no input lists them. */
  private bearBox(event: number): void {
    const first = this.input.vertexCount;
    for (let i = 0; i < 4; i++) this.bearSubsegment(first + i, first + ((i + 1) % 4), NONE, event);
  }

  private bearTriangle(stream: Uint32Array, at: number, event: number): void {
    const [a, b, c] = canonical(stream[at]!, stream[at + 1]!, stream[at + 2]!);
    const number = this.triangleCount;
    this.triangles.push(a);
    this.triangles.push(b);
    this.triangles.push(c);
    this.triangleLabel.push(stream[at + 3]!);
    this.triangleBorn.push(event);
    this.triangleDied.push(NEVER);
    this.liveTriangles.set(a, b, c, number);
    this.changes.push(number);
  }

  /** False if there is no such triangle. */
  private killTriangle(stream: Uint32Array, at: number, event: number): boolean {
    const [a, b, c] = canonical(stream[at]!, stream[at + 1]!, stream[at + 2]!);
    const number = this.liveTriangles.take(a, b, c);
    if (number < 0) return false;
    this.triangleDied.data[number] = event;
    this.changes.push(number);
    // A relabeled triangle is born again at once and keeps its place in the queue.
    if (this.kind(event) === Kind.inserted) this.queue.died(a, b, c, event);
    return true;
  }

  /** The input's segments count as born by event 0: with the first vertex they are there. */
  private bearSubsegment(a: number, b: number, segment: number, event: number): void {
    const number = this.subsegmentCount;
    this.subsegments.push(a);
    this.subsegments.push(b);
    // The core counts the sides of the box as further segments.
    this.subsegments.push(segment < this.input.segments.length ? segment : NONE);
    this.subsegmentBorn.push(event);
    this.subsegmentDied.push(NEVER);
    this.liveSubsegments.set(Math.min(a, b), Math.max(a, b), NONE, number);
  }

  private killSubsegment(a: number, b: number, segment: number, event: number): void {
    const low = Math.min(a, b);
    const high = Math.max(a, b);
    if (this.liveSubsegments.get(low, high, NONE) < 0) this.bearSubsegment(a, b, segment, 0);
    const number = this.liveSubsegments.take(low, high, NONE);
    this.subsegmentDied.data[number] = event;
  }

  private reserveEvents(count: number): void {
    if (count * EVENT_BYTES <= this.bytes.length) return;
    const next = new Uint8Array(Math.max(count * EVENT_BYTES, this.bytes.length * 2));
    next.set(this.bytes.subarray(0, this.eventCount * EVENT_BYTES));
    this.bytes = next;
    this.words = new Uint32Array(next.buffer);
    this.doubles = new Float64Array(next.buffer);
  }
}

/** Rotated so that the smallest vertex comes first: one name for a triangle, orientation kept. */
export function canonical(a: number, b: number, c: number): [number, number, number] {
  if (a < b && a < c) return [a, b, c];
  return b < c ? [b, c, a] : [c, a, b];
}

function vertexKindOf(event: TraceEvent): VertexKind {
  if (event.reason === Reason.input) return VertexKind.input;
  if (event.reason === Reason.box) return VertexKind.box;
  return event.dimension === 1 && event.center === NONE ? VertexKind.onSegment : VertexKind.free;
}
