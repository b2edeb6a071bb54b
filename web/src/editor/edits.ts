/** Edits: what the commands of the editor do to a draft. Each keeps the complex free of duplicates as far as it can. */

import type { Complex2, Point } from '../shared/types';
import type { Draft } from './command';
import { findMeetings } from './crossings';
import { type Document, endsOf, find, fromComplex, type Ids } from './document';

/** The vertex at exactly this place: the one that is there, or a new one. */
export function addVertex(draft: Draft, at: Point): number {
  return draft.vertexAt(at) ?? draft.insert('vertices', { at });
}

/** A vertex at `at` in the interior of a segment, which becomes two. Markers are handed down. */
export function splitSegment(draft: Draft, segment: number, at: Point): number {
  const vertex = addVertex(draft, at);
  const old = draft.get('segments', segment);
  if (!old || old.a === vertex || old.b === vertex) return vertex;
  draft.remove('segments', segment);
  addSegment(draft, old.a, vertex, old.marker);
  addSegment(draft, vertex, old.b, old.marker);
  return vertex;
}

/** Null if the ends are one vertex; the segment that is there if there is one. */
export function addSegment(draft: Draft, a: number, b: number, marker?: number): number | null {
  if (a === b) return null;
  const there = draft.segmentBetween(a, b);
  if (there !== null) return there;
  return draft.insert('segments', marker === undefined ? { a, b } : { a, b, marker });
}

/** Segments along the vertices, and back to the first if `closed`. */
export function addPolyline(draft: Draft, vertices: readonly number[], closed: boolean): void {
  for (let i = 1; i < vertices.length; ++i) addSegment(draft, vertices[i - 1]!, vertices[i]!);
  if (closed && vertices.length > 2) addSegment(draft, vertices.at(-1)!, vertices[0]!);
}

/** With a vertex go its segments. */
export function removeAll(draft: Draft, ids: Ids): void {
  const segments = draft.document.segments.filter(
    (s) => ids.segments.has(s.id) || ids.vertices.has(s.a) || ids.vertices.has(s.b),
  );
  draft.removeMany('segments', new Set(segments.map((s) => s.id)));
  for (const kind of ['vertices', 'holes', 'regions'] as const) draft.removeMany(kind, ids[kind]);
}

/** The vertices that move with a selection: its own, and the ends of its segments. */
export function movedVertices(document: Document, ids: Ids): Set<number> {
  const moved = new Set(ids.vertices);
  for (const id of ids.segments) {
    const segment = find(document, 'segments', id);
    if (segment) moved.add(segment.a).add(segment.b);
  }
  return moved;
}

export function moveAll(draft: Draft, ids: Ids, dx: number, dy: number): void {
  const shift = (p: Point): Point => [p[0] + dx, p[1] + dy];
  for (const id of movedVertices(draft.document, ids)) {
    const vertex = draft.get('vertices', id);
    if (vertex) draft.change('vertices', id, { at: shift(vertex.at) });
  }
  for (const kind of ['holes', 'regions'] as const) {
    for (const id of ids[kind]) {
      const seed = draft.get(kind, id);
      if (seed) draft.change(kind, id, { at: shift(seed.at) });
    }
  }
}

/** Vertices that came to lie exactly on others become one with them; segments follow, none doubled, none of length zero. */
export function weld(draft: Draft, moved: ReadonlySet<number>): void {
  for (const id of moved) {
    const vertex = draft.get('vertices', id);
    const other = vertex && draft.vertexAt(vertex.at, id);
    if (!vertex || other === null) continue;
    for (const segment of draft.document.segments.filter((s) => s.a === id || s.b === id)) {
      draft.remove('segments', segment.id);
      const a = segment.a === id ? other : segment.a;
      const b = segment.b === id ? other : segment.b;
      addSegment(draft, a, b, segment.marker);
    }
    draft.remove('vertices', id);
  }
}

/** A copy of the selection, shifted; returns the copy. Segments come with their ends. */
export function duplicateAll(draft: Draft, ids: Ids, dx: number, dy: number): Ids {
  const document = draft.document;
  const shift = (p: Point): Point => [p[0] + dx, p[1] + dy];
  const copies = new Map<number, number>();
  const copied = movedVertices(document, ids);
  for (const vertex of document.vertices) {
    if (!copied.has(vertex.id)) continue;
    const { id, ...rest } = vertex;
    copies.set(id, draft.insert('vertices', { ...rest, at: shift(vertex.at) }));
  }
  const segments = new Set<number>();
  for (const segment of document.segments) {
    // Between two selected vertices a segment is meant too.
    const a = copies.get(segment.a);
    const b = copies.get(segment.b);
    if (a === undefined || b === undefined) continue;
    const { id: _, ...rest } = segment;
    segments.add(draft.insert('segments', { ...rest, a, b }));
  }
  const seeds = <K extends 'holes' | 'regions'>(kind: K) => {
    const added = new Set<number>();
    for (const seed of document[kind]) {
      if (!ids[kind].has(seed.id)) continue;
      const { id: _, ...rest } = seed;
      added.add(draft.insert(kind, { ...rest, at: shift(seed.at) } as never));
    }
    return added;
  };
  return {
    vertices: new Set(copies.values()),
    segments,
    holes: seeds('holes'),
    regions: seeds('regions'),
  };
}

/** Everything of a complex beside what is there; equal vertices become one. Returns what it became. */
export function pasteComplex(draft: Draft, complex: Complex2): Ids {
  const pasted = fromComplex(complex, draft.ids);
  const vertex = new Map<number, number>();
  for (const { id, at } of pasted.vertices) vertex.set(id, addVertex(draft, at));
  const segments = new Set<number>();
  for (const { a, b, marker } of pasted.segments) {
    const from = vertex.get(a);
    const to = vertex.get(b);
    if (from === undefined || to === undefined) continue;
    const id = addSegment(draft, from, to, marker);
    if (id !== null) segments.add(id);
  }
  const holes = new Set(pasted.holes.map(({ at }) => draft.insert('holes', { at })));
  const regions = new Set(
    pasted.regions.map(({ id: _, ...rest }) => draft.insert('regions', rest)),
  );
  return { vertices: new Set(vertex.values()), segments, holes, regions };
}

/** Rounds that a split may take: rounded crossings can, rarely, make new ones. */
const mostRounds = 8;

/**
 * Splits segments where they cross, where a vertex lies inside one, and where they overlap. Returns the number of
 * places. Afterwards no two segments meet but at a vertex of both, unless the rounding of `mostRounds` rounds would not have it.
 */
export function splitCrossings(draft: Draft): number {
  let places = 0;
  for (let round = 0; round < mostRounds; ++round) {
    const document = draft.document;
    const segments = document.segments;
    const pairs = findMeetings(segments.map((s) => endsOf(document, s)));
    if (pairs.length === 0) break;
    const cuts = new Map<number, Set<number>>();
    const cut = (segment: number, vertex: number) => {
      const list = cuts.get(segment) ?? new Set();
      cuts.set(segment, list.add(vertex));
    };
    for (const { i, j, meeting } of pairs) {
      const [s, t] = [segments[i]!, segments[j]!];
      const ends = [s.a, s.b, t.a, t.b] as const;
      if (meeting.kind === 'crossing') {
        const vertex = addVertex(draft, meeting.at);
        cut(s.id, vertex);
        cut(t.id, vertex);
      } else {
        const inside = meeting.kind === 'touch' ? [meeting.end] : meeting.ends;
        for (const end of inside) cut(end < 2 ? t.id : s.id, ends[end]!);
      }
      ++places;
    }
    const placed = draft.document;
    draft.removeMany('segments', new Set(cuts.keys()));
    for (const [id, vertices] of cuts) addPieces(draft, placed, id, [...vertices]);
  }
  return places;
}

/** The pieces of a segment of `document` that is cut at vertices. */
function addPieces(
  draft: Draft,
  document: Document,
  id: number,
  vertices: readonly number[],
): void {
  const segment = find(document, 'segments', id);
  const ends = segment && endsOf(document, segment);
  if (!segment || !ends) return;
  const [a, b] = ends;
  const along = (v: number) => {
    const at = find(document, 'vertices', v)!.at;
    return (at[0] - a[0]) * (b[0] - a[0]) + (at[1] - a[1]) * (b[1] - a[1]);
  };
  const sorted = vertices.filter((v) => v !== segment.a && v !== segment.b);
  sorted.sort((v, w) => along(v) - along(w) || v - w);
  const chain = [segment.a, ...sorted, segment.b];
  for (let i = 1; i < chain.length; ++i) {
    addSegment(draft, chain[i - 1]!, chain[i]!, segment.marker);
  }
}
