/**
 * The parts into which the subsegments cut the domain, numbered from 0 from left to right: refinement does not move
 * them, so a part keeps its number while its triangles come and go.
 */

import { Label } from '../shared/types';
import type { MeshModel } from './mesh-model';

/** Region by slot; -1 outside. O(n) expected. */
export function regionsOf(model: MeshModel): Int32Array {
  const n = model.triangleCount;
  const key = (a: number, b: number) => (a < b ? a * 0x4000000 + b : b * 0x4000000 + a);
  const walls = new Set<number>();
  for (let s = 0; s < model.subsegmentCount; ++s) {
    walls.add(key(model.subsegments[3 * s]!, model.subsegments[3 * s + 1]!));
  }
  const neighbors = new Int32Array(3 * n).fill(-1);
  const open = new Map<number, number>();
  for (let i = 0; i < 3 * n; ++i) {
    const slot = Math.floor(i / 3);
    const k = i % 3;
    const edge = key(model.triangles[i]!, model.triangles[3 * slot + ((k + 1) % 3)]!);
    if (walls.has(edge)) continue;
    const other = open.get(edge);
    if (other === undefined) {
      open.set(edge, i);
    } else {
      neighbors[i] = Math.floor(other / 3);
      neighbors[other] = slot;
      open.delete(edge);
    }
  }
  const regions = new Int32Array(n).fill(-1);
  let count = 0;
  const stack: number[] = [];
  for (let first = 0; first < n; ++first) {
    if (regions[first] !== -1 || model.labels[first] === Label.outside) continue;
    regions[first] = count;
    stack.push(first);
    for (let slot = stack.pop(); slot !== undefined; slot = stack.pop()) {
      for (let k = 0; k < 3; ++k) {
        const next = neighbors[3 * slot + k]!;
        if (next >= 0 && regions[next] === -1 && model.labels[next] !== Label.outside) {
          regions[next] = count;
          stack.push(next);
        }
      }
    }
    ++count;
  }
  return numbered(model, regions, count);
}

function numbered(model: MeshModel, regions: Int32Array, count: number): Int32Array {
  const corner = Array.from({ length: count }, () => [
    Number.POSITIVE_INFINITY,
    Number.POSITIVE_INFINITY,
    Number.NEGATIVE_INFINITY,
  ]);
  for (let i = 0; i < 3 * regions.length; ++i) {
    const region = regions[Math.floor(i / 3)]!;
    if (region < 0) continue;
    const c = corner[region]!;
    const v = model.triangles[i]!;
    c[0] = Math.min(c[0]!, model.coordinates[2 * v]!);
    c[1] = Math.min(c[1]!, model.coordinates[2 * v + 1]!);
    c[2] = Math.max(c[2]!, model.coordinates[2 * v]!);
  }
  const order = corner.map((_, i) => i);
  order.sort((i, j) => {
    const a = corner[i]!;
    const b = corner[j]!;
    return a[0]! - b[0]! || a[1]! - b[1]! || b[2]! - a[2]! || i - j;
  });
  const rank = new Int32Array(count);
  order.forEach((region, i) => {
    rank[region] = i;
  });
  return regions.map((region) => (region < 0 ? -1 : rank[region]!));
}
