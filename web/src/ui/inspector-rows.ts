import type { Cause } from '../replay/ancestry.ts';
import { NONE, Reason } from '../replay/event.ts';
import { point } from '../replay/geometry.ts';
import { measureTriangle } from '../replay/measure.ts';
import type { Protection } from '../replay/protection.ts';
import type { Trace } from '../replay/trace.ts';
import { VertexKind } from '../shared/types.ts';
import { texts } from '../texts.ts';
import { formatDegrees, formatNumber, simplexName } from '../words.ts';

/** A name and what it is, as the inspector lists it. */
export type Row = readonly [name: string, value: string];

const t = texts.inspector;

/** The input features that a vertex lies on, known from its birth. */
export function featuresOf(trace: Trace, protection: Protection, v: number): string {
  const birth = trace.event(trace.vertexBorn.at(v));
  switch (trace.vertexKind.data[v]) {
    case VertexKind.input:
      return t.ends(trace.input.segments.flatMap((s, i) => (s.includes(v) ? [i] : [])));
    case VertexKind.box:
      return t.box;
  }
  if (birth.center !== NONE || birth.reason === Reason.circle) {
    return t.onCircle(protection.centerOf(v));
  }
  if (birth.dimension !== 1) return t.free;
  return birth.segment < trace.input.segments.length ? t.onSegment(birth.segment) : t.onBox;
}

/** Why a vertex was inserted, in the words of the proof. */
export function causeText(cause: Cause, splitSegment: number, face = NONE): string {
  const edge = (e: readonly number[]) => e.join('–');
  switch (cause.kind) {
    case 'input':
      return t.causes.input;
    case 'box':
      return t.causes.box;
    case 'division':
      return t.causes.division(cause.segment);
    case 'third':
      return t.causes.third(cause.segment);
    case 'protection':
      return t.causes.protection(cause.parent);
    case 'encroached':
      return t.causes.encroached(simplexName(cause.split, splitSegment), cause.parent);
    case 'nearer': {
      const split = simplexName(cause.split, splitSegment, face);
      const say = cause.split.length === 2 ? t.causes.nearer : t.causes.outside;
      return say(split, cause.parent);
    }
    case 'missing':
      return t.causes.missing(simplexName(cause.split, splitSegment), cause.parent);
    case 'yielded':
      return t.causes.yielded(simplexName(cause.triangle), edge(cause.edge), cause.parent);
    case 'triangle':
      return t.causes.triangle(simplexName(cause.triangle), edge(cause.edge), cause.parent);
  }
}

export function triangleRows(trace: Trace, n: number): Row[] {
  if (n >= trace.cellCount) return [];
  const m = measureTriangle(trace, n);
  return [
    ['vertices', Array.from(trace.cells.data.subarray(3 * n, 3 * n + 3)).join(', ')],
    ['angles', `${formatDegrees(m.minAngle)} … ${formatDegrees(m.maxAngle)}`],
    ['circumradius', formatNumber(m.circumradius)],
    ['shortest edge', formatNumber(m.shortestEdge)],
    ['radius / edge', formatNumber(m.radiusEdge)],
  ];
}

export function subsegmentRows(trace: Trace, n: number): Row[] {
  if (n >= trace.subsegmentCount) return [];
  const [a, b, s] = Array.from(trace.subsegments.data.subarray(3 * n, 3 * n + 3)) as [
    number,
    number,
    number,
  ];
  const p = point(trace.coordinates.data, a);
  const q = point(trace.coordinates.data, b);
  return [
    ['vertices', `${a}, ${b}`],
    ['input segment', s < trace.input.segments.length ? String(s) : 'of the box'],
    ['length', formatNumber(Math.hypot(p[0] - q[0], p[1] - q[1]))],
  ];
}
