/**
 * Many of one kind of thing in one draw call: an instanced shape whose instances are rows of floats. Rows are
 * written one by one; only the ranges that were touched are uploaded.
 */

import {
  BufferAttribute,
  DoubleSide,
  DynamicDrawUsage,
  FrontSide,
  GLSL3,
  InstancedBufferGeometry,
  InstancedInterleavedBuffer,
  InterleavedBufferAttribute,
  type IUniform,
  Mesh,
  RawShaderMaterial,
} from 'three';
import { premultiplied } from './uniforms';

export interface BatchShader {
  /** Floats a row, by attribute. */
  readonly layout: readonly (readonly [name: string, size: 1 | 2 | 3 | 4])[];
  /** Corners of the shape that is repeated: 3 (a triangle) or 6 (a quad as two triangles). */
  readonly corners: 3 | 6;
  readonly vertex: string;
  readonly fragment: string;
  readonly uniforms?: Record<string, IUniform>;
}

/** In space: what is behind is hidden, and (write) hides what is behind it. The plane needs neither. */
export type Depth = 'none' | 'test' | 'write';

/** Ranges closer than this many rows are uploaded as one. */
const joinGap = 32;

const quad = [0, 0, 1, 0, 1, 1, 0, 0, 1, 1, 0, 1];
const triangle = [0, 0, 1, 0, 2, 0];

export class Batch {
  readonly mesh: Mesh<InstancedBufferGeometry, RawShaderMaterial>;
  readonly stride: number;
  array: Float32Array;
  private buffer: InstancedInterleavedBuffer;
  private readonly layout: BatchShader['layout'];
  private count_ = 0;
  private dirty: number[] = [];
  private allDirty = false;

  /** `view`: uniforms that all shaders of a picture share. */
  constructor(shader: BatchShader, view: object, order: number, depth: Depth = 'none') {
    this.layout = shader.layout;
    this.stride = shader.layout.reduce((sum, [, size]) => sum + size, 0);
    const geometry = new InstancedBufferGeometry();
    const corners = new Float32Array(3 * shader.corners);
    const shape = shader.corners === 3 ? triangle : quad;
    for (let i = 0; i < shader.corners; ++i) {
      corners[3 * i] = shape[2 * i]!;
      corners[3 * i + 1] = shape[2 * i + 1]!;
    }
    geometry.setAttribute('position', new BufferAttribute(corners, 3));
    geometry.instanceCount = 0;
    const material = new RawShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: shader.vertex,
      fragmentShader: shader.fragment,
      uniforms: { ...(view as Record<string, IUniform>), ...shader.uniforms },
      side: depth === 'none' ? FrontSide : DoubleSide,
      transparent: true,
      depthTest: depth !== 'none',
      depthWrite: depth === 'write',
      ...premultiplied,
    });
    this.mesh = new Mesh(geometry, material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = order;
    this.mesh.visible = false;
    this.array = new Float32Array(0);
    this.buffer = this.allocate(16);
  }

  get count(): number {
    return this.count_;
  }

  /** Makes room for `rows` rows; what was written stays. */
  reserve(rows: number): void {
    if (rows * this.stride <= this.array.length) return;
    this.buffer = this.allocate(Math.ceil(rows * 1.5) + 16);
  }

  /** Marks a row as written. */
  touch(row: number): void {
    if (!this.allDirty) this.dirty.push(row);
  }

  touchAll(): void {
    this.allDirty = true;
    this.dirty = [];
  }

  /** Uploads what was touched, and draws the first `count` rows from now on. */
  flush(count: number): void {
    this.count_ = count;
    this.mesh.geometry.instanceCount = count;
    this.mesh.visible = count > 0;
    if (this.allDirty) {
      this.buffer.clearUpdateRanges();
      if (count > 0) this.buffer.addUpdateRange(0, count * this.stride);
      this.buffer.needsUpdate = true;
    } else if (this.dirty.length > 0) {
      this.dirty.sort((a, b) => a - b);
      let start = this.dirty[0]!;
      let end = start + 1;
      const add = () =>
        this.buffer.addUpdateRange(start * this.stride, (end - start) * this.stride);
      for (const row of this.dirty) {
        if (row <= end + joinGap) {
          end = Math.max(end, row + 1);
        } else {
          add();
          start = row;
          end = row + 1;
        }
      }
      add();
      this.buffer.needsUpdate = true;
    }
    this.allDirty = false;
    this.dirty = [];
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }

  private allocate(rows: number): InstancedInterleavedBuffer {
    const array = new Float32Array(rows * this.stride);
    array.set(this.array.subarray(0, Math.min(this.array.length, array.length)));
    this.array = array;
    const buffer = new InstancedInterleavedBuffer(array, this.stride);
    buffer.setUsage(DynamicDrawUsage);
    const geometry = this.mesh.geometry;
    geometry.dispose(); // frees the smaller buffer; three makes the geometry anew
    let offset = 0;
    for (const [name, size] of this.layout) {
      geometry.setAttribute(name, new InterleavedBufferAttribute(buffer, size, offset));
      offset += size;
    }
    this.touchAll();
    return buffer;
  }
}
