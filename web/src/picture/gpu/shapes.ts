/** Shaders of the display list: flat polygons, lines, disks, marks and glyphs; smooth by their distance to the edge. */

import type { Texture } from 'three';
import type { BatchShader } from './batch';
import { viewGlsl } from './uniforms';

const fragmentHead = /* glsl */ `
precision highp float;
precision highp int;
uniform float uPixel;
out vec4 color;
vec4 paint(vec4 c, float cover) { return vec4(c.rgb * c.a, c.a) * cover; }
float cover(float distance) { return clamp(0.5 - distance * uPixel, 0.0, 1.0); }
`;

export const polygonShader: BatchShader = {
  layout: [
    ['aP01', 4],
    ['aP2', 2],
    ['aColor', 4],
  ],
  corners: 3,
  vertex: `${viewGlsl}
in vec3 position; in vec4 aP01; in vec2 aP2; in vec4 aColor;
flat out vec4 vColor;
void main() {
  vec2 p = position.x < 0.5 ? aP01.xy : position.x < 1.5 ? aP01.zw : aP2;
  vColor = aColor;
  gl_Position = toClip(toPixels(p));
}`,
  fragment: `${fragmentHead}
flat in vec4 vColor;
void main() { color = paint(vColor, 1.0); }`,
};

/** Round-capped lines of a width in pixels, solid, or with dashes of given lengths. */
export const lineShader: BatchShader = {
  layout: [
    ['aEnds', 4],
    ['aColor', 4],
    ['aStyle', 3], // width, dash, gap (gap 0: solid)
  ],
  corners: 6,
  vertex: `${viewGlsl}
in vec3 position; in vec4 aEnds; in vec4 aColor; in vec3 aStyle;
flat out vec4 vColor; flat out vec3 vStyle; flat out float vLength;
out vec2 vAlong;
void main() {
  vec2 a = toPixels(aEnds.xy);
  vec2 b = toPixels(aEnds.zw);
  vec2 d = b - a;
  float l = length(d);
  vec2 u = l > 1e-6 ? d / l : vec2(1.0, 0.0);
  float r = aStyle.x * 0.5 + 1.0;
  float along = mix(-r, l + r, position.x);
  float across = mix(-r, r, position.y);
  vAlong = vec2(along, across);
  vColor = aColor; vStyle = aStyle; vLength = l;
  gl_Position = toClip(a + u * along + vec2(-u.y, u.x) * across);
}`,
  fragment: `${fragmentHead}
flat in vec4 vColor; flat in vec3 vStyle; flat in float vLength;
in vec2 vAlong;
void main() {
  float along = vAlong.x;
  float excess = max(max(-along, along - vLength), 0.0);
  if (vStyle.z > 0.0) {
    float period = vStyle.y + vStyle.z;
    float start = floor(along / period + 0.5 * vStyle.z / period) * period;
    start = clamp(start, 0.0, floor(vLength / period) * period);
    float end = min(start + vStyle.y, vLength);
    excess = max(max(start - along, along - end), 0.0);
  }
  float distance = length(vec2(excess, vAlong.y)) - vStyle.x * 0.5;
  color = paint(vColor, cover(distance));
}`,
};

/** Circles whose radius is in window units and whose stroke is in pixels. */
export const diskShader: BatchShader = {
  layout: [
    ['aCircle', 3],
    ['aStyle', 3], // width, dash, gap
    ['aStroke', 4],
    ['aFill', 4],
  ],
  corners: 6,
  vertex: `${viewGlsl}
in vec3 position; in vec3 aCircle; in vec3 aStyle; in vec4 aStroke; in vec4 aFill;
flat out vec4 vStroke; flat out vec4 vFill; flat out vec3 vStyle; flat out float vRadius;
out vec2 vAt;
void main() {
  vRadius = aCircle.z * uRatio;
  float r = vRadius + aStyle.x + 1.0;
  vAt = (position.xy * 2.0 - 1.0) * r;
  vStroke = aStroke; vFill = aFill; vStyle = aStyle;
  gl_Position = toClip(toPixels(aCircle.xy) + vAt);
}`,
  fragment: `${fragmentHead}
flat in vec4 vStroke; flat in vec4 vFill; flat in vec3 vStyle; flat in float vRadius;
in vec2 vAt;
void main() {
  float d = length(vAt) - vRadius;
  vec4 fill = paint(vFill, cover(d));
  float ring = abs(d) - vStyle.x * 0.5;
  float stroke = cover(ring);
  if (vStyle.z > 0.0) {
    float around = 6.283185307 * vRadius;
    float period = around / max(1.0, floor(around / (vStyle.y + vStyle.z) + 0.5));
    float along = mod((atan(vAt.y, vAt.x) + 6.283185307) * vRadius, period);
    float excess = max(abs(along - period * 0.5) - vStyle.y * 0.5, 0.0);
    stroke = cover(length(vec2(excess, d)) - vStyle.x * 0.5);
  }
  vec4 s = paint(vStroke, stroke);
  color = s + fill * (1.0 - s.a);
}`,
};

export const markLayout = [
  ['aAt', 2],
  ['aShape', 4], // size, shape, stroke width, angle
  ['aFill', 4],
  ['aStroke', 4],
] as const;

/** Marks of a size in pixels. `uSize` scales all marks of a batch; row `uLanding` is scaled by `uLandingSize`. */
export function markShader(uniforms: {
  uSize: { value: number };
  uLanding: { value: number };
  uLandingSize: { value: number };
}): BatchShader {
  return {
    layout: markLayout,
    corners: 6,
    uniforms,
    vertex: `${viewGlsl}
uniform float uSize; uniform float uLanding; uniform float uLandingSize;
in vec3 position; in vec2 aAt; in vec4 aShape; in vec4 aFill; in vec4 aStroke;
flat out vec4 vShape; flat out vec4 vFill; flat out vec4 vStroke;
out vec2 vAt;
void main() {
  vShape = aShape;
  vShape.x *= uSize * (float(gl_InstanceID) == uLanding ? uLandingSize : 1.0);
  vShape.z = min(aShape.z, vShape.x * 0.4);
  vFill = aFill; vStroke = aStroke;
  float r = vShape.x > 0.0 ? vShape.x * 0.75 + vShape.z + 1.0 : 0.0;
  vAt = (position.xy * 2.0 - 1.0) * r;
  gl_Position = toClip(toPixels(aAt) + vAt);
}`,
    fragment: `${fragmentHead}
flat in vec4 vShape; flat in vec4 vFill; flat in vec4 vStroke;
in vec2 vAt;
float segment(vec2 p, vec2 a, vec2 b) {
  vec2 d = b - a;
  return length(p - a - d * clamp(dot(p - a, d) / dot(d, d), 0.0, 1.0));
}
void main() {
  float r = vShape.x * 0.5;
  int shape = int(vShape.y + 0.5);
  float s = sin(vShape.w), c = cos(vShape.w);
  vec2 p = vec2(c * vAt.x + s * vAt.y, c * vAt.y - s * vAt.x);
  float d;
  bool open = false;
  if (shape == 1) { vec2 q = abs(p) - r * 0.88; d = max(q.x, q.y); }
  else if (shape == 2) { vec2 q = abs(p); d = (q.x + q.y - r * 1.2) * 0.7071; }
  else if (shape == 3) { d = min(segment(p, vec2(-r), vec2(r)), segment(p, vec2(-r, r), vec2(r, -r))); open = true; }
  else if (shape == 4) { d = min(segment(p, vec2(-r, 0.0), vec2(r, 0.0)), segment(p, vec2(0.0, -r), vec2(0.0, r))); open = true; }
  else if (shape == 5) { // arrow head, its tip at the place
    vec2 q = vec2(-p.x, abs(p.y));
    d = max(q.x - 2.0 * r, dot(q - vec2(0.0), normalize(vec2(-0.42, 1.0))));
  }
  else if (shape == 6) { // triangle, point up
    vec2 q = vec2(abs(p.x), p.y);
    d = max(dot(q, vec2(0.866, 0.5)) - r * 0.6, -q.y - r * 0.6);
  }
  else d = length(p) - r;
  if (open) {
    color = paint(vStroke, cover(d - vShape.z * 0.5));
  } else {
    vec4 fill = paint(vFill, cover(d));
    vec4 stroke = paint(vStroke, vShape.z > 0.0 ? cover(abs(d) - vShape.z * 0.5) : 0.0);
    color = stroke + fill * (1.0 - stroke.a);
  }
}`,
  };
}

export function glyphShader(atlas: Texture): BatchShader {
  return {
    layout: [
      ['aAt', 2],
      ['aBox', 4], // lower left corner from the place, and size, in pixels
      ['aUv', 4],
      ['aColor', 4],
      ['aHalo', 4],
    ],
    corners: 6,
    uniforms: { uAtlas: { value: atlas } },
    vertex: `${viewGlsl}
in vec3 position; in vec2 aAt; in vec4 aBox; in vec4 aUv; in vec4 aColor; in vec4 aHalo;
flat out vec4 vColor; flat out vec4 vHalo; out vec2 vUv;
void main() {
  vColor = aColor; vHalo = aHalo;
  vUv = mix(aUv.xy, aUv.zw, position.xy);
  vec2 at = toPixels(aAt) + aBox.xy;
  // Whole device pixels keep the type sharp.
  at = floor(at * uPixel + 0.5 + fract(uHalf * uPixel)) / uPixel - fract(uHalf * uPixel) / uPixel;
  gl_Position = toClip(at + aBox.zw * position.xy);
}`,
    fragment: `${fragmentHead}
uniform sampler2D uAtlas;
flat in vec4 vColor; flat in vec4 vHalo; in vec2 vUv;
void main() {
  vec4 texel = texture(uAtlas, vUv); // red: glyph, green: its halo
  vec4 halo = paint(vHalo, texel.g);
  vec4 ink = paint(vColor, texel.r);
  color = ink + halo * (1.0 - ink.a);
}`,
  };
}
