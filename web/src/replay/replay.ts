import type { MeshChange, MeshState } from '../shared/types.ts';
import { LiveSet } from './lives.ts';
import type { Trace } from './trace.ts';

/** Farther than this, scanning every interval is cheaper than applying changes one by one. */
const NEAR = 400;

/**
 * The mesh at a position of a trace. `seek` moves by the change records when the goal is near, else it scans all
 * intervals: O(cells ever born), a few milliseconds for 10^5 insertions.
 */
export class Replay {
  position = 0;
  private readonly cells: LiveSet;
  private readonly facets: LiveSet | null;
  private readonly protecting: LiveSet | null;

  constructor(readonly trace: Trace) {
    this.cells = new LiveSet(trace.cellLives);
    this.facets = trace.facetLives && new LiveSet(trace.facetLives);
    this.protecting = trace.protecting && new LiveSet(trace.protecting.lives);
  }

  seek(goal: number): void {
    const position = Math.max(0, Math.min(goal, this.trace.eventCount));
    if (Math.abs(position - this.position) > NEAR) this.scan(position);
    while (this.position < position) this.apply(this.position, true);
    while (this.position > position) this.apply(this.position - 1, false);
  }

  /** What event i changed, as seen when it is applied (forward) or taken back. */
  change(i: number, forward = true): MeshChange | null {
    const { died, born } = this.trace.cellLives.changed(i);
    const vertex = this.trace.insertedBefore.at(i + 1) > this.trace.insertedBefore.at(i);
    if (!vertex && died.length === 0 && born.length === 0) return null;
    const landed = vertex ? this.trace.event(i).subject : -1;
    return forward
      ? { died, born, vertex: landed, forward }
      : { died: born, born: died, vertex: landed, forward };
  }

  /** The kinds of protecting elements that have begun at a position. */
  protectingKinds(position: number): Set<number> {
    const first = this.trace.protecting?.firstOfKind ?? [];
    return new Set(first.flatMap((event, kind) => (event < position ? [kind] : [])));
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
    const facets = t.facetLives;
    const protection = t.protecting?.lives;
    return {
      dimension: t.dimension,
      position: this.position,
      vertexCount: t.vertexCount,
      coordinates: t.coordinates.data,
      vertexKind: t.vertexKind.data,
      vertexBorn: t.vertexBorn.data,
      vertexStep: t.vertexStep.data,
      cellCount: t.cellCount,
      cells: t.cells.data,
      cellLabel: t.cellLabel.data,
      cellBorn: t.cellBorn.data,
      cellDied: t.cellDied.data,
      liveCells: this.cells.list,
      liveCellCount: this.cells.count,
      subsegments: t.subsegments.data,
      subsegmentBorn: t.subsegmentBorn.data,
      liveSubsegments: subsegments,
      liveSubsegmentCount: count,
      facets: facets && {
        count: facets.count,
        triangles: facets.vertices.data,
        label: facets.label.data,
        born: facets.born.data,
        live: this.facets!.list,
        liveCount: this.facets!.count,
      },
      protection: protection
        ? {
            count: protection.count,
            elements: protection.vertices.data,
            kind: protection.label.data,
            live: this.protecting!.list,
            liveCount: this.protecting!.count,
          }
        : null,
    };
  }

  private apply(i: number, forward: boolean): void {
    this.cells.apply(i, forward);
    this.facets?.apply(i, forward);
    this.protecting?.apply(i, forward);
    this.position += forward ? 1 : -1;
  }

  private scan(position: number): void {
    this.cells.scan(position);
    this.facets?.scan(position);
    this.protecting?.scan(position);
    this.position = position;
  }
}
