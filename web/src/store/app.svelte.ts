import type { AlgorithmInfo, Defect, RunOptions } from 'circumball';
import { CoreClient, type CoreLoss } from '../core/client.ts';
import { inputFromJson } from '../core/complex-json.ts';
import type { Hello } from '../core/worker.ts';
import type { ComparisonOptions, Shared } from '../link/link.ts';
import { point } from '../replay/geometry.ts';
import { centroid, extremesOf, point3 } from '../replay/geometry3.ts';
import { refinedComplex } from '../replay/refined-complex.ts';
import { emptyComplex, type Input, type Point, type Point3, type View } from '../shared/types.ts';
import { findSimplex } from '../space/pick.ts';
import { noHit, type SpaceHit, type SpaceView } from '../space/types.ts';
import { texts } from '../texts.ts';
import { asSentence, formatNumber } from '../words.ts';
import { Comparison } from './comparison.svelte.ts';
import { DocumentStore } from './document.svelte.ts';
import { FaceStore } from './face.svelte.ts';
import { FeatureStore } from './features.svelte.ts';
import { type FamilyChoice, NumericsStore } from './numerics.svelte.ts';
import { Pane } from './pane.svelte.ts';
import { SegmentStore } from './segment.svelte.ts';
import { Settings } from './settings.svelte.ts';
import { SpaceSettings } from './space.svelte.ts';
import { TriangleStore } from './triangle.svelte.ts';
import { RepetitionZoom } from './zoom.svelte.ts';

export type DialogId = 'gallery' | 'export' | 'share' | 'help' | 'triangle';
export type Tab = 'why' | 'mesh' | 'setup' | 'numerics' | 'compare';

export interface Notice {
  readonly text: string;
  readonly tone: 'info' | 'bad';
}

/** The one store: what the page is about. Parts of the interface read it; actions (actions/) and it alone change it. */
export class App {
  readonly settings = new Settings();
  readonly look = new SpaceSettings();
  readonly core = new CoreClient((loss) => this.coreLost(loss));
  readonly doc = new DocumentStore(this.core);
  readonly features = new FeatureStore(this.core);
  readonly first = new Pane(this.core, () => this.settings.speed);
  readonly comparison = new Comparison(
    this.first,
    () => this.settings.speed,
    (loss) => this.coreLost(loss),
  );

  readonly face = new FaceStore(this.core, () => this.first);
  readonly segment = new SegmentStore(this.core, () => this.first);
  readonly numerics = new NumericsStore((loss) => this.coreLost(loss));
  readonly triangle = new TriangleStore((loss) => this.coreLost(loss));

  hello = $state.raw<Hello | null>(null);
  coreError = $state('');
  /** Drawing the input, or watching the mesh. */
  mode = $state<'draw' | 'watch'>('watch');
  tab = $state<Tab>('why');
  dialog = $state<DialogId | null>(null);
  notice = $state.raw<Notice | null>(null);
  /** Read out by screen readers. */
  announcement = $state('');
  /** Which of two compared runs the panel is about. */
  side = $state<0 | 1>(0);
  sheetOpen = $state(false);
  /** A view to restore, or the whole input to show, once the picture has it. */
  pendingView: View | null = null;
  pendingSpaceView: SpaceView | null = null;
  pendingFit = false;

  /** What the panel is about; all others are shorthand for what is in it. */
  readonly pane = $derived((this.side === 1 ? this.comparison.second : null) ?? this.first);
  get run() {
    return this.pane.run;
  }
  get playback() {
    return this.pane.playback;
  }
  get parameters() {
    return this.pane.parameters;
  }
  get picture() {
    return this.pane.picture;
  }
  /** Whichever of the two pictures the page shows: what both of them can do. */
  get shown() {
    return this.inSpace ? this.pane.spacePicture : this.pane.picture;
  }
  get picked() {
    return this.pane.picked;
  }
  set picked(hit) {
    this.pane.picked = hit;
  }
  readonly comparing = $derived(this.comparison.second !== null);
  readonly panes = $derived([
    this.first,
    ...(this.comparison.second ? [this.comparison.second] : []),
  ]);
  /** What the transport drives. */
  readonly clock = $derived(
    this.comparing && this.comparison.second?.run.phase !== 'failed'
      ? this.comparison.clock
      : this.first.playback,
  );

  /** The pane whose run repeats itself: the one in the panel, or the other. */
  readonly repeating = $derived(
    [this.pane, ...this.panes].find((pane) => pane.repetition !== null) ?? null,
  );
  readonly zoom = new RepetitionZoom(this);

  readonly inSpace = $derived(this.doc.solid !== null);
  readonly dimension = $derived<2 | 3>(this.inSpace ? 3 : 2);
  readonly algorithms = $derived<readonly AlgorithmInfo[]>(
    (this.hello?.algorithms ?? [])
      .filter((a) => a.dimension === this.dimension)
      // The page knows where it is.
      .map((a) => ({ ...a, title: a.title.replace(/ in space\b/, '') })),
  );
  readonly algorithm = $derived(this.algorithms.find((a) => a.id === this.parameters.algorithm));
  /** The finished or growing run is about the input as it is drawn now. */
  readonly fresh = $derived(
    this.first.run.trace !== null && this.first.run.complex === this.doc.input,
  );

  /** Are errors of a function measured and shown? */
  readonly measures = $derived(!this.inSpace && this.mode === 'watch' && this.tab === 'numerics');
  /** The mesh in the picture that is not the run's. */
  readonly still = $derived(this.measures ? this.numerics.still : null);

  private readonly boxed = $derived.by(() => {
    const { trace, traceVersion } = this.first.run;
    void traceVersion;
    return (
      !this.inSpace && this.fresh && refinedComplex(this.doc.complex, trace) !== this.doc.complex
    );
  });
  /** What feature sizes are about: the input, and the box about it if the run made one. */
  readonly featureComplex = $derived.by(() => {
    if (this.inSpace) return emptyComplex;
    const { complex } = this.doc;
    return this.boxed ? refinedComplex(complex, this.first.run.trace) : complex;
  });

  constructor() {
    this.doc.onChange(() => {
      const isStale = ({ run }: Pane) => run.complex && run.complex !== this.doc.input;
      if (this.panes.some(isStale)) this.discardRun();
      for (const pane of this.panes) pane.unpick();
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
  open(input: Input, title: string, options?: RunOptions): void {
    this.discardRun();
    const fromPlane = !this.inSpace;
    this.doc.open(input, texts.open.opened(title));
    this.doc.title = title;
    const { parameters } = this.first;
    if (options) parameters.adopt(options);
    // Ruppert's algorithm alone need not end: the core's default in space protects what is acute.
    else if (fromPlane && this.inSpace && parameters.algorithm === 'ruppert')
      parameters.adopt({ algorithm: 'collar' });
    this.settleDimension();
    this.pendingView = null;
    this.pendingSpaceView = null;
    this.pendingFit = true;
  }

  /** Back to the drawing that a complex of space was opened over. */
  closeSpace(): void {
    this.doc.close();
    this.settleDimension();
    this.mode = 'draw';
    this.pendingFit = true;
  }

  /** Each dimension has algorithms of its own, and no others; in space nothing is drawn or measured. */
  private settleDimension(): void {
    const first = this.algorithms.find((a) => a.id === 'collar') ?? this.algorithms[0];
    for (const { parameters } of this.panes) {
      if (first && !this.algorithms.some((a) => a.id === parameters.algorithm))
        parameters.adopt({ algorithm: first.id });
    }
    if (!this.inSpace) return;
    this.mode = 'watch';
    this.numerics.leave();
    if (this.tab === 'numerics') this.tab = 'why';
  }

  /** Refines the input as it is, under both algorithms while comparing. Resolves when that has ended. */
  async refine(
    then: { play?: boolean; moment?: number; tick?: number | null } = {},
  ): Promise<void> {
    if (this.doc.input.vertices.length === 0) {
      this.say(texts.empty.title);
      return;
    }
    if (!this.hello) await this.begin();
    if (this.mode === 'draw' && this.tab === 'setup') this.tab = 'why';
    this.mode = 'watch';
    const { first, panes, clock } = this;
    clock.pause();
    this.zoom.reset();
    if (this.comparing) clock.position = 0;
    let loaded = 0;
    const onLoaded = () => {
      if (++loaded === panes.length && then.play) clock.play();
    };
    await Promise.all(panes.map((pane) => this.start(pane, onLoaded)));
    if (panes.some((pane) => !this.panes.includes(pane))) return; // closed in the meantime
    if (first.run.phase === 'failed') this.failed();
    else if (this.tellLoss(panes) || then.play) return;
    else if (this.comparing) this.seekComparison(then.tick ?? null, then.moment);
    else if (then.moment !== undefined) clock.seek(then.moment);
    else if (clock.position === 0) clock.seek(clock.length);
  }

  /** Puts a second algorithm beside the first one, on the same input. */
  async compare(asked?: Partial<ComparisonOptions>): Promise<void> {
    if (!this.hello) await this.begin();
    const second = this.comparison.open({
      options: asked?.options ?? this.counterpart(),
      // Steps in space have names in common, and take very different numbers of vertices.
      pace: asked?.pace ?? (this.inSpace ? 'steps' : 'vertices'),
    });
    this.tab = 'compare';
    if (!this.fresh) return;
    await this.start(second, () => {});
    if (this.comparison.second !== second || this.tellLoss([second])) return;
    this.seekComparison(asked?.tick ?? null, this.first.playback.position);
  }

  closeComparison(): void {
    if (!this.comparing) return;
    this.zoom.reset();
    this.comparison.close();
    this.side = 0;
    if (this.tab === 'compare') this.tab = 'why';
  }

  async readFiles(files: readonly { name: string; bytes: Uint8Array }[]): Promise<void> {
    const main = mainFile(files);
    if (!main) return;
    try {
      const answer = await this.core.read([main, ...files.filter((f) => f !== main)]);
      const fatal = answer.defects.filter((d) => !d.warning);
      const complex = answer.complex ? inputFromJson(answer.complex) : emptyComplex;
      const readable = complex.vertices.length > 0;
      if (readable) this.open(complex, main.name);
      this.showDefects(answer.defects);
      if (fatal.length > 0) {
        this.say(
          readable
            ? fatal[0]!.message
            : `${texts.open.failed(main.name)} ${asSentence(fatal[0]!.message)}`,
          'bad',
        );
        this.tab = 'setup';
      } else {
        this.say(texts.open.opened(main.name));
        if (this.algorithms.length > 0) await this.refine({});
      }
    } catch {
      this.say(texts.open.failed(main.name), 'bad');
    }
  }

  /** What a link or the last visit carries. */
  async restore(shared: Shared, title: string): Promise<void> {
    this.closeComparison();
    this.open(shared.complex, title, shared.options);
    if (shared.compare) await this.compare(shared.compare);
    if (shared.color) this.settings.color = shared.color;
    if (shared.overlays) this.settings.showOverlays(shared.overlays);
    this.pendingView = shared.view;
    this.pendingSpaceView = shared.space?.view ?? null;
    if (shared.space) this.look.adopt(shared.space.look);
    const tick = shared.compare?.tick ?? null;
    if (shared.moment !== null) await this.refine({ moment: shared.moment, tick });
    else if (!shared.triangle && !this.inSpace) this.mode = 'draw';
    // A run tells how many faces there are.
    if (shared.space) {
      if (shared.space.face == null) this.face.close();
      else this.face.show(shared.space.face);
    }
    // After the run: a mesh that is no run's is left when the playhead moves.
    if (shared.numerics) {
      this.numerics.adopt(shared.numerics);
      this.tab = 'numerics';
    }
    if (shared.triangle) {
      this.triangle.adopt(shared.triangle);
      this.dialog = 'triangle';
    }
  }

  /** The moment as a link carries it. */
  shared(): Shared {
    const { second, pace, clock } = this.comparison;
    const tick = this.fresh ? clock.position : null;
    return {
      complex: this.doc.input,
      options: this.optionsOf(this.first),
      moment: this.fresh ? this.first.playback.position : null,
      view: this.first.picture?.getView() ?? null,
      ...(this.inSpace
        ? {
            space: {
              view: this.first.spacePicture?.getView() ?? null,
              look: this.look.shared(),
              face: this.face.open ? this.face.index : null,
            },
          }
        : {}),
      color: this.settings.color,
      overlays: this.settings.shownOverlays,
      ...(this.tab === 'numerics' && this.numerics.expression !== ''
        ? { numerics: this.numerics.options() }
        : {}),
      ...(this.dialog === 'triangle' ? { triangle: this.triangle.options() } : {}),
      ...(second ? { compare: { options: this.optionsOf(second), pace, tick } } : {}),
    };
  }

  familyTitle({ id, columns, degeneration }: FamilyChoice): string {
    const title = this.hello?.families.find((f) => f.id === id)?.title ?? id;
    return texts.numerics.familyTitle(title, columns, degeneration);
  }

  /** Puts a mesh of the study in the picture, with the error on each of its triangles. */
  showStudyStep(index: number): void {
    const { numerics } = this;
    const { study, method, norm } = numerics;
    const step = study.steps[index];
    if (!step || !study.plan) return;
    study.shown = index;
    const { varied, family } = study.plan;
    const ofFamily = varied !== 'size';
    const title = ofFamily
      ? this.familyTitle({ ...family, [varied]: step.point.value })
      : texts.numerics.sizeTitle(formatNumber(step.point.h));
    const field = step.fields[method] ?? null;
    numerics.show(step.mesh, field, norm, step.complex, title, ofFamily);
    if (field) numerics.take(field);
  }

  /** To a position of the run in the panel, and the other one to where it then stands. */
  seekMoment(position: number): void {
    const { lockstep } = this.comparison.clock;
    const tick = this.comparing
      ? lockstep?.tickOf(this.pane === this.first ? 0 : 1, position)
      : null;
    this.clock.seek(tick ?? position);
  }

  /** A vertex of the run in the panel, in whichever picture there is. */
  pickVertex(vertex: number): void {
    if (this.inSpace) this.pane.spacePicked = { ...noHit, vertex };
    else this.picked = { vertex, subsegment: null, triangle: null, hole: null, region: null };
  }

  /** Keeps the ball at a place of the picture: at the vertex, if one was hit. */
  probe(at: Point): void {
    const vertex = this.picked?.vertex;
    const { trace } = this.run;
    const exact = vertex != null && trace && vertex < trace.vertexCount;
    this.features.pin(exact ? point(trace.coordinates.data, vertex) : at);
  }

  /** Brings a place of the world to the middle of the picture. */
  centerOn(at: readonly number[]): void {
    const [x = 0, y = 0, z = 0] = at;
    if (this.inSpace) {
      this.pane.spacePicture?.centerOn([x, y, z]);
      return;
    }
    const view = this.picture?.getView();
    if (view) this.picture?.setView({ ...view, x, y });
  }

  /** Picks a simplex that is left unacceptable in space, and brings it and what stops it into sight. False in the plane. */
  showUnresolved(simplex: readonly number[]): boolean {
    const { pane } = this;
    const { trace } = pane.run;
    const { replay } = pane.playback;
    if (!trace || !replay || trace.dimension !== 3) return false;
    this.clock.pause();
    this.clock.seek(this.clock.length);
    pane.spacePicked = findSimplex(replay.state(), simplex);
    const { stops } = pane;
    const balls = stops ? [stops.ball, ...stops.stoppers.slice(0, 1).map((s) => s.ball)] : [];
    const places = simplex.map((v) => point3(trace.coordinates.data, v));
    pane.spacePicture?.lookAt([...places, ...balls.flatMap(extremesOf)]);
    this.tab = 'why';
    return true;
  }

  /** Brings what was pressed twice to the middle, and turns about it from then on. */
  centerOnHit(pane: Pane, hit: SpaceHit): void {
    const state = pane.playback.replay?.state();
    const { solid } = this.doc;
    if (!solid) return;
    const place = (v: number): Point3 =>
      state && v < state.vertexCount ? point3(state.coordinates, v) : solid.vertices[v]!;
    const of = (list: ArrayLike<number>) =>
      pane.spacePicture?.centerOn(centroid(Array.from(list, place)));
    if (hit.vertex !== null) of([hit.vertex]);
    else if (hit.subsegment !== null)
      of(
        state?.subsegments.subarray(3 * hit.subsegment, 3 * hit.subsegment + 2) ??
          solid.segments[hit.subsegment] ??
          [],
      );
    else if (hit.cell !== null && state) of(state.cells.subarray(4 * hit.cell, 4 * hit.cell + 4));
    else if (hit.facet !== null && state?.facets)
      of(state.facets.triangles.subarray(4 * hit.facet, 4 * hit.facet + 3));
    else if (hit.face !== null) of(solid.faces[hit.face]?.loops[0] ?? []);
  }

  discardRun(): void {
    this.comparison.clock.pause();
    this.comparison.clock.position = 0;
    this.zoom.reset();
    for (const pane of this.panes) pane.discard();
  }

  say(text: string, tone: Notice['tone'] = 'info'): void {
    // What went wrong is mostly said by the core, as the command prints it after a file name.
    const sentence = tone === 'bad' ? asSentence(text) : text;
    this.notice = { text: sentence, tone };
    this.announcement = sentence;
  }

  /** What a run is best held against: an algorithm that protects small angles against one that does not. */
  private counterpart(): RunOptions {
    const own = this.first.parameters.options(this.algorithms);
    if (this.inSpace) {
      const others = this.algorithms.filter((a) => a.id !== own.algorithm).map((a) => a.id);
      const like = ['collar', 'intestine-structured', 'intestine', 'ruppert', others[0]];
      const other = like.find((id) => id !== undefined && others.includes(id));
      return { ...own, ...(other ? { algorithm: other } : {}) };
    }
    if (own.algorithm === 'collar') return { ...own, algorithm: 'ruppert' };
    const smallest = this.first.run.report?.input.smallest_angle_degrees ?? 0;
    // Where no angle is acute and the run repeats itself all the same, collars help only at every vertex.
    const beside: RunOptions = { ...own, algorithm: 'collar' };
    if (this.first.repetition && smallest >= 90)
      beside.parameters = { ...own.parameters, protect: 'all' };
    return beside;
  }

  private optionsOf(pane: Pane): RunOptions {
    return this.fresh ? pane.run.options : pane.parameters.options(this.algorithms);
  }

  private async start(pane: Pane, onLoaded: () => void): Promise<void> {
    const { run, playback, parameters } = pane;
    pane.unpick();
    await run.start(this.doc.input, parameters.options(this.algorithms), () => {
      if (!run.trace) return;
      playback.load(run.trace);
      onLoaded();
    });
  }

  /** At a tick, or where the first run is at a moment, or at the end. */
  private seekComparison(tick: number | null, moment?: number): void {
    const { clock } = this.comparison;
    if (tick !== null) clock.seek(tick);
    else if (moment === undefined) clock.seek(clock.length);
    else clock.seek(clock.lockstep?.tickOf(0, moment) ?? 0);
  }

  /** Says what became of a run that the core did not bring to its end. */
  private tellLoss(panes: readonly Pane[]): boolean {
    const lost = panes.find(({ run }) => run.error !== '');
    if (lost) this.say(this.describeLoss(lost.run.error), 'bad');
    return lost !== undefined;
  }

  private failed(): void {
    const { defects, error } = this.first.run;
    this.showDefects(defects);
    if (!this.inSpace) this.mode = 'draw';
    this.tab = 'setup';
    this.say(defects[0]?.message ?? (error || texts.run.failed), 'bad');
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
