/** From a snapped place to a vertex of the draft: the one that is there, one that splits a segment, or a new one. */

import type { Point } from '../../shared/types';
import type { Draft } from '../command';
import { meet } from '../crossings';
import { type Document, endsOf, find } from '../document';
import { addVertex, splitSegment } from '../edits';
import { nearestSegment, type Snapped } from '../snapping';

export function vertexAt(draft: Draft, snapped: Snapped): number {
  if (snapped.vertex !== null && find(draft.document, 'vertices', snapped.vertex)) {
    return snapped.vertex;
  }
  if (snapped.segment !== null) {
    if (find(draft.document, 'segments', snapped.segment)) {
      return splitSegment(draft, snapped.segment, snapped.at);
    }
    // An earlier corner has split it: one of the pieces is meant.
    const piece = nearestSegment(draft.document, snapped.at, Number.MIN_VALUE);
    if (piece) return splitSegment(draft, piece.id, snapped.at);
  }
  return addVertex(draft, snapped.at);
}

/** Places where a line would cross segments of the document. */
export function crossingsOf(document: Document, a: Point, b: Point): Point[] {
  const places: Point[] = [];
  for (const segment of document.segments) {
    const ends = endsOf(document, segment);
    const meeting = ends && meet([a, b], ends);
    if (meeting?.kind === 'crossing') places.push(meeting.at);
  }
  return places;
}
