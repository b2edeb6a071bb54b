import type { ComplexJson } from 'circumball';
import type { Complex2, Point } from '../shared/types.ts';

/**
 * A complex as text for the core and for links. JSON.stringify writes every double so that it reads back bit for bit,
 * with one exception, minus zero, which it writes as 0: so numbers are written here.
 */
export function complexToText(complex: Complex2): string {
  const parts = [
    '"circumball":1,"dimension":2',
    `"vertices":[${complex.vertices.map(pointText).join()}]`,
    `"segments":[${complex.segments.map(([a, b]) => `[${a},${b}]`).join()}]`,
  ];
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
  const markers = [
    ...(vertices ? [`"vertices":[${vertices.join()}]`] : []),
    ...(segments ? [`"segments":[${segments.join()}]`] : []),
  ];
  if (markers.length > 0) parts.push(`"markers":{${markers.join()}}`);
  return `{${parts.join()}}`;
}

function pointText(p: Point): string {
  return `[${numberText(p[0])},${numberText(p[1])}]`;
}

function numberText(x: number): string {
  return Object.is(x, -0) ? '-0' : String(x);
}

/** The plane part of what the core (or a link) gives. Markers are kept only while they fit. */
export function complexFromJson(json: ComplexJson): Complex2 {
  const plane = (p: number[]): Point => [p[0] ?? 0, p[1] ?? 0];
  const vertices = json.vertices.map(plane);
  const segments = (json.segments ?? []).map(([a, b]) => [a, b] as const);
  const markers = {
    ...(json.markers?.vertices?.length === vertices.length && vertices.length > 0
      ? { vertices: json.markers.vertices }
      : {}),
    ...(json.markers?.segments?.length === segments.length && segments.length > 0
      ? { segments: json.markers.segments }
      : {}),
  };
  return {
    vertices,
    segments,
    holes: (json.holes ?? []).map(plane),
    regions: (json.regions ?? []).map((r) => ({
      at: plane(r.at),
      label: r.label,
      ...(r.max === undefined ? {} : { max: r.max }),
    })),
    ...(Object.keys(markers).length > 0 ? { markers } : {}),
  };
}
