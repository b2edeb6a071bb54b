/**
 * The document behind the editor: a 2D complex whose things keep an id for life, so that a selection, a command and an undo name
 * the same thing however the lists shift. Immutable.
 */

import type { Complex2, Point, Region2, Selection } from '../shared/types';

export interface Vertex {
  readonly id: number;
  readonly at: Point;
  readonly marker?: number;
}

export interface Segment {
  readonly id: number;
  readonly a: number; // id of a vertex
  readonly b: number;
  readonly marker?: number;
}

export interface Hole {
  readonly id: number;
  readonly at: Point;
}

export interface Region extends Region2 {
  readonly id: number;
}

export interface Document {
  readonly vertices: readonly Vertex[];
  readonly segments: readonly Segment[];
  readonly holes: readonly Hole[];
  readonly regions: readonly Region[];
}

export type Kind = keyof Document;
export const kinds: readonly Kind[] = ['vertices', 'segments', 'holes', 'regions'];
export type Entity<K extends Kind = Kind> = Document[K][number];

export const emptyDocument: Document = { vertices: [], segments: [], holes: [], regions: [] };

/** Gives out ids that were never used before. */
export class IdSource {
  next = 1;

  take(): number {
    return this.next++;
  }

  /** Keeps clear of the ids in a document. */
  skip(document: Document): void {
    for (const kind of kinds) {
      for (const { id } of document[kind]) this.next = Math.max(this.next, id + 1);
    }
  }
}

export function fromComplex(complex: Complex2, ids: IdSource): Document {
  const { markers } = complex;
  const vertices = complex.vertices.map(
    (at, i): Vertex => ({ id: ids.take(), at, ...markerAt(markers?.vertices, i) }),
  );
  const segments = complex.segments.map(
    ([a, b], i): Segment => ({
      id: ids.take(),
      // An index out of range stays one (no vertex has a negative id): the core's check must see it.
      a: vertices[a]?.id ?? -1,
      b: vertices[b]?.id ?? -1,
      ...markerAt(markers?.segments, i),
    }),
  );
  return {
    vertices,
    segments,
    holes: complex.holes.map((at) => ({ id: ids.take(), at })),
    regions: complex.regions.map((region) => ({ id: ids.take(), ...region })),
  };
}

function markerAt(list: readonly number[] | undefined, i: number): { marker?: number } {
  const marker = list?.[i];
  return marker === undefined ? {} : { marker };
}

export function toComplex(document: Document): Complex2 {
  const index = indexOf(document, 'vertices');
  const has = (list: readonly { marker?: number }[]) => list.some((e) => e.marker !== undefined);
  const vertexMarkers = has(document.vertices);
  const segmentMarkers = has(document.segments);
  const complex: Complex2 = {
    vertices: document.vertices.map((v) => v.at),
    segments: document.segments.map(
      (s) => [index.get(s.a) ?? 0xffffffff, index.get(s.b) ?? 0xffffffff] as const,
    ),
    holes: document.holes.map((h) => h.at),
    regions: document.regions.map(({ at, label, max }) =>
      max === undefined ? { at, label } : { at, label, max },
    ),
  };
  if (!vertexMarkers && !segmentMarkers) return complex;
  return {
    ...complex,
    markers: {
      ...(vertexMarkers ? { vertices: document.vertices.map((v) => v.marker ?? 0) } : {}),
      ...(segmentMarkers ? { segments: document.segments.map((s) => s.marker ?? 0) } : {}),
    },
  };
}

const indexes = new WeakMap<readonly { id: number }[], ReadonlyMap<number, number>>();

/** Position by id. Kept with the list, which never changes. */
export function indexOf(document: Document, kind: Kind): ReadonlyMap<number, number> {
  const list = document[kind];
  let index = indexes.get(list);
  if (!index) {
    index = new Map(list.map(({ id }, i) => [id, i]));
    indexes.set(list, index);
  }
  return index;
}

export function find<K extends Kind>(document: Document, kind: K, id: number): Entity<K> | null {
  const i = indexOf(document, kind).get(id);
  return i === undefined ? null : (document[kind][i] as Entity<K>);
}

/** Ends of a segment; null if one is missing. */
export function endsOf(document: Document, segment: Segment): readonly [Point, Point] | null {
  const a = find(document, 'vertices', segment.a);
  const b = find(document, 'vertices', segment.b);
  return a && b ? [a.at, b.at] : null;
}

/** A selection by id. */
export type Ids = { readonly [K in Kind]: ReadonlySet<number> };

export const noIds: Ids = {
  vertices: new Set(),
  segments: new Set(),
  holes: new Set(),
  regions: new Set(),
};

export function isEmpty(ids: Ids): boolean {
  return kinds.every((kind) => ids[kind].size === 0);
}

export function countIds(ids: Ids): number {
  return kinds.reduce((sum, kind) => sum + ids[kind].size, 0);
}

/** Without what the document does not hold. */
export function prune(ids: Ids, document: Document): Ids {
  const keep = (kind: Kind) => {
    const index = indexOf(document, kind);
    return new Set([...ids[kind]].filter((id) => index.has(id)));
  };
  return {
    vertices: keep('vertices'),
    segments: keep('segments'),
    holes: keep('holes'),
    regions: keep('regions'),
  };
}

export function toSelection(ids: Ids, document: Document): Selection {
  const indexes = (kind: Kind) => {
    const index = indexOf(document, kind);
    const list: number[] = [];
    for (const id of ids[kind]) {
      const i = index.get(id);
      if (i !== undefined) list.push(i);
    }
    return new Set(list.sort((a, b) => a - b));
  };
  return {
    vertices: indexes('vertices'),
    segments: indexes('segments'),
    holes: indexes('holes'),
    regions: indexes('regions'),
  };
}

export function fromSelection(selection: Partial<Selection>, document: Document): Ids {
  const ids = (kind: Kind) => {
    const list: number[] = [];
    for (const i of selection[kind] ?? []) {
      const entity = document[kind][i];
      if (entity) list.push(entity.id);
    }
    return new Set(list);
  };
  return {
    vertices: ids('vertices'),
    segments: ids('segments'),
    holes: ids('holes'),
    regions: ids('regions'),
  };
}
