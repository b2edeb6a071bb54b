import { Label } from '../shared/types.ts';
import { type Band, bands } from './timeline.ts';
import type { Trace } from './trace.ts';

/** What a mesh in space consists of at a position. */
export interface SpaceCounts {
  readonly vertices: number;
  readonly subsegments: number;
  readonly triangles: number; // of the faces' own triangulations, inside of the polygons
}

export interface SpaceStep extends SpaceCounts {
  readonly name: string;
  readonly ended: boolean; // else it is the step at hand
}

/** Counts by step as in Table 4.1, up to a position. What a step ended with is counted once. */
export class StepCounts {
  private readonly ends = new Map<number, SpaceCounts>();

  constructor(private readonly trace: Trace) {}

  /** O(ever born) for the step at hand and for each that ended since the last time, else O(steps). */
  at(position: number): SpaceStep[] {
    const { trace } = this;
    const steps: SpaceStep[] = [];
    const all = bands(trace);
    for (const [i, band] of all.entries()) {
      if (band.start >= position && steps.length > 0) break;
      // The last band may still grow.
      const ended = position >= band.end && i + 1 < all.length;
      const counts = ended ? this.atEnd(band) : countsAt(trace, Math.min(band.end, position));
      steps.push({ name: band.name, ended: position >= band.end, ...counts });
    }
    return steps;
  }

  private atEnd(band: Band): SpaceCounts {
    let counts = this.ends.get(band.end);
    if (!counts) {
      counts = countsAt(this.trace, band.end);
      this.ends.set(band.end, counts);
    }
    return counts;
  }
}

export function countsAt(trace: Trace, position: number): SpaceCounts {
  const alive = (born: Uint32Array, died: Uint32Array, n: number) =>
    born[n]! < position && position <= died[n]!;
  let subsegments = 0;
  const born = trace.subsegmentBorn.data;
  const died = trace.subsegmentDied.data;
  for (let n = 0; n < trace.subsegmentCount; n++) if (alive(born, died, n)) subsegments++;
  let triangles = 0;
  const lives = trace.facetLives;
  for (let n = 0; lives && n < lives.count; n++) {
    if (lives.label.data[n] === Label.outside) continue;
    if (alive(lives.born.data, lives.died.data, n)) triangles++;
  }
  return { vertices: trace.insertedBefore.at(position), subsegments, triangles };
}
