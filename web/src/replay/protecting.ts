import { NEVER, Protecting } from '../shared/types.ts';
import { NONE } from './event.ts';
import { ascending, Lives, type Record4 } from './lives.ts';
import { SimplexTable } from './simplex-table.ts';

/** One protecting element, taken out of its record (ProtectingElement in lib/include/circumball/trace.h). */
export interface ProtectingElement {
  readonly kind: number;
  readonly vertices: readonly number[]; // two, or the three of a patch
  readonly center: number; // of an arc: the vertex that it is about; NONE
  readonly carrier: number; // face, input vertex or input segment, by its kind
}

/** Numbers of a record in the simplex stream: a, b, c, carrier, kind. */
export const ELEMENT_NUMBERS = 5;

/** The protecting elements of a run in space: numbered by birth, with their lives, and found by their ends. */
export class ProtectingLives {
  /** Four numbers an element: a, b, c and its carrier; the label is its kind. */
  readonly lives = new Lives(4);
  /** By kind, the event that made the first one. */
  readonly firstOfKind: number[] = Object.values(Protecting).map(() => NEVER);
  private readonly byVertices = new SimplexTable();

  bear(stream: Uint32Array, at: number, event: number): void {
    const [a, b, c, carrier, kind] = recordAt(stream, at);
    const number = this.lives.count;
    if (this.firstOfKind[kind] === NEVER) this.firstOfKind[kind] = event;
    this.lives.bear([a, b, c, carrier], keyOf(a, b, c, carrier, kind), kind, event);
    const [p, q, r] = ascending(a, b, isPatch(kind) ? c : NONE, NONE);
    this.byVertices.set(p, q, r, number);
  }

  /** False if there is no such element. */
  kill(stream: Uint32Array, at: number, event: number): boolean {
    return this.lives.kill(keyOf(...recordAt(stream, at)), event);
  }

  /** The curve between two vertices, or the patch of three, that lives or lived last; -1 if there was none. */
  find(vertices: readonly number[]): number {
    const [a = NONE, b = NONE, c = NONE] = vertices;
    const [p, q, r] = ascending(a, b, c, NONE);
    return this.byVertices.get(p, q, r);
  }

  element(number: number): ProtectingElement {
    const { vertices, label } = this.lives;
    const [a, b, c, carrier] = vertices.data.subarray(4 * number, 4 * number + 4);
    const kind = label.data[number]!;
    const patch = isPatch(kind);
    return {
      kind,
      vertices: patch ? [a!, b!, c!] : [a!, b!],
      center: patch ? NONE : c!,
      carrier: carrier!,
    };
  }
}

export function isPatch(kind: number): boolean {
  return kind === Protecting.spherePatch || kind === Protecting.tubePatch;
}

type Record5 = [number, number, number, number, number];

function recordAt(stream: Uint32Array, at: number): Record5 {
  return Array.from(stream.subarray(at, at + ELEMENT_NUMBERS)) as Record5;
}

/** Its vertices in ascending order, and its carrier together with its kind: numbers of carriers are small. */
function keyOf(a: number, b: number, c: number, carrier: number, kind: number): Record4 {
  const [p, q, r] = ascending(a, b, c, NONE);
  return [p, q, r, (carrier * 8 + kind) >>> 0];
}
