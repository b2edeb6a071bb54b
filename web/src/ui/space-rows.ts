import { collarRegionAt } from '../replay/collar-region.ts';
import { NONE } from '../replay/event.ts';
import { sidesOf } from '../replay/face-replay.ts';
import { circumball, distance3, point3, shortestEdge } from '../replay/geometry3.ts';
import { measureTetrahedron } from '../replay/measure.ts';
import { refusal } from '../replay/sentence.ts';
import { refusalOf, type Stopper } from '../replay/stoppers.ts';
import type { Trace } from '../replay/trace.ts';
import { type Complex3, type MeshState, Protecting, VertexKind } from '../shared/types.ts';
import type { SpaceHit } from '../space/types.ts';
import { texts } from '../texts.ts';
import { formatDegrees, formatNumber } from '../words.ts';
import type { Row } from './inspector-rows.ts';

/** What the inspector lists of what is picked in space. Without a trace the numbers are those of the input. */

const t = texts.inspector;

export function spaceTitle(hit: SpaceHit, trace: Trace | null): string {
  if (hit.vertex !== null) return t.vertex(hit.vertex);
  if (hit.subsegment !== null) return trace ? t.subsegment : t.segment(hit.subsegment);
  if (hit.cell !== null) return t.tetrahedron;
  if (hit.facet !== null) return t.triangle;
  return hit.face === null ? '' : t.face(hit.face);
}

/** What protection says of what is picked, at one state of a run that protects: what is in a collar, who was refused and why. */
export function protectionRows(
  hit: SpaceHit,
  trace: Trace,
  state: MeshState,
  stoppers: readonly Stopper[] | null,
): Row[] {
  const { protecting } = trace;
  if (!protecting?.lives.count) return [];
  const p = texts.protection;
  const rows: Row[] = [];
  if (hit.facet !== null) {
    const region = collarRegionAt(trace, state);
    if (region.facets.length > 0)
      rows.push([p.row, region.holds[hit.facet] ? p.inCollar : p.beyond]);
    const corners = trace.facetLives!.vertices.data.subarray(4 * hit.facet, 4 * hit.facet + 3);
    rows.push(...refusedRow(trace, [...corners]));
  } else if (hit.subsegment !== null) {
    const n = 3 * hit.subsegment;
    const element = protecting.find([...trace.subsegments.data.subarray(n, n + 2)]);
    const since = element < 0 ? Number.POSITIVE_INFINITY : protecting.lives.born.at(element);
    rows.push([p.row, since < state.position ? p.piece : p.ordinary]);
  } else if (hit.vertex !== null) {
    const vertex = hit.vertex;
    const around = elementsAbout(vertex, state);
    if (around.length > 0) rows.push([p.row, p.about(around.length)]);
  } else if (hit.cell !== null) {
    rows.push(...refusedRow(trace, [...trace.cells.data.subarray(4 * hit.cell, 4 * hit.cell + 4)]));
    const [first, ...others] = stoppers ?? [];
    if (first) rows.push([p.stopped, p.stoppers(first.name, others.length)]);
    else if (stoppers) rows.push([p.stopped, p.free]);
  }
  return rows;
}

function refusedRow(trace: Trace, simplex: readonly number[]): Row[] {
  const e = refusalOf(trace, simplex);
  return e ? [[texts.protection.refused, refusal(e, 3)]] : [];
}

/** Arcs and patches about an input vertex. */
function elementsAbout(v: number, { protection }: MeshState): number[] {
  const found: number[] = [];
  for (let i = 0; protection && i < protection.liveCount; i++) {
    const n = protection.live[i]!;
    const kind = protection.kind[n];
    const place = kind === Protecting.collarArc ? 2 : kind === Protecting.spherePatch ? 3 : -1;
    if (place >= 0 && protection.elements[4 * n + place] === v) found.push(n);
  }
  return found;
}

export function spaceRows(hit: SpaceHit, complex: Complex3, trace: Trace | null): Row[] {
  if (hit.vertex !== null) return vertexRows(hit.vertex, complex, trace);
  if (hit.subsegment !== null)
    return trace ? subsegmentRows(hit.subsegment, trace) : segmentRows(hit.subsegment, complex);
  if (hit.cell !== null && trace) return cellRows(hit.cell, trace);
  if (hit.facet !== null && trace) return facetRows(hit.facet, trace);
  return hit.face === null ? [] : faceRows(hit.face, complex);
}

function vertexRows(v: number, complex: Complex3, trace: Trace | null): Row[] {
  const known = trace !== null && v < trace.vertexCount;
  const at = known ? point3(trace.coordinates.data, v) : complex.vertices[v];
  if (!at) return [];
  const rows: Row[] = [
    ['x', String(at[0])],
    ['y', String(at[1])],
    ['z', String(at[2])],
    [t.features, known ? featuresOf(v, complex, trace) : ofInput(v, complex)],
  ];
  if (!known || trace.vertexBorn.at(v) === NONE) return rows;
  const birth = trace.event(trace.vertexBorn.at(v));
  rows.push([t.born, t.event(birth.index + 1, trace.steps[birth.step] ?? '')]);
  if (birth.value > 0) rows.push([t.insertionRadius, formatNumber(birth.value)]);
  return rows;
}

function featuresOf(v: number, complex: Complex3, trace: Trace): string {
  const birth = trace.event(trace.vertexBorn.at(v));
  switch (trace.vertexKind.data[v]) {
    case VertexKind.input:
      return ofInput(v, complex);
    case VertexKind.box:
      return t.box;
    case VertexKind.onSegment:
      return birth.segment < complex.segments.length ? t.onSegment(birth.segment) : t.onBoxEdge;
    case VertexKind.inFace:
      return birth.face < complex.faces.length ? t.inFace(birth.face) : t.onBoxFace;
    default:
      return t.free;
  }
}

function ofInput(v: number, complex: Complex3): string {
  const segments = complex.segments.flatMap((s, i) => (s.includes(v) ? [i] : []));
  const faces = complex.faces.flatMap((f, i) =>
    f.vertices.includes(v) || f.loops.some((loop) => loop.includes(v)) ? [i] : [],
  );
  const of = faces.length > 0 ? `; ${t.ofFaces(faces)}` : '';
  return `${t.ends(segments)}${of}`;
}

function subsegmentRows(n: number, trace: Trace): Row[] {
  if (n >= trace.subsegmentCount) return [];
  const [a, b, s] = trace.subsegments.data.subarray(3 * n, 3 * n + 3) as unknown as Three;
  const xyz = trace.coordinates.data;
  return [
    ['vertices', `${a}, ${b}`],
    ['input segment', s < trace.input.segments.length ? String(s) : t.ofBox],
    ['length', formatNumber(distance3(point3(xyz, a), point3(xyz, b)))],
  ];
}

type Three = [number, number, number];

function segmentRows(s: number, complex: Complex3): Row[] {
  const [a, b] = complex.segments[s] ?? [0, 0];
  const [p, q] = [complex.vertices[a], complex.vertices[b]];
  if (!p || !q) return [];
  return [
    ['vertices', `${a}, ${b}`],
    ['length', formatNumber(distance3(p, q))],
  ];
}

function facetRows(n: number, trace: Trace): Row[] {
  const lives = trace.facetLives;
  if (!lives || n >= lives.count) return [];
  const [a, b, c, face] = lives.vertices.data.subarray(4 * n, 4 * n + 4) as unknown as [
    ...Three,
    number,
  ];
  const corners = [a, b, c].map((v) => point3(trace.coordinates.data, v));
  const radius = circumball(corners)?.radius ?? Number.POSITIVE_INFINITY;
  const edge = shortestEdge(corners);
  return [
    ['vertices', `${a}, ${b}, ${c}`],
    ['face', String(face)],
    ['circumradius', formatNumber(radius)],
    ['shortest edge', formatNumber(edge)],
    ['radius / edge', formatNumber(radius / edge)],
  ];
}

function cellRows(n: number, trace: Trace): Row[] {
  if (n >= trace.cellCount) return [];
  const m = measureTetrahedron(trace, n);
  return [
    ['vertices', Array.from(trace.cells.data.subarray(4 * n, 4 * n + 4)).join(', ')],
    [
      'dihedral angles',
      `${formatDegrees(Math.min(...m.angles))} … ${formatDegrees(Math.max(...m.angles))}`,
    ],
    ['circumradius', formatNumber(m.circumradius)],
    ['shortest edge', formatNumber(m.shortestEdge)],
    ['radius / edge', formatNumber(m.radiusEdge)],
    ['volume', formatNumber(m.volume)],
  ];
}

function faceRows(f: number, complex: Complex3): Row[] {
  const face = complex.faces[f];
  if (!face) return [];
  const rows: Row[] = [['loops', face.loops.map((loop) => loop.length).join(', ')]];
  if (face.segments.length > 0) rows.push(['segments in it', String(face.segments.length)]);
  if (face.vertices.length > 0) rows.push(['vertices in it', String(face.vertices.length)]);
  if (face.holes.length > 0) rows.push(['holes', String(face.holes.length)]);
  return rows;
}

/** The faces that what is picked lies in. */
export function facesAt(hit: SpaceHit, complex: Complex3, trace: Trace | null): number[] {
  if (hit.face !== null) return [hit.face];
  if (!trace) return [];
  const { vertex: v, subsegment: n } = hit;
  if (n !== null && n < trace.subsegmentCount)
    return facesOfSegment(trace.subsegments.at(3 * n + 2), complex);
  if (v === null || v >= trace.vertexCount || trace.vertexBorn.at(v) === NONE) return [];
  const birth = trace.event(trace.vertexBorn.at(v));
  if (birth.dimension === 1) return facesOfSegment(birth.segment, complex);
  if (birth.face !== NONE) return [birth.face];
  return complex.faces.flatMap((f, i) =>
    f.vertices.includes(v) || f.loops.some((loop) => loop.includes(v)) ? [i] : [],
  );
}

function facesOfSegment(s: number, complex: Complex3): number[] {
  const [a, b] = complex.segments[s] ?? [NONE, NONE];
  return complex.faces.flatMap((f, i) => {
    if (f.segments.includes(s)) return [i];
    for (const [p, q] of sidesOf(f)) if ((p === a && q === b) || (p === b && q === a)) return [i];
    return [];
  });
}
