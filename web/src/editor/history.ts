/** Undo and redo without end: commands, and what was selected before and after each. */

import { apply, type Command, invert, isPatches, mergeCommands } from './command';
import { type Document, type Ids, kinds, noIds } from './document';

interface Entry {
  readonly command: Command;
  readonly before: Ids;
  readonly after: Ids;
}

export interface Step {
  readonly document: Document;
  readonly selection: Ids;
}

export class History {
  private undone: Entry[] = [];
  private done: Entry[] = [];

  get undoTitle(): string {
    return this.done.at(-1)?.command.title ?? '';
  }

  get redoTitle(): string {
    return this.undone.at(-1)?.command.title ?? '';
  }

  get canUndo(): boolean {
    return this.done.length > 0;
  }

  get canRedo(): boolean {
    return this.undone.length > 0;
  }

  push(command: Command, before: Ids, after: Ids): void {
    const last = this.done.at(-1);
    this.undone = [];
    if (last && command.merge !== undefined && last.command.merge === command.merge) {
      const merged = mergeCommands(last.command, command);
      this.done[this.done.length - 1] = { command: merged, before: last.before, after };
    } else {
      this.done.push({ command, before, after });
    }
  }

  /** The next command starts a step of its own, even with the same merge key. */
  seal(): void {
    const last = this.done.at(-1);
    if (last?.command.merge === undefined) return;
    const { merge: _, ...command } = last.command;
    this.done[this.done.length - 1] = { ...last, command };
  }

  undo(document: Document): Step | null {
    const entry = this.done.pop();
    if (!entry) return null;
    this.undone.push(entry);
    this.seal();
    return { document: apply(document, invert(entry.command.patches)), selection: entry.before };
  }

  redo(document: Document): Step | null {
    const entry = this.undone.pop();
    if (!entry) return null;
    this.done.push(entry);
    return { document: apply(document, entry.command.patches), selection: entry.after };
  }

  /** The nearest steps on both sides, at most about `budget` characters. */
  toJson(budget: number): { done: unknown[]; undone: unknown[] } {
    const take = (list: readonly Entry[]) => {
      const kept: unknown[] = [];
      for (let i = list.length - 1; i >= 0 && budget > 0; --i) {
        const { command, before, after } = list[i]!;
        const json = { command, before: idsToJson(before), after: idsToJson(after) };
        budget -= JSON.stringify(json).length;
        if (budget > 0) kept.unshift(json);
      }
      return kept;
    };
    return { done: take(this.done), undone: take(this.undone) };
  }

  /** False, and unchanged, if the value is not what `toJson` gives. */
  fromJson(value: unknown): boolean {
    if (typeof value !== 'object' || value === null) return false;
    const { done, undone } = value as Record<string, unknown>;
    if (!Array.isArray(done) || !Array.isArray(undone)) return false;
    const read = (list: unknown[]) => list.map(entryFromJson);
    const lists = [read(done), read(undone)] as const;
    if (lists.some((list) => list.includes(null))) return false;
    this.done = lists[0] as Entry[];
    this.undone = lists[1] as Entry[];
    return true;
  }
}

function idsToJson(ids: Ids): number[][] {
  return kinds.map((kind) => [...ids[kind]]);
}

function idsFromJson(value: unknown): Ids | null {
  if (!Array.isArray(value) || value.length !== kinds.length) return null;
  if (!value.every((list) => Array.isArray(list) && list.every(Number.isInteger))) return null;
  const ids: Record<string, ReadonlySet<number>> = { ...noIds };
  kinds.forEach((kind, i) => {
    ids[kind] = new Set(value[i] as number[]);
  });
  return ids as Ids;
}

function entryFromJson(value: unknown): Entry | null {
  if (typeof value !== 'object' || value === null) return null;
  const { command, before, after } = value as Record<string, unknown>;
  const selected = [idsFromJson(before), idsFromJson(after)] as const;
  if (typeof command !== 'object' || command === null || !selected[0] || !selected[1]) return null;
  const { title, patches, merge } = command as Record<string, unknown>;
  if (typeof title !== 'string' || !isPatches(patches)) return null;
  return {
    command: typeof merge === 'string' ? { title, patches, merge } : { title, patches },
    before: selected[0],
    after: selected[1],
  };
}
