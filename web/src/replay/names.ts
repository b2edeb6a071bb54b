import { Protecting } from '../shared/types.ts';
import { simplexName } from '../words.ts';
import { NONE, type TraceEvent } from './event.ts';
import type { ProtectingElement, ProtectingLives } from './protecting.ts';

/** "collar segment 3–7 in face 2", "collar arc 3–7 about vertex 0 in face 2", "sphere patch 1–2–3 about vertex 0". */
export function elementName({ kind, vertices, center, carrier }: ProtectingElement): string {
  const name = vertices.join('–');
  switch (kind) {
    case Protecting.collarSegment:
      return `collar segment ${name} in face ${carrier}`;
    case Protecting.collarArc:
      return `collar arc ${name} about vertex ${center} in face ${carrier}`;
    case Protecting.ringArc:
      return `ring arc ${name} about vertex ${center} of segment ${carrier}`;
    case Protecting.spherePatch:
      return `sphere patch ${name} about vertex ${carrier}`;
    case Protecting.tubePatch:
      return `tube patch ${name} about segment ${carrier}`;
    default:
      return `protected subsegment ${name} of segment ${carrier}`;
  }
}

/** A simplex by what it is: an element that protects, where the run has such, or what simplexName says. */
export function nameOf(
  protecting: ProtectingLives | null,
  simplex: readonly number[],
  segment: number,
  face: number,
): string {
  const bare =
    face === NONE && (simplex.length === 3 || (simplex.length === 2 && segment === NONE));
  const number = bare && protecting ? protecting.find(simplex) : -1;
  return number < 0
    ? simplexName(simplex, segment, face)
    : elementName(protecting!.element(number));
}

export function eventName(protecting: ProtectingLives | null, e: TraceEvent): string {
  // An arc of a ring knows the segment that it goes around: it is no piece of it.
  return nameOf(protecting, e.simplex, e.center === NONE ? e.segment : NONE, e.face);
}
