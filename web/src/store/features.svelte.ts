import type { FeatureSizesAnswer } from 'circumball';
import type { CoreClient } from '../core/client.ts';
import { complexToText } from '../core/complex-json.ts';
import type { FeatureBall, FeatureField, Witness } from '../shared/overlay-facts.ts';
import type { Complex2, Picture, Point } from '../shared/types.ts';

/** The view must rest so long before its field is measured. */
const REST_MS = 140;
/** Steps of the lattice in CSS pixels: first a rough field at once, then a fine one. */
const STEPS = [24, 6];
/** The lattice reaches beyond the view by this part of it, so that a little panning shows no edge. */
const MARGIN = 0.12;
/** A question to the core should take about so long: in between it hears others. */
const QUESTION_MS = 60;

/**
 * Local feature sizes of the input, asked of the core's oracle (thesis, Definition 2.1.6): at the vertices of the input, on a lattice
 * over the view, and the ball at a point. One question at a time; an answer that came too late is dropped.
 */
export class FeatureStore {
  field = $state.raw<FeatureField | null>(null);
  ball = $state.raw<FeatureBall | null>(null);
  /** A point that was picked: its ball stays. */
  pinned = $state.raw<Point | null>(null);
  /** lfs at the vertices of the complex. */
  atVertices = $state.raw<Float64Array | null>(null);
  measuring = $state(false);
  error = $state('');
  complex = $state.raw<Complex2 | null>(null);

  private text = '';
  private generation = 0; // of the complex
  private fieldWanted = 0;
  private pointsAQuestion = 500;
  private rest: ReturnType<typeof setTimeout> | undefined;
  private hovering = false;
  private hovered: Point | null = null;

  constructor(private readonly core: Pick<CoreClient, 'featureSizes'>) {}

  /** Another complex: nothing that was measured is about it. */
  setComplex(complex: Complex2): void {
    if (complex === this.complex) return;
    this.complex = complex;
    this.text = '';
    this.generation++;
    this.field = null;
    this.ball = null;
    this.pinned = null;
    this.atVertices = null;
    this.error = '';
  }

  /** lfs at points; null if the complex changed meanwhile, or has no answer. */
  async lfs(points: readonly Point[]): Promise<Float64Array | null> {
    const answer = await this.ask(Float64Array.from(points.flat()));
    return answer?.lfs ?? null;
  }

  async measureVertices(): Promise<void> {
    const { complex } = this;
    if (!complex || this.atVertices) return;
    const lfs = await this.lfs(complex.vertices);
    if (complex === this.complex && lfs) this.atVertices = lfs;
  }

  pin(at: Point | null): void {
    this.pinned = at;
    this.ball = null;
    if (at) void this.measureBall(at, () => this.pinned === at);
  }

  /** Follows the pointer while no point is picked; the newest place wins. */
  hover(at: Point | null): void {
    if (this.pinned) return;
    this.hovered = at;
    if (!at) this.ball = null;
    if (!this.hovering) void this.follow();
  }

  /** Measures the field of a picture's view once it rests. */
  watch(picture: Picture): void {
    clearTimeout(this.rest);
    this.rest = setTimeout(() => void this.measureField(picture), this.field ? REST_MS : 0);
  }

  unwatch(): void {
    clearTimeout(this.rest);
    this.fieldWanted++;
    this.field = null;
    this.measuring = false;
  }

  private async follow(): Promise<void> {
    this.hovering = true;
    let at = this.hovered;
    while (at && !this.pinned) {
      const place = at;
      await this.measureBall(place, () => !this.pinned && this.hovered !== null);
      at = this.hovered === place ? null : this.hovered;
    }
    this.hovering = false;
  }

  private async measureBall(at: Point, isWanted: () => boolean): Promise<void> {
    const { complex } = this;
    const answer = await this.ask(Float64Array.from(at));
    if (!answer || !complex || complex !== this.complex || !isWanted()) return;
    this.ball = ballOf(complex, at, answer);
  }

  private async measureField(picture: Picture): Promise<void> {
    const wanted = ++this.fieldWanted;
    const { clientWidth: width, clientHeight: height } = picture.canvas;
    if (width === 0 || height === 0) return;
    const { scale } = picture.getView();
    const [left, bottom] = picture.toWorld(-MARGIN * width, (1 + MARGIN) * height);
    this.measuring = true;
    for (const pixels of STEPS) {
      const lattice = {
        x: left,
        y: bottom,
        step: pixels / scale,
        columns: Math.ceil((width * (1 + 2 * MARGIN)) / pixels) + 1,
        rows: Math.ceil((height * (1 + 2 * MARGIN)) / pixels) + 1,
      };
      const values = await this.measureLattice(lattice, () => wanted === this.fieldWanted);
      if (!values) break;
      this.field = { ...lattice, values };
    }
    if (wanted === this.fieldWanted) this.measuring = false;
  }

  private async measureLattice(
    { x, y, step, columns, rows }: Omit<FeatureField, 'values'>,
    isWanted: () => boolean,
  ): Promise<Float64Array | null> {
    const values = new Float64Array(columns * rows);
    for (let from = 0; from < values.length; ) {
      const count = Math.min(this.pointsAQuestion, values.length - from);
      const points = new Float64Array(2 * count);
      for (let i = 0; i < count; i++) {
        points[2 * i] = x + step * ((from + i) % columns);
        points[2 * i + 1] = y + step * Math.floor((from + i) / columns);
      }
      const start = performance.now();
      const answer = await this.ask(points);
      if (!answer || !isWanted()) return null;
      values.set(answer.lfs, from);
      from += count;
      const took = performance.now() - start;
      const factor = Math.min(Math.max(QUESTION_MS / Math.max(took, 1), 0.25), 4);
      this.pointsAQuestion = Math.min(Math.max(Math.round(count * factor), 64), 50_000);
    }
    return values;
  }

  private async ask(points: Float64Array): Promise<FeatureSizesAnswer | null> {
    if (!this.complex || this.complex.vertices.length === 0) return null;
    if (this.text === '') this.text = complexToText(this.complex);
    const { generation } = this;
    try {
      const answer = await this.core.featureSizes(this.text, points);
      if (generation !== this.generation) return null;
      this.error = answer.ok ? '' : answer.error;
      return answer.ok ? answer : null;
    } catch {
      return null; // the core was lost, which it tells by itself
    }
  }
}

/** From the answer for one point. */
export function ballOf(complex: Complex2, center: Point, answer: FeatureSizesAnswer): FeatureBall {
  const witnesses: Witness[] = [];
  for (const k of [0, 1]) {
    const kind = answer.witnesses[2 * k];
    const index = answer.witnesses[2 * k + 1]!;
    const at: Point = [answer.at[2 * k]!, answer.at[2 * k + 1]!];
    if (kind === 0) {
      witnesses.push({ kind: 'vertex', index, ends: [complex.vertices[index] ?? at], at });
    } else if (kind === 1) {
      const ends = (complex.segments[index] ?? []).map((v) => complex.vertices[v] ?? at);
      witnesses.push({ kind: 'segment', index, ends, at });
    }
  }
  return { center, radius: answer.lfs[0] ?? Number.POSITIVE_INFINITY, witnesses };
}
