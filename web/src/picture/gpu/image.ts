/** One picture of texels, stretched over a rectangle of the plane, smooth between them. */

import {
  BufferAttribute,
  BufferGeometry,
  ClampToEdgeWrapping,
  DataTexture,
  GLSL3,
  LinearFilter,
  Mesh,
  type Object3D,
  RawShaderMaterial,
  RGBAFormat,
  UnsignedByteType,
  Vector4,
} from 'three';
import type { Bounds } from '../../shared/types';
import type { Window } from '../window';
import { premultiplied, type ViewUniforms, viewGlsl } from './uniforms';

export class ImageLayer {
  private readonly mesh: Mesh<BufferGeometry, RawShaderMaterial>;
  private readonly box = { value: new Vector4() };
  private readonly texels: { value: DataTexture };
  private pixels: Uint8Array | null = null;

  constructor(parent: Object3D, view: ViewUniforms, order: number) {
    this.texels = { value: emptyTexture() };
    const geometry = new BufferGeometry();
    const corners = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0];
    geometry.setAttribute('position', new BufferAttribute(new Float32Array(corners), 3));
    const material = new RawShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: `${viewGlsl}
uniform vec4 uBox;
in vec3 position;
out vec2 vAt;
void main() {
  vAt = position.xy;
  gl_Position = toClip(toPixels(mix(uBox.xy, uBox.zw, position.xy)));
}`,
      fragmentShader: /* glsl */ `
precision highp float;
uniform sampler2D uTexels;
in vec2 vAt;
out vec4 color;
void main() { vec4 c = texture(uTexels, vAt); color = vec4(c.rgb * c.a, c.a); }`,
      uniforms: { ...view, uBox: this.box, uTexels: this.texels },
      transparent: true,
      depthTest: false,
      depthWrite: false,
      ...premultiplied,
    });
    this.mesh = new Mesh(geometry, material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = order;
    this.mesh.visible = false;
    parent.add(this.mesh);
  }

  /** `pixels`: rows upwards, RGBA with straight alpha; the same array again is not uploaded again. Null: nothing. */
  set(
    image: { pixels: Uint8Array; width: number; height: number; bounds: Bounds } | null,
    window: Window,
  ): void {
    this.mesh.visible = image !== null;
    if (!image) return;
    const { minX, minY, maxX, maxY } = image.bounds;
    const { originX, originY, unit } = window;
    this.box.value.set(
      (minX - originX) * unit,
      (minY - originY) * unit,
      (maxX - originX) * unit,
      (maxY - originY) * unit,
    );
    if (image.pixels === this.pixels) return;
    this.pixels = image.pixels;
    this.texels.value.dispose();
    const texture = new DataTexture(
      image.pixels,
      image.width,
      image.height,
      RGBAFormat,
      UnsignedByteType,
    );
    texture.magFilter = LinearFilter;
    texture.minFilter = LinearFilter;
    texture.wrapS = ClampToEdgeWrapping;
    texture.wrapT = ClampToEdgeWrapping;
    texture.needsUpdate = true;
    this.texels.value = texture;
  }

  dispose(): void {
    this.texels.value.dispose();
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }
}

function emptyTexture(): DataTexture {
  return new DataTexture(new Uint8Array(4), 1, 1, RGBAFormat, UnsignedByteType);
}
