/**
 * Commands: what an edit did, as plain data. A command is a list of patches, each of which holds what it takes to
 * go back; the inverse is the inverses in reverse. Applying a command and its inverse gives the same document, ids
 * and order included.
 */

import type { Point } from '../shared/types';
import type { Document, Entity, IdSource, Kind, Segment, Vertex } from './document';
import { kinds } from './document';

export type Patch =
  | { readonly op: 'insert'; readonly kind: Kind; readonly index: number; readonly entity: Entity }
  | { readonly op: 'remove'; readonly kind: Kind; readonly index: number; readonly entity: Entity }
  | {
      readonly op: 'change';
      readonly kind: Kind;
      readonly index: number;
      readonly before: Entity;
      readonly after: Entity;
    }
  | { readonly op: 'reset'; readonly before: Document; readonly after: Document };

export interface Command {
  readonly title: string;
  readonly patches: readonly Patch[];
  /** Commands in a row with the same key are one step of undo (nudges by arrow key). */
  readonly merge?: string;
}

type Lists = { [K in Kind]: Entity[] };

function isReset(patch: Patch): patch is Extract<Patch, { op: 'reset' }> {
  return patch.op === 'reset';
}

export function apply(document: Document, patches: readonly Patch[]): Document {
  let base = document;
  let lists: Partial<Lists> = {};
  for (const patch of patches) {
    if (isReset(patch)) {
      base = patch.after;
      lists = {};
      continue;
    }
    lists[patch.kind] ??= [...base[patch.kind]];
    const list = lists[patch.kind]!;
    if (patch.op === 'insert') list.splice(patch.index, 0, patch.entity);
    else if (patch.op === 'change') list[patch.index] = patch.after;
    else list.splice(patch.index, 1);
  }
  return { ...base, ...lists } as Document;
}

export function invert(patches: readonly Patch[]): Patch[] {
  return patches
    .map((patch): Patch => {
      switch (patch.op) {
        case 'insert':
          return { ...patch, op: 'remove' };
        case 'remove':
          return { ...patch, op: 'insert' };
        default:
          return { ...patch, before: patch.after, after: patch.before } as Patch;
      }
    })
    .reverse();
}

/**
 * An edit in the making: every call patches the working document and writes the patch down. Looking things up takes
 * constant time; `document` costs a copy of the lists that change afterwards, so loops take it once.
 */
export class Draft {
  readonly ids: IdSource;
  readonly patches: Patch[] = [];
  private base: Document;
  private lists: Partial<Lists> = {};
  private snapshot: Document | null;
  private indexes: Partial<Record<Kind, Map<number, number>>> = {};
  private places: Map<string, Set<number>> | null = null; // vertices by their coordinates
  private pairs: Map<string, number> | null = null; // segment by its ends

  constructor(document: Document, ids: IdSource) {
    this.base = document;
    this.snapshot = document;
    this.ids = ids;
  }

  /** As edited so far. */
  get document(): Document {
    if (!this.snapshot) {
      this.snapshot = { ...this.base, ...this.lists } as Document;
      this.base = this.snapshot;
      this.lists = {}; // what was handed out does not change any more
    }
    return this.snapshot;
  }

  get<K extends Kind>(kind: K, id: number): Entity<K> | null {
    const index = this.indexOf(kind, id);
    return index === undefined ? null : (this.current(kind)[index] as Entity<K>);
  }

  /** The vertex at exactly this place, other than `except`. */
  vertexAt(at: Point, except?: number): number | null {
    if (!this.places) {
      this.places = new Map();
      for (const vertex of this.current('vertices') as readonly Vertex[]) this.note(vertex);
    }
    for (const id of this.places.get(placeKey(at)) ?? []) if (id !== except) return id;
    return null;
  }

  /** The segment between two vertices, in either direction. */
  segmentBetween(a: number, b: number): number | null {
    if (!this.pairs) {
      this.pairs = new Map();
      for (const s of this.current('segments') as readonly Segment[]) {
        this.pairs.set(pairKey(s.a, s.b), s.id);
      }
    }
    return this.pairs.get(pairKey(a, b)) ?? null;
  }

  insert<K extends Kind>(kind: K, entity: Omit<Entity<K>, 'id'>): number {
    const id = this.ids.take();
    const list = this.list(kind);
    const whole = { ...entity, id } as Entity;
    this.patches.push({ op: 'insert', kind, index: list.length, entity: whole });
    this.indexes[kind]?.set(id, list.length);
    list.push(whole);
    this.enter(kind, whole);
    return id;
  }

  remove(kind: Kind, id: number): void {
    this.removeMany(kind, new Set([id]));
  }

  /** From the last to the first, so that no index shifts under another. */
  removeMany(kind: Kind, ids: ReadonlySet<number>): void {
    if (ids.size === 0) return;
    const list = this.list(kind);
    for (let index = list.length - 1; index >= 0; --index) {
      const entity = list[index]!;
      if (!ids.has(entity.id)) continue;
      this.patches.push({ op: 'remove', kind, index, entity });
      this.leave(kind, entity);
    }
    this.lists[kind] = list.filter((e) => !ids.has(e.id)) as never;
    delete this.indexes[kind];
  }

  change<K extends Kind>(kind: K, id: number, fields: Partial<Omit<Entity<K>, 'id'>>): void {
    const index = this.indexOf(kind, id);
    if (index === undefined) return;
    const before = this.current(kind)[index]!;
    const after = { ...before, ...fields } as Entity;
    if (JSON.stringify(before) === JSON.stringify(after)) return;
    this.patches.push({ op: 'change', kind, index, before, after });
    this.leave(kind, before);
    this.list(kind)[index] = after;
    this.enter(kind, after);
  }

  reset(after: Document): void {
    this.patches.push({ op: 'reset', before: this.document, after });
    this.base = after;
    this.snapshot = after;
    this.lists = {};
    this.indexes = {};
    this.places = null;
    this.pairs = null;
  }

  private list(kind: Kind): Entity[] {
    this.lists[kind] ??= [...this.base[kind]] as never;
    this.snapshot = null;
    return this.lists[kind]!;
  }

  private current(kind: Kind): readonly Entity[] {
    return this.lists[kind] ?? this.base[kind];
  }

  private indexOf(kind: Kind, id: number): number | undefined {
    this.indexes[kind] ??= new Map(this.current(kind).map((e, i) => [e.id, i]));
    return this.indexes[kind]!.get(id);
  }

  private note(vertex: Vertex): void {
    const key = placeKey(vertex.at);
    const there = this.places!.get(key);
    if (there) there.add(vertex.id);
    else this.places!.set(key, new Set([vertex.id]));
  }

  private enter(kind: Kind, entity: Entity): void {
    if (kind === 'vertices' && this.places) this.note(entity as Vertex);
    if (kind === 'segments' && this.pairs) {
      const { id, a, b } = entity as Segment;
      this.pairs.set(pairKey(a, b), id);
    }
  }

  private leave(kind: Kind, entity: Entity): void {
    if (kind === 'vertices') this.places?.get(placeKey((entity as Vertex).at))?.delete(entity.id);
    if (kind === 'segments' && this.pairs) {
      const { id, a, b } = entity as Segment;
      if (this.pairs.get(pairKey(a, b)) === id) this.pairs.delete(pairKey(a, b));
    }
  }
}

function placeKey(at: Point): string {
  return `${at[0] + 0} ${at[1] + 0}`; // no negative zero
}

function pairKey(a: number, b: number): string {
  return a < b ? `${a} ${b}` : `${b} ${a}`;
}

/** One command in place of two in a row: changes of the same thing keep the first before and the last after. */
export function mergeCommands(first: Command, second: Command): Command {
  const patches = [...first.patches];
  const key = (p: Patch) => (p.op === 'change' ? `${p.kind} ${p.index}` : '');
  const changes = new Map(patches.map((p, i) => [key(p), i]));
  for (const patch of second.patches) {
    const at = patch.op === 'change' ? changes.get(key(patch)) : undefined;
    const old = at === undefined ? undefined : patches[at];
    if (old?.op === 'change' && patch.op === 'change') {
      patches[at!] = { ...old, after: patch.after };
    } else {
      patches.push(patch);
    }
  }
  return { ...second, patches };
}

/** Is this the plain JSON of a list of patches? What comes from storage is not trusted. */
export function isPatches(value: unknown): value is Patch[] {
  return (
    Array.isArray(value) &&
    value.every((patch) => {
      if (typeof patch !== 'object' || patch === null) return false;
      if (patch.op === 'reset') return isDocument(patch.before) && isDocument(patch.after);
      if (!kinds.includes(patch.kind) || !Number.isInteger(patch.index) || patch.index < 0) {
        return false;
      }
      return patch.op === 'change'
        ? isEntity(patch.kind, patch.before) && isEntity(patch.kind, patch.after)
        : (patch.op === 'insert' || patch.op === 'remove') && isEntity(patch.kind, patch.entity);
    })
  );
}

export function isDocument(value: unknown): value is Document {
  if (typeof value !== 'object' || value === null) return false;
  const lists = value as Record<string, unknown>;
  return kinds.every((kind) => {
    const list = lists[kind];
    return Array.isArray(list) && list.every((entity) => isEntity(kind, entity));
  });
}

function isEntity(kind: Kind, value: unknown): boolean {
  if (typeof value !== 'object' || value === null) return false;
  const entity = value as Record<string, unknown>;
  if (!Number.isInteger(entity.id)) return false;
  if (kind === 'segments') return Number.isInteger(entity.a) && Number.isInteger(entity.b);
  const at = entity.at;
  if (!Array.isArray(at) || at.length !== 2 || !at.every((c) => typeof c === 'number'))
    return false;
  return kind !== 'regions' || typeof entity.label === 'number';
}
