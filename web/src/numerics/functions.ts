import type { Bounds, Point } from '../shared/types.ts';

/** Functions of x and y as text, and the inputs that they are looked at on. */

/** "x - 3", "x + 2", "x". */
function plus(text: string, value: number): string {
  if (value === 0) return text;
  return value < 0 ? `${text} - ${-value}` : `${text} + ${value}`;
}

/** The text with x and y shifted and scaled evenly, so that what it did on `from` it does on `to`. Unchanged if the two have one corner and one size. */
export function scaledTo(expression: string, from: Bounds, to: Bounds): string {
  const extent = (b: Bounds) => Math.max(b.maxX - b.minX, b.maxY - b.minY);
  const factor = extent(to) / extent(from);
  if (!(factor > 0) || !Number.isFinite(factor)) return expression;
  const moved = (name: 'x' | 'y', before: number, after: number) => {
    const shift = after === 0 ? name : `(${plus(name, -after)})`;
    const whole = plus(factor === 1 ? shift : `${shift}/${factor}`, before);
    return whole === name ? name : `(${whole})`;
  };
  const x = moved('x', from.minX, to.minX);
  const y = moved('y', from.minY, to.minY);
  // Names are words: the x of "exp" is none of ours.
  return expression.replace(/\b[xy]\b/g, (name) => (name === 'x' ? x : y));
}

export function sameBounds(a: Bounds, b: Bounds): boolean {
  return a.minX === b.minX && a.minY === b.minY && a.maxX === b.maxX && a.maxY === b.maxY;
}

/** Is the polygon all of the input, corner by corner in some order? */
export function isOutline(outline: readonly Point[], vertices: readonly Point[]): boolean {
  const key = ([x, y]: Point) => `${x} ${y}`;
  const own = new Set(vertices.map(key));
  return outline.length === vertices.length && outline.every((p) => own.has(key(p)));
}
