import { describe, expect, it } from 'vitest';
import { apply, Draft, invert, mergeCommands } from '../../web/src/editor/command';
import {
  type Document,
  emptyDocument,
  fromComplex,
  IdSource,
  type Ids,
  noIds,
  toComplex,
} from '../../web/src/editor/document';
import * as edits from '../../web/src/editor/edits';
import { complexOf, random, square } from './editor-helpers';

/** A random edit of a random part of the document. */
function randomEdit(draft: Draft, next: () => number): void {
  const document = draft.document;
  const pick = <T>(list: readonly T[]) => list[Math.floor(next() * list.length)];
  const some = (list: readonly { id: number }[]) =>
    new Set(list.filter(() => next() < 0.3).map((e) => e.id));
  const ids: Ids = {
    vertices: some(document.vertices),
    segments: some(document.segments),
    holes: some(document.holes),
    regions: some(document.regions),
  };
  switch (Math.floor(next() * 9)) {
    case 0:
      edits.addVertex(draft, [next(), next()]);
      break;
    case 1: {
      const a = pick(document.vertices);
      const b = pick(document.vertices);
      if (a && b) edits.addSegment(draft, a.id, b.id);
      break;
    }
    case 2:
      edits.removeAll(draft, ids);
      break;
    case 3:
      edits.moveAll(draft, ids, next(), next());
      break;
    case 4:
      edits.duplicateAll(draft, ids, 0.1, 0.1);
      break;
    case 5:
      edits.splitCrossings(draft);
      break;
    case 6:
      draft.insert('holes', { at: [next(), next()] });
      draft.insert('regions', { at: [next(), next()], label: 1 });
      break;
    case 7: {
      const segment = pick(document.segments);
      if (segment) edits.splitSegment(draft, segment.id, [next(), next()]);
      break;
    }
    default: {
      const [v, w] = [pick(document.vertices), pick(document.vertices)];
      if (v && w) {
        draft.change('vertices', v.id, { at: w.at });
        edits.weld(draft, new Set([v.id]));
      }
    }
  }
}

describe('commands', () => {
  it('a command and its inverse give the same document, ids and order included', () => {
    const next = random(7);
    const ids = new IdSource();
    let document: Document = fromComplex(square, ids);
    for (let i = 0; i < 400; ++i) {
      const draft = new Draft(document, ids);
      randomEdit(draft, next);
      const after = draft.document;
      expect(apply(document, draft.patches)).toEqual(after);
      expect(apply(after, invert(draft.patches))).toEqual(document);
      expect(invert(invert(draft.patches))).toEqual(draft.patches);
      document = after.vertices.length > 60 ? emptyDocument : after;
    }
  });

  it('a command survives JSON', () => {
    const ids = new IdSource();
    const document = fromComplex(square, ids);
    const draft = new Draft(document, ids);
    edits.addVertex(draft, [0.5, 0.25]);
    draft.reset(fromComplex(complexOf([[3, 4]]), ids));
    const patches = JSON.parse(JSON.stringify(draft.patches));
    expect(apply(document, patches)).toEqual(draft.document);
    expect(apply(draft.document, invert(patches))).toEqual(document);
  });

  it('an edit that changes nothing leaves no patch', () => {
    const ids = new IdSource();
    const document = fromComplex(square, ids);
    const draft = new Draft(document, ids);
    draft.change('vertices', document.vertices[0]!.id, { at: [0, 0] });
    edits.addSegment(draft, document.vertices[1]!.id, document.vertices[0]!.id);
    edits.addVertex(draft, [1, 1]);
    expect(draft.patches).toEqual([]);
  });

  it('merged changes of one thing keep the first before and the last after', () => {
    const ids = new IdSource();
    const document = fromComplex(square, ids);
    const step = (from: Document) => {
      const draft = new Draft(from, ids);
      edits.moveAll(draft, { ...noIds, vertices: new Set([from.vertices[0]!.id]) }, 0.25, 0);
      return { command: { title: 'Move', patches: draft.patches }, after: draft.document };
    };
    const one = step(document);
    const two = step(one.after);
    const merged = mergeCommands(one.command, two.command);
    expect(merged.patches).toHaveLength(1);
    expect(apply(document, merged.patches)).toEqual(two.after);
    expect(apply(two.after, invert(merged.patches))).toEqual(document);
  });

  it('a complex comes back from the document as it went in, markers and bad indices included', () => {
    const ids = new IdSource();
    const complex = {
      ...square,
      holes: [[0.5, 0.5]] as [number, number][],
      regions: [{ at: [0.1, 0.1] as const, label: 2, max: 0.01 }],
      markers: { segments: [1, 2, 3, 4] },
    };
    expect(toComplex(fromComplex(complex, ids))).toEqual(complex);
    const broken = toComplex(fromComplex(complexOf([[0, 0]], [[0, 7]]), ids));
    expect(broken.segments[0]![1]).toBeGreaterThan(0);
  });
});

describe('edits', () => {
  const make = (complex = square) => {
    const ids = new IdSource();
    const document = fromComplex(complex, ids);
    return { ids, document, draft: new Draft(document, ids) };
  };

  it('removing a vertex removes its segments', () => {
    const { draft, document } = make();
    edits.removeAll(draft, { ...noIds, vertices: new Set([document.vertices[0]!.id]) });
    expect(toComplex(draft.document)).toEqual(
      complexOf(
        [
          [1, 0],
          [1, 1],
          [0, 1],
        ],
        [
          [0, 1],
          [1, 2],
        ],
      ),
    );
  });

  it('splitting a segment keeps its marker in both pieces', () => {
    const { draft, document } = make({ ...square, markers: { segments: [5, 6, 7, 8] } });
    edits.splitSegment(draft, document.segments[0]!.id, [0.5, 0]);
    const complex = toComplex(draft.document);
    expect(complex.segments).toHaveLength(5);
    expect(complex.markers?.segments).toEqual([6, 7, 8, 5, 5]);
  });

  it('welding leaves no double and no zero-length segment', () => {
    const { draft, document } = make();
    const [a, b] = document.vertices;
    draft.change('vertices', a!.id, { at: b!.at });
    edits.weld(draft, new Set([a!.id]));
    const complex = toComplex(draft.document);
    expect(complex.vertices).toHaveLength(3);
    expect(complex.segments).toHaveLength(3);
    expect(complex.segments.every(([v, w]) => v !== w)).toBe(true);
  });

  it('a copy is shifted and keeps the segments between its vertices', () => {
    const { draft, document } = make();
    const all = { ...noIds, vertices: new Set(document.vertices.map((v) => v.id)) };
    const copy = edits.duplicateAll(draft, all, 2, 0);
    const complex = toComplex(draft.document);
    expect(complex.vertices.slice(4)).toEqual(square.vertices.map(([x, y]) => [x + 2, y]));
    expect(copy.segments.size).toBe(4);
  });

  it('pasting over itself adds nothing', () => {
    const { draft } = make();
    edits.pasteComplex(draft, square);
    expect(toComplex(draft.document)).toEqual(square);
  });
});
