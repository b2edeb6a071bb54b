/** Axes of logarithmic plots. */

/** 1, 2, 5 and tens between two positive numbers; only powers of ten, or of a hundred …, where those would be too many. */
export function logTicks(min: number, max: number, most: number): number[] {
  if (!(min > 0) || !(max >= min) || !Number.isFinite(max)) return [];
  const low = Math.floor(Math.log10(min));
  const high = Math.ceil(Math.log10(max));
  const ticks = (factors: readonly number[], stride: number) => {
    const found: number[] = [];
    for (let e = Math.floor(low / stride) * stride; e <= high; e += stride) {
      for (const f of factors) {
        const tick = Number(`${f}e${e}`);
        if (tick >= min && tick <= max) found.push(tick);
      }
    }
    return found;
  };
  const fine = [1, 2, 3, 4, 5, 6, 7, 8, 9];
  for (const factors of [fine, [1, 2, 5], [1, 3], [1]]) {
    const found = ticks(factors, 1);
    if (found.length <= most && (found.length > 1 || factors.length > 1)) return found;
  }
  let stride = 2;
  while (ticks([1], stride).length > most) stride++;
  return ticks([1], stride);
}

/** Both ends with some room, and never empty. */
export function logRange(values: Iterable<number | null>, room = 1.25): [number, number] {
  let min = Number.POSITIVE_INFINITY;
  let max = 0;
  for (const v of values) {
    if (v === null || !(v > 0) || !Number.isFinite(v)) continue;
    min = Math.min(min, v);
    max = Math.max(max, v);
  }
  return max > 0 ? [min / room, max * room] : [0.1, 1];
}
