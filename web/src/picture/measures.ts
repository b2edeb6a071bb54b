/** Measures of a triangle, for coloring. Doubles in, doubles out; no decisions hang on them. */

/** Smallest angle in degrees, circumradius, longest edge and smallest height of triangle abc. */
export interface TriangleMeasures {
  minAngle: number;
  circumradius: number;
  longest: number;
  height: number;
}

export function measureTriangle(
  ax: number,
  ay: number,
  bx: number,
  by: number,
  cx: number,
  cy: number,
  out: TriangleMeasures,
): void {
  const a = Math.hypot(cx - bx, cy - by);
  const b = Math.hypot(ax - cx, ay - cy);
  const c = Math.hypot(bx - ax, by - ay);
  const twiceArea = Math.abs((bx - ax) * (cy - ay) - (by - ay) * (cx - ax));
  const shortest = Math.min(a, b, c);
  const longest = Math.max(a, b, c);
  const middle = a + b + c - shortest - longest;
  // The smallest angle lies between the two longer sides: sin = twice the area / their product.
  const sine = twiceArea / (longest * middle);
  out.minAngle = Math.asin(Math.min(sine, 1)) * (180 / Math.PI);
  out.circumradius = twiceArea > 0 ? (a / twiceArea) * b * c * 0.5 : Number.POSITIVE_INFINITY;
  out.longest = longest;
  out.height = longest > 0 ? twiceArea / longest : 0;
}
