import { NONE } from './replay/event.ts';

/** How numbers, names and the core's messages are written. */

const counts = new Intl.NumberFormat('en-US');

export function formatCount(n: number): string {
  return counts.format(n);
}

/** Four significant digits: for reading. Exact values are shown where they are edited. */
export function formatNumber(x: number): string {
  if (!Number.isFinite(x)) return Number.isNaN(x) ? '–' : x > 0 ? '∞' : '−∞';
  if (x === 0) return '0';
  const size = Math.abs(x);
  const text =
    size >= 1e6 || size < 1e-3
      ? x.toExponential(2).replace('e', ' · 10^').replace('^+', '^')
      : String(Number(x.toPrecision(4)));
  return text.replace('-', '−').replace(/\^(.*)$/, (_, power: string) => superscript(power));
}

function superscript(power: string): string {
  const digits = '⁰¹²³⁴⁵⁶⁷⁸⁹';
  return [...power].map((c) => (c >= '0' && c <= '9' ? digits[Number(c)] : '⁻')).join('');
}

/** 0.002, 50, 10⁻⁴, 2 · 10⁻⁵: numbers of few digits, as axes carry them. */
export function formatTick(x: number): string {
  if (x >= 1e-3 && x < 1e5) return String(Number(x.toPrecision(3)));
  const [digits, power] = x.toExponential().split('e');
  const ten = `10${superscript(power!.replace('+', ''))}`;
  return digits === '1' ? ten : `${digits} · ${ten}`;
}

export function formatDegrees(x: number): string {
  return Number.isFinite(x) ? `${x.toFixed(1)}°` : '–';
}

/** The core's messages begin in lower case, as the command prints them after a file name. */
export function asSentence(message: string): string {
  // The name of a function, or of a file, stays as it is.
  const text = message.replace(/^(?!u\b|\S+\.\w)./, (first) => first.toUpperCase());
  return /[.!?]$/.test(text) || text === '' ? text : `${text}.`;
}

/** "H1", "H^s", "L2", "h^2", as the core writes them in plain text, with raised letters and digits. */
export function raised(text: string): string {
  return text
    .replace(/\b([HL])\^?([12])\b/g, (_, space: string, of: string) => space + superscript(of))
    .replace(/\^(\d+)\b/g, (_, power: string) => superscript(power))
    .replace(/\^s\b/g, 'ˢ');
}

/** "0", "0 and 4", "0, 1 and 4". */
export function formatList(items: readonly (number | string)[]): string {
  const last = items.length - 1;
  return last < 1 ? items.join('') : `${items.slice(0, last).join(', ')} and ${items[last]}`;
}

/** "triangle 3–7–12", "subsegment 3–7 of segment 2", in space "triangle 3–7–12 of face 4", "tetrahedron 1–2–3–4". */
export function simplexName(simplex: readonly number[], segment?: number, face = NONE): string {
  const vertices = simplex.join('–');
  switch (simplex.length) {
    case 2:
      // An arc of a protecting circle lies on no input segment.
      if (segment === NONE) return `arc ${vertices}`;
      return `subsegment ${vertices}${segment === undefined ? '' : ` of segment ${segment}`}`;
    case 3:
      return `triangle ${vertices}${face === NONE ? '' : ` of face ${face}`}`;
    case 4:
      return `tetrahedron ${vertices}`;
    default:
      return `vertex ${vertices}`;
  }
}
