/** Shaders of space: filled triangles with their edges, lines, spheres and marks; smooth by their distance to the edge. */

import { type IUniform, Matrix3, type Texture, Vector2, Vector3, Vector4 } from 'three';
import type { BatchShader } from '../picture/gpu/batch';
import { glyphShader, lineShader, markShader } from '../picture/gpu/shapes';
import { dot, minus } from '../replay/geometry3';
import type { SpaceView } from './types';
import { type Basis, basisOf, type Plane, type Size, type Window3 } from './view';

/** From window units to CSS pixels about the center of the canvas, with the depth as third coordinate; and to clip space. */
export interface SpaceUniforms extends Record<string, IUniform> {
  readonly uTurn: { value: Matrix3 }; // pixels a window unit: right, up, towards the eye
  readonly uOffset: { value: Vector3 }; // the target from the window's origin, in pixels
  readonly uHalf: { value: Vector2 }; // half the canvas in pixels
  readonly uDepth: { value: number }; // pixels of depth on each side of the target
  readonly uPixel: { value: number }; // device pixels a CSS pixel
  readonly uTile: { value: Vector4 }; // clip = clip * xy + zw: one tile of a print
  readonly uClip: { value: Vector4 }; // plane in window units: dot(xyz, p) > w is beyond it; 0 for none
}

export function makeSpaceUniforms(): SpaceUniforms {
  return {
    uTurn: { value: new Matrix3() },
    uOffset: { value: new Vector3() },
    uHalf: { value: new Vector2(1, 1) },
    uDepth: { value: 1 },
    uPixel: { value: 1 },
    uTile: { value: new Vector4(1, 1, 0, 0) },
    uClip: { value: new Vector4() },
  };
}

/** Differences are taken in double precision, before anything becomes single. `depth`: world units on each side of the target. */
export function setSpaceView(
  uniforms: SpaceUniforms,
  view: SpaceView,
  size: Size,
  window: Window3,
  depth: number,
  clip: Plane | null,
): Basis {
  const basis = basisOf(view);
  const { right, up, toEye } = basis;
  const ratio = view.scale / window.unit;
  const rows = [...right, ...up, ...toEye].map((x) => x * ratio) as NineNumbers;
  uniforms.uTurn.value.set(...rows);
  const d = minus(view.target, window.origin);
  uniforms.uOffset.value.set(
    dot(right, d) * view.scale,
    dot(up, d) * view.scale,
    dot(toEye, d) * view.scale,
  );
  uniforms.uHalf.value.set(size.width / 2, size.height / 2);
  uniforms.uDepth.value = Math.max(depth * view.scale, 1);
  if (clip) {
    const offset = (clip.offset - dot(clip.normal, window.origin)) * window.unit;
    uniforms.uClip.value.set(...(clip.normal as [number, number, number]), offset);
  } else {
    uniforms.uClip.value.set(0, 0, 0, 1);
  }
  return basis;
}

type NineNumbers = [number, number, number, number, number, number, number, number, number];

/** Lines lie on the faces that they bound, and marks on both: they are brought forward by so many pixels. */
const viewGlsl = /* glsl */ `
precision highp float;
precision highp int;
uniform mat3 uTurn;
uniform vec3 uOffset;
uniform vec2 uHalf;
uniform float uDepth;
uniform float uPixel;
uniform vec4 uTile;
uniform vec4 uClip;
vec3 toPixels(vec3 p) { return uTurn * p - uOffset; }
vec4 toClip(vec3 pixels) {
  float z = clamp(-pixels.z / uDepth, -0.9999, 0.9999);
  return vec4(pixels.xy / uHalf * uTile.xy + uTile.zw, z, 1.0);
}
float beyond(vec3 p) { return dot(uClip.xyz, p) - uClip.w; }
`;

/** The plane cuts off fragments of what the plane's picture draws in whole. */
function clipped(fragment: string): string {
  return fragment.replace(
    'void main() {',
    'in float vBeyond;\nvoid main() {\n  if (vBeyond > 0.0) discard;',
  );
}

/**
 * Triangles, lit from above the viewer's left shoulder, both sides alike. Edges whose bit is set in `aEdges` (1, 2, 4: opposite the
 * first, second, third corner) are drawn in the same pass. `uLit` 0 leaves the color as it is.
 */
export function triangleShader(uniforms: {
  uEdge: IUniform; // color
  uEdgeWidth: IUniform;
  uOpacity: IUniform;
  uLit: IUniform;
  uClips: IUniform; // 1: the plane cuts
  uLift: IUniform; // pixels towards the eye: what lies in one plane is drawn one above the other
}): BatchShader {
  return {
    layout: [
      ['aP0', 3],
      ['aP1', 3],
      ['aP2', 3],
      ['aColor', 4],
      ['aEdges', 1],
    ],
    corners: 3,
    uniforms,
    vertex: `${viewGlsl}
uniform float uLit; uniform float uClips; uniform float uLift;
in vec3 position; in vec3 aP0; in vec3 aP1; in vec3 aP2; in vec4 aColor; in float aEdges;
flat out vec4 vColor; flat out float vEdges; out vec3 vPart; out float vBeyond;
void main() {
  vec3 p = position.x < 0.5 ? aP0 : position.x < 1.5 ? aP1 : aP2;
  vPart = vec3(position.x < 0.5, position.x > 0.5 && position.x < 1.5, position.x > 1.5);
  vec3 n = uTurn * cross(aP1 - aP0, aP2 - aP0);
  float size = length(n);
  n = size > 0.0 ? n / size : vec3(0.0, 0.0, 1.0);
  if (n.z < 0.0) n = -n;
  float light = mix(1.0, 0.78 + 0.24 * max(dot(n, vec3(-0.32, 0.55, 0.77)), 0.0), uLit);
  vColor = vec4(aColor.rgb * light, aColor.a);
  vEdges = aEdges;
  vBeyond = uClips > 0.5 && aEdges < 7.5 ? beyond(p) : -1.0; // 8: a cap lies in the plane
  gl_Position = toClip(toPixels(p) + vec3(0.0, 0.0, uLift));
}`,
    fragment: /* glsl */ `
precision highp float;
precision highp int;
uniform float uPixel; uniform vec4 uEdge; uniform float uEdgeWidth; uniform float uOpacity;
flat in vec4 vColor; flat in float vEdges; in vec3 vPart; in float vBeyond;
out vec4 color;
void main() {
  vec3 slope = fwidth(vPart);
  if (vBeyond > 0.0 || vColor.a == 0.0) discard;
  vec4 fill = vec4(vColor.rgb, 1.0) * vColor.a * uOpacity;
  // Distance to each edge in device pixels; half of a line lies in each of the two triangles beside it.
  vec3 distance = vPart / max(slope, vec3(1e-9));
  int edges = int(vEdges + 0.5);
  float nearest = 1e9;
  if ((edges & 1) != 0) nearest = min(nearest, distance.x);
  if ((edges & 2) != 0) nearest = min(nearest, distance.y);
  if ((edges & 4) != 0) nearest = min(nearest, distance.z);
  float cover = clamp(0.5 * uEdgeWidth * uPixel + 0.5 - nearest, 0.0, 1.0) * uEdge.a;
  color = vec4(uEdge.rgb, 1.0) * cover + fill * (1.0 - cover);
}`,
  };
}

/** Round-capped lines of a width in pixels, as in the plane. */
export const line3Shader: BatchShader = {
  layout: [
    ['aA', 3],
    ['aB', 3],
    ['aColor', 4],
    ['aStyle', 3], // width, dash, gap (gap 0: solid)
  ],
  corners: 6,
  vertex: `${viewGlsl}
in vec3 position; in vec3 aA; in vec3 aB; in vec4 aColor; in vec3 aStyle;
flat out vec4 vColor; flat out vec3 vStyle; flat out float vLength;
out vec2 vAlong; out float vBeyond;
void main() {
  vec3 a = toPixels(aA);
  vec3 b = toPixels(aB);
  vec2 d = b.xy - a.xy;
  float l = length(d);
  vec2 u = l > 1e-6 ? d / l : vec2(1.0, 0.0);
  float r = aStyle.x * 0.5 + 1.0;
  float along = mix(-r, l + r, position.x);
  float across = mix(-r, r, position.y);
  float t = l > 1e-6 ? clamp(along / l, 0.0, 1.0) : 0.5;
  vAlong = vec2(along, across);
  vColor = aColor; vStyle = aStyle; vLength = l;
  vBeyond = beyond(mix(aA, aB, t));
  gl_Position = toClip(vec3(a.xy + u * along + vec2(-u.y, u.x) * across, mix(a.z, b.z, t) + 1.0 + aStyle.x));
}`,
  fragment: clipped(lineShader.fragment),
};

const flatMark = markShader({
  uSize: { value: 1 },
  uLanding: { value: -1 },
  uLandingSize: { value: 1 },
});

/** Marks of a size in pixels; `uSize` scales all of a batch. An arrow head points away from `aFrom`. */
export function mark3Shader(uniforms: { uSize: IUniform }): BatchShader {
  return {
    layout: [
      ['aAt', 3],
      ['aFrom', 3],
      ['aShape', 3], // size, shape, stroke width
      ['aFill', 4],
      ['aStroke', 4],
    ],
    corners: 6,
    uniforms,
    vertex: `${viewGlsl}
uniform float uSize;
in vec3 position; in vec3 aAt; in vec3 aFrom; in vec3 aShape; in vec4 aFill; in vec4 aStroke;
flat out vec4 vShape; flat out vec4 vFill; flat out vec4 vStroke;
out vec2 vAt; out float vBeyond;
void main() {
  vec3 at = toPixels(aAt);
  vec2 way = at.xy - toPixels(aFrom).xy;
  float size = aShape.x * uSize;
  vShape = vec4(size, aShape.y, min(aShape.z, size * 0.4), length(way) > 1e-3 ? atan(way.y, way.x) : 0.0);
  vFill = aFill; vStroke = aStroke;
  float r = size > 0.0 ? size * 0.75 + vShape.z + 1.0 : 0.0;
  vAt = (position.xy * 2.0 - 1.0) * r;
  vBeyond = beyond(aAt);
  gl_Position = toClip(vec3(at.xy + vAt, at.z + 4.0 + size));
}`,
    fragment: clipped(flatMark.fragment),
  };
}

/** Balls: translucent, denser towards the rim, and a thin circle around them. What stands before the sphere covers it. */
export const sphereShader: BatchShader = {
  layout: [
    ['aSphere', 4], // center and radius, in window units
    ['aStyle', 3], // width of the rim, dash, gap
    ['aColor', 4], // opacity at the middle
  ],
  corners: 6,
  vertex: `${viewGlsl}
in vec3 position; in vec4 aSphere; in vec3 aStyle; in vec4 aColor;
flat out vec4 vColor; flat out vec3 vStyle; flat out vec2 vSphere;
out vec2 vAt;
void main() {
  vec3 center = toPixels(aSphere.xyz);
  // The first row of the turn is as long as a window unit is in pixels.
  float radius = aSphere.w * length(vec3(uTurn[0][0], uTurn[1][0], uTurn[2][0]));
  vAt = (position.xy * 2.0 - 1.0) * (radius + aStyle.x + 1.0);
  vColor = aColor; vStyle = aStyle; vSphere = vec2(radius, center.z);
  gl_Position = toClip(vec3(center.xy + vAt, center.z));
}`,
  fragment: /* glsl */ `
precision highp float;
uniform float uPixel; uniform float uDepth;
flat in vec4 vColor; flat in vec3 vStyle; flat in vec2 vSphere;
in vec2 vAt;
out vec4 color;
void main() {
  float r = vSphere.x;
  float d = length(vAt);
  float inside = clamp(0.5 - (d - r) * uPixel, 0.0, 1.0);
  float height = sqrt(max(1.0 - (d * d) / (r * r), 0.0));
  float edge = (1.0 - height) * (1.0 - height);
  float light = max(dot(vec3(vAt / max(r, 1e-6), height), vec3(-0.32, 0.55, 0.77)), 0.0);
  float density = vColor.a * (0.55 + 0.45 * light + 2.2 * edge) * inside;
  float rim = abs(d - r);
  float cover = clamp(0.5 - (rim - vStyle.x * 0.5) * uPixel, 0.0, 1.0);
  if (vStyle.z > 0.0) {
    float around = 6.283185307 * r;
    float period = around / max(1.0, floor(around / (vStyle.y + vStyle.z) + 0.5));
    float along = mod((atan(vAt.y, vAt.x) + 6.283185307) * r, period);
    cover *= clamp(0.5 - (abs(along - period * 0.5) - vStyle.y * 0.5) * uPixel, 0.0, 1.0);
  }
  float alpha = max(density, cover * 0.9);
  if (alpha < 0.002) discard;
  color = vec4(vColor.rgb * alpha, alpha);
  float z = clamp(-(vSphere.y + height * r + 1.0) / uDepth, -0.9999, 0.9999);
  gl_FragDepth = z * 0.5 + 0.5;
}`,
};

export function text3Shader(atlas: Texture): BatchShader {
  return {
    layout: [
      ['aAt', 3],
      ['aBox', 4], // lower left corner from the place, and size, in pixels
      ['aUv', 4],
      ['aColor', 4],
      ['aHalo', 4],
    ],
    corners: 6,
    uniforms: { uAtlas: { value: atlas } },
    vertex: `${viewGlsl}
in vec3 position; in vec3 aAt; in vec4 aBox; in vec4 aUv; in vec4 aColor; in vec4 aHalo;
flat out vec4 vColor; flat out vec4 vHalo; out vec2 vUv; out float vBeyond;
void main() {
  vColor = aColor; vHalo = aHalo;
  vUv = mix(aUv.xy, aUv.zw, position.xy);
  vBeyond = beyond(aAt);
  vec3 at = toPixels(aAt);
  gl_Position = toClip(at + vec3(aBox.xy + aBox.zw * position.xy, 12.0));
}`,
    fragment: clipped(glyphShader(atlas).fragment),
  };
}
