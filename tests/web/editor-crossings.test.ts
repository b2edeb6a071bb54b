import { describe, expect, it } from 'vitest';
import { Draft } from '../../web/src/editor/command';
import { findMeetings, meet } from '../../web/src/editor/crossings';
import { endsOf, fromComplex, IdSource, toComplex } from '../../web/src/editor/document';
import { splitCrossings } from '../../web/src/editor/edits';
import { orientation } from '../../web/src/editor/orientation';
import type { Complex2, Point } from '../../web/src/shared/types';
import { complexOf, random } from './editor-helpers';

describe('orientation', () => {
  it('is exact next to a line, where rounding is not', () => {
    const ulp = 2 ** -53;
    for (let i = 0; i < 32; ++i) {
      for (let j = 0; j < 32; ++j) {
        const p: Point = [0.5 + i * ulp, 0.5 + j * ulp];
        expect(orientation(p, [12, 12], [24, 24])).toBe(Math.sign(j - i) || 0);
      }
    }
  });

  it('changes sign when two points are exchanged, tiny, huge and subnormal', () => {
    const next = random(3);
    for (const scale of [1, 1e-300, 1e150, 5e-324]) {
      for (let i = 0; i < 200; ++i) {
        const point = (): Point => [Math.floor(next() * 8) * scale, Math.floor(next() * 8) * scale];
        const [a, b, c] = [point(), point(), point()];
        expect(orientation(a, b, c) + orientation(b, a, c)).toBe(0);
        expect(orientation(a, b, c)).toBe(orientation(b, c, a));
      }
    }
  });
});

describe('meetings', () => {
  it('tells crossing, touch and overlap apart, and a shared end from all of them', () => {
    const s = (ax: number, ay: number, bx: number, by: number) =>
      [
        [ax, ay],
        [bx, by],
      ] as const;
    expect(meet(s(0, 0, 2, 2), s(0, 2, 2, 0))).toEqual({ kind: 'crossing', at: [1, 1] });
    expect(meet(s(0, 0, 2, 0), s(1, 0, 1, 3))).toEqual({ kind: 'touch', end: 2 });
    expect(meet(s(0, 0, 2, 0), s(1, 0, 3, 0))).toEqual({ kind: 'overlap', ends: [1, 2] });
    expect(meet(s(0, 0, 2, 0), s(2, 0, 3, 4))).toBeNull();
    expect(meet(s(0, 0, 2, 0), s(2, 0, 3, 0))).toBeNull();
    expect(meet(s(0, 0, 1, 1), s(5, 5, 6, 6))).toBeNull();
  });

  it('the sweep finds what all pairs find', () => {
    const next = random(11);
    const point = (): Point => [Math.floor(next() * 12), Math.floor(next() * 12)];
    const segments = Array.from({ length: 90 }, () => [point(), point()] as const);
    const brute: string[] = [];
    for (let i = 0; i < segments.length; ++i) {
      for (let j = i + 1; j < segments.length; ++j) {
        if (meet(segments[i]!, segments[j]!)) brute.push(`${i} ${j}`);
      }
    }
    expect(findMeetings(segments).map(({ i, j }) => `${i} ${j}`)).toEqual(brute);
    expect(brute.length).toBeGreaterThan(100);
  });
});

describe('splitting of crossings', () => {
  function split(complex: Complex2): { after: Complex2; places: number } {
    const ids = new IdSource();
    const draft = new Draft(fromComplex(complex, ids), ids);
    const places = splitCrossings(draft);
    const document = draft.document;
    expect(findMeetings(document.segments.map((s) => endsOf(document, s)))).toEqual([]);
    return { after: toComplex(document), places };
  }

  it('makes four segments of two that cross', () => {
    const { after, places } = split(
      complexOf(
        [
          [0, 0],
          [1, 1],
          [0, 1],
          [1, 0],
        ],
        [
          [0, 1],
          [2, 3],
        ],
      ),
    );
    expect(places).toBe(1);
    expect(after.vertices[4]).toEqual([0.5, 0.5]);
    expect(after.segments).toHaveLength(4);
  });

  it('cuts a segment at a vertex inside it, and leaves one piece of an overlap', () => {
    const touch = split(
      complexOf(
        [
          [0, 0],
          [2, 0],
          [1, 0],
          [1, 1],
        ],
        [
          [0, 1],
          [2, 3],
        ],
      ),
    );
    expect(touch.after.segments).toHaveLength(3);
    expect(touch.after.vertices).toHaveLength(4);
    const overlap = split(
      complexOf(
        [
          [0, 0],
          [2, 0],
          [1, 0],
          [3, 0],
        ],
        [
          [0, 1],
          [2, 3],
        ],
      ),
    );
    expect(overlap.after.segments).toHaveLength(3);
  });

  it('leaves nothing that meets in a star of forty random segments', () => {
    const next = random(5);
    const vertices = Array.from({ length: 80 }, (): Point => [next(), next()]);
    const segments = Array.from({ length: 40 }, (_, i): [number, number] => [2 * i, 2 * i + 1]);
    const { places } = split(complexOf(vertices, segments));
    expect(places).toBeGreaterThan(50);
  });
});
