/**
 * Boxes by slot, found by their place. Meshes are graded over many orders of magnitude, so the grid is hierarchical: a box
 * lies in the level whose cells are just as large as it is, and so meets at most four of them. Putting and taking one cost
 * O(1), a question O(levels + what is there).
 */

interface Level {
  readonly cell: number; // side of a cell
  readonly cells: Map<number, number[]>;
  count: number;
}

/** Cells are counted in doubles: this many on each side of the origin are told apart. */
const mostCells = 2 ** 50;

export class SlotGrid {
  private readonly levels = new Map<number, Level>();
  private readonly levelOf = new Map<number, number>();
  /** By slot: up to four keys of cells, and how many. */
  private keys = new Int32Array(0);
  private keyCount = new Uint8Array(0);
  private seen = new Uint32Array(0);
  private stamp = 0;

  clear(): void {
    this.levels.clear();
    this.levelOf.clear();
    this.keyCount.fill(0);
  }

  set(slot: number, minX: number, minY: number, maxX: number, maxY: number): void {
    this.remove(slot);
    this.reserve(slot + 1);
    const magnitude = Math.max(Math.abs(minX), Math.abs(maxX), Math.abs(minY), Math.abs(maxY));
    const extent = Math.max(maxX - minX, maxY - minY, magnitude / mostCells, Number.MIN_VALUE);
    const exponent = Math.ceil(Math.log2(extent));
    let level = this.levels.get(exponent);
    if (!level) {
      level = { cell: 2 ** exponent, cells: new Map(), count: 0 };
      this.levels.set(exponent, level);
    }
    const columns = pair(Math.floor(minX / level.cell), Math.floor(maxX / level.cell));
    const rows = pair(Math.floor(minY / level.cell), Math.floor(maxY / level.cell));
    let count = 0;
    for (const i of columns) {
      for (const j of rows) {
        const key = hash(i, j);
        const cell = level.cells.get(key);
        if (!cell) level.cells.set(key, [slot]);
        else if (cell.at(-1) !== slot) cell.push(slot);
        else continue; // two cells of one key: it is there
        this.keys[4 * slot + count++] = key;
      }
    }
    this.keyCount[slot] = count;
    this.levelOf.set(slot, exponent);
    level.count++;
  }

  remove(slot: number): void {
    const exponent = this.levelOf.get(slot);
    if (exponent === undefined) return;
    this.levelOf.delete(slot);
    const level = this.levels.get(exponent)!;
    for (let k = 0; k < this.keyCount[slot]!; ++k) {
      const key = this.keys[4 * slot + k]!;
      const cell = level.cells.get(key)!;
      const at = cell.indexOf(slot);
      const last = cell.pop()!;
      if (at < cell.length) cell[at] = last;
      if (cell.length === 0) level.cells.delete(key);
    }
    this.keyCount[slot] = 0;
    if (--level.count === 0) this.levels.delete(exponent);
  }

  /**
   * Calls `visit` once for each slot whose cells meet the box, and for a few more: the caller looks closer.
   */
  query(
    minX: number,
    minY: number,
    maxX: number,
    maxY: number,
    visit: (slot: number) => void,
  ): void {
    const stamp = ++this.stamp;
    const look = (cell: readonly number[] | undefined) => {
      for (const slot of cell ?? []) {
        if (this.seen[slot] === stamp) continue;
        this.seen[slot] = stamp;
        visit(slot);
      }
    };
    for (const level of this.levels.values()) {
      const i0 = Math.floor(minX / level.cell);
      const i1 = Math.floor(maxX / level.cell);
      const j0 = Math.floor(minY / level.cell);
      const j1 = Math.floor(maxY / level.cell);
      const counts =
        Math.max(Math.abs(i0), Math.abs(i1), Math.abs(j0), Math.abs(j1)) < mostCells * 4;
      if (counts && (i1 - i0 + 1) * (j1 - j0 + 1) <= level.cells.size) {
        for (let i = i0; i <= i1; ++i) {
          for (let j = j0; j <= j1; ++j) look(level.cells.get(hash(i, j)));
        }
      } else {
        for (const cell of level.cells.values()) look(cell);
      }
    }
  }

  private reserve(count: number): void {
    if (this.keyCount.length >= count) return;
    const size = Math.ceil(count * 1.5) + 64;
    const keys = new Int32Array(4 * size);
    keys.set(this.keys);
    this.keys = keys;
    const keyCount = new Uint8Array(size);
    keyCount.set(this.keyCount);
    this.keyCount = keyCount;
    const seen = new Uint32Array(size);
    seen.set(this.seen);
    this.seen = seen;
  }
}

/** Cells of one key are looked at together: that only costs a look. */
function hash(i: number, j: number): number {
  return Math.imul(i % 0x80000000, 0x9e3779b1) ^ Math.imul(j % 0x80000000, 0x85ebca77);
}

function pair(a: number, b: number): readonly number[] {
  return a === b ? [a] : [a, b];
}
