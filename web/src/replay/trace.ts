import { NEVER, VertexKind } from '../shared/types.ts';
import { EVENT_BYTES, Kind, NONE, Reason, type TraceEvent } from './event.ts';
import { GrowF64, GrowU8, GrowU32 } from './grow.ts';
import { ascending, canonical, Lives } from './lives.ts';
import { ELEMENT_NUMBERS, ProtectingLives } from './protecting.ts';
import { QueueHistory } from './queue.ts';
import { SimplexTable } from './simplex-table.ts';

/** What the trace is about: the input that the numbers refer to. */
export interface TraceInput {
  readonly dimension?: 2 | 3; // the plane, if nothing is said
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

  /** Triangles in the plane (counter-clockwise), tetrahedra in space (positively oriented): `dimension + 1` vertices a cell. */
  readonly cellLives: Lives;
  readonly cells: GrowU32;
  readonly cellLabel: GrowU8;
  readonly cellBorn: GrowU32;
  readonly cellDied: GrowU32;
  get cellCount(): number {
    return this.cellLives.count;
  }
  /** In space, the triangles of each face's own triangulation: a, b, c (counter-clockwise about its normal), face. */
  readonly facetLives: Lives | null;
  /** In space, what protects acute features. */
  readonly protecting: ProtectingLives | null;

  readonly subsegments = new GrowU32();
  readonly subsegmentBorn = new GrowU32();
  readonly subsegmentDied = new GrowU32();
  get subsegmentCount(): number {
    return this.subsegmentBorn.length;
  }

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
  private readonly liveSubsegments = new SimplexTable();

  readonly dimension: 2 | 3;

  constructor(readonly input: TraceInput) {
    this.dimension = input.dimension ?? 2;
    this.cellLives = new Lives(this.dimension === 2 ? 3 : 4);
    this.facetLives = this.dimension === 2 ? null : new Lives(4);
    this.protecting = this.dimension === 2 ? null : new ProtectingLives();
    const { vertices, label, born, died } = this.cellLives;
    this.cells = vertices;
    this.cellLabel = label;
    this.cellBorn = born;
    this.cellDied = died;
    for (const [i, [a, b]] of input.segments.entries()) this.bearSubsegment(a, b, i, 0);
    this.insertedBefore.push(0);
    this.refusedBefore.push(0);
    this.yieldedBefore.push(0);
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

  /** Of the subsegment that an event is about. */
  segmentLength(index: number): number {
    const { dimension } = this;
    const [a, b] = this.event(index).simplex;
    let sum = 0;
    for (let k = 0; k < dimension; k++) {
      const d =
        this.coordinates.data[dimension * a! + k]! - this.coordinates.data[dimension * b! + k]!;
      sum += d * d;
    }
    return Math.sqrt(sum);
  }

  event(index: number): TraceEvent {
    const byte = index * EVENT_BYTES;
    const word = index * 16;
    const double = index * 8;
    const dimension = this.bytes[byte + 1]!;
    const simplex: number[] = [];
    for (let k = 0; k <= dimension && dimension > 0 && k < 4; k++) {
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
      face: dimension % 2 === 0 && this.dimension === 3 ? this.words[word + 4]! : NONE,
      center:
        dimension === 1 ? this.words[word + 3]! : dimension === 0 ? this.words[word + 2]! : NONE,
      across: dimension === 0 ? this.words[word + 1]! : NONE,
      subject: this.words[word + 5]!,
      other: [this.words[word + 6]!, this.words[word + 7]!],
      at: [this.doubles[double + 4]!, this.doubles[double + 5]!],
      place: [this.doubles[double + 4]!, this.doubles[double + 5]!, this.doubles[double + 6]!],
      value: this.doubles[double + 7]!,
    };
  }

  private decode(i: number, simplices: Uint32Array, start: number): number {
    const event = this.event(i);
    const last = this.stepStarts.at(-1);
    if (!last || last.step !== event.step) this.stepStarts.push({ step: event.step, event: i });
    this.queue.record(event);
    if (event.kind === Kind.inserted) this.bearVertex(event);
    const stream =
      event.kind === Kind.inserted || event.kind === Kind.relabeled
        ? this.changeCells(event, simplices, start)
        : event.kind === Kind.faceChanged
          ? this.changeFacets(event, simplices, start)
          : event.kind === Kind.protection
            ? this.changeProtection(event, simplices, start)
            : start;
    this.cellLives.close();
    this.facetLives?.close();
    this.protecting?.lives.close();
    this.insertedBefore.push(this.insertedBefore.at(i) + (event.kind === Kind.inserted ? 1 : 0));
    this.refusedBefore.push(this.refusedBefore.at(i) + (event.kind === Kind.refused ? 1 : 0));
    this.yieldedBefore.push(this.yieldedBefore.at(i) + (event.kind === Kind.yielded ? 1 : 0));
    return stream;
  }

  private changeCells(event: TraceEvent, simplices: Uint32Array, start: number): number {
    const [deadCount, bornCount] = event.other;
    const width = this.dimension + 2;
    const isRelabel = event.kind === Kind.relabeled;
    const skipped = new Set<number>();
    let stream = start;
    for (let k = 0; k < deadCount; k++, stream += width) {
      if (this.killCell(simplices, stream, event.index)) continue;
      // A relabeled cell may be listed twice; it is one change.
      if (isRelabel) skipped.add(k);
      else throw new Error(`event ${event.index}: a cell died that never lived`);
    }
    for (let k = 0; k < bornCount; k++, stream += width) {
      if (!skipped.has(k)) this.bearCell(simplices, stream, event.index);
    }
    return stream;
  }

  /** Records of a face: its triangles, nothing, and 4 times the face plus the label. */
  private changeFacets(event: TraceEvent, simplices: Uint32Array, start: number): number {
    const lives = this.facetLives;
    if (!lives) throw new Error(`event ${event.index}: there are no faces in the plane`);
    const [deadCount, bornCount] = event.other;
    const end = start + 5 * (deadCount + bornCount);
    for (let stream = start; stream < end; stream += 5) {
      const corners = simplices.subarray(stream, stream + 3) as unknown as [number, number, number];
      const face = simplices[stream + 4]! >>> 2;
      const record = [...canonical(...corners), face] as [number, number, number, number];
      if (stream >= start + 5 * deadCount) {
        lives.bear(record, record, simplices[stream + 4]! & 3, event.index);
        this.placeInFace(corners);
      } else if (lives.kill(record, event.index)) this.queue.died(corners, event.index);
      else throw new Error(`event ${event.index}: a triangle of a face died that never lived`);
    }
    return end;
  }

  private changeProtection(event: TraceEvent, simplices: Uint32Array, start: number): number {
    const { protecting } = this;
    if (!protecting) throw new Error(`event ${event.index}: elements that protect are of space`);
    const [deadCount, bornCount] = event.other;
    const born = start + ELEMENT_NUMBERS * deadCount;
    const end = born + ELEMENT_NUMBERS * bornCount;
    for (let stream = start; stream < end; stream += ELEMENT_NUMBERS) {
      if (stream >= born) protecting.bear(simplices, stream, event.index);
      else if (!protecting.kill(simplices, stream, event.index))
        throw new Error(`event ${event.index}: an element ended that never began`);
    }
    return end;
  }

  /** A vertex that splits nothing tells by the face that takes it in where it lies. */
  private placeInFace(corners: readonly number[]): void {
    for (const v of corners)
      if (this.vertexKind.data[v] === VertexKind.free) this.vertexKind.data[v] = VertexKind.inFace;
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
    this.vertexKind.data[v] = vertexKindOf(event, this.dimension);
    for (let k = 0; k < this.dimension; k++)
      this.coordinates.set(this.dimension * v + k, event.place[k]!);
    this.vertexRadius.set(v, event.value);
    if (event.reason === Reason.box && ++this.boxCorners === 2 ** this.dimension)
      this.bearBox(event.index);
    // Arcs of protecting circles and, in space, collar segments are no subsegments of the input.
    const ofInput = event.center === NONE && (this.dimension === 2 || event.segment !== NONE);
    if (event.dimension === 1 && event.simplex.length === 2 && ofInput) {
      const [a, b] = event.simplex as [number, number];
      this.killSubsegment(a, b, event.segment, event.index);
      this.bearSubsegment(a, v, event.segment, event.index);
      this.bearSubsegment(v, b, event.segment, event.index);
    }
  }

  /** The sides (edges) of the box are segments, too; no input lists them. Its corners differ in one coordinate there. */
  private bearBox(event: number): void {
    const { dimension } = this;
    const first = this.input.vertexCount;
    const at = this.coordinates.data;
    const differences = (a: number, b: number) => {
      let count = 0;
      for (let k = 0; k < dimension; k++) {
        if (at[dimension * a + k] !== at[dimension * b + k]) count++;
      }
      return count;
    };
    for (let a = first; a < first + 2 ** dimension; a++) {
      for (let b = a + 1; b < first + 2 ** dimension; b++) {
        if (differences(a, b) === 1) this.bearSubsegment(a, b, NONE, event);
      }
    }
  }

  private bearCell(stream: Uint32Array, at: number, event: number): void {
    const [a, b, c, d] = stream.subarray(at, at + 4) as unknown as [number, number, number, number];
    if (this.dimension === 2) {
      const name = [...canonical(a, b, c), NONE] as [number, number, number, number];
      this.cellLives.bear(name, name, d, event);
    } else {
      this.cellLives.bear([a, b, c, d], ascending(a, b, c, d), stream[at + 4]!, event);
    }
  }

  /** False if there is no such cell. */
  private killCell(stream: Uint32Array, at: number, event: number): boolean {
    const [a, b, c, d] = stream.subarray(at, at + 4) as unknown as [number, number, number, number];
    const name: [number, number, number, number] =
      this.dimension === 2 ? [...canonical(a, b, c), NONE] : ascending(a, b, c, d);
    if (!this.cellLives.kill(name, event)) return false;
    // A relabeled cell is born again at once and keeps its place in the queue.
    if (this.kind(event) === Kind.inserted)
      this.queue.died(this.dimension === 2 ? name.slice(0, 3) : name, event);
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

function vertexKindOf(event: TraceEvent, dimension: number): VertexKind {
  if (event.reason === Reason.input) return VertexKind.input;
  if (event.reason === Reason.box) return VertexKind.box;
  const ofInput = event.center === NONE && (dimension === 2 || event.segment !== NONE);
  if (event.dimension === 1 && ofInput) return VertexKind.onSegment;
  const inFace = dimension === 3 && event.dimension === 2 && event.face !== NONE;
  return inFace ? VertexKind.inFace : VertexKind.free;
}
