import { describe, expect, it } from 'vitest';
import { MeshModel, SlotTable } from '../../web/src/picture/mesh-model';
import { pickMesh } from '../../web/src/picture/pick';
import { Scene } from '../../web/src/picture/scene';
import { type MeshState, NEVER } from '../../web/src/shared/types';
import { random } from './editor-helpers';
import { lattice, theme } from './picture-helpers';

function contents(table: SlotTable): number[] {
  return [...table.numbers.subarray(0, table.count)].sort((a, b) => a - b);
}

describe('slots', () => {
  it('hold exactly what is live after any change, each number in one slot', () => {
    const next = random(17);
    const table = new SlotTable();
    for (let round = 0; round < 60; ++round) {
      const density = next();
      const live = Array.from({ length: 200 }, (_, i) => i).filter(() => next() < density);
      const written = new Set<number>();
      const before = Array.from(table.numbers.subarray(0, table.count));
      table.sync(Uint32Array.from(live), live.length, 200, (slot) => written.add(slot));
      expect(contents(table)).toEqual(live);
      for (let slot = 0; slot < table.count; ++slot) {
        const number = table.numbers[slot]!;
        expect(table.slot(number)).toBe(slot);
        if (!written.has(slot)) expect(before[slot]).toBe(number);
      }
      for (let n = 0; n < 200; ++n) if (!live.includes(n)) expect(table.slot(n)).toBe(-1);
    }
  });

  it('a step rewrites only as many slots as triangles came', () => {
    const table = new SlotTable();
    const live = Array.from({ length: 1000 }, (_, i) => i);
    table.sync(Uint32Array.from(live), 1000, 1000, () => undefined);
    const changed = live.filter((n) => n !== 3 && n !== 700).concat([1000, 1001, 1002, 1003]);
    const written: number[] = [];
    table.sync(Uint32Array.from(changed), changed.length, 1004, (slot) => written.push(slot));
    expect(written.sort((a, b) => a - b)).toEqual([3, 700, 1000, 1001]);
  });
});

describe('model', () => {
  it('notices another run by the places and triangles of the same numbers', () => {
    const model = new MeshModel();
    const state = lattice(4);
    expect(model.sync(state).restarted).toBe(false);
    expect(model.sync(state).triangleSlots).toEqual([]);
    const moved = { ...state, coordinates: state.coordinates.slice() };
    moved.coordinates[12] = 0.123;
    const difference = model.sync(moved);
    expect(difference.restarted).toBe(true);
    expect(difference.triangleSlots).toHaveLength(state.liveCellCount);
    expect(model.coordinates[12]).toBe(0.123);
  });

  it('keeps its own copy of what it was shown', () => {
    const model = new MeshModel();
    const state = lattice(3);
    model.sync(state);
    state.coordinates.fill(9);
    state.cells.fill(0);
    expect(model.bounds).toEqual({ minX: 0, minY: 0, maxX: 1, maxY: 1 });
    expect(new Set(model.triangles.subarray(0, 3)).size).toBe(3);
  });

  it('a vertex whose place becomes known later is no other run', () => {
    const model = new MeshModel();
    const state = lattice(3);
    const unknown = {
      ...state,
      vertexBorn: state.vertexBorn.slice(),
      coordinates: state.coordinates.slice(),
    };
    unknown.vertexBorn[15] = NEVER;
    unknown.coordinates[30] = 0;
    unknown.coordinates[31] = 0;
    const fewer: MeshState = { ...unknown, liveCellCount: state.liveCellCount - 2 };
    model.sync(fewer);
    const difference = model.sync(state);
    expect(difference.restarted).toBe(false);
    expect(difference.vertices).toContain(15);
    expect(model.coordinates[31]).toBe(1);
  });
});

describe('picking', () => {
  it('finds vertex, side and triangle under a place', () => {
    const scene = new Scene(theme);
    const state = lattice(4);
    scene.model.sync(state);
    const reach = { vertex: 10, segment: 7 };
    const hit = pickMesh(scene.model, [0.5 + 0.1, 0.5 + 0.05], 400, reach, true);
    expect(hit.vertex).toBeNull();
    const t = hit.triangle!;
    const corners = [0, 1, 2].map((k) => state.cells[3 * t + k]!);
    expect(corners).toContain(12); // the middle of the lattice
    expect(pickMesh(scene.model, [0.501, 0.5], 400, reach, true).vertex).toBe(12);
    expect(pickMesh(scene.model, [0.4, 0.001], 400, reach, true).subsegment).toBe(0);
    expect(pickMesh(scene.model, [1.4, 1.4], 400, reach, true).triangle).toBeNull();
  });

  it('finds every triangle by its own center', () => {
    const scene = new Scene(theme);
    const state = lattice(20);
    scene.model.sync(state);
    for (let t = 0; t < state.liveCellCount; t += 7) {
      let x = 0;
      let y = 0;
      for (let k = 0; k < 3; ++k) {
        x += state.coordinates[2 * state.cells[3 * t + k]!]! / 3;
        y += state.coordinates[2 * state.cells[3 * t + k]! + 1]! / 3;
      }
      expect(pickMesh(scene.model, [x, y], 1e6, { vertex: 1, segment: 1 }, true).triangle).toBe(t);
    }
  });
});

describe('regions', () => {
  it('a wall between two halves makes two regions, left before right', () => {
    const scene = new Scene(theme);
    const state = lattice(4);
    const wall = [...state.subsegments, 2, 7, 4, 7, 12, 4, 12, 17, 4, 17, 22, 4];
    const walled: MeshState = {
      ...state,
      subsegments: Uint32Array.from(wall),
      liveSubsegments: Uint32Array.from({ length: wall.length / 3 }, (_, i) => i),
      liveSubsegmentCount: wall.length / 3,
    };
    scene.model.sync(walled);
    scene.coloring.setMode('region', false);
    for (let slot = 0; slot < scene.model.triangleCount; ++slot) {
      const x = [0, 1, 2].reduce(
        (sum, k) => sum + scene.model.coordinates[2 * scene.model.triangles[3 * slot + k]!]! / 3,
        0,
      );
      expect(Math.floor(scene.coloring.value(slot))).toBe(x < 0.5 ? 0 : 1);
    }
    expect(scene.coloring.scale?.max).toBe(2);
  });
});
