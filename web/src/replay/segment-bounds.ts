import { Kind } from './event.ts';
import type { Trace } from './trace.ts';

/** Sizes of a subsegment s (thesis, Definitions 2.1.6 and 2.1.7): infinite where there are no two such features. */
export interface SegmentSizes {
  readonly length: number; // |s|
  readonly fs1: number;
  readonly lfs1: number;
  readonly lfs: number;
}

/** What chapter 4 proves of |s| at some moment of the run. */
export interface SegmentBound {
  readonly theorem: string;
  /** The statement, with |s| on one side. */
  readonly statement: string;
  /** The other side, and what |s| is of it. */
  readonly value: number;
  readonly ratio: number;
  readonly holds: boolean;
}

/** Thirds and halves attain the bounds exactly, up to rounding: the slack of lengths of constructed pieces. */
const SLACK = 1e-10;

/**
 * The bounds that hold for every segment of `feature-size` in space at a position of the trace: some throughout a step, some when it
 * has ended. `step2a` is the parameter of the run: the upper bound of Lemma 4.10 is that of a split into fourths.
 */
export function segmentBounds(
  trace: Trace,
  position: number,
  sizes: SegmentSizes,
  step2a = 'fourths',
): SegmentBound[] {
  const { name, ended } = stepAt(trace, position);
  const { length, fs1, lfs1, lfs } = sizes;
  const lower = (theorem: string, statement: string, value: number): SegmentBound => ({
    theorem,
    statement,
    value,
    ratio: length / value,
    // Of infinite sizes nothing is said.
    holds: value === Number.POSITIVE_INFINITY || length >= value * (1 - SLACK),
  });
  const upper = (theorem: string, statement: string, value: number): SegmentBound => ({
    theorem,
    statement,
    value,
    ratio: length / value,
    holds: length <= value * (1 + SLACK),
  });
  const throughout = lower(
    'Theorem 4.1',
    'min(fs₁(s) / 16, lfs(s) / 4) ≤ |s|',
    Math.min(fs1 / 16, lfs / 4),
  );
  switch (name) {
    case '1b':
      return [
        lower('Lemma 4.5', 'fs₁(s) / 4 ≤ |s|', fs1 / 4),
        ...(ended ? [upper('Lemma 4.9', '|s| ≤ √2 fs₁(s)', Math.SQRT2 * fs1)] : []),
      ];
    case '2a': {
      if (!ended) return [throughout];
      const halves = step2a === 'halves';
      return [
        lower('Lemma 4.11', 'fs₁(s) / 16 ≤ |s|', fs1 / 16),
        halves
          ? upper('as Lemma 4.10, for halves', '|s| ≤ lfs₁(s) / √2', lfs1 / Math.SQRT2)
          : upper('Lemma 4.10', '|s| ≤ lfs₁(s) / (2√2)', lfs1 / (2 * Math.SQRT2)),
      ];
    }
    case '2b':
      return [
        throughout,
        ...(ended
          ? [
              upper(
                'Theorem 4.2',
                '|s| ≤ min(√2 fs₁(s), 5/3 lfs(s))',
                Math.min(Math.SQRT2 * fs1, (5 / 3) * lfs),
              ),
            ]
          : []),
      ];
    default:
      // Before its first vertex on a segment the algorithm has promised nothing of them.
      return name === '1a' && ended ? [throughout] : [];
  }
}

/** The step at a position, and whether it has ended there. */
export function stepAt(trace: Trace, position: number): { name: string; ended: boolean } {
  const starts = trace.stepStarts;
  let i = starts.length - 1;
  while (i > 0 && starts[i]!.event >= position) i--;
  const start = starts[i];
  if (!start) return { name: '', ended: false };
  const end = starts[i + 1]?.event ?? trace.eventCount;
  const complete = end > start.event && trace.kind(end - 1) === Kind.stepEnded;
  return { name: trace.steps[start.step] ?? '', ended: complete && position >= end };
}
