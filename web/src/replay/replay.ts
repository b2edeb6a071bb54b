import { type MeshChange, type MeshState, NEVER } from '../shared/types.ts';
import type { Trace } from './trace.ts';

/** Farther than this, scanning every interval is cheaper than applying changes one by one. */
const NEAR = 400;

/**
 * The mesh at a position of a trace. `seek` moves by the change records when the goal is near, else it scans all
 * intervals: O(triangles ever born), a few milliseconds for 10^5 insertions.
 */
export class Replay {
  position = 0;
  private live = new Uint32Array(1024);
  private liveCount = 0;
  private slot = new Int32Array(1024).fill(-1);

  constructor(readonly trace: Trace) {}

  seek(goal: number): void {
    const position = Math.max(0, Math.min(goal, this.trace.eventCount));
    if (Math.abs(position - this.position) > NEAR) this.scan(position);
    while (this.position < position) this.apply(this.position, true);
    while (this.position > position) this.apply(this.position - 1, false);
  }

  /** What event i changed, as seen when it is applied (forward) or taken back. */
  change(i: number, forward = true): MeshChange | null {
    const { died, born } = this.changed(i);
    const vertex = this.trace.insertedBefore.at(i + 1) > this.trace.insertedBefore.at(i);
    if (!vertex && died.length === 0 && born.length === 0) return null;
    const landed = vertex ? this.trace.event(i).subject : -1;
    return forward
      ? { died, born, vertex: landed, forward }
      : { died: born, born: died, vertex: landed, forward };
  }

  state(): MeshState {
    const t = this.trace;
    const subsegments = new Uint32Array(t.subsegmentCount);
    let count = 0;
    for (let i = 0; i < t.subsegmentCount; i++) {
      if (t.subsegmentBorn.at(i) < this.position && this.position <= t.subsegmentDied.at(i)) {
        subsegments[count++] = i;
      }
    }
    return {
      position: this.position,
      vertexCount: t.vertexCount,
      coordinates: t.coordinates.data,
      vertexKind: t.vertexKind.data,
      vertexBorn: t.vertexBorn.data,
      vertexStep: t.vertexStep.data,
      triangleCount: t.triangleCount,
      triangles: t.triangles.data,
      triangleLabel: t.triangleLabel.data,
      triangleBorn: t.triangleBorn.data,
      triangleDied: t.triangleDied.data,
      liveTriangles: this.live,
      liveTriangleCount: this.liveCount,
      subsegments: t.subsegments.data,
      subsegmentBorn: t.subsegmentBorn.data,
      liveSubsegments: subsegments,
      liveSubsegmentCount: count,
    };
  }

  private changed(i: number): { died: Uint32Array; born: Uint32Array } {
    const start = this.trace.changeStart.at(i);
    const middle = start + this.trace.changeDead.at(i);
    const end = this.trace.changeStart.at(i + 1);
    return {
      died: this.trace.changes.data.slice(start, middle),
      born: this.trace.changes.data.slice(middle, end),
    };
  }

  private apply(i: number, forward: boolean): void {
    this.reserve();
    const { died, born } = this.changed(i);
    for (const n of forward ? died : born) this.remove(n);
    for (const n of forward ? born : died) this.add(n);
    this.position += forward ? 1 : -1;
  }

  private scan(position: number): void {
    this.reserve();
    const { triangleBorn, triangleDied, triangleCount } = this.trace;
    const born = triangleBorn.data;
    const died = triangleDied.data;
    this.slot.fill(-1);
    this.liveCount = 0;
    for (let n = 0; n < triangleCount; n++) {
      if (born[n]! >= position) break; // numbers are in order of birth
      if (died[n] === NEVER || position <= died[n]!) this.add(n);
    }
    this.position = position;
  }

  private add(n: number): void {
    this.slot[n] = this.liveCount;
    this.live[this.liveCount++] = n;
  }

  private remove(n: number): void {
    const hole = this.slot[n]!;
    const last = this.live[--this.liveCount]!;
    this.live[hole] = last;
    this.slot[last] = hole;
    this.slot[n] = -1;
  }

  private reserve(): void {
    const need = this.trace.triangleCount;
    if (need <= this.slot.length) return;
    const size = Math.max(need, 2 * this.slot.length);
    const slot = new Int32Array(size).fill(-1);
    slot.set(this.slot);
    this.slot = slot;
    const live = new Uint32Array(size);
    live.set(this.live.subarray(0, this.liveCount));
    this.live = live;
  }
}
