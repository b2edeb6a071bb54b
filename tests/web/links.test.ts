import { describe, expect, it } from 'vitest';
import { fromHash, type Shared, toHash } from '../../web/src/link/link.ts';
import { defaultLook } from '../../web/src/space/types.ts';

const shared: Shared = {
  complex: {
    vertices: [
      [0.1, -0],
      [1 / 3, 5e-324],
      [1e6 + 1e-9, 1.25e55],
      [-2.5e-45, Math.PI],
    ],
    segments: [
      [0, 1],
      [2, 3],
    ],
    holes: [[0.25, 0.5]],
    regions: [{ at: [1, 2], label: 7, max: 0.125 }],
    markers: { vertices: [1, 2, 3, 4], segments: [-5, 6] },
  },
  options: { algorithm: 'ruppert', minAngle: 26.5, size: '0.1 + x*x' },
  moment: 1234,
  view: { x: 0.1 + 0.2, y: -1e-17, scale: 512.3 },
  color: 'quality',
  overlays: ['featureSize', 'collars'],
};

describe('a link', () => {
  it('restores input, options, moment and view bit for bit, minus zero included', () => {
    const back = fromHash(toHash(shared));
    expect(back).toEqual(shared);
    expect(Object.is(back!.complex.vertices[0]![1], -0)).toBe(true);
  });

  it('restores a comparison, and takes a strange one for what can be made of it', () => {
    const compare = {
      options: { algorithm: 'collar', minEdge: 1e-4 },
      pace: 'share',
      tick: 77,
    } as const;
    expect(fromHash(toHash({ ...shared, compare }))).toEqual({ ...shared, compare });
    const strange = { options: 7, pace: 'gallop', tick: -1 } as never;
    expect(fromHash(toHash({ ...shared, compare: strange }))!.compare).toEqual({
      options: {},
      pace: 'vertices',
      tick: null,
    });
  });

  it('restores camera, cut and layers of space, and the face that is shown alone', () => {
    const space = {
      view: { target: [1, -2, 0.1], azimuth: 33, elevation: -12, scale: 1e-3 },
      look: {
        ...defaultLook,
        clip: { axis: 'y', normal: [0, 1, 0], offset: 0.25, flipped: true, exact: true },
        surfaces: false,
        collars: true,
      },
      face: 7,
    } as const;
    expect(fromHash(toHash({ ...shared, space }))).toEqual({ ...shared, space });
    const strange = { view: 'up', look: null, face: -3 } as never;
    expect(fromHash(toHash({ ...shared, space: strange }))!.space).toEqual({
      view: null,
      look: {},
      face: null,
    });
  });

  it('carries only characters that mail programs leave alone', () => {
    expect(toHash(shared)).toMatch(/^#v1=[A-Za-z0-9_-]+$/);
  });

  it('says what to do when it was cut off', () => {
    const hash = toHash(shared);
    expect(() => fromHash(hash.slice(0, hash.length - 20))).toThrow(/cut off/);
    expect(() => fromHash('#v1=!!!')).toThrow(/damaged/);
  });

  it('is not seen where there is none', () => {
    expect(fromHash('')).toBeNull();
    expect(fromHash('#something')).toBeNull();
  });

  it('refuses a complex that is not one', () => {
    const hash = toHash({
      ...shared,
      complex: { ...shared.complex, vertices: [['a', 1] as never] },
    });
    expect(() => fromHash(hash)).toThrow(/damaged/);
  });
});
