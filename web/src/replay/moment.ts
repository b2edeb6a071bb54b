import type { Moment, MomentKind, Point, RuleName } from '../shared/types.ts';
import { Kind, NONE, Reason, type TraceEvent } from './event.ts';
import { circumcircle, distance, midpoint, point } from './geometry.ts';
import type { Replay } from './replay.ts';
import { sentenceOf } from './sentence.ts';

const kinds: readonly MomentKind[] = [
  'step-began',
  'step-ended',
  'queued',
  'dropped',
  'refused',
  'yielded',
  'inserted',
  'relabeled',
  'limit',
];

/** What the event that led to a position shows: who acts, by which rule, why. Null at position 0. */
export function momentAt(replay: Replay, position: number, forward = true): Moment | null {
  if (position <= 0 || position > replay.trace.eventCount) return null;
  const { trace } = replay;
  const e = trace.event(position - 1);
  const xy = trace.coordinates.data;
  const corners = e.simplex.filter((v) => v < trace.vertexCount).map((v) => point(xy, v));
  const acting = e.kind >= Kind.queued && e.kind <= Kind.inserted && e.dimension > 0;
  const yields = e.kind === Kind.yielded && e.other[0] !== NONE;
  return {
    kind: kinds[e.kind] ?? 'step-began',
    rule: ruleOf(e),
    simplex: acting ? e.simplex : [],
    witness: witnessOf(e),
    ball: acting ? ballOf(corners) : null,
    ghost: e.kind === Kind.yielded || hasRefusedPoint(e) ? e.at : null,
    yieldTo: yields ? e.other : null,
    vertex: e.kind === Kind.inserted ? e.subject : null,
    change: replay.change(position - 1, forward),
    sentence: sentenceOf(e, trace.steps),
  };
}

/** Which of the four rules speaks. */
export function ruleOf(e: TraceEvent): RuleName | null {
  switch (e.kind) {
    case Kind.queued:
      return e.reason === Reason.yieldedTo || e.reason === Reason.returned
        ? 'action'
        : 'unacceptability';
    case Kind.dropped:
      return e.reason === Reason.acceptable ? 'unacceptability' : 'priority';
    case Kind.refused:
      return 'safety';
    case Kind.yielded:
      return 'action';
    case Kind.inserted:
      return e.dimension > 0 ? 'action' : null;
    default:
      return null;
  }
}

function witnessOf(e: TraceEvent): number | null {
  const hasWitness =
    e.kind === Kind.queued && (e.reason === Reason.encroached || e.reason === Reason.witness);
  return hasWitness && e.subject !== NONE ? e.subject : null;
}

/** A refusal without a point has its place at the origin of the record: it is not drawn. */
function hasRefusedPoint(e: TraceEvent): boolean {
  return e.kind === Kind.refused && (e.at[0] !== 0 || e.at[1] !== 0);
}

function ballOf(corners: readonly Point[]): { center: Point; radius: number } | null {
  const [a, b, c] = corners;
  if (a && b && c) return circumcircle(a, b, c);
  if (a && b) return { center: midpoint(a, b), radius: distance(a, b) / 2 };
  return null;
}
