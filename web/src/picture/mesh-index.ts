/**
 * Finds triangles, subsegments and vertices of the mesh by their place. It hears of every slot that changes and takes the changes
 * in when it is next asked: playing costs nothing, and a question costs what has changed since the last.
 */

import type { Point } from '../shared/types';
import type { MeshModel } from './mesh-model';
import { SlotGrid } from './slot-grid';

/** Slots to be put anew, each once; everything, when they are more than there are. */
class Pending {
  private slots: number[] = [];
  private isPending = new Uint8Array(0);

  add(slot: number): void {
    if (slot >= this.isPending.length) {
      const bigger = new Uint8Array(2 * slot + 64);
      bigger.set(this.isPending);
      this.isPending = bigger;
    }
    if (this.isPending[slot]) return;
    this.isPending[slot] = 1;
    this.slots.push(slot);
  }

  take(visit: (slot: number) => void): void {
    for (const slot of this.slots) {
      this.isPending[slot] = 0;
      visit(slot);
    }
    this.slots = [];
  }
}

export class MeshIndex {
  private readonly triangles = new SlotGrid();
  private readonly subsegments = new SlotGrid();
  private readonly pendingTriangles = new Pending();
  private readonly pendingSubsegments = new Pending();
  private triangleCount = 0; // slots that are in the grid, at least
  private subsegmentCount = 0;

  constructor(private readonly model: MeshModel) {}

  clear(): void {
    this.triangles.clear();
    this.subsegments.clear();
    this.triangleCount = 0;
    this.subsegmentCount = 0;
  }

  touchTriangle(slot: number): void {
    this.pendingTriangles.add(slot);
  }

  touchSubsegment(slot: number): void {
    this.pendingSubsegments.add(slot);
  }

  /** Slot of the triangle that contains p, or -1; of several (p on an edge), the lowest. Those that are hidden are not met. */
  triangleAt(p: Point, hidden: (slot: number) => boolean): number {
    this.update();
    const { coordinates: xy, triangles } = this.model;
    const [x, y] = p;
    let found = -1;
    this.triangles.query(x, y, x, y, (slot) => {
      if (hidden(slot) || (found >= 0 && slot > found)) return;
      const a = 2 * triangles[3 * slot]!;
      const b = 2 * triangles[3 * slot + 1]!;
      const c = 2 * triangles[3 * slot + 2]!;
      const ax = xy[a]! - x;
      const ay = xy[a + 1]! - y;
      const bx = xy[b]! - x;
      const by = xy[b + 1]! - y;
      const cx = xy[c]! - x;
      const cy = xy[c + 1]! - y;
      if (ax * by - ay * bx >= 0 && bx * cy - by * cx >= 0 && cx * ay - cy * ax >= 0) found = slot;
    });
    return found;
  }

  /** The live vertex nearest to p, closer than `reach`, or -1. A vertex without a triangle is looked for one by one. */
  vertexNear(p: Point, reach: number): number {
    this.update();
    const { coordinates: xy, triangles, vertexAlive } = this.model;
    let best = reach;
    let found = -1;
    const look = (v: number) => {
      if (!vertexAlive[v]) return;
      const d = Math.hypot(xy[2 * v]! - p[0], xy[2 * v + 1]! - p[1]);
      if (d < best || (d === best && v < found)) {
        best = d;
        found = v;
      }
    };
    if (this.model.triangleCount === 0) {
      for (let v = 0; v < this.model.vertexCount; ++v) look(v);
      return found;
    }
    this.triangles.query(p[0] - reach, p[1] - reach, p[0] + reach, p[1] + reach, (slot) => {
      for (let k = 0; k < 3; ++k) look(triangles[3 * slot + k]!);
    });
    return found;
  }

  /** Slot of the subsegment nearest to p, within `reach`, or -1. */
  subsegmentNear(p: Point, reach: number, distance: (slot: number) => number): number {
    this.update();
    let best = reach;
    let found = -1;
    this.subsegments.query(p[0] - reach, p[1] - reach, p[0] + reach, p[1] + reach, (slot) => {
      const d = distance(slot);
      if (d < best || (d === best && (found < 0 || slot > found))) {
        best = d;
        found = slot;
      }
    });
    return found;
  }

  /**
   * A vertex in the open diametral disk of ab, deep enough not to be rounding, or -1. Where ab is an edge, one is found at an
   * apex of its triangles if there is any (thesis, Proposition 2.1); where it is not, the disk is searched.
   */
  encroaching(a: number, b: number): number {
    this.update();
    const { coordinates: xy, triangles } = this.model;
    const x = (xy[2 * a]! + xy[2 * b]!) / 2;
    const y = (xy[2 * a + 1]! + xy[2 * b + 1]!) / 2;
    let found = -1;
    let isEdge = false;
    let best = -slack;
    const look = (v: number) => {
      if (v === a || v === b) return;
      const ax = xy[2 * a]! - xy[2 * v]!;
      const ay = xy[2 * a + 1]! - xy[2 * v + 1]!;
      const bx = xy[2 * b]! - xy[2 * v]!;
      const by = xy[2 * b + 1]! - xy[2 * v + 1]!;
      const cosine = (ax * bx + ay * by) / (Math.hypot(ax, ay) * Math.hypot(bx, by));
      if (cosine < best || (cosine === best && v < found)) {
        best = cosine;
        found = v;
      }
    };
    this.triangles.query(x, y, x, y, (slot) => {
      const corners = [triangles[3 * slot]!, triangles[3 * slot + 1]!, triangles[3 * slot + 2]!];
      if (!corners.includes(a) || !corners.includes(b)) return;
      isEdge = true;
      for (const v of corners) look(v);
    });
    if (isEdge) return found;
    const radius = Math.hypot(xy[2 * a]! - x, xy[2 * a + 1]! - y);
    this.triangles.query(x - radius, y - radius, x + radius, y + radius, (slot) => {
      for (let k = 0; k < 3; ++k) look(triangles[3 * slot + k]!);
    });
    return found;
  }

  private update(): void {
    const { model } = this;
    const { coordinates: xy, triangles, subsegments } = model;
    for (let slot = model.triangleCount; slot < this.triangleCount; ++slot) {
      this.triangles.remove(slot);
    }
    for (let slot = model.subsegmentCount; slot < this.subsegmentCount; ++slot) {
      this.subsegments.remove(slot);
    }
    this.pendingTriangles.take((slot) => {
      if (slot >= model.triangleCount) return;
      const a = 2 * triangles[3 * slot]!;
      const b = 2 * triangles[3 * slot + 1]!;
      const c = 2 * triangles[3 * slot + 2]!;
      this.triangles.set(
        slot,
        Math.min(xy[a]!, xy[b]!, xy[c]!),
        Math.min(xy[a + 1]!, xy[b + 1]!, xy[c + 1]!),
        Math.max(xy[a]!, xy[b]!, xy[c]!),
        Math.max(xy[a + 1]!, xy[b + 1]!, xy[c + 1]!),
      );
    });
    this.pendingSubsegments.take((slot) => {
      if (slot >= model.subsegmentCount) return;
      const a = 2 * subsegments[3 * slot]!;
      const b = 2 * subsegments[3 * slot + 1]!;
      this.subsegments.set(
        slot,
        Math.min(xy[a]!, xy[b]!),
        Math.min(xy[a + 1]!, xy[b + 1]!),
        Math.max(xy[a]!, xy[b]!),
        Math.max(xy[a + 1]!, xy[b + 1]!),
      );
    });
    this.triangleCount = model.triangleCount;
    this.subsegmentCount = model.subsegmentCount;
  }
}

/** Cosine of the angle at a vertex on the circle itself, up to rounding: kLengthSlack of the core. */
const slack = 1e-10;
