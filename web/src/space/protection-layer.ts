/** Collars and intestines on the GPU: the region of the collars in faces, curves that bound it, spheres and tubes. */

import { BackSide, FrontSide, Mesh, type Object3D, type RawShaderMaterial, Vector4 } from 'three';
import { parseColor } from '../picture/color';
import { Batch } from '../picture/gpu/batch';
import { SlotTable } from '../picture/mesh-model';
import type { CollarRegion } from '../replay/collar-region';
import {
  type Complex3,
  type MeshState,
  type PictureTheme,
  Protecting,
  type ProtectionState,
} from '../shared/types';
import { putLine, putPoint3 } from './layer';
import { place } from './mesh-layer';
import { ARC_PIECES, curvePoints, patchCorners } from './protection-geometry';
import { line3Shader, type SpaceUniforms, triangleShader } from './shaders';
import type { SpaceLook } from './types';
import type { Window3 } from './view';

export interface ProtectionLook {
  readonly theme: PictureTheme;
  readonly look: SpaceLook;
  readonly window: Window3;
  readonly complex: Complex3 | null;
}

function flat(lift: number) {
  return {
    uEdge: { value: new Vector4() },
    uEdgeWidth: { value: 1 },
    uOpacity: { value: 1 },
    uLit: { value: 0 },
    uClips: { value: 1 },
    uLift: { value: lift },
  };
}

/** Elements of some kinds in a batch: a fixed number of rows for each, written when it appears. */
interface Part {
  readonly kinds: readonly number[];
  readonly rows: number;
  readonly batch: Batch;
  readonly slots: SlotTable;
}

export class ProtectionLayer {
  private readonly regionUniforms = flat(1.25);
  private readonly patchUniforms = { ...flat(0), uLit: { value: 0.6 } };
  private readonly region: Batch;
  private readonly pieces: Part; // protected pieces of segments
  private readonly straight: Part;
  private readonly arcs: Part;
  private readonly patches: Part;
  /** The far side of the surfaces, drawn before the near side. */
  private readonly far: Mesh;
  private live = new Uint32Array(256);

  constructor(parent: Object3D, uniforms: SpaceUniforms) {
    const part = (kinds: readonly number[], rows: number, batch: Batch): Part => ({
      kinds,
      rows,
      batch,
      slots: new SlotTable(),
    });
    this.region = new Batch(triangleShader(this.regionUniforms), uniforms, 13, 'test');
    this.pieces = part([Protecting.subsegment], 1, new Batch(line3Shader, uniforms, 28, 'test'));
    this.straight = part(
      [Protecting.collarSegment],
      1,
      new Batch(line3Shader, uniforms, 33, 'test'),
    );
    this.arcs = part(
      [Protecting.collarArc, Protecting.ringArc],
      ARC_PIECES,
      new Batch(line3Shader, uniforms, 34, 'test'),
    );
    this.patches = part(
      [Protecting.spherePatch, Protecting.tubePatch],
      1,
      new Batch(triangleShader(this.patchUniforms), uniforms, 16, 'test'),
    );
    const near = this.patches.batch.mesh;
    const material = near.material.clone() as RawShaderMaterial;
    material.uniforms = near.material.uniforms; // shared, not copied
    material.side = BackSide;
    near.material.side = FrontSide;
    this.far = new Mesh(near.geometry, material);
    this.far.frustumCulled = false;
    this.far.renderOrder = 15;
    for (const { mesh } of this.batches()) parent.add(mesh);
    parent.add(this.far);
  }

  /** Every row is written at the next `sync`. */
  clear(): void {
    for (const { slots, batch } of this.parts()) {
      slots.clear();
      batch.flush(0);
    }
    this.region.flush(0);
  }

  show(meshed: boolean, { collars, surfaces }: SpaceLook): void {
    const shows = (batch: Batch, wanted: boolean) => {
      batch.mesh.visible = meshed && wanted && batch.count > 0;
    };
    shows(this.region, collars);
    for (const { batch } of [this.pieces, this.straight]) shows(batch, collars);
    shows(this.arcs.batch, collars || surfaces);
    shows(this.patches.batch, surfaces);
    this.far.visible = this.patches.batch.mesh.visible;
  }

  sync(state: MeshState, region: CollarRegion, what: ProtectionLook): void {
    const { protection } = state;
    const { theme } = what;
    const edge = parseColor(theme.intestine);
    this.patchUniforms.uEdge.value.set(edge[0], edge[1], edge[2], theme.dark ? 0.4 : 0.3);
    this.patchUniforms.uOpacity.value = theme.dark ? 0.17 : 0.14;
    if (!protection) {
      this.clear();
      return;
    }
    for (const part of this.parts()) this.syncPart(part, state, protection, what);
    this.setRegion(state, region, what);
  }

  dispose(): void {
    for (const batch of this.batches()) batch.dispose();
    (this.far.material as RawShaderMaterial).dispose();
  }

  private parts(): Part[] {
    return [this.pieces, this.straight, this.arcs, this.patches];
  }

  private batches(): Batch[] {
    return [this.region, ...this.parts().map((p) => p.batch)];
  }

  private syncPart(
    part: Part,
    state: MeshState,
    protection: ProtectionState,
    what: ProtectionLook,
  ): void {
    const { batch, slots, rows } = part;
    const count = this.filter(protection, part.kinds);
    batch.reserve(count * rows);
    slots.sync(this.live, count, protection.count, (slot) => {
      const n = slots.numbers[slot]!;
      if (part === this.patches) this.putPatch(n, slot, state, protection, what);
      else this.putCurve(part, n, slot, state, protection, what);
      for (let row = slot * rows; row < (slot + 1) * rows; row++) batch.touch(row);
    });
    batch.flush(slots.count * rows);
  }

  /** Fills `live` with the live elements of some kinds. */
  private filter({ live, liveCount, kind }: ProtectionState, kinds: readonly number[]): number {
    if (this.live.length < liveCount) this.live = new Uint32Array(2 * liveCount);
    let count = 0;
    for (let i = 0; i < liveCount; i++)
      if (kinds.includes(kind[live[i]!]!)) this.live[count++] = live[i]!;
    return count;
  }

  private putCurve(
    { batch, rows }: Part,
    n: number,
    slot: number,
    state: MeshState,
    { elements, kind }: ProtectionState,
    { theme, window, complex }: ProtectionLook,
  ): void {
    const record = elements.subarray(4 * n, 4 * n + 4);
    const points = curvePoints(kind[n]!, record, (v) => place(state, v), complex);
    const isPiece = kind[n] === Protecting.subsegment;
    const color = parseColor(kind[n] === Protecting.ringArc ? theme.intestine : theme.collar);
    const width = isPiece ? 7 : 2;
    for (let i = 0; i < rows; i++) {
      const [a, b] = [points[i]!, points[i + 1]!];
      const row = slot * rows + i;
      const opacity = isPiece ? 0.4 : 1;
      // A line out of sight keeps its row, with nothing to see.
      if (putLine(batch, row, a, b, color, window, width, 'solid', opacity) === 0)
        batch.array.fill(0, row * batch.stride, (row + 1) * batch.stride);
    }
  }

  private putPatch(
    n: number,
    row: number,
    state: MeshState,
    { elements, kind }: ProtectionState,
    { theme, window, complex }: ProtectionLook,
  ): void {
    const { array, stride } = this.patches.batch;
    const record = elements.subarray(4 * n, 4 * n + 4);
    const corners = patchCorners(kind[n]!, record, (v) => place(state, v), complex);
    for (const [k, p] of corners.entries()) putPoint3(array, row * stride + 3 * k, p, window);
    array.set(parseColor(theme.intestine), row * stride + 9);
    array[row * stride + 13] = 7;
  }

  /** Few, and they change with each insertion: written anew. */
  private setRegion(state: MeshState, region: CollarRegion, { theme, window }: ProtectionLook) {
    const { region: batch } = this;
    const { facets } = state;
    const color = parseColor(theme.collar);
    this.regionUniforms.uOpacity.value = theme.dark ? 0.34 : 0.26;
    batch.reserve(region.facets.length);
    for (const [row, n] of region.facets.entries()) {
      const at = row * batch.stride;
      for (let k = 0; k < 3; k++)
        putPoint3(batch.array, at + 3 * k, place(state, facets!.triangles[4 * n + k]!), window);
      batch.array.set(color, at + 9);
      batch.array[at + 13] = 0;
    }
    batch.touchAll();
    batch.flush(region.facets.length);
  }
}
