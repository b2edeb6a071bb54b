/** The editor: a document, its history, what is selected, and the tool in hand. No DOM. */

import { roundStep } from '../picture/view';
import type {
  Complex2,
  Editor,
  EditorChange,
  EditorKey,
  EditorPointer,
  Point,
  Region2,
  Selection,
  Sketch,
  SnapOptions,
  ToolId,
} from '../shared/types';
import { Draft, isDocument } from './command';
import {
  type Document,
  fromComplex,
  fromSelection,
  IdSource,
  type Ids,
  isEmpty,
  kinds,
  noIds,
  prune,
  toComplex,
  toSelection,
} from './document';
import {
  addPolyline,
  addSegment,
  addVertex,
  duplicateAll,
  moveAll,
  movedVertices,
  pasteComplex,
  removeAll,
  splitCrossings,
  weld,
} from './edits';
import { History } from './history';
import { KeyboardCursor } from './keyboard-cursor';
import { snapPoint } from './snapping';
import { createTool, tools } from './tools';
import { moveTitle } from './tools/select';
import { emptySketch, type Tool, type ToolContext } from './tools/tool';

/** Characters of history that are stored; more would fill the browser's storage. */
const storedHistory = 1_000_000;

const defaultSnap: SnapOptions = {
  vertex: true,
  segment: true,
  grid: true,
  angle: true,
  gridStep: 0,
};

const nothing: EditorChange = { document: false, selection: false, tool: false, sketch: false };

export class ComplexEditor implements Editor {
  readonly tools = tools;
  private readonly ids = new IdSource();
  private history = new History();
  private base: Document;
  private shown: Document; // the base, or the preview of an edit in the making
  private selected: Ids = noIds;
  private snapOptions = defaultSnap;
  private toolId: ToolId = 'select';
  private implementation: Tool;
  private readonly cursor = new KeyboardCursor();
  private readonly listeners = new Set<(change: EditorChange) => void>();
  private readonly complexes = new WeakMap<Document, Complex2>();
  private selectionOf: { ids: Ids; document: Document; selection: Selection } | null = null;

  constructor(initial: Complex2) {
    this.base = fromComplex(initial, this.ids);
    this.shown = this.base;
    this.implementation = createTool(this.toolId, this.context());
  }

  get tool(): ToolId {
    return this.toolId;
  }

  get complex(): Complex2 {
    let complex = this.complexes.get(this.shown);
    if (!complex) {
      complex = toComplex(this.shown);
      this.complexes.set(this.shown, complex);
    }
    return complex;
  }

  get selection(): Selection {
    const { selected: ids, shown: document, selectionOf: last } = this;
    if (last?.ids === ids && last.document === document) return last.selection;
    const selection = toSelection(ids, document);
    this.selectionOf = { ids, document, selection };
    return selection;
  }

  get snap(): SnapOptions {
    return this.snapOptions;
  }

  get canUndo(): boolean {
    return this.history.canUndo;
  }

  get canRedo(): boolean {
    return this.history.canRedo;
  }

  get undoTitle(): string {
    return this.history.undoTitle;
  }

  get redoTitle(): string {
    return this.history.redoTitle;
  }

  get sketch(): Sketch | null {
    const sketch = this.implementation.sketch;
    const cursor = this.cursor.at;
    return cursor ? { ...(sketch ?? emptySketch), cursor } : sketch;
  }

  setTool(tool: ToolId): void {
    this.implementation.cancel();
    this.toolId = tool;
    this.implementation = createTool(tool, this.context());
    this.emit({ tool: true, sketch: true });
  }

  setSnap(snap: SnapOptions): void {
    this.snapOptions = snap;
    this.emit({ tool: true, sketch: true });
  }

  replace(complex: Complex2, title: string): void {
    this.implementation.cancel();
    this.commit(title, (draft) => {
      draft.reset(fromComplex(complex, draft.ids));
      return noIds;
    });
  }

  paste(complex: Complex2): void {
    this.commit('Paste', (draft) => pasteComplex(draft, complex));
  }

  undo(): void {
    this.step(this.history.undo(this.base));
  }

  redo(): void {
    this.step(this.history.redo(this.base));
  }

  select(selection: Partial<Selection>): void {
    this.setSelected(fromSelection(selection, this.shown));
  }

  selectAll(): void {
    const all = (kind: (typeof kinds)[number]) => new Set(this.shown[kind].map((e) => e.id));
    this.setSelected({
      vertices: all('vertices'),
      segments: all('segments'),
      holes: all('holes'),
      regions: all('regions'),
    });
  }

  clearSelection(): void {
    this.setSelected(noIds);
  }

  deleteSelection(): void {
    if (isEmpty(this.selected)) return;
    const ids = this.selected;
    this.commit('Delete', (draft) => {
      removeAll(draft, ids);
      return noIds;
    });
  }

  duplicateSelection(): void {
    if (isEmpty(this.selected)) return;
    const ids = this.selected;
    const shift = this.duplicateShift();
    this.commit('Duplicate', (draft) => duplicateAll(draft, ids, shift, -shift));
  }

  moveSelection(dx: number, dy: number): void {
    this.move(dx, dy);
  }

  setPosition(kind: 'vertex' | 'hole' | 'region', index: number, at: Point): void {
    const list = kind === 'vertex' ? 'vertices' : kind === 'hole' ? 'holes' : 'regions';
    const entity = this.base[list][index];
    if (!entity) return;
    this.commit('Set coordinates', (draft) => {
      draft.change(list, entity.id, { at });
      if (list === 'vertices') weld(draft, new Set([entity.id]));
      return undefined;
    });
  }

  addPoint(at: Point): void {
    this.commit('Add vertex', (draft) => ({
      ...noIds,
      vertices: new Set([addVertex(draft, at)]),
    }));
  }

  addSegment(a: number, b: number): void {
    const from = this.base.vertices[a];
    const to = this.base.vertices[b];
    if (!from || !to) return;
    this.commit('Add segment', (draft) => {
      const id = addSegment(draft, from.id, to.id);
      return id === null ? undefined : { ...noIds, segments: new Set([id]) };
    });
  }

  joinSelection(close: boolean): void {
    const vertices = [...this.selected.vertices]; // in the order in which they were selected
    if (vertices.length < 2) return;
    this.commit(close ? 'Close polygon' : 'Join vertices', (draft) => {
      addPolyline(draft, vertices, close);
      return undefined;
    });
  }

  setRegion(index: number, region: Region2): void {
    const entity = this.base.regions[index];
    if (!entity) return;
    this.commit('Change region', (draft) => {
      draft.change('regions', entity.id, {
        at: region.at,
        label: region.label,
        max: region.max,
      });
      return undefined;
    });
  }

  splitCrossings(): number {
    let places = 0;
    this.commit('Split crossings', (draft) => {
      places = splitCrossings(draft);
      return undefined;
    });
    return places;
  }

  pointerDown(e: EditorPointer): boolean {
    this.history.seal();
    this.cursor.hide();
    return this.passed(this.implementation.down(e));
  }

  pointerMove(e: EditorPointer): boolean {
    this.cursor.follow(e.at);
    return this.passed(this.implementation.move(e));
  }

  pointerUp(e: EditorPointer): boolean {
    return this.passed(this.implementation.up(e));
  }

  keyDown(e: EditorKey): boolean {
    if (e.key === 'Escape') {
      const busy = this.implementation.cancel();
      const shown = this.cursor.hide();
      this.emit({ sketch: true });
      return busy || shown;
    }
    const step = this.cursor.stepOf(e, this.snapOptions);
    if (step) {
      if (e.control) return false;
      if (this.toolId === 'select' && !isEmpty(this.selected)) this.move(step[0], step[1], 'nudge');
      else this.moveCursor(e, step);
      return true;
    }
    if (e.control || e.alt) return false;
    if (e.key === 'Enter' || (e.key === ' ' && this.cursor.at)) return this.pressAtCursor(e);
    if (e.key === '[' || e.key === ']') return this.cycle(e.key === ']' ? 1 : -1, e.shift);
    if (!this.implementation.key(e)) return false;
    this.emit({ sketch: true });
    return true;
  }

  cancel(): void {
    this.implementation.cancel();
    this.cursor.hide();
    this.emit({ sketch: true });
  }

  subscribe(listener: (change: EditorChange) => void): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  serialize(): string {
    return JSON.stringify({
      version: 1,
      document: this.base,
      history: this.history.toJson(storedHistory),
    });
  }

  restore(text: string): boolean {
    let value: unknown;
    try {
      value = JSON.parse(text);
    } catch {
      return false;
    }
    if (typeof value !== 'object' || value === null) return false;
    const { version, document, history } = value as Record<string, unknown>;
    const restored = new History();
    if (version !== 1 || !isDocument(document) || !restored.fromJson(history)) return false;
    this.implementation.cancel();
    this.history = restored;
    this.base = document;
    this.shown = document;
    this.ids.next = largestId(text) + 1;
    this.selected = noIds;
    this.emit({ document: true, selection: true, sketch: true });
    return true;
  }

  private context(): ToolContext {
    const editor = this;
    return {
      get document() {
        return editor.base;
      },
      get selection() {
        return editor.selected;
      },
      get snapOptions() {
        return editor.snapOptions;
      },
      snap: (e, from = null, exclude = new Set()) =>
        snapPoint(editor.base, editor.snapOptions, {
          at: e.at,
          unitsPerPixel: e.unitsPerPixel,
          touch: e.touch,
          from,
          exclude,
          forceAngle: e.shift,
          free: e.alt,
        }),
      commit: (title, build, merge) => editor.commit(title, build, merge),
      preview: (build) => editor.preview(build),
      select: (ids) => editor.setSelected(ids),
    };
  }

  private commit(title: string, build: (draft: Draft) => Ids | undefined, merge?: string): void {
    const draft = new Draft(this.base, this.ids);
    const before = this.selected;
    const chosen = build(draft);
    const previewed = this.shown !== this.base;
    if (draft.patches.length > 0) {
      this.base = draft.document;
      this.shown = this.base;
      this.selected = prune(chosen ?? before, this.base);
      const command =
        merge === undefined
          ? { title, patches: draft.patches }
          : { title, patches: draft.patches, merge };
      this.history.push(command, before, this.selected);
      this.emit({ document: true, selection: true, sketch: true });
      return;
    }
    this.shown = this.base;
    if (chosen) this.selected = prune(chosen, this.base);
    this.emit({ document: previewed, selection: true, sketch: true });
  }

  private preview(build: ((draft: Draft) => void) | null): void {
    if (build) {
      const draft = new Draft(this.base, this.ids);
      build(draft);
      this.shown = draft.document;
    } else {
      this.shown = this.base;
    }
    this.emit({ document: true, selection: true, sketch: true });
  }

  private step(step: { document: Document; selection: Ids } | null): void {
    if (!step) return;
    this.implementation.cancel();
    this.base = step.document;
    this.shown = this.base;
    this.selected = prune(step.selection, this.base);
    this.emit({ document: true, selection: true, sketch: true });
  }

  private move(dx: number, dy: number, merge?: string): void {
    if (isEmpty(this.selected) || (dx === 0 && dy === 0)) return;
    const ids = this.selected;
    const moved = movedVertices(this.base, ids);
    const key = merge && `${merge} ${kinds.map((kind) => [...ids[kind]].join(',')).join(';')}`;
    this.commit(
      moveTitle(ids, moved.size),
      (draft) => {
        moveAll(draft, ids, dx, dy);
        return ids;
      },
      key,
    );
  }

  private setSelected(ids: Ids): void {
    this.history.seal();
    this.selected = ids;
    this.emit({ selection: true, sketch: true });
  }

  private duplicateShift(): number {
    let low = Number.POSITIVE_INFINITY;
    let high = Number.NEGATIVE_INFINITY;
    for (const { at } of this.base.vertices) {
      low = Math.min(low, at[0]);
      high = Math.max(high, at[0]);
    }
    return high > low ? roundStep((high - low) / 20) : 0.1;
  }

  private moveCursor(e: EditorKey, step: Point): void {
    const at = this.cursor.move(step, this.base);
    this.implementation.move(pointerAt(at, e));
    this.emit({ sketch: true });
  }

  /** Enter presses at the cursor; a second time at the same place, or without a cursor, it tells the tool to finish. */
  private pressAtCursor(e: EditorKey): boolean {
    const at = this.cursor.at;
    if (!at || this.cursor.pressedHere) {
      const used = this.implementation.key(e);
      if (used) this.emit({ sketch: true });
      if (used || !at) return used;
    }
    this.cursor.pressedHere = true;
    const pointer = pointerAt(at, e);
    this.implementation.down(pointer);
    this.implementation.up(pointer);
    this.emit({ sketch: true });
    return true;
  }

  /** The next or last vertex becomes the selection, or joins it. */
  private cycle(by: 1 | -1, extend: boolean): boolean {
    const { vertices } = this.base;
    if (vertices.length === 0) return false;
    const last = [...this.selected.vertices].at(-1);
    const from = vertices.findIndex((v) => v.id === last);
    const next = from < 0 ? (by > 0 ? 0 : vertices.length - 1) : from + by;
    const { id, at } = vertices[(next + vertices.length) % vertices.length]!;
    this.cursor.follow(at);
    const ids = extend ? [...this.selected.vertices, id] : [id];
    this.setSelected({ ...(extend ? this.selected : noIds), vertices: new Set(ids) });
    return true;
  }

  private passed(used: boolean): boolean {
    if (used) this.emit({ sketch: true });
    return used;
  }

  private emit(change: Partial<EditorChange>): void {
    for (const listener of [...this.listeners]) listener({ ...nothing, ...change });
  }
}

function pointerAt(at: Point, e: EditorKey): EditorPointer {
  return {
    at,
    screen: [at[0] / e.unitsPerPixel, -at[1] / e.unitsPerPixel],
    unitsPerPixel: e.unitsPerPixel,
    touch: false,
    shift: e.shift,
    alt: e.alt,
    control: false,
    double: false,
  };
}

/** Ids stand in the stored text as "id":n, in documents and in patches alike. */
function largestId(text: string): number {
  let largest = 0;
  for (const match of text.matchAll(/"id":(\d+)/g)) largest = Math.max(largest, Number(match[1]));
  return largest;
}
