import { expect, it } from 'vitest';
import { asSentence, formatList, raised } from '../../web/src/words.ts';

it('raises what the core writes in plain text, and leaves expressions alone', () => {
  expect(raised('like h in H1 and like h^2 in L2.')).toBe('like h in H¹ and like h² in L².');
  expect(raised('H^s for s < 5/3, not H^2')).toBe('Hˢ for s < 5/3, not H²');
  expect(raised('analytic, |u|_2 is large')).toBe('analytic, |u|_2 is large');
  expect(raised('r^(1/5) at a point')).toBe('r^(1/5) at a point');
});

it('lists with an "and" before the last', () => {
  expect(formatList([])).toBe('');
  expect(formatList([4])).toBe('4');
  expect(formatList([0, 4])).toBe('0 and 4');
  expect(formatList([0, 1, 4])).toBe('0, 1 and 4');
});

it('makes sentences of what the core says, and keeps the name of a function', () => {
  expect(asSentence('vertices 0 and 1 are both at (0, 0)')).toBe(
    'Vertices 0 and 1 are both at (0, 0).',
  );
  expect(asSentence('a number was expected')).toBe('A number was expected.');
  expect(asSentence('u has no finite value')).toBe('u has no finite value.');
  expect(asSentence('Done already.')).toBe('Done already.');
  expect(asSentence('')).toBe('');
});
