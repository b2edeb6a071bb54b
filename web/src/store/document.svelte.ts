import type { Defect } from 'circumball';
import type { CoreClient } from '../core/client.ts';
import { complexToText } from '../core/complex-json.ts';
import { createEditor } from '../editor/index.ts';
import {
  type Complex2,
  type Editor,
  emptyComplex,
  type Selection,
  type Sketch,
  type SnapOptions,
  type ToolId,
} from '../shared/types.ts';

/** The editor as the interface sees it: its state mirrored where Svelte notices, and the core's verdict on the input. */
export class DocumentStore {
  readonly editor: Editor = createEditor(emptyComplex);
  complex = $state.raw<Complex2>(emptyComplex);
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

  get text(): string {
    return complexToText(this.complex);
  }

  get isEmpty(): boolean {
    const { vertices, holes, regions } = this.complex;
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
    this.checkSoon();
    for (const listener of this.listeners) listener();
  }

  /** Asks the core what is wrong with the input, once the hand has rested. */
  private checkSoon(): void {
    clearTimeout(this.checking);
    this.checking = setTimeout(async () => {
      const asked = this.complex;
      try {
        const defects =
          asked.vertices.length > 0 ? await this.core.check(complexToText(asked)) : [];
        if (asked === this.complex) this.defects = defects;
      } catch {
        // The core was lost; it is checked again after the next change, and at the next run.
      }
    }, 120);
  }
}
