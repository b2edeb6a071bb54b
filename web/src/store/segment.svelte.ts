import type { FeatureBalls, SubsegmentSizesAnswer } from 'circumball';
import type { CoreClient } from '../core/client.ts';
import { complexToText } from '../core/complex-json.ts';
import { point3 } from '../replay/geometry3.ts';
import type { FeatureBall3, Witness3 } from '../shared/overlay-facts.ts';
import type { Complex3, Point3 } from '../shared/types.ts';
import type { Pane } from './pane.svelte.ts';

export interface SubsegmentBalls {
  readonly subsegment: number;
  readonly fs1: FeatureBall3;
  readonly lfs1: FeatureBall3;
  readonly lfs: FeatureBall3;
}

/** Which balls of a picked subsegment are drawn. */
export type DrawnBalls = 'fs1' | 'lfs' | 'both';

/** Feature sizes of what is picked in space, asked of the core's oracle. One question at a time; late answers are dropped. */
export class SegmentStore {
  balls = $state.raw<SubsegmentBalls | null>(null);
  /** lfs at the picked vertex; NaN while it is not known. */
  vertexSize = $state(Number.NaN);
  drawn = $state<DrawnBalls>('both');
  error = $state('');

  private asked = 0;
  private text: { of: Complex3; text: string } | null = null;

  constructor(
    private readonly core: Pick<CoreClient, 'subsegmentSizes' | 'featureSizes'>,
    private readonly pane: () => Pane,
  ) {}

  /** Measures what is picked now. */
  async measure(): Promise<void> {
    const asked = ++this.asked;
    this.balls = null;
    this.vertexSize = Number.NaN;
    this.error = '';
    const { run, spacePicked: picked } = this.pane();
    const { trace, refined } = run;
    if (!picked || !trace || !refined || trace.dimension !== 3) return;
    const xyz = trace.coordinates.data;
    try {
      if (picked.vertex !== null && picked.vertex < trace.vertexCount) {
        const at = Float64Array.from(point3(xyz, picked.vertex));
        const answer = await this.core.featureSizes(this.textOf(refined), at);
        if (asked !== this.asked) return;
        this.error = answer.error;
        this.vertexSize = answer.lfs[0] ?? Number.NaN;
      } else if (picked.subsegment !== null && picked.subsegment < trace.subsegmentCount) {
        const n = picked.subsegment;
        const [a, b] = [trace.subsegments.at(3 * n), trace.subsegments.at(3 * n + 1)];
        const ends = Float64Array.from([...point3(xyz, a), ...point3(xyz, b)]);
        const answer = await this.core.subsegmentSizes(this.textOf(refined), ends);
        if (asked !== this.asked) return;
        this.error = answer.error;
        if (answer.ok) this.balls = { subsegment: n, ...ballsOf(answer) };
      }
    } catch {
      // The core was lost, which it tells by itself.
    }
  }

  private textOf(complex: Complex3): string {
    if (this.text?.of !== complex) this.text = { of: complex, text: complexToText(complex) };
    return this.text.text;
  }
}

/** From the answer for one subsegment. */
export function ballsOf(answer: SubsegmentSizesAnswer) {
  return { fs1: ballOf(answer.fs1), lfs1: ballOf(answer.lfs1), lfs: ballOf(answer.lfs) };
}

function ballOf({ radius, center, witnesses, at }: FeatureBalls): FeatureBall3 {
  const kinds = ['vertex', 'segment', 'face'] as const;
  const place = (list: Float64Array, k: number): Point3 => [list[k]!, list[k + 1]!, list[k + 2]!];
  const found: Witness3[] = [];
  for (const k of [0, 1]) {
    const kind = kinds[witnesses[2 * k] ?? 3];
    if (kind) found.push({ kind, index: witnesses[2 * k + 1]!, at: place(at, 3 * k) });
  }
  return {
    radius: radius[0] ?? Number.POSITIVE_INFINITY,
    center: place(center, 0),
    witnesses: found,
  };
}
