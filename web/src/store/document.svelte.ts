import type { Defect } from 'circumball';
import type { CoreClient } from '../core/client.ts';
import { complexToText } from '../core/complex-json.ts';
import { createEditor } from '../editor/index.ts';
import {
  type Complex2,
  type Complex3,
  type Editor,
  emptyComplex,
  type Input,
  isSpace,
  type Selection,
  type Sketch,
  type SnapOptions,
  type ToolId,
} from '../shared/types.ts';

/** The editor as the interface sees it: its state mirrored where Svelte notices, and the core's verdict on the input. */
export class DocumentStore {
  readonly editor: Editor = createEditor(emptyComplex);
  complex = $state.raw<Complex2>(emptyComplex);
  /** A complex of space in place of the drawing, which is kept beneath it. */
  solid = $state.raw<Complex3 | null>(null);
  /** What the faces of `solid` are filled with: four numbers a triangle, three vertices and the face. */
  faceTriangles = $state.raw<Uint32Array>(new Uint32Array(0));
  /** What runs, exports and links are about. */
  readonly input = $derived<Input>(this.solid ?? this.complex);
  selection = $state.raw<Selection>(this.editor.selection);
  sketch = $state.raw<Sketch | null>(null);
  snap = $state.raw<SnapOptions>(this.editor.snap);
  tool = $state<ToolId>(this.editor.tool);
  canUndo = $state(false);
  canRedo = $state(false);
  undoTitle = $state('');
  redoTitle = $state('');
  defects = $state.raw<readonly Defect[]>([]);
  /** Where the input came from: the title of an example or the name of a file. */
  title = $state('');
  /** Bad input as a file gave it, which no complex could be made of. */
  readonly faulty = $derived(this.defects.some((d) => !d.warning));

  private checking: ReturnType<typeof setTimeout> | undefined;
  private readonly listeners = new Set<() => void>();

  constructor(private readonly core: CoreClient) {
    this.editor.subscribe((change) => {
      if (change.document) this.mirrorDocument();
      if (change.selection) this.selection = this.editor.selection;
      if (change.tool) {
        this.tool = this.editor.tool;
        this.snap = this.editor.snap;
      }
      this.sketch = this.editor.sketch;
    });
  }

  /** Called after the document became another one. */
  onChange(listener: () => void): void {
    this.listeners.add(listener);
  }

  /** Puts another input in place of this one; one of the plane can be undone. */
  open(input: Input, title: string): void {
    if (isSpace(input)) {
      this.editor.cancel();
      this.solid = input;
      this.faceTriangles = new Uint32Array(0);
      this.changed();
    } else {
      this.solid = null;
      this.editor.replace(input, title);
    }
  }

  /** Back to the drawing, which lay beneath a complex of space. */
  close(): void {
    if (!this.solid) return;
    this.solid = null;
    this.title = '';
    this.changed();
  }

  get text(): string {
    return complexToText(this.input);
  }

  get isEmpty(): boolean {
    const { vertices, holes, regions } = this.input;
    return vertices.length + holes.length + regions.length === 0;
  }

  setSnap(snap: SnapOptions): void {
    this.editor.setSnap(snap);
    this.snap = this.editor.snap;
  }

  private mirrorDocument(): void {
    this.complex = this.editor.complex;
    this.selection = this.editor.selection;
    this.canUndo = this.editor.canUndo;
    this.canRedo = this.editor.canRedo;
    this.undoTitle = this.editor.undoTitle;
    this.redoTitle = this.editor.redoTitle;
    this.changed();
  }

  private changed(): void {
    this.checkSoon();
    for (const listener of this.listeners) listener();
  }

  /** Asks the core what is wrong with the input, once the hand has rested. */
  private checkSoon(): void {
    clearTimeout(this.checking);
    this.checking = setTimeout(async () => {
      const asked = this.input;
      try {
        const text = complexToText(asked);
        const defects = asked.vertices.length > 0 ? await this.core.check(text) : [];
        if (asked !== this.input) return;
        this.defects = defects;
        if (!isSpace(asked)) return;
        const triangles = await this.core.faceTriangles(text);
        if (asked === this.input) this.faceTriangles = triangles;
      } catch {
        // The core was lost; it is checked again after the next change, and at the next run.
      }
    }, 120);
  }
}
