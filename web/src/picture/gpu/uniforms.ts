import { CustomBlending, OneFactor, OneMinusSrcAlphaFactor, Vector2, Vector4 } from 'three';
import type { View } from '../../shared/types';
import type { Size } from '../view';
import type { Window } from '../window';

/** How a material blends whose shader gives premultiplied colors. */
export const premultiplied = {
  blending: CustomBlending,
  blendSrc: OneFactor,
  blendDst: OneMinusSrcAlphaFactor,
  blendSrcAlpha: OneFactor,
  blendDstAlpha: OneMinusSrcAlphaFactor,
} as const;

/** What all shaders share: from window units to CSS pixels about the center of the canvas, and from there to clip space. */
export interface ViewUniforms {
  readonly uRatio: { value: number }; // pixels a window unit
  readonly uOffset: { value: Vector2 }; // view center from the window's origin, in pixels
  readonly uHalf: { value: Vector2 }; // half the canvas in pixels
  readonly uPixel: { value: number }; // device pixels a CSS pixel
  readonly uTile: { value: Vector4 }; // clip = clip * xy + zw: one tile of a print
}

export function makeViewUniforms(): ViewUniforms {
  return {
    uRatio: { value: 1 },
    uOffset: { value: new Vector2() },
    uHalf: { value: new Vector2(1, 1) },
    uPixel: { value: 1 },
    uTile: { value: new Vector4(1, 1, 0, 0) },
  };
}

/** Differences are taken in double precision, before anything becomes single. */
export function setView(uniforms: ViewUniforms, view: View, size: Size, window: Window): void {
  uniforms.uRatio.value = view.scale / window.unit;
  uniforms.uOffset.value.set(
    (view.x - window.originX) * view.scale,
    (view.y - window.originY) * view.scale,
  );
  uniforms.uHalf.value.set(size.width / 2, size.height / 2);
}

/** GLSL shared by all vertex shaders. */
export const viewGlsl = /* glsl */ `
precision highp float;
precision highp int;
uniform float uRatio;
uniform vec2 uOffset;
uniform vec2 uHalf;
uniform float uPixel;
uniform vec4 uTile;
vec2 toPixels(vec2 p) { return p * uRatio - uOffset; }
vec4 toClip(vec2 pixels) { return vec4(pixels / uHalf * uTile.xy + uTile.zw, 0.0, 1.0); }
`;
