import { Protecting } from '../shared/types.ts';
import { formatCount, formatList, formatNumber } from '../words.ts';
import { Kind, NONE, Reason, type TraceEvent, yieldedTo } from './event.ts';
import { elementName, eventName, nameOf } from './names.ts';
import type { ProtectingLives } from './protecting.ts';

/**
 * The sentence of an event, in the words of the four rules, naming the witness: what circumball::describe says for the
 * command, with the names that the panel uses.
 */
export function sentenceOf(
  e: TraceEvent,
  steps: readonly string[],
  dimension: 2 | 3 = 2,
  { domain, protecting = null, inCollar = false }: SentenceContext = {},
): string {
  const name = eventName(protecting, e);
  const step = stepName(steps[e.step] ?? String(e.step));
  switch (e.kind) {
    case Kind.stepBegan:
      return `Step ${step} begins.`;
    case Kind.stepEnded: {
      const refusals = e.other[0] === NONE ? 0 : e.other[0];
      return `Step ${step} ends: ${plural(e.subject, 'vertex', 'vertices')} inserted, ${plural(refusals, 'refusal', 'refusals')}.`;
    }
    case Kind.queued:
      return queued(e, name, dimension);
    case Kind.dropped:
      return e.reason === Reason.died
        ? `${capital(name)} was taken from the queue and dropped: it is no longer in the mesh.`
        : `${capital(name)} was taken from the queue and dropped: it has become acceptable.`;
    case Kind.refused:
      return `${capital(name)} is not safe to split: ${refusal(e, dimension)}.`;
    case Kind.yielded: {
      const to = yieldedTo(e);
      const other =
        to.length === 3
          ? nameOf(protecting, to, NONE, e.subject)
          : nameOf(protecting, to, e.subject, NONE);
      if (inCollar)
        return `${capital(name)} belongs to the collar and is never split: ${other} at its edge is queued instead.`;
      return `The circumcenter of ${name} encroaches upon ${other}, so it yields: that is queued instead, and the ${simplexSort(e)} goes back.`;
    }
    case Kind.inserted:
      return inserted(e, name);
    case Kind.relabeled:
      return relabeled(e, dimension, domain);
    case Kind.faceChanged:
      return faceChanged(e);
    case Kind.protection:
      return protection(e, protecting);
    case Kind.limit:
      return `The run stops: ${limit(e.reason)}.`;
    default:
      return '';
  }
}

/** What the record of an event leaves out. */
export interface SentenceContext {
  readonly domain?: DomainCounts | undefined;
  readonly protecting?: ProtectingLives | null;
  readonly inCollar?: boolean; // the triangle that yields belongs to a collar
}

/** Of the cells whose side of the boundary an event tells. */
export interface DomainCounts {
  readonly inside: number;
  readonly outside: number;
}

/** What protects acute features follows what was inserted. */
function protection(e: TraceEvent, protecting: ProtectingLives | null): string {
  const [dead, born] = e.other;
  if (!protecting) return '';
  const changed = protecting.lives.changed(e.index);
  const names = (list: ArrayLike<number>) =>
    Array.from(list, (n) => elementName(protecting.element(n)));
  if (dead === 0 && born === 1) return `${capital(names(changed.born)[0]!)} is drawn.`;
  if (dead === 1 && born === 2) {
    const parts = Array.from(changed.born, (n) => protecting.element(n).vertices.join('–'));
    return `${capital(names(changed.died)[0]!)} is now two: ${formatList(parts)}.`;
  }
  const kinds = Array.from(changed.born, (n) => protecting.element(n).kind);
  if (dead === 0 && kinds.every((k) => k === Protecting.subsegment))
    return `Short enough now, ${plural(born, 'subsegment is', 'subsegments are')} protected: never split from now on.`;
  return `What protects the input changes: ${plural(dead, 'element', 'elements')} became ${formatCount(born)}.`;
}

/** The triangulation of a face follows what happened in space. */
function faceChanged(e: TraceEvent): string {
  const [dead, born] = e.other;
  const triangles = (n: number) => plural(n, 'triangle', 'triangles');
  if (dead === 0)
    return `Face ${e.subject} has its own Delaunay triangulation: ${triangles(born)}.`;
  return `In the triangulation of face ${e.subject}, ${triangles(dead)} became ${triangles(born)}.`;
}

function simplexSort(e: TraceEvent): string {
  return e.simplex.length === 4 ? 'tetrahedron' : 'triangle';
}

function relabeled(e: TraceEvent, dimension: 2 | 3, domain: DomainCounts | undefined): string {
  if (e.reason === Reason.matching)
    return `In the tubes, ${plural(e.other[1], 'tetrahedron that conforms takes', 'tetrahedra that conform take')} the place of ${formatCount(e.other[0])} Delaunay ones, and match what is around (Theorem 6.15).`;
  const cell = dimension === 2 ? 'triangle' : 'tetrahedron';
  const cells = dimension === 2 ? 'triangles' : 'tetrahedra';
  const lie = (n: number) => plural(n, `${cell} is`, `${cells} are`);
  if (!domain) return `${lie(e.other[1])} now known to be inside or outside the domain.`;
  const { inside, outside } = domain;
  if (outside === 0) return `${lie(inside)} now known to lie inside the domain.`;
  if (inside === 0) return `${lie(outside)} now known to lie outside of the domain.`;
  return `${lie(inside)} now known to lie inside the domain, and ${formatCount(outside)} outside.`;
}

function queued(e: TraceEvent, name: string, dimension: 2 | 3): string {
  const it = capital(name);
  const ball = ballName(e, dimension);
  switch (e.reason) {
    case Reason.encroached:
      return e.subject === NONE
        ? `${it} is unacceptable: a vertex lies inside its ${ball}.`
        : `${it} is unacceptable: vertex ${e.subject} lies inside its ${ball}.`;
    case Reason.witness:
      return `${it} is unacceptable: vertex ${e.subject} is a 1-feature size witness inside its ${ball}.`;
    case Reason.nearWitness:
      return `${it} is unacceptable: vertex ${e.subject}, a Delaunay neighbor of one of its ends or of an end in its spindle, is a 1-feature size witness for it, ${formatNumber(e.value)} away: less than its length.`;
    case Reason.nearLocalWitness:
      return `${it} is unacceptable: vertex ${e.subject}, a Delaunay neighbor of one of its ends, is a local feature size witness for it, ${formatNumber(e.value)} away: less than its length.`;
    case Reason.nearVertex:
      return `${it} is unacceptable: vertex ${e.subject}, a Delaunay neighbor of one of its vertices, lies outside of the face and ${formatNumber(e.value)} away: less than its circumdiameter.`;
    case Reason.missing:
      return `${it} is unacceptable: it is not an edge of the Delaunay triangulation.`;
    case Reason.radiusEdge:
      return `${it} is unacceptable: its circumradius is ${formatNumber(e.value)} times its shortest edge, more than τ.`;
    case Reason.size:
      return `${it} is unacceptable: its circumradius, ${formatNumber(e.value)}, exceeds the size bound.`;
    case Reason.regionSize:
      return `${it} is unacceptable: its ${dimension === 2 ? 'area' : 'volume'}, ${formatNumber(e.value)}, exceeds the bound of its region.`;
    case Reason.sliver:
      return `${it} is a sliver: its smallest dihedral angle is ${formatNumber(e.value)}°, below the bound.`;
    case Reason.tooLong:
      return `${it} is unacceptable: it is ${formatNumber(e.value)} long, more than twice the shortest segment of its spindle, and vertex ${e.subject} lies inside its ${ball}.`;
    case Reason.wide:
      return `${it} is unacceptable: seen from the center of its sphere, its angular radius is above 45 degrees.`;
    case Reason.yieldedTo:
      return `${it} is queued: a circumcenter yielded to it.`;
    case Reason.returned:
      return `${it} goes back to the head of the queue, to wait for that split.`;
    default:
      return `${it} is queued.`;
  }
}

/** The smallest ball that circumscribes a subsegment or, in space, a triangle. */
function ballName(e: TraceEvent, dimension: 2 | 3): string {
  if (e.dimension === 2 && dimension === 3) return 'equatorial ball';
  return dimension === 3 ? 'diametral ball' : 'diametral disk';
}

function inserted(e: TraceEvent, name: string): string {
  const vertex = `Vertex ${e.subject}`;
  const radius = e.value > 0 ? ` Its nearest neighbor was ${formatNumber(e.value)} away.` : '';
  switch (e.reason) {
    case Reason.input:
      return `${vertex} of the input is inserted.`;
    case Reason.box:
      return `${vertex}, a corner of the box, is inserted.`;
    case Reason.midpoint:
      return `${vertex} is inserted at the midpoint of ${name}.${radius}`;
    case Reason.division:
      return `${vertex} is inserted to divide ${name} into equal parts.${radius}`;
    case Reason.collar:
      if (e.dimension === 0) return collarVertex(e, radius);
      return `${vertex} is inserted on ${name}, at the distance that protects its acute angle.${radius}`;
    case Reason.circle:
      if (e.center !== NONE)
        return `Rule 3: vertex ${e.subject} is inserted in face ${e.face} on the circle about input vertex ${e.center}, so that collar arcs there are short.${radius}`;
      return `${vertex} is inserted on the circle that protects an acute angle, so that no arc spans more than a quarter turn.${radius}`;
    case Reason.arcMidpoint:
      return `${vertex} is inserted at the midpoint of ${name}.${radius}`;
    case Reason.equalLength:
      return `${vertex} is inserted on ${name}, so that adjacent segments have pieces of equal lengths.${radius}`;
    case Reason.shell:
      return `${vertex} is inserted on ${name}, on a concentric shell about its input vertex.${radius}`;
    case Reason.third:
      return `${vertex} is inserted on ${name}, a third of the way to the nearest neighbor of its input vertex.${radius}`;
    case Reason.ring:
      if (e.dimension > 0)
        return `${vertex} is inserted on a new ring, which splits ${name}.${radius}`;
      return `${vertex} is inserted on a ring about a segment at its vertex ${e.across}${e.face === NONE ? '' : `, in face ${e.face}`}.${radius}`;
    case Reason.seed:
      return `${vertex} is inserted on the sphere about input vertex ${e.center}, where nothing else is near.${radius}`;
    case Reason.surface:
      return `${vertex} is inserted on the sphere or tube, above the circumcenter of ${name}.${radius}`;
    case Reason.offCenter:
      return `${vertex} is inserted at the off-center of ${name}.${radius}`;
    case Reason.picked:
      return `${vertex} is inserted near the circumcenter of ${name}, where it makes slivers fewer.${radius}`;
    case Reason.circumcenter:
      return `${vertex} is inserted at the circumcenter of ${name}.${radius}`;
    default:
      return `${vertex} is inserted.${radius}`;
  }
}

/** Step 2c of Algorithm 6.2: rules 1 and 2. */
function collarVertex(e: TraceEvent, radius: string): string {
  const where = e.face === NONE ? '' : ` in face ${e.face}`;
  if (e.center !== NONE)
    return `Rule 2: vertex ${e.subject} is inserted${where} beside the end segment at input vertex ${e.center}, on the circle about it that passes through the segment’s tip${e.across === NONE ? '' : `, vertex ${e.across}`}.${radius}`;
  if (e.across === NONE) return `Vertex ${e.subject} of a collar is inserted${where}.${radius}`;
  return `Rule 1: vertex ${e.subject} is inserted${where} straight across from vertex ${e.across} of a segment, at a height in proportion to the longer subsegment there.${radius}`;
}

/** Why Safety refused, as the end of a sentence. */
export function refusal(e: TraceEvent, dimension: 2 | 3): string {
  switch (e.reason) {
    case Reason.outsideDomain:
      return 'its circumcenter lies outside the domain';
    case Reason.protected:
      if (dimension === 3)
        return 'its circumcenter lies in the balls of collar simplices alone, which are never split (Theorem 6.11 allows it)';
      return e.dimension === 1
        ? 'it is a collar simplex, which protects an acute input angle'
        : 'its circumcenter lies in the diametral disk of a collar simplex, which is never split';
    case Reason.minEdge:
      return 'an edge shorter than the bound would appear';
    case Reason.precision:
      return 'the new vertex could not be told from another one in double precision';
    case Reason.seditious:
      return 'its shortest edge is seditious: it joins two segments of a small angle, equally far from where they meet';
    case Reason.outsideFace:
      return 'its circumcenter lies outside of its face';
    case Reason.nearSegment:
      return 'its circumcenter would have an end of a segment of the face for a Delaunay neighbor, nearer than that segment is long';
    case Reason.noRoom:
      return 'all points tried in its ball encroach upon a segment or a face, or lie outside';
    case Reason.notImproved:
      return 'no point tried in its ball leaves fewer slivers and keeps radius-edge ratios and sizes';
    case Reason.frozen:
      return 'it would yield to a subsegment that was refused itself';
    default:
      return 'the Safety rule forbids it';
  }
}

function limit(reason: number): string {
  switch (reason) {
    case Reason.limitVertices:
      return 'the bound on the number of vertices is reached';
    case Reason.limitMinEdge:
      return 'the bound on the shortest edge is reached';
    case Reason.limitSeconds:
      return 'the bound on time is reached';
    case Reason.limitPrecision:
      return 'double precision is exhausted';
    case Reason.limitMemory:
      return 'the bound on memory is reached';
    case Reason.cancelled:
      return 'it was stopped by hand';
    default:
      return 'a limit is reached';
  }
}

/** Steps are numbered as in the thesis; ours between them have names. */
export function stepName(name: string): string {
  return /^[0-9]/.test(name) ? name : `“${name}”`;
}

/** Why a simplex waits, in a few words, for the list of the queue. */
export function reasonInBrief(e: TraceEvent): string {
  switch (e.reason) {
    case Reason.encroached:
      return e.subject === NONE ? 'encroached' : `encroached by vertex ${e.subject}`;
    case Reason.witness:
      return `vertex ${e.subject} is a witness`;
    case Reason.nearWitness:
    case Reason.nearLocalWitness:
      return `witness ${e.subject} is ${formatNumber(e.value)} away`;
    case Reason.nearVertex:
      return `vertex ${e.subject} is ${formatNumber(e.value)} away`;
    case Reason.missing:
      return 'not an edge';
    case Reason.radiusEdge:
      return `R / edge = ${formatNumber(e.value)}`;
    case Reason.size:
      return `R = ${formatNumber(e.value)}`;
    case Reason.regionSize:
      return `area ${formatNumber(e.value)}`;
    case Reason.sliver:
      return `dihedral angle ${formatNumber(e.value)}°`;
    case Reason.tooLong:
      return `length ${formatNumber(e.value)}`;
    case Reason.yieldedTo:
      return 'a circumcenter yielded to it';
    case Reason.returned:
      return 'its circumcenter yielded';
    default:
      return '';
  }
}

function capital(s: string): string {
  return s.charAt(0).toUpperCase() + s.slice(1);
}

function plural(n: number, one: string, many: string): string {
  return `${formatCount(n)} ${n === 1 ? one : many}`;
}
