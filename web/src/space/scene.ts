/** What is drawn of space: input, mesh, protection, moment, and what is picked; written to the GPU as far as it changed. */

import { Scene as ThreeScene, Vector4 } from 'three';
import { Batch } from '../picture/gpu/batch';
import { type Glyphs, makeGlyphs } from '../picture/gpu/glyphs';
import { type CollarRegion, noRegion } from '../replay/collar-region';
import { distance3, dot, minus } from '../replay/geometry3';
import type {
  ColorScale,
  Complex3,
  DefectMark,
  MeshState,
  Moment3,
  PictureTheme,
  Point3,
} from '../shared/types';
import type { SpaceCamera } from './camera';
import { rgbaOf, SpaceColoring } from './coloring';
import { complexItems3, defectItems3 } from './complex-items';
import { append } from './face-items';
import { noSpaceItems, type SpaceItems } from './items';
import { putPoint3, SpaceLayer } from './layer';
import { faceColor, faceOpacity, type MeshLook, place, SpaceMeshLayer } from './mesh-layer';
import { momentOver3, momentUnder3, placesOf } from './moment-items';
import { labelItems3, pickedItems3 } from './overlay-items';
import type { PickScene } from './pick';
import { arcSpacing } from './protection-geometry';
import { ProtectionLayer } from './protection-layer';
import { makeSpaceUniforms, setSpaceView, triangleShader } from './shaders';
import { defaultLook, type SpaceHit, type SpaceLook, type SpaceView } from './types';
import {
  type Basis,
  type Bounds3,
  basisOf,
  boundsOf3,
  cornersOf,
  include,
  makeWindow3,
  type Plane,
  planeThrough,
  serves3,
  type Window3,
} from './view';

interface Stale {
  complex: boolean;
  mesh: boolean;
  rows: boolean; // every row of the mesh
  cells: boolean;
  moment: boolean;
  look: boolean;
  protection: boolean;
}

const everything: Stale = {
  complex: true,
  mesh: true,
  rows: true,
  cells: true,
  moment: true,
  look: true,
  protection: true,
};

export class SpaceScene {
  readonly three = new ThreeScene();
  readonly uniforms = makeSpaceUniforms();
  /** What the colors mean, or null; as of the last drawing. */
  scale: ColorScale | null = null;
  featureBounds: Bounds3 | null = null; // of segments and faces
  spacing = 0; // mean length of subsegments
  private crowding = 0; // the same, or of the arcs of rings, which may be shorter
  theme: PictureTheme;
  private readonly glyphs: Glyphs = makeGlyphs();
  private readonly mesh: SpaceMeshLayer;
  private readonly protection: ProtectionLayer;
  private readonly coloring = new SpaceColoring();
  private readonly faceUniforms = {
    uEdge: { value: new Vector4() },
    uEdgeWidth: { value: 1 },
    uOpacity: { value: 1 },
    uLit: { value: 1 },
    uClips: { value: 1 },
    uLift: { value: 0.75 },
  };
  private readonly faces: Batch;
  private readonly layers: { under: SpaceLayer; input: SpaceLayer; over: SpaceLayer };
  private basis: Basis;
  private window: Window3;
  private complex: Complex3 | null = null;
  private triangles = new Uint32Array(0);
  private defects: readonly DefectMark[] = [];
  private inputBounds: Bounds3 | null = null;
  private spacingOfInput = 0;
  private meshBounds: Bounds3 | null = null;
  private boundedVertices = 0;
  private state: MeshState | null = null;
  private run: object | null = null;
  private region: (() => CollarRegion) | null = null;
  private moment: Moment3 | null = null;
  private spaceLook: SpaceLook = defaultLook;
  private picked: SpaceHit | null = null;
  private extras: SpaceItems | null = null;
  private stale: Stale = { ...everything };

  /** `touched`: a drawing is due. */
  constructor(
    view: SpaceView,
    theme: PictureTheme,
    private readonly touched: () => void,
  ) {
    this.theme = theme;
    this.basis = basisOf(view);
    this.window = makeWindow3(view, null);
    this.mesh = new SpaceMeshLayer(this.three, this.uniforms);
    this.protection = new ProtectionLayer(this.three, this.uniforms);
    this.faces = new Batch(triangleShader(this.faceUniforms), this.uniforms, 11, 'test');
    this.three.add(this.faces.mesh);
    const layer = (order: number, depth: 'none' | 'test') =>
      new SpaceLayer(this.three, this.uniforms, this.glyphs, order, depth);
    this.layers = { under: layer(20, 'test'), input: layer(36, 'test'), over: layer(60, 'none') };
    this.three.matrixWorldAutoUpdate = false;
  }

  setComplex(
    complex: Complex3 | null,
    triangles: Uint32Array,
    defects: readonly DefectMark[],
  ): void {
    if (complex !== this.complex) {
      this.inputBounds = complex && boundsOf3([...complex.vertices, ...complex.holes]);
      this.featureBounds = complex && boundsOfFeatures(complex);
      this.spacingOfInput = complex ? meanLength(complex.vertices, complex.segments) : 0;
      if (!this.state) this.spacing = this.crowding = this.spacingOfInput;
    }
    Object.assign(this, { complex, triangles, defects });
    this.touch('complex');
  }

  setMesh(
    state: MeshState | null,
    run: object | null,
    region: (() => CollarRegion) | null = null,
  ): void {
    // Before the first event there is nothing but the input.
    const shown = state && state.position > 0 ? state : null;
    if (run !== this.run || !shown) {
      this.run = run;
      this.mesh.clear();
      this.protection.clear();
      this.coloring.forget();
      this.meshBounds = null;
      this.boundedVertices = 0;
    }
    if ((shown === null) !== (this.state === null)) this.touch('complex');
    this.state = shown;
    this.region = region;
    this.spacing = shown ? this.mesh.spacing(shown) : this.spacingOfInput;
    this.crowding = Math.min(this.spacing, shown ? arcSpacing(shown) : Number.POSITIVE_INFINITY);
    this.touch('mesh', 'cells', 'moment');
  }

  setMoment(moment: Moment3 | null): void {
    this.moment = moment;
    this.touch('moment');
  }

  setLook(look: SpaceLook): void {
    const before = this.spaceLook;
    this.spaceLook = look;
    this.touch('look', 'cells', 'moment');
    if (before.color !== look.color || before.cells !== look.cells || before.faces !== look.faces)
      this.touch('rows', 'mesh', 'complex');
  }

  setPicked(hit: SpaceHit | null): void {
    this.picked = hit;
    this.touch('moment');
  }

  setExtras(items: SpaceItems | null): void {
    this.extras = items;
    this.touch('moment');
  }

  setTheme(theme: PictureTheme): void {
    this.theme = theme;
    this.touch('complex', 'mesh', 'rows', 'cells', 'moment', 'look');
  }

  /** What the GPU held is gone. */
  restore(): void {
    this.mesh.clear();
    this.protection.clear();
    this.stale = { ...everything };
    this.touched();
  }

  dispose(): void {
    for (const layer of Object.values(this.layers)) layer.dispose();
    this.faces.dispose();
    this.mesh.dispose();
    this.protection.dispose();
    this.glyphs.texture.dispose();
  }

  /** The input, and the box about it once it is there. */
  contents(): Bounds3 | null {
    if (!this.meshBounds) return this.inputBounds;
    if (!this.inputBounds) return this.meshBounds;
    return include(include(this.inputBounds, this.meshBounds.min), this.meshBounds.max);
  }

  /** Where the moment takes place; nothing if it is about no place. */
  momentPlaces(): Point3[] {
    const { moment, state } = this;
    return moment && state ? placesOf(moment, state) : [];
  }

  /** As it was drawn last. */
  pickScene({ view, size }: SpaceCamera): PickScene {
    return {
      view,
      size,
      basis: this.basis,
      look: this.spaceLook,
      plane: this.plane(),
      complex: this.complex,
      triangles: this.triangles,
      state: this.state,
      filledFaces: this.mesh.filledFaces,
      cut: this.mesh.cut,
    };
  }

  /** Brings the buffers up to what was set, and no further. */
  prepare({ view, size }: SpaceCamera, pixelRatio: number): void {
    const { stale, state, theme, spaceLook } = this;
    this.includeVertices();
    const bounds = this.contents();
    if (!serves3(this.window, view, bounds)) {
      this.window = makeWindow3(view, bounds);
      Object.assign(stale, everything);
    }
    const { window, coloring } = this;
    const plane = this.plane();
    const depth = depthOf(bounds, view);
    this.basis = setSpaceView(this.uniforms, view, size, window, depth, plane);
    this.uniforms.uPixel.value = pixelRatio;
    if (stale.mesh || stale.rows || stale.look) {
      const ofCells = spaceLook.cells;
      if (coloring.set(spaceLook.color, theme.dark, state, ofCells))
        stale.rows = stale.cells = true;
      this.scale = state ? coloring.scale : null;
    }
    const look: MeshLook = { theme, look: spaceLook, coloring, plane, window };
    if (stale.rows) {
      this.mesh.clear();
      this.protection.clear();
      stale.cells = true;
    }
    if (stale.look || stale.rows) this.mesh.setLook(look);
    if (state && (stale.mesh || stale.rows)) {
      const before = this.mesh.filledFaces.size;
      this.mesh.sync(state, look);
      if (this.mesh.filledFaces.size !== before) stale.complex = true;
    }
    if (state && spaceLook.cells && stale.cells) this.mesh.setCells(state, look);
    this.mesh.show(state !== null, spaceLook);
    this.prepareProtection();
    if (stale.complex) this.prepareComplex(view.scale);
    if (stale.complex || stale.look) this.showFaces();
    if (stale.moment || stale.complex) this.prepareMoment(view.scale);
    const markSize = this.markSize(view.scale);
    this.mesh.setVertexSize(markSize);
    // Vertices of the input stay larger than what is between them.
    this.layers.input.setMarkSize(Math.max(markSize, 0.6));
    Object.assign(stale, {
      complex: false,
      mesh: false,
      rows: false,
      cells: spaceLook.cells ? false : stale.cells,
      moment: false,
      look: false,
    });
  }

  private prepareProtection(): void {
    const { stale, state, spaceLook, theme, window, complex } = this;
    const wanted = spaceLook.collars || spaceLook.surfaces;
    if (state && wanted && (stale.mesh || stale.rows || stale.protection)) {
      const region = this.region?.() ?? noRegion;
      this.protection.sync(state, region, { theme, look: spaceLook, window, complex });
    }
    stale.protection = !wanted;
    this.protection.show(state !== null, spaceLook);
  }

  private prepareComplex(scale: number): void {
    const { complex, theme, window, faces, triangles } = this;
    const meshed = this.state !== null;
    const items = complex ? complexItems3(complex, theme, meshed) : noSpaceItems();
    this.layers.input.set(items, window, scale);
    const color = rgbaOf(faceColor(theme));
    faces.reserve(triangles.length / 4);
    let row = 0;
    for (let t = 0; complex && t < triangles.length; t += 4) {
      if (meshed && this.mesh.filledFaces.has(triangles[t + 3]!)) continue;
      const at = row++ * faces.stride;
      for (let k = 0; k < 3; k++)
        putPoint3(faces.array, at + 3 * k, complex.vertices[triangles[t + k]!]!, window);
      faces.array.set(color, at + 9);
      faces.array[at + 13] = 0;
    }
    faces.touchAll();
    faces.flush(row);
  }

  private showFaces(): void {
    const { spaceLook, theme, faces } = this;
    const solid = spaceLook.faces === 'solid';
    this.faceUniforms.uOpacity.value = faceOpacity(spaceLook, theme);
    this.faceUniforms.uLit.value = solid ? 1 : 0.4;
    faces.mesh.material.depthWrite = solid;
    // Solid faces are drawn before what is translucent.
    faces.mesh.renderOrder = solid ? 1 : 11;
    faces.mesh.visible = faces.count > 0 && spaceLook.faces !== 'hidden';
  }

  private prepareMoment(scale: number): void {
    const { moment, state, theme, window, complex, picked } = this;
    const under = moment && state ? momentUnder3(moment, state, theme, complex) : noSpaceItems();
    const hides = this.spaceLook.faces === 'solid' || this.spaceLook.cells;
    const over = moment && state ? momentOver3(moment, state, theme, hides) : noSpaceItems();
    if (complex && this.defects.length > 0)
      append(over, defectItems3(complex, this.triangles, this.defects, theme));
    append(over, pickedItems3(picked, state, complex, theme));
    if (this.spaceLook.labels) append(over, labelItems3(state, complex, theme));
    if (this.extras) append(over, this.extras);
    this.layers.under.set(under, window, scale);
    this.layers.over.set(over, window, scale);
  }

  /** Vertices get smaller where they would crowd. */
  private markSize(scale: number): number {
    if (this.crowding === 0) return 1;
    return Math.min(1, Math.max(0.35, (this.crowding * scale) / 16));
  }

  private includeVertices(): void {
    const { state } = this;
    if (!state) return;
    for (; this.boundedVertices < state.vertexCount; this.boundedVertices++) {
      const v = this.boundedVertices;
      if (state.vertexBorn[v] === 0xffffffff) break; // not yet known
      this.meshBounds = include(this.meshBounds, place(state, v));
    }
  }

  private plane(): Plane | null {
    const { clip } = this.spaceLook;
    const bounds = this.contents();
    return clip && bounds ? planeThrough(bounds, clip.normal, clip.offset, clip.flipped) : null;
  }

  private touch(...what: (keyof Stale)[]): void {
    for (const key of what) this.stale[key] = true;
    this.touched();
  }
}

/** World units that what there is reaches before or behind the target. */
function depthOf(bounds: Bounds3 | null, view: SpaceView): number {
  if (!bounds) return 1;
  const { toEye } = basisOf(view);
  const depths = cornersOf(bounds).map((p) => Math.abs(dot(toEye, minus(p, view.target))));
  return 1.02 * Math.max(...depths) + 30 / view.scale;
}

/** Of segments and faces; of all vertices if there are none. */
function boundsOfFeatures(complex: Complex3): Bounds3 | null {
  const used = new Set<number>();
  for (const [a, b] of complex.segments) used.add(a).add(b);
  for (const { loops } of complex.faces)
    for (const loop of loops) for (const v of loop) used.add(v);
  const places = [...used].map((v) => complex.vertices[v]).filter((p) => p !== undefined);
  return boundsOf3(places.length > 1 ? places : complex.vertices);
}

function meanLength(
  vertices: readonly Point3[],
  segments: readonly (readonly [number, number])[],
): number {
  let sum = 0;
  let count = 0;
  for (const [a, b] of segments) {
    const [p, q] = [vertices[a], vertices[b]];
    if (!p || !q) continue;
    sum += distance3(p, q);
    count++;
  }
  return count > 0 ? sum / count : 0;
}
