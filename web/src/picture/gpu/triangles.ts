/**
 * Triangles of the mesh with their edges, in one draw call. Each triangle paints the inner half of its three edges from their
 * line equations, so an edge needs no row of its own, has a constant width in pixels, and is smooth without
 * multisampling. Edges fade where triangles are only a few pixels long: there the shading tells more.
 */

import { type DataTexture, Vector4 } from 'three';
import type { BatchShader } from './batch';
import { viewGlsl } from './uniforms';

/** Floats of a row; see `writeTriangle`. */
export const triangleLayout = [
  ['aP01', 4], // corners of the piece that is filled
  ['aP2', 2],
  ['aE0', 3], // unit normal (inward) and offset of the lines of the edges
  ['aE1', 3],
  ['aE2', 3],
  ['aTraits', 3], // longest edge, value (color), flags
] as const;

export const TriangleFlag = { outside: 1, unknown: 2, dimmed: 4, stressed: 8 } as const;

export interface TriangleUniforms {
  readonly uRamp: { value: DataTexture };
  readonly uColored: { value: number };
  readonly uRange: { value: Vector4 }; // minimum, 1 / width of the range
  readonly uFill: { value: Vector4 };
  readonly uFillOutside: { value: Vector4 };
  readonly uEdge: { value: Vector4 };
  readonly uEdgeOutside: { value: Vector4 };
  readonly uStress: { value: Vector4 };
  readonly uEdgeWidth: { value: number };
}

export function makeTriangleUniforms(ramp: DataTexture): TriangleUniforms {
  return {
    uRamp: { value: ramp },
    uColored: { value: 0 },
    uRange: { value: new Vector4(0, 1, 0, 0) },
    uFill: { value: new Vector4() },
    uFillOutside: { value: new Vector4() },
    uEdge: { value: new Vector4() },
    uEdgeOutside: { value: new Vector4() },
    uStress: { value: new Vector4() },
    uEdgeWidth: { value: 1 },
  };
}

export function triangleShader(uniforms: TriangleUniforms): BatchShader {
  return {
    layout: triangleLayout,
    corners: 3,
    uniforms: uniforms as never,
    vertex: `${viewGlsl}
in vec3 position;
in vec4 aP01; in vec2 aP2; in vec3 aE0; in vec3 aE1; in vec3 aE2; in vec3 aTraits;
out vec2 vP;
flat out vec3 vE0; flat out vec3 vE1; flat out vec3 vE2;
flat out vec3 vTraits;
void main() {
  vec2 p = position.x < 0.5 ? aP01.xy : position.x < 1.5 ? aP01.zw : aP2;
  vP = p; vE0 = aE0; vE1 = aE1; vE2 = aE2; vTraits = aTraits;
  gl_Position = toClip(toPixels(p));
}`,
    fragment: /* glsl */ `
precision highp float;
precision highp int;
uniform float uRatio; uniform float uPixel;
uniform sampler2D uRamp; uniform float uColored; uniform vec4 uRange;
uniform vec4 uFill; uniform vec4 uFillOutside; uniform vec4 uEdge; uniform vec4 uEdgeOutside; uniform vec4 uStress;
uniform float uEdgeWidth;
in vec2 vP;
flat in vec3 vE0; flat in vec3 vE1; flat in vec3 vE2;
flat in vec3 vTraits;
out vec4 color;
float line(vec3 e) { return (dot(e.xy, vP) + e.z) * uRatio; }
void main() {
  int flags = int(vTraits.z + 0.5);
  bool outside = (flags & 1) != 0;
  vec4 fill = outside ? uFillOutside : uFill;
  if ((flags & 2) != 0) fill *= 0.55;
  if (!outside && uColored > 0.5) {
    float t = clamp((vTraits.y - uRange.x) * uRange.y, 0.0, 1.0);
    fill = texture(uRamp, vec2((0.5 + t * 255.0) / 256.0, 0.5));
  }
  if ((flags & 4) != 0) fill *= 0.28;
  if ((flags & 8) != 0 && uColored < 0.5) fill = uStress;
  float d = min(line(vE0), min(line(vE1), line(vE2)));
  float size = vTraits.x * uRatio;
  float show = mix(outside ? 0.3 : 0.16, 1.0, smoothstep(3.0, 13.0, size));
  float cover = clamp((uEdgeWidth * 0.5 - max(d, 0.0)) * uPixel + 0.5, 0.0, 1.0) * show;
  vec4 edge = (outside ? uEdgeOutside : uEdge) * cover;
  color = edge + fill * (1.0 - edge.a);
}`,
  };
}
