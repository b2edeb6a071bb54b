import { expect, it } from 'vitest';
import { cutCells } from '../../web/src/space/cut.ts';
import { lattice, SIDE } from './lattice.ts';

it('of 200,000 tetrahedra only what is seen is drawn: the hull, and the section', () => {
  const state = lattice(SIDE);
  expect(state.liveCellCount).toBeGreaterThan(190_000);
  const plane = { normal: [0.6, 0, 0.8] as const, offset: 20 };
  const cut = cutCells(state, { outside: true, only: null, exact: true, shrink: 0, plane });
  expect(cut.count).toBeGreaterThan(2 * SIDE * SIDE);
  expect(cut.count).toBeLessThan(24 * SIDE * SIDE);
});
