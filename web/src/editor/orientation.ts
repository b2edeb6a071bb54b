/** The orientation of three points, exact: the editor must not call a touch a crossing. */

/** Error bound of the determinant in doubles: J. R. Shewchuk, "Adaptive precision floating-point arithmetic", 1997, section 4.3. */
const errorBound = (3 + 16 * (Number.EPSILON / 2)) * (Number.EPSILON / 2);

/** Sign of the area of abc: 1 counter-clockwise, -1 clockwise, 0 on one line. Finite coordinates. */
export function orientation(
  a: readonly [number, number],
  b: readonly [number, number],
  c: readonly [number, number],
): -1 | 0 | 1 {
  const left = (a[0] - c[0]) * (b[1] - c[1]);
  const right = (a[1] - c[1]) * (b[0] - c[0]);
  const determinant = left - right;
  // Products below this may have lost bits to underflow, which the bound does not cover.
  const safe = Math.abs(left) + Math.abs(right) > 1e-280;
  if (safe && Math.abs(determinant) > errorBound * (Math.abs(left) + Math.abs(right))) {
    return determinant > 0 ? 1 : -1;
  }
  return exactOrientation(a, b, c);
}

/** In integers: every double is a whole number of the smallest unit among the six. */
function exactOrientation(
  a: readonly [number, number],
  b: readonly [number, number],
  c: readonly [number, number],
): -1 | 0 | 1 {
  const parts = [a[0], a[1], b[0], b[1], c[0], c[1]].map(split);
  const unit = Math.min(...parts.map((p) => p.exponent));
  const [ax, ay, bx, by, cx, cy] = parts.map((p) => p.mantissa << BigInt(p.exponent - unit)) as [
    bigint,
    bigint,
    bigint,
    bigint,
    bigint,
    bigint,
  ];
  const value = (ax - cx) * (by - cy) - (ay - cy) * (bx - cx);
  return value > 0n ? 1 : value < 0n ? -1 : 0;
}

const view = new DataView(new ArrayBuffer(8));

/** value = mantissa * 2^exponent, of the bits of the double. */
function split(value: number): { mantissa: bigint; exponent: number } {
  view.setFloat64(0, value);
  const bits = view.getBigUint64(0);
  const fraction = bits & 0xfffffffffffffn;
  const biased = Number((bits >> 52n) & 0x7ffn);
  const magnitude = biased === 0 ? fraction : fraction | 0x10000000000000n;
  return {
    mantissa: bits >> 63n ? -magnitude : magnitude,
    exponent: biased === 0 ? -1074 : biased - 1075,
  };
}
