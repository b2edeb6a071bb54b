import type { RunOptions } from 'circumball';
import { deflateSync, inflateSync, strFromU8, strToU8 } from 'fflate';
import { complexToText, inputFromJson } from '../core/complex-json.ts';
import { type Corners, isCorners } from '../numerics/triangle.ts';
import { type Pace, paces } from '../replay/lockstep.ts';
import type { ColorMode, Input, View } from '../shared/types.ts';
import { isSpaceView, type SharedLook, type SpaceView } from '../space/types.ts';

/** What a link restores: input, algorithm, parameters, moment and view, exactly. */
export interface Shared {
  readonly complex: Input;
  readonly options: RunOptions;
  readonly moment: number | null; // position in the trace; null: the input alone
  readonly view: View | null;
  readonly color?: ColorMode;
  readonly overlays?: readonly string[]; // of the theory, by name
  readonly compare?: ComparisonOptions;
  readonly numerics?: NumericsOptions; // what is measured on the mesh
  readonly space?: SharedSpace;
  readonly triangle?: TriangleOptions; // the triangle laboratory is open
}

/** How space is looked at. */
export interface SharedSpace {
  readonly view: SpaceView | null;
  readonly look: SharedLook;
  readonly face?: number | null; // that is shown alone; null: none
}

/** A second algorithm beside the first one. */
export interface ComparisonOptions {
  readonly options: RunOptions;
  readonly pace: Pace;
  readonly tick: number | null; // of the common timeline; null: where `moment` is
}

/** A function, how it is approximated, and on which mesh: of a family, or (null) of the run. */
export interface NumericsOptions {
  readonly function: string; // id of the core's list; '' for one's own
  readonly expression: string;
  readonly method: string;
  readonly norm: string;
  readonly family: {
    readonly id: string;
    readonly columns: number;
    readonly degeneration: number;
  } | null;
}

export interface TriangleOptions {
  readonly corners: Corners;
  readonly expression: string;
}

const PREFIX = '#v1=';
/** A link may not unpack to more than this: a small hostile link must not take gigabytes. */
const MAX_BYTES = 64 * 1024 * 1024;

/** The part of the address after the page, "#v1=…": deflated JSON in URL-safe base 64. */
export function toHash(shared: Shared): string {
  const { complex, ...others } = shared;
  const rest = JSON.stringify(others);
  const text = `{"complex":${complexToText(complex)},"rest":${rest}}`;
  return PREFIX + toBase64(deflateSync(strToU8(text), { level: 9 }));
}

/** Null if the address carries no link; throws a sentence if it carries one that is damaged. */
export function fromHash(hash: string): Shared | null {
  if (!hash.startsWith(PREFIX)) return null;
  try {
    const packed = fromBase64(hash.slice(PREFIX.length));
    const json = JSON.parse(strFromU8(inflateBounded(packed)));
    const { options, moment, view, color, overlays, compare, numerics, triangle, space } =
      json.rest ?? {};
    if (!isComplexJson(json.complex)) throw new Error('no complex');
    return {
      complex: inputFromJson(json.complex),
      options: isRecord(options) ? (options as RunOptions) : {},
      moment: isPosition(moment) ? moment : null,
      view: isView(view) ? view : null,
      ...(typeof color === 'string' ? { color: color as ColorMode } : {}),
      ...(Array.isArray(overlays) ? { overlays: overlays.map(String) } : {}),
      ...(isRecord(compare) ? { compare: comparisonOf(compare) } : {}),
      ...(isRecord(space)
        ? {
            space: {
              view: isSpaceView(space.view) ? space.view : null,
              look: isRecord(space.look) ? (space.look as SharedLook) : {},
              face: isPosition(space.face) ? space.face : null,
            },
          }
        : {}),
      ...(isRecord(numerics) ? { numerics: numericsOf(numerics) } : {}),
      ...(isRecord(triangle) && isCorners(triangle.corners)
        ? { triangle: { corners: triangle.corners, expression: String(triangle.expression ?? '') } }
        : {}),
    };
  } catch {
    throw new Error(
      'The link is damaged: perhaps it was cut off. Ask for it again, or for the exported input.',
    );
  }
}

function comparisonOf({ options, pace, tick }: Record<string, unknown>): ComparisonOptions {
  return {
    options: isRecord(options) ? (options as RunOptions) : {},
    pace: paces.find((p) => p === pace) ?? 'vertices',
    tick: isPosition(tick) ? tick : null,
  };
}

function numericsOf(x: Record<string, unknown>): NumericsOptions {
  const { id, columns, degeneration } = isRecord(x.family) ? x.family : {};
  return {
    function: String(x.function ?? ''),
    expression: String(x.expression ?? ''),
    method: String(x.method ?? ''),
    norm: String(x.norm ?? ''),
    family:
      typeof id === 'string' && isPosition(columns) && isPosition(degeneration)
        ? { id, columns, degeneration }
        : null,
  };
}

function isPosition(x: unknown): x is number {
  return Number.isInteger(x) && (x as number) >= 0;
}

function inflateBounded(packed: Uint8Array): Uint8Array {
  // Deflate expands at most 1032 to 1; the output array bounds what is taken.
  const bound = Math.min(MAX_BYTES, packed.length * 1032 + 64);
  const text = inflateSync(packed, { out: new Uint8Array(bound) });
  return text;
}

function isRecord(x: unknown): x is Record<string, unknown> {
  return typeof x === 'object' && x !== null && !Array.isArray(x);
}

function isComplexJson(x: unknown): x is Parameters<typeof inputFromJson>[0] {
  const isPoint = (p: unknown) =>
    Array.isArray(p) && p.length >= 2 && p.every((c) => typeof c === 'number');
  return (
    isRecord(x) &&
    Array.isArray(x.vertices) &&
    x.vertices.every(isPoint) &&
    (x.segments === undefined || (Array.isArray(x.segments) && x.segments.every(isPoint))) &&
    (x.faces === undefined || (Array.isArray(x.faces) && x.faces.every(isFace))) &&
    (x.holes === undefined || (Array.isArray(x.holes) && x.holes.every(isPoint))) &&
    (x.regions === undefined ||
      (Array.isArray(x.regions) &&
        x.regions.every((r) => isRecord(r) && isPoint(r.at) && typeof r.label === 'number')))
  );
}

function isFace(x: unknown): boolean {
  const isList = (l: unknown) => Array.isArray(l) && l.every((n) => typeof n === 'number');
  const isOptional = (l: unknown) => l === undefined || isList(l);
  return (
    isRecord(x) &&
    Array.isArray(x.loops) &&
    x.loops.every(isList) &&
    (x.holes === undefined || (Array.isArray(x.holes) && x.holes.every(isList))) &&
    isOptional(x.segments) &&
    isOptional(x.vertices)
  );
}

function isView(x: unknown): x is View {
  return (
    isRecord(x) && [x.x, x.y, x.scale].every((n) => Number.isFinite(n)) && (x.scale as number) > 0
  );
}

function toBase64(bytes: Uint8Array): string {
  let text = '';
  for (let i = 0; i < bytes.length; i += 0x8000) {
    text += String.fromCharCode(...bytes.subarray(i, i + 0x8000));
  }
  return btoa(text).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
}

function fromBase64(text: string): Uint8Array {
  const binary = atob(text.replaceAll('-', '+').replaceAll('_', '/'));
  return Uint8Array.from(binary, (c) => c.charCodeAt(0));
}
