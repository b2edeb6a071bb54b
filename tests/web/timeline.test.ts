import { describe, expect, it } from 'vitest';
import { bands, countsByStep, density, jump, weight } from '../../web/src/replay/timeline.ts';
import { Trace } from '../../web/src/replay/trace.ts';
import { encode, randomDrafts, squareTrace } from './small-trace.ts';

describe('the timeline', () => {
  const trace = squareTrace();

  it('has a band for each step, and together they cover every event', () => {
    expect(bands(trace)).toEqual([
      { step: 0, name: '0', start: 0, end: 7 },
      { step: 1, name: '2', start: 7, end: 16 },
    ]);
  });

  it('jumps to the moment right after the next event of a sort', () => {
    expect(jump(trace, 0, 'insertion', true)).toBe(2);
    expect(jump(trace, 2, 'insertion', true)).toBe(3);
    expect(jump(trace, 5, 'insertion', true)).toBe(14);
    expect(jump(trace, 14, 'insertion', true)).toBeNull();
    expect(jump(trace, 0, 'yield', true)).toBe(11);
    expect(jump(trace, 0, 'refusal', true)).toBe(15);
    expect(jump(trace, 0, 'step', true)).toBe(7);
    expect(jump(trace, 7, 'step', true)).toBe(16);
    expect(jump(trace, 16, 'step', true)).toBeNull();
  });

  it('jumps backwards to the one before, not to the one it stands on', () => {
    expect(jump(trace, 16, 'insertion', false)).toBe(14);
    expect(jump(trace, 14, 'insertion', false)).toBe(5);
    expect(jump(trace, 2, 'insertion', false)).toBeNull();
    expect(jump(trace, 16, 'step', false)).toBe(7);
    expect(jump(trace, 7, 'step', false)).toBe(0);
    expect(jump(trace, 0, 'step', false)).toBeNull();
  });

  it('going there and back visits the same insertions', () => {
    const long = new Trace({ vertexCount: 0, segments: [] });
    const { events, simplices } = encode(randomDrafts(60, 5));
    long.append(events, simplices, ['0']);
    const there: number[] = [];
    let p = jump(long, 0, 'insertion', true);
    for (; p !== null; p = jump(long, p, 'insertion', true)) there.push(p);
    const back: number[] = [];
    for (p = long.eventCount; p !== null; p = jump(long, p, 'insertion', false)) back.push(p);
    expect(back.reverse()).toEqual(there);
    expect(there.length).toBe(63);
  });

  it('densities add up to the events of their sort', () => {
    for (const buckets of [1, 4, 16]) {
      const d = density(trace, buckets);
      const size = trace.eventCount / buckets;
      const total = (a: Float32Array) => a.reduce((s, x) => s + x * size, 0);
      expect(total(d.inserted)).toBeCloseTo(5, 4);
      expect(total(d.refused)).toBeCloseTo(1, 4);
      expect(total(d.yielded)).toBeCloseTo(1, 4);
    }
  });

  it('counts by step, up to the moment', () => {
    expect(countsByStep(trace, 16)).toEqual([
      { name: '0', inserted: 4, refused: 0, yielded: 0, vertices: 4 },
      { name: '2', inserted: 1, refused: 1, yielded: 1, vertices: 5 },
    ]);
    expect(countsByStep(trace, 11).at(-1)).toEqual({
      name: '2',
      inserted: 0,
      refused: 0,
      yielded: 1,
      vertices: 4,
    });
    expect(countsByStep(trace, 3)).toEqual([
      { name: '0', inserted: 2, refused: 0, yielded: 0, vertices: 2 },
    ]);
  });

  it('gives every kind of event some time on screen', () => {
    for (let kind = 0; kind <= 8; kind++) expect(weight(kind)).toBeGreaterThan(0);
  });
});
