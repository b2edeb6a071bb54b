import type { AlgorithmInfo, Defect, RunOptions } from 'circumball';
import { CoreClient, type CoreLoss } from '../core/client.ts';
import { complexFromJson } from '../core/complex-json.ts';
import type { Hello } from '../core/worker.ts';
import type { Shared } from '../link/link.ts';
import { type Complex2, emptyComplex, type Hit, type Picture, type View } from '../shared/types.ts';
import { texts } from '../texts.ts';
import { DocumentStore } from './document.svelte.ts';
import { ParameterStore } from './parameters.svelte.ts';
import { PlaybackStore } from './playback.svelte.ts';
import { RunStore } from './run.svelte.ts';
import { Settings } from './settings.svelte.ts';

export type DialogId = 'gallery' | 'export' | 'share' | 'help';
export type Tab = 'why' | 'mesh' | 'setup';

export interface Notice {
  readonly text: string;
  readonly tone: 'info' | 'bad';
}

/** The one store: what the page is about. Parts of the interface read it; actions (actions/) and it alone change it. */
export class App {
  readonly settings = new Settings();
  readonly core = new CoreClient((loss) => this.coreLost(loss));
  readonly doc = new DocumentStore(this.core);
  readonly run = new RunStore(this.core);
  readonly playback = new PlaybackStore(this.run, () => this.settings.speed);
  readonly parameters = new ParameterStore();

  hello = $state.raw<Hello | null>(null);
  coreError = $state('');
  /** Drawing the input, or watching the mesh. */
  mode = $state<'draw' | 'watch'>('watch');
  tab = $state<Tab>('why');
  dialog = $state<DialogId | null>(null);
  notice = $state.raw<Notice | null>(null);
  /** Read out by screen readers. */
  announcement = $state('');
  picked = $state.raw<Hit | null>(null);
  picture = $state.raw<Picture | null>(null);
  sheetOpen = $state(false);
  /** A view to restore, or the whole input to show, once the picture has it. */
  pendingView: View | null = null;
  pendingFit = false;

  readonly algorithms = $derived<readonly AlgorithmInfo[]>(
    (this.hello?.algorithms ?? []).filter((a) => a.dimension === 2),
  );
  readonly algorithm = $derived(this.algorithms.find((a) => a.id === this.parameters.algorithm));
  /** The finished or growing run is about the input as it is drawn now. */
  readonly fresh = $derived(this.run.trace !== null && this.run.complex === this.doc.complex);

  constructor() {
    this.doc.onChange(() => {
      if (this.run.complex && this.run.complex !== this.doc.complex) this.discardRun();
      this.picked = null;
    });
  }

  /** Starts the core; everything that needs it waits for `hello`. */
  async begin(): Promise<void> {
    try {
      this.hello = await this.core.hello();
      if (this.hello.selfTest !== '') this.coreError = texts.coreUnsound + this.hello.selfTest;
    } catch (error) {
      this.coreError = `${texts.coreFailed} ${String(error)}`;
    }
  }

  /** Puts another input in place of this one, and refines it if `options` are given. */
  open(complex: Complex2, title: string, options?: RunOptions): void {
    this.discardRun();
    this.doc.editor.replace(complex, texts.open.opened(title));
    this.doc.title = title;
    if (options) this.parameters.adopt(options);
    this.picked = null;
    this.pendingView = null;
    this.pendingFit = true;
  }

  /** Refines the input as it is. Resolves when the run has ended. */
  async refine(then: { play?: boolean; moment?: number } = {}): Promise<void> {
    if (this.doc.complex.vertices.length === 0) {
      this.say(texts.empty.title);
      return;
    }
    if (!this.hello) await this.begin();
    if (this.mode === 'draw' && this.tab === 'setup') this.tab = 'why';
    this.mode = 'watch';
    this.picked = null;
    await this.run.start(this.doc.complex, this.parameters.options(this.algorithms), () => {
      if (!this.run.trace) return;
      this.playback.load(this.run.trace);
      if (then.play) this.playback.play();
    });
    if (this.run.phase === 'failed') this.failed();
    else if (this.run.error !== '') this.say(this.describeLoss(this.run.error), 'bad');
    else if (then.moment !== undefined) this.playback.seek(then.moment);
    else if (!then.play && this.playback.position === 0) this.playback.seek(this.playback.length);
  }

  async readFiles(files: readonly { name: string; bytes: Uint8Array }[]): Promise<void> {
    const main = mainFile(files);
    if (!main) return;
    try {
      const answer = await this.core.read([main, ...files.filter((f) => f !== main)]);
      if (answer.complex?.dimension === 3) {
        this.say(texts.open.three, 'bad');
        return;
      }
      const fatal = answer.defects.filter((d) => !d.warning);
      const complex = answer.complex ? complexFromJson(answer.complex) : emptyComplex;
      const readable = complex.vertices.length > 0;
      if (readable) this.open(complex, main.name);
      this.showDefects(answer.defects);
      if (fatal.length > 0) {
        this.say(
          readable ? fatal[0]!.message : `${texts.open.failed(main.name)} ${fatal[0]!.message}`,
          'bad',
        );
        this.tab = 'setup';
      } else {
        this.say(texts.open.opened(main.name));
        await this.refine({});
      }
    } catch {
      this.say(texts.open.failed(main.name), 'bad');
    }
  }

  /** What a link or the last visit carries. */
  async restore(shared: Shared, title: string): Promise<void> {
    this.open(shared.complex, title, shared.options);
    if (shared.color) this.settings.color = shared.color;
    this.pendingView = shared.view;
    if (shared.moment !== null) await this.refine({ moment: shared.moment });
    else this.mode = 'draw';
  }

  /** The moment as a link carries it. */
  shared(): Shared {
    return {
      complex: this.doc.complex,
      options: this.fresh ? this.run.options : this.parameters.options(this.algorithms),
      moment: this.fresh ? this.playback.position : null,
      view: this.picture?.getView() ?? null,
      color: this.settings.color,
    };
  }

  discardRun(): void {
    this.playback.unload();
    this.run.discard();
    this.picked = null;
  }

  say(text: string, tone: Notice['tone'] = 'info'): void {
    this.notice = { text, tone };
    this.announcement = text;
  }

  private failed(): void {
    this.showDefects(this.run.defects);
    this.mode = 'draw';
    this.tab = 'setup';
    this.say(this.run.defects[0]?.message ?? (this.run.error || texts.run.failed), 'bad');
  }

  private showDefects(defects: readonly Defect[]): void {
    if (defects.length > 0) this.doc.defects = defects;
  }

  private coreLost(loss: CoreLoss): void {
    this.say(this.describeLoss(loss), 'bad');
  }

  private describeLoss(error: string): string {
    if (error === 'hung') return texts.run.hung;
    return error === 'crashed' ? texts.run.crashed : error;
  }
}

/** A .node stands beside a .poly or .ele: the one that refers to the other is read. */
function mainFile(
  files: readonly { name: string; bytes: Uint8Array }[],
): { name: string; bytes: Uint8Array } | undefined {
  const rank = (name: string) => (/\.(poly|ele)$/i.test(name) ? 0 : /\.node$/i.test(name) ? 2 : 1);
  return [...files].sort((a, b) => rank(a.name) - rank(b.name) || a.name.localeCompare(b.name))[0];
}

export const app = new App();
