import {
  Label,
  type Moment,
  type Moment3,
  type MomentKind,
  type Point,
  type Point3,
  Protecting,
  type RuleName,
} from '../shared/types.ts';
import { collarRegionAt } from './collar-region.ts';
import { Kind, NONE, Reason, type TraceEvent, yieldedTo } from './event.ts';
import { circumcircle, distance, midpoint, point } from './geometry.ts';
import { type Ball3, circumball, distance3, point3 } from './geometry3.ts';
import { canonical } from './lives.ts';
import type { Replay } from './replay.ts';
import { type DomainCounts, sentenceOf } from './sentence.ts';

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
  'face-changed',
  'protection',
];

/** What the event that led to a position shows: who acts, by which rule, why. Null at position 0. */
export function momentAt(
  replay: Replay,
  position: number,
  forward = true,
): Moment | Moment3 | null {
  if (position <= 0 || position > replay.trace.eventCount) return null;
  const { trace } = replay;
  const e = trace.event(position - 1);
  const xyz = trace.coordinates.data;
  const known = e.simplex.filter((v) => v < trace.vertexCount);
  const acting = e.kind >= Kind.queued && e.kind <= Kind.inserted && e.dimension > 0;
  const yields = e.kind === Kind.yielded && e.other[0] !== NONE;
  const hasGhost = e.kind === Kind.yielded || hasRefusedPoint(e);
  const words = {
    kind: kinds[e.kind] ?? 'step-began',
    rule: ruleOf(e),
    simplex: acting ? e.simplex : [],
    witness: witnessOf(e),
    yieldTo: yields && e.value === 0 ? e.other : null,
    yieldFace: yields && e.value > 0 ? yieldedTo(e) : null,
    vertex: e.kind === Kind.inserted ? e.subject : null,
    change: replay.change(position - 1, forward),
    sentence: sentenceOf(e, trace.steps, trace.dimension, {
      domain: domainCounts(replay, e),
      protecting: trace.protecting,
      inCollar: yieldsInCollar(replay, e),
    }),
  } as const;
  if (trace.dimension === 3) {
    const corners = known.map((v) => point3(xyz, v));
    const face = e.kind === Kind.faceChanged ? e.subject : faceOf(replay, e);
    return {
      ...words,
      dimension: 3,
      ...nearness(replay, e),
      ...(acting && !isNear(e) ? { ball: circumball(corners) } : {}),
      ghost: hasGhost ? e.place : refusedCenter(e, corners),
      face: face === NONE ? null : face,
      facets: trace.facetLives?.changed(e.index).born ?? new Uint32Array(0),
      elements: trace.protecting?.lives.changed(e.index).born ?? new Uint32Array(0),
    };
  }
  const corners = known.map((v) => point(xyz, v));
  return {
    ...words,
    dimension: 2,
    ball: acting ? ballOf(e, corners, trace.input.vertexCount) : null,
    ghost: hasGhost ? e.at : null,
  };
}

/** The face that an event is about: of a triangle, of a collar vertex, of collar elements. */
function faceOf({ trace }: Replay, e: TraceEvent): number {
  const { protecting } = trace;
  if (e.face !== NONE || !protecting) return e.face;
  const collar = e.dimension === 1 && e.segment === NONE ? protecting.find(e.simplex) : -1;
  const [changed = -1] = e.kind === Kind.protection ? protecting.lives.changed(e.index).born : [];
  const number = collar >= 0 ? collar : changed;
  if (number < 0) return NONE;
  const { kind, carrier } = protecting.element(number);
  return kind === Protecting.collarSegment || kind === Protecting.collarArc ? carrier : NONE;
}

/** A vertex is unacceptably near to a Delaunay neighbor of it (thesis, sections 4.2 and 4.3). */
function isNear(e: TraceEvent): boolean {
  return (
    e.reason === Reason.nearWitness ||
    e.reason === Reason.nearLocalWitness ||
    e.reason === Reason.nearVertex
  );
}

/**
 * The vertex q that the witness is near to, and the ball about it that decides: of the length of the subsegment, or of the
 * circumdiameter of the triangle. The record tells the distance alone; q is a corner of the simplex, or an end in its spindle.
 */
function nearness(replay: Replay, e: TraceEvent): { near: number | null; ball: Ball3 | null } {
  const { trace } = replay;
  const none = { near: null, ball: null };
  if (!isNear(e) || e.kind !== Kind.queued || e.subject >= trace.vertexCount) return none;
  const at = (v: number) => point3(trace.coordinates.data, v);
  const witness = at(e.subject);
  const isIt = (v: number) =>
    v !== e.subject &&
    trace.vertexBorn.at(v) < e.index &&
    Math.abs(distance3(at(v), witness) - e.value) <= 1e-12 * e.value;
  let near = e.simplex.find(isIt) ?? null;
  for (let v = 0; near === null && v < trace.input.vertexCount; v++) if (isIt(v)) near = v;
  for (let v = 0; near === null && v < trace.vertexCount; v++) if (isIt(v)) near = v;
  const radius = 2 * (circumball(e.simplex.map(at))?.radius ?? Number.NaN);
  if (near === null || !Number.isFinite(radius)) return { near, ball: null };
  return { near, ball: { center: at(near), radius } };
}

/** A triangle of a collar that is encroached is not split: it queues the collar elements at it. */
function yieldsInCollar(replay: Replay, e: TraceEvent): boolean {
  const { trace } = replay;
  if (trace.dimension === 2 || e.kind !== Kind.yielded || e.face === NONE) return false;
  if (e.subject !== NONE || replay.position !== e.index + 1) return false;
  const record = [...canonical(...(e.simplex as [number, number, number])), e.face];
  const { data } = trace.facetLives!.vertices;
  return collarRegionAt(trace, replay.state()).facets.some((n) =>
    record.every((x, k) => data[4 * n + k] === x),
  );
}

function domainCounts(replay: Replay, e: TraceEvent): DomainCounts | undefined {
  if (e.kind !== Kind.relabeled) return undefined;
  const born = replay.change(e.index)?.born ?? [];
  let outside = 0;
  for (const n of born) {
    if (replay.trace.cellLabel.data[n] === Label.outside) outside++;
  }
  return { inside: born.length - outside, outside };
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
    e.kind === Kind.queued &&
    (e.reason === Reason.encroached ||
      e.reason === Reason.witness ||
      e.reason === Reason.tooLong ||
      isNear(e));
  return hasWitness && e.subject !== NONE ? e.subject : null;
}

/** Safety judges the circumcenter of a face's triangle (Algorithm 4.3) before it is proposed: the record has no place of it. */
function refusedCenter(e: TraceEvent, corners: readonly Point3[]): Point3 | null {
  const judged =
    e.kind === Kind.refused && (e.reason === Reason.outsideFace || e.reason === Reason.nearSegment);
  return judged && corners.length === 3 ? (circumball(corners)?.center ?? null) : null;
}

/** A refusal without a point has its place at the origin of the record: it is not drawn. */
function hasRefusedPoint(e: TraceEvent): boolean {
  return e.kind === Kind.refused && e.place.some((x) => x !== 0);
}

/**
 * The ball that decided: circumdisk or diametral disk. A collar vertex lies on a circle around its input vertex instead, the
 * same for every segment there; points that divide a segment come from none.
 */
function ballOf(
  e: TraceEvent,
  corners: readonly Point[],
  inputVertices: number,
): { center: Point; radius: number } | null {
  if (e.kind === Kind.inserted && e.reason === Reason.division) return null;
  if (e.kind === Kind.inserted && e.reason === Reason.collar) {
    const centers = corners.filter((_, i) => e.simplex[i]! < inputVertices);
    centers.sort((p, q) => distance(p, e.at) - distance(q, e.at));
    const center = centers[0];
    return center ? { center, radius: distance(center, e.at) } : null;
  }
  const [a, b, c] = corners;
  if (a && b && c) return circumcircle(a, b, c);
  if (a && b) return { center: midpoint(a, b), radius: distance(a, b) / 2 };
  return null;
}
