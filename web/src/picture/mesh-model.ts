/**
 * The picture's own copy of the replayed mesh, kept in dense slots: the slot of a triangle that dies is taken by one
 * that is born, or by the last one. The difference to the last state is found by comparing the lists of what is
 * live, so a step, a jump and a new run are all the same call, and the copy cannot drift from the replay.
 */

import { type Bounds, type MeshState, NEVER } from '../shared/types';
import { MeshIndex } from './mesh-index';

/** A dense table of live numbers, and where each number sits. */
export class SlotTable {
  numbers = new Uint32Array(0);
  count = 0;
  private slotOf = new Int32Array(0); // slot + 1 by number; 0: not live
  private seen = new Uint32Array(0);
  private stamp = 0;

  slot(number: number): number {
    return (this.slotOf[number] ?? 0) - 1;
  }

  clear(): void {
    this.slotOf.fill(0);
    this.count = 0;
  }

  /** Makes `live` what is in the table; calls `write` for each slot whose number changed. */
  sync(
    live: Uint32Array,
    liveCount: number,
    numberCount: number,
    write: (slot: number) => void,
  ): void {
    this.grow(numberCount, liveCount);
    if (++this.stamp === NEVER) {
      this.seen.fill(0);
      this.stamp = 1;
    }
    const { slotOf, seen, stamp, numbers } = this;
    const added: number[] = [];
    for (let i = 0; i < liveCount; ++i) {
      const number = live[i]!;
      seen[number] = stamp;
      if (slotOf[number] === 0) added.push(number);
    }
    let next = 0;
    let slot = 0;
    let end = this.count;
    while (slot < end) {
      const number = numbers[slot]!;
      if (seen[number] === stamp) {
        ++slot;
        continue;
      }
      slotOf[number] = 0;
      if (next < added.length) {
        this.put(slot, added[next++]!);
        write(slot++);
        continue;
      }
      // The last live one fills the hole.
      while (--end > slot && seen[numbers[end]!] !== stamp) slotOf[numbers[end]!] = 0;
      if (end > slot) {
        this.put(slot, numbers[end]!);
        write(slot++);
      }
    }
    while (next < added.length) {
      this.put(end, added[next++]!);
      write(end++);
    }
    this.count = end;
  }

  private put(slot: number, number: number): void {
    this.numbers[slot] = number;
    this.slotOf[number] = slot + 1;
  }

  private grow(numberCount: number, liveCount: number): void {
    if (this.slotOf.length < numberCount) {
      const size = Math.ceil(numberCount * 1.5) + 64;
      const slots = new Int32Array(size);
      slots.set(this.slotOf);
      this.slotOf = slots;
      const seen = new Uint32Array(size);
      seen.set(this.seen);
      this.seen = seen;
    }
    if (this.numbers.length < liveCount) {
      const numbers = new Uint32Array(Math.ceil(liveCount * 1.5) + 64);
      numbers.set(this.numbers);
      this.numbers = numbers;
    }
  }
}

export interface MeshDifference {
  /** Coordinates of known vertices changed: another run. Everything was written anew. */
  readonly restarted: boolean;
  readonly triangleSlots: readonly number[];
  readonly subsegmentsChanged: boolean;
  /** Vertices whose coordinates, kind or presence changed. */
  readonly vertices: readonly number[];
}

export class MeshModel {
  readonly triangleSlots = new SlotTable();
  readonly subsegmentSlots = new SlotTable();
  position = 0;
  revision = 0; // how often it took over a state
  vertexCount = 0;
  coordinates = new Float64Array(0);
  vertexKind = new Uint8Array(0);
  vertexBorn = new Uint32Array(0);
  vertexStep = new Uint8Array(0);
  vertexAlive = new Uint8Array(0);
  /** By slot: 3 vertices, domain label, event of birth. */
  triangles = new Uint32Array(0);
  labels = new Uint8Array(0);
  born = new Uint32Array(0);
  /** By slot: ends and input segment. */
  subsegments = new Uint32Array(0);
  bounds: Bounds | null = null;
  /** Finds what lies where; brought up to date when it is asked. */
  readonly index = new MeshIndex(this);

  get triangleCount(): number {
    return this.triangleSlots.count;
  }

  get subsegmentCount(): number {
    return this.subsegmentSlots.count;
  }

  /** Takes over a state. O(live); allocates only to grow. */
  sync(state: MeshState): MeshDifference {
    ++this.revision;
    const restarted = this.isAnotherRun(state);
    if (restarted) {
      this.index.clear();
      this.triangleSlots.clear();
      this.subsegmentSlots.clear();
      this.vertexCount = 0;
      this.bounds = null;
    }
    const vertices = this.syncVertices(state);
    this.reserveSlots(state);
    const triangleSlots: number[] = [];
    this.triangleSlots.sync(state.liveCells, state.liveCellCount, state.cellCount, (slot) => {
      const number = this.triangleSlots.numbers[slot]!;
      for (let k = 0; k < 3; ++k) this.triangles[3 * slot + k] = state.cells[3 * number + k]!;
      this.labels[slot] = state.cellLabel[number]!;
      this.born[slot] = state.cellBorn[number]!;
      triangleSlots.push(slot);
      this.index.touchTriangle(slot);
    });
    const before = this.subsegmentSlots.count;
    let changed = restarted;
    this.subsegmentSlots.sync(
      state.liveSubsegments,
      state.liveSubsegmentCount,
      state.subsegments.length / 3,
      (slot) => {
        const number = this.subsegmentSlots.numbers[slot]!;
        for (let k = 0; k < 3; ++k) {
          this.subsegments[3 * slot + k] = state.subsegments[3 * number + k]!;
        }
        this.index.touchSubsegment(slot);
        changed = true;
      },
    );
    changed ||= before !== this.subsegmentSlots.count;
    this.position = state.position;
    return { restarted, triangleSlots, subsegmentsChanged: changed, vertices };
  }

  /** Numbers name the same things as before only as long as no known vertex moved and no live triangle changed. */
  private isAnotherRun(state: MeshState): boolean {
    const known = Math.min(this.vertexCount, state.vertexCount);
    if (this.vertexCount > state.vertexCount) return true;
    for (let v = 0; v < known; ++v) {
      if (
        this.vertexBorn[v] !== NEVER &&
        (this.coordinates[2 * v] !== state.coordinates[2 * v] ||
          this.coordinates[2 * v + 1] !== state.coordinates[2 * v + 1])
      ) {
        return true;
      }
    }
    const { numbers, count } = this.triangleSlots;
    for (let slot = 0; slot < count; ++slot) {
      const number = numbers[slot]!;
      if (number >= state.cellCount || this.born[slot] !== state.cellBorn[number]) return true;
      for (let k = 0; k < 3; ++k) {
        if (this.triangles[3 * slot + k] !== state.cells[3 * number + k]) return true;
      }
    }
    const segments = this.subsegmentSlots;
    for (let slot = 0; slot < segments.count; ++slot) {
      const number = segments.numbers[slot]!;
      for (let k = 0; k < 3; ++k) {
        if (this.subsegments[3 * slot + k] !== state.subsegments[3 * number + k]) return true;
      }
    }
    return false;
  }

  private syncVertices(state: MeshState): number[] {
    const n = state.vertexCount;
    if (this.vertexAlive.length < n) {
      const size = Math.ceil(n * 1.5) + 64;
      this.coordinates = grown(this.coordinates, 2 * size);
      this.vertexKind = grown(this.vertexKind, size);
      this.vertexBorn = grown(this.vertexBorn, size);
      this.vertexStep = grown(this.vertexStep, size);
      this.vertexAlive = grown(this.vertexAlive, size);
    }
    const changed: number[] = [];
    for (let v = 0; v < n; ++v) {
      const alive = state.vertexBorn[v]! < state.position ? 1 : 0;
      const isNew = v >= this.vertexCount || this.vertexBorn[v] === NEVER;
      if (isNew) {
        this.coordinates[2 * v] = state.coordinates[2 * v]!;
        this.coordinates[2 * v + 1] = state.coordinates[2 * v + 1]!;
        if (state.vertexBorn[v] !== NEVER) {
          this.include(state.coordinates[2 * v]!, state.coordinates[2 * v + 1]!);
        }
      }
      if (isNew || this.vertexAlive[v] !== alive || this.vertexKind[v] !== state.vertexKind[v]) {
        changed.push(v);
      }
      this.vertexKind[v] = state.vertexKind[v]!;
      this.vertexBorn[v] = state.vertexBorn[v]!;
      this.vertexStep[v] = state.vertexStep[v]!;
      this.vertexAlive[v] = alive;
    }
    this.vertexCount = n;
    return changed;
  }

  private include(x: number, y: number): void {
    const b = this.bounds;
    this.bounds = b
      ? {
          minX: Math.min(b.minX, x),
          minY: Math.min(b.minY, y),
          maxX: Math.max(b.maxX, x),
          maxY: Math.max(b.maxY, y),
        }
      : { minX: x, minY: y, maxX: x, maxY: y };
  }

  private reserveSlots(state: MeshState): void {
    const triangles = state.liveCellCount;
    if (this.labels.length < triangles) {
      const size = Math.ceil(triangles * 1.5) + 64;
      this.triangles = grown(this.triangles, 3 * size);
      this.labels = grown(this.labels, size);
      this.born = grown(this.born, size);
    }
    if (this.subsegments.length < 3 * state.liveSubsegmentCount) {
      this.subsegments = grown(
        this.subsegments,
        3 * (Math.ceil(state.liveSubsegmentCount * 1.5) + 64),
      );
    }
  }
}

function grown<T extends Float64Array | Uint8Array | Uint32Array>(array: T, length: number): T {
  const bigger = new (array.constructor as new (n: number) => T)(length);
  bigger.set(array as never);
  return bigger;
}
