import type { CoreClient } from '../core/client.ts';
import { complexToText } from '../core/complex-json.ts';
import { type FacePlane, facePlane, toSpace } from '../replay/face-plane.ts';
import { FaceReplay, type Outsider } from '../replay/face-replay.ts';
import type { Complex3, Hit, Moment, Picture, Point, Point3 } from '../shared/types.ts';
import { noHit, type SpaceHit } from '../space/types.ts';
import type { Pane } from './pane.svelte.ts';

/** One face of a run in space alone in its own plane, as in the thesis' figures 4.24 to 4.30. */
export class FaceStore {
  open = $state(false);
  /** Its number among the faces that the run refines: those of the input, then those of the box. */
  index = $state(0);
  /** Goes with the face in which something happens. */
  following = $state(false);
  picture = $state.raw<Picture | null>(null);
  /** What the pointer is over, in one of the two pictures: its place in space. */
  hovered = $state.raw<Point3 | null>(null);
  hovering = $state<'face' | 'space'>('face');

  private frames = $state.raw<{ of: Complex3; numbers: Float64Array } | null>(null);

  constructor(
    private readonly core: Pick<CoreClient, 'faceFrames'>,
    private readonly pane: () => Pane,
  ) {}

  /** What the run is about; null without one. */
  get complex(): Complex3 | null {
    return this.pane().run.refined;
  }

  readonly count = $derived.by(() => this.complex?.faces.length ?? 0);

  readonly plane = $derived.by<FacePlane | null>(() => {
    const { frames, index } = this;
    return frames && frames.of === this.complex ? facePlane(frames.numbers, index) : null;
  });

  readonly replay = $derived.by<FaceReplay | null>(() => {
    const { trace } = this.pane().run;
    const { complex, plane, index, open } = this;
    if (!open || !trace || !complex || !plane || trace.dimension !== 3) return null;
    return new FaceReplay(trace, complex, index, plane);
  });

  /** The moment of the run as far as it is in the face. */
  readonly moment = $derived.by<Moment | null>(() => {
    const { moment, position } = this.pane().playback;
    return moment?.dimension === 3 ? (this.replay?.moment(moment, position) ?? null) : null;
  });

  readonly outsider = $derived.by<Outsider | null>(() => {
    const { moment } = this.pane().playback;
    return moment?.dimension === 3 ? (this.replay?.outsider(moment) ?? null) : null;
  });

  /** Is it known whether the faces have planes? */
  readonly measured = $derived.by(() => this.frames !== null && this.frames.of === this.complex);

  /** Asks the core for the planes of the faces, once a complex. */
  async measure(): Promise<void> {
    const { complex } = this;
    if (!complex || this.frames?.of === complex) return;
    try {
      const numbers = await this.core.faceFrames(complexToText(complex));
      if (complex === this.complex) this.frames = { of: complex, numbers };
    } catch {
      // The core was lost, which it tells by itself.
    }
  }

  /** Shows a face; one that there is not is left. */
  show(face: number): void {
    if (!(face >= 0 && face < this.count)) return;
    this.index = face;
    this.open = true;
  }

  close(): void {
    this.open = false;
    this.hovered = null;
    this.following = false;
  }

  /** To the next one, around. */
  go(by: number): void {
    if (this.count > 0) this.show((this.index + by + this.count) % this.count);
  }

  /** The pointer is over something in the picture of space: its place, if it belongs to the face. */
  pointAt(hit: SpaceHit | null): void {
    const own = hit && this.hitOf(hit);
    const { replay } = this;
    this.hovering = 'space';
    this.hovered = own && replay ? replay.placeOf(own) : null;
  }

  /** The pointer is over a place of the face. */
  hoverFace(at: Point | null): void {
    this.hovering = 'face';
    this.hovered = at && this.plane ? toSpace(this.plane, at) : null;
  }

  /** What of the picked thing lies in the face, as its picture names it. */
  hitOf(picked: SpaceHit | null): Hit | null {
    const { replay } = this;
    if (!picked || !replay) return null;
    const none: Hit = { vertex: null, subsegment: null, triangle: null, hole: null, region: null };
    if (picked.vertex !== null)
      return replay.has(picked.vertex) ? { ...none, vertex: picked.vertex } : null;
    if (picked.subsegment !== null)
      return replay.hasSubsegment(picked.subsegment)
        ? { ...none, subsegment: picked.subsegment }
        : null;
    if (picked.facet === null) return null;
    const triangle = replay.triangleOf(picked.facet);
    return triangle < 0 ? null : { ...none, triangle };
  }

  /** The other way round: what was picked in the face, as the picture of space names it. */
  spaceHitOf(hit: Hit | null): SpaceHit | null {
    const { replay, index } = this;
    if (!hit || !replay) return null;
    if (hit.vertex !== null) return { ...noHit, vertex: hit.vertex };
    if (hit.subsegment !== null) return { ...noHit, subsegment: hit.subsegment };
    if (hit.triangle === null) return null;
    return { ...noHit, facet: replay.facetOf(hit.triangle), face: index };
  }
}
