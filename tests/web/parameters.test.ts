import type { AlgorithmInfo } from 'circumball';
import { describe, expect, it } from 'vitest';
import { ParameterStore } from '../../web/src/store/parameters.svelte.ts';

const parameter = (name: string, value: number) => ({
  name,
  default: value,
  min: 0,
  max: 100,
  help: '',
});

const ruppert = {
  id: 'ruppert',
  dimension: 2,
  parameters: [
    parameter('tau', 1.4145),
    parameter('min-angle', 20.7),
    parameter('size', 0),
    parameter('box-scale', 3),
  ],
} as unknown as AlgorithmInfo;

const [tau, minAngle, size, boxScale] = ruppert.parameters as [never, never, never, never];

describe('parameters of the next run', () => {
  it('leave to the core what was not set by hand', () => {
    const store = new ParameterStore();
    expect(store.options([ruppert])).toEqual({ algorithm: 'ruppert', maxVertices: 200_000 });
    store.set('size', '0', size);
    expect(store.options([ruppert]).size).toBeUndefined();
  });

  it('go where the core looks for them', () => {
    const store = new ParameterStore();
    store.set('min-angle', '26', minAngle);
    store.set('size', '0.1 + x*x', size);
    store.set('box-scale', '4', boxScale);
    store.domain = 'box';
    store.minEdge = '1e-3';
    expect(store.options([ruppert])).toEqual({
      algorithm: 'ruppert',
      maxVertices: 200_000,
      minAngle: 26,
      size: '0.1 + x*x',
      parameters: { 'box-scale': '4' },
      domain: 'box',
      minEdge: 0.001,
    });
  });

  it('know that tau and min-angle are one threshold: the last one set is meant', () => {
    const store = new ParameterStore();
    store.set('min-angle', '26', minAngle);
    store.set('tau', '1.6', tau);
    expect(store.options([ruppert])).toMatchObject({ tau: 1.6 });
    expect(store.options([ruppert]).minAngle).toBeUndefined();
  });

  it('survive a link: what options say is what they were made from', () => {
    const store = new ParameterStore();
    store.set('min-angle', '26', minAngle);
    store.set('box-scale', '4', boxScale);
    store.domain = 'closed';
    store.maxVertices = 1234;
    const other = new ParameterStore();
    other.adopt(store.options([ruppert]));
    expect(other.options([ruppert])).toEqual(store.options([ruppert]));
  });

  it('of another algorithm are not passed on', () => {
    const store = new ParameterStore();
    store.set('min-angle', '26', minAngle);
    store.algorithm = 'delaunay';
    const delaunay = { id: 'delaunay', dimension: 2, parameters: [] } as unknown as AlgorithmInfo;
    expect(store.options([ruppert, delaunay])).toEqual({
      algorithm: 'delaunay',
      maxVertices: 200_000,
    });
  });
});
