/**
 * Commands: what an edit did, as plain data. A command is a list of patches, each of which holds what it takes to
 * go back; the inverse is the inverses in reverse. Applying a command and its inverse gives the same document, ids
 * and order included.
 */

import type { Document, Entity, IdSource, Kind } from './document';
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

/** An edit in the making: every call patches the working document and writes the patch down. */
export class Draft {
  readonly ids: IdSource;
  readonly patches: Patch[] = [];
  private base: Document;
  private lists: Partial<Lists> = {};
  private snapshot: Document | null;

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

  insert<K extends Kind>(kind: K, entity: Omit<Entity<K>, 'id'>): number {
    const id = this.ids.take();
    const list = this.list(kind);
    const whole = { ...entity, id } as Entity;
    this.patches.push({ op: 'insert', kind, index: list.length, entity: whole });
    list.push(whole);
    return id;
  }

  remove(kind: Kind, id: number): void {
    const list = this.list(kind);
    const index = list.findIndex((e) => e.id === id);
    if (index < 0) return;
    this.patches.push({ op: 'remove', kind, index, entity: list[index]! });
    list.splice(index, 1);
  }

  change<K extends Kind>(kind: K, id: number, fields: Partial<Omit<Entity<K>, 'id'>>): void {
    const list = this.list(kind);
    const index = list.findIndex((e) => e.id === id);
    if (index < 0) return;
    const before = list[index]!;
    const after = { ...before, ...fields } as Entity;
    if (JSON.stringify(before) === JSON.stringify(after)) return;
    this.patches.push({ op: 'change', kind, index, before, after });
    list[index] = after;
  }

  reset(after: Document): void {
    this.patches.push({ op: 'reset', before: this.document, after });
    this.base = after;
    this.snapshot = after;
    this.lists = {};
  }

  private list(kind: Kind): Entity[] {
    this.lists[kind] ??= [...this.base[kind]];
    this.snapshot = null;
    return this.lists[kind]!;
  }
}

/** One command in place of two in a row: changes of the same thing keep the first before and the last after. */
export function mergeCommands(first: Command, second: Command): Command {
  const patches = [...first.patches];
  for (const patch of second.patches) {
    const at = patches.findIndex(
      (p) =>
        p.op === 'change' &&
        patch.op === 'change' &&
        p.kind === patch.kind &&
        p.index === patch.index,
    );
    const old = patches[at];
    if (old?.op === 'change' && patch.op === 'change') patches[at] = { ...old, after: patch.after };
    else patches.push(patch);
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
