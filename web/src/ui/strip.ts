import { density } from '../replay/timeline.ts';
import type { Trace } from '../replay/trace.ts';

/** Drawing of the strip: density of what matters. Insertions grow up from a line, refusals and yields hang from it. */

/** One run in the strip. */
export interface Lane {
  readonly trace: Trace;
  readonly length: number; // of the strip, in positions or ticks
  readonly at: (place: number) => number; // position in the trace at a place of the strip
  readonly parts: readonly {
    readonly name: string;
    readonly start: number;
    readonly end: number;
  }[];
}

interface Place {
  readonly top: number;
  readonly height: number;
  readonly width: number;
}

/** A cleared canvas of that many CSS pixels. */
export function stripPainter(
  canvas: HTMLCanvasElement,
  width: number,
  height: number,
): CanvasRenderingContext2D | null {
  const ratio = Math.min(2, window.devicePixelRatio);
  canvas.width = width * ratio;
  canvas.height = height * ratio;
  const context = canvas.getContext('2d');
  context?.scale(ratio, ratio);
  return context;
}

export function drawLane(context: CanvasRenderingContext2D, lane: Lane, place: Place): void {
  const { trace, length, at } = lane;
  const { width, height } = place;
  if (length === 0 || trace.eventCount === 0) return;
  const css = getComputedStyle(document.documentElement);
  const color = (name: string) => css.getPropertyValue(name).trim();
  const buckets = Math.max(1, Math.min(Math.floor(width / 3), length));
  const pitch = width / buckets;
  const thickness = Math.max(2, Math.min(pitch - 1, 12));
  const d = density(trace, buckets, length, at);
  const down = height / 3;
  const up = height - down - 4;
  const line = place.top + up;
  const bar = (b: number, from: number, to: number) =>
    context.fillRect(
      (b + 0.5) * pitch - thickness / 2,
      Math.min(from, to),
      thickness,
      Math.abs(to - from),
    );
  for (let b = 0; b < buckets; b++) {
    const inserted = Math.sqrt(d.inserted[b]!) * up;
    const refused = Math.sqrt(d.refused[b]!) * down;
    const yielded = Math.sqrt(d.yielded[b]!) * down;
    context.fillStyle = color('--inserted');
    if (inserted > 0) bar(b, line + 1, line + 1 - Math.max(1.5, inserted));
    context.fillStyle = color('--yielded');
    if (yielded > 0) bar(b, line + 2, line + 2 + Math.max(2, yielded));
    context.fillStyle = color('--refused');
    if (refused > 0) bar(b, line + 2, line + 2 + Math.max(2, refused));
  }
  context.fillStyle = color('--line-strong');
  context.fillRect(0, line + 1, width, 1);
}
