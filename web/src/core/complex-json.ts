import type { ComplexJson } from 'circumball';
import {
  type Complex2,
  type Complex3,
  type Face3,
  type Input,
  isSpace,
  type Point,
  type Point3,
} from '../shared/types.ts';

/**
 * A complex as text for the core and for links. JSON.stringify writes every double so that it reads back bit for bit,
 * with one exception, minus zero, which it writes as 0: so numbers are written here.
 */
export function complexToText(complex: Input): string {
  const space = isSpace(complex);
  const parts = [
    `"circumball":1,"dimension":${space ? 3 : 2}`,
    `"vertices":[${complex.vertices.map(pointText).join()}]`,
    `"segments":[${complex.segments.map(([a, b]) => `[${a},${b}]`).join()}]`,
  ];
  if (space) parts.push(`"faces":[${complex.faces.map(faceText).join()}]`);
  if (complex.holes.length > 0) parts.push(`"holes":[${complex.holes.map(pointText).join()}]`);
  if (complex.regions.length > 0) {
    const regions = complex.regions.map(
      (r) =>
        `{"at":${pointText(r.at)},"label":${numberText(r.label)}` +
        (r.max === undefined ? '}' : `,"max":${numberText(r.max)}}`),
    );
    parts.push(`"regions":[${regions.join()}]`);
  }
  const { vertices, segments } = complex.markers ?? {};
  const faces = space ? complex.markers?.faces : undefined;
  const markers = [
    ...(vertices ? [`"vertices":[${vertices.join()}]`] : []),
    ...(segments ? [`"segments":[${segments.join()}]`] : []),
    ...(faces ? [`"faces":[${faces.join()}]`] : []),
  ];
  if (markers.length > 0) parts.push(`"markers":{${markers.join()}}`);
  return `{${parts.join()}}`;
}

function faceText({ loops, holes, segments, vertices }: Face3): string {
  return (
    `{"loops":[${loops.map((loop) => `[${loop.join()}]`).join()}]` +
    (holes.length > 0 ? `,"holes":[${holes.map(pointText).join()}]` : '') +
    (segments.length > 0 ? `,"segments":[${segments.join()}]` : '') +
    (vertices.length > 0 ? `,"vertices":[${vertices.join()}]` : '') +
    '}'
  );
}

function pointText(p: readonly number[]): string {
  return `[${p.map(numberText).join()}]`;
}

function numberText(x: number): string {
  return Object.is(x, -0) ? '-0' : String(x);
}

/** What the core (or a link) gives, in the dimension that it is of. */
export function inputFromJson(json: ComplexJson): Input {
  return json.dimension === 3 ? spaceFromJson(json) : complexFromJson(json);
}

function spaceFromJson(json: ComplexJson): Complex3 {
  const space = (p: number[]): Point3 => [p[0] ?? 0, p[1] ?? 0, p[2] ?? 0];
  const vertices = json.vertices.map(space);
  const segments = (json.segments ?? []).map(([a, b]) => [a, b] as const);
  const faces = (json.faces ?? []).map((f) => ({
    loops: f.loops,
    holes: (f.holes ?? []).map(space),
    segments: f.segments ?? [],
    vertices: f.vertices ?? [],
  }));
  return {
    dimension: 3,
    vertices,
    segments,
    faces,
    holes: (json.holes ?? []).map(space),
    regions: (json.regions ?? []).map((r) => ({ ...r, at: space(r.at) })),
    ...fittingMarkers(json, {
      vertices: vertices.length,
      segments: segments.length,
      faces: faces.length,
    }),
  };
}

/** Markers are kept only while they fit. */
function fittingMarkers(json: ComplexJson, counts: Record<string, number>) {
  const fitting = Object.entries(json.markers ?? {}).filter(
    ([name, list]) => list.length > 0 && list.length === counts[name],
  );
  return fitting.length > 0 ? { markers: Object.fromEntries(fitting) } : {};
}

/** The plane part of what the core (or a link) gives. */
export function complexFromJson(json: ComplexJson): Complex2 {
  const plane = (p: number[]): Point => [p[0] ?? 0, p[1] ?? 0];
  const vertices = json.vertices.map(plane);
  const segments = (json.segments ?? []).map(([a, b]) => [a, b] as const);
  return {
    vertices,
    segments,
    holes: (json.holes ?? []).map(plane),
    regions: (json.regions ?? []).map((r) => ({
      at: plane(r.at),
      label: r.label,
      ...(r.max === undefined ? {} : { max: r.max }),
    })),
    ...fittingMarkers(json, { vertices: vertices.length, segments: segments.length }),
  };
}
