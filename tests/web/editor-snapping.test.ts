import { describe, expect, it } from 'vitest';
import { fromComplex, IdSource } from '../../web/src/editor/document';
import { roundTo, type SnapQuery, snapPoint, tidy } from '../../web/src/editor/snapping';
import type { Point, SnapOptions } from '../../web/src/shared/types';
import { allSnap, noSnap, square } from './editor-helpers';

const document = fromComplex(square, new IdSource());

function snap(at: Point, options: SnapOptions, more: Partial<SnapQuery> = {}) {
  return snapPoint(document, options, {
    at,
    unitsPerPixel: 0.01,
    touch: false,
    from: null,
    exclude: null,
    forceAngle: false,
    free: false,
    ...more,
  });
}

describe('snapping', () => {
  it('a vertex attracts before the segment it ends', () => {
    const snapped = snap([0.95, 0.03], allSnap);
    expect(snapped.kind).toBe('vertex');
    expect(snapped.at).toEqual([1, 0]);
  });

  it('a finger is attracted from farther than a mouse', () => {
    expect(snap([1.15, 0], { ...noSnap, vertex: true }).kind).toBeNull();
    expect(snap([1.15, 0], { ...noSnap, vertex: true }, { touch: true }).kind).toBe('vertex');
  });

  it('a place on a segment is on it, and on the grid along it', () => {
    const snapped = snap([0.43, 0.05], allSnap);
    expect(snapped.kind).toBe('segment');
    expect(snapped.at).toEqual([0.4, 0]);
    expect(snapped.segment).toBe(document.segments[0]!.id);
  });

  it('what is being moved does not attract itself', () => {
    const exclude = new Set([document.vertices[1]!.id]);
    expect(snap([1.02, 0.02], { ...allSnap, grid: false }, { exclude }).kind).toBeNull();
  });

  it('45 degrees is exact on all eight rays', () => {
    for (let k = 0; k < 8; ++k) {
      const angle = (k * Math.PI) / 4 + 0.03;
      const from: Point = [3, 3];
      const at: Point = [3 + 1.1 * Math.cos(angle), 3 + 1.1 * Math.sin(angle)];
      const { kind, at: p } = snap(at, { ...noSnap, angle: true }, { from });
      expect(kind).toBe('angle');
      const dx = Math.abs(p[0] - 3);
      const dy = Math.abs(p[1] - 3);
      expect(Math.min(dx, dy, Math.abs(dx - dy))).toBeLessThan(1e-12);
      expect(Math.hypot(p[0] - at[0], p[1] - at[1])).toBeLessThan(0.06);
    }
  });

  it('Shift keeps to 45 degrees however far, Alt to nothing at all', () => {
    const from: Point = [3, 3];
    expect(snap([4, 3.4], allSnap, { from, forceAngle: true }).kind).toBe('angle');
    const free = snap([1.001, 0.002], allSnap, { free: true });
    expect(free.kind).toBeNull();
    expect(free.at).toEqual([1, 0]); // tidied to the pixel
  });

  it('where a 45 degree ray meets a segment both hold', () => {
    const { kind, at } = snap([0.52, 0.97], allSnap, { from: [0.1, 0.55] });
    expect(kind).toBe('segment');
    expect(at[1]).toBe(1);
    expect(at[0]).toBeCloseTo(0.55, 12);
  });

  it('the grid gives the double next to the decimal', () => {
    expect(roundTo(0.30000000000000004, 0.1)).toBe(0.3);
    expect(roundTo(-0.0001, 0.02)).toBe(0);
    expect(Object.is(roundTo(-0.0001, 0.02), 0)).toBe(true);
    expect(roundTo(37.4, 5)).toBe(35);
    expect(snap([7.123, 7.456], allSnap).at).toEqual([7.2, 7.4]);
  });

  it('a free place has no more digits than a tenth of a pixel', () => {
    expect(tidy([0.123456789, 12.3456789], 0.01)).toEqual([0.12, 12.35]);
  });
});
