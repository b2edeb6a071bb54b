import { Ancestry } from '../replay/ancestry.ts';
import { nearestNeighbors } from '../replay/nearest.ts';
import { Protection } from '../replay/protection.ts';
import { spindleOf } from '../replay/spindle.ts';
import type { NeighborRing, OverlayFacts, Spindle } from '../shared/overlay-facts.ts';
import type { Hit, Overlays } from '../shared/types.ts';
import type { FeatureStore } from './features.svelte.ts';
import type { PlaybackStore } from './playback.svelte.ts';
import type { RunStore } from './run.svelte.ts';

/** What the core measured of the input. */
type Measured = Pick<FeatureStore, 'field' | 'ball' | 'atVertices'>;

/** What the overlays of one picture show: read off its trace at its playhead, and only as far as it is switched on. */
export class OverlayStore {
  readonly protection = $derived.by(() => this.run.trace && new Protection(this.run.trace));
  readonly ancestry = $derived.by(
    () => this.run.trace && this.protection && new Ancestry(this.run.trace, this.protection),
  );

  constructor(
    private readonly run: RunStore,
    private readonly playback: PlaybackStore,
    private readonly picked: () => Hit | null,
  ) {}

  facts(shown: Overlays, features: Measured): OverlayFacts {
    return {
      field: features.field,
      ball: features.ball,
      neighbors: shown.neighbors ? this.neighbors(features.atVertices) : [],
      spindle: shown.spindles ? this.spindle() : null,
      collars: shown.collars ? this.collars() : [],
      intestines: shown.intestines ? this.intestines() : [],
      ancestry: shown.ancestry ? this.chain() : [],
    };
  }

  /** The state at the playhead; what reads it follows the playhead. */
  private state() {
    void this.playback.position;
    void this.run.traceVersion;
    return this.playback.replay?.state() ?? null;
  }

  private neighbors(lfs: Float64Array | null): NeighborRing[] {
    const state = this.state();
    const { complex } = this.run;
    if (!state || !complex) return [];
    const count = Math.min(complex.vertices.length, state.vertexCount);
    const nearest = nearestNeighbors(state, count);
    return Array.from(nearest, (n, v) => ({
      vertex: v,
      nearest: n,
      lfs: lfs?.[v] ?? Number.NaN,
      promised: this.run.algorithm === 'feature-size',
    }));
  }

  private spindle(): Spindle | null {
    const state = this.state();
    if (!state) return null;
    const picked = this.picked()?.subsegment;
    if (picked != null && this.picked()?.vertex === null && picked < state.subsegments.length / 3) {
      const s = state.subsegments;
      return spindleOf(state, s[3 * picked]!, s[3 * picked + 1]!);
    }
    const simplex = this.playback.moment?.simplex ?? [];
    return simplex.length === 2 ? spindleOf(state, simplex[0]!, simplex[1]!) : null;
  }

  private collars() {
    void this.run.traceVersion;
    return this.protection?.collars(this.playback.position) ?? [];
  }

  /** Collars alone draw no circles. */
  private intestines() {
    const state = this.state();
    if (this.run.algorithm !== 'intestine' || !state || !this.protection) return [];
    return this.protection.intestines(this.playback.position, state);
  }

  private chain() {
    const vertex = this.picked()?.vertex;
    const { trace } = this.run;
    if (vertex == null || !trace || vertex >= trace.vertexCount) return [];
    return this.ancestry?.chain(vertex) ?? [];
  }
}
