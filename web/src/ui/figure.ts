/** Figures of one picture or of two compared ones, with the name of its algorithm above each. */

/** One picture of a figure. */
export interface Part<T> {
  readonly title: string;
  readonly picture: T;
  readonly width: number; // on the screen, in CSS pixels; only the ratio counts
  readonly height: number;
}

/** How the parts lie in a figure of a given width: beside each other, or one above the other as on a phone. */
interface Layout {
  readonly width: number;
  readonly height: number;
  readonly boxes: readonly { x: number; y: number; width: number; height: number }[];
  readonly title: number; // height of a line of text above each part
}

function layout(parts: readonly Part<unknown>[], width: number, stacked: boolean): Layout {
  const gap = width * 0.02;
  const title = width * 0.035;
  const each = stacked ? width : (width - gap * (parts.length - 1)) / parts.length;
  const boxes: { x: number; y: number; width: number; height: number }[] = [];
  let across = 0;
  let down = 0;
  for (const part of parts) {
    const height = (each * part.height) / part.width;
    boxes.push({ x: across, y: down + title, width: each, height });
    if (stacked) down += title + height + gap;
    else across += each + gap;
  }
  const height = Math.max(...boxes.map((b) => b.y + b.height));
  return { width, height, boxes, title };
}

/** CSS pixels, which are the units of an SVG without other ones, to a centimeter. */
const PER_CENTIMETER = 96 / 2.54;

/** One SVG out of several: each is nested as it is, at its place. */
export function joinSvg(
  parts: readonly Part<string>[],
  centimeters: number,
  stacked: boolean,
  ink: string,
): string {
  const units = (x: number) => String(Math.round(x * 100) / 100);
  const place = layout(parts, centimeters * PER_CENTIMETER, stacked);
  const body = parts.map(({ picture, title }, i) => {
    const { x, y, width, height } = place.boxes[i]!;
    const nested = picture
      .replace(
        /width="[^"]*cm" height="[^"]*cm"/,
        `x="${units(x)}" y="${units(y)}" width="${units(width)}" height="${units(height)}"`,
      )
      .replaceAll(' id="', ` id="part-${i + 1}-`);
    const size = 0.62 * place.title;
    return (
      `<text x="${units(x)}" y="${units(y - 0.32 * place.title)}" font-family="sans-serif" font-weight="600" ` +
      `font-size="${units(size)}" fill="${ink}">${title.replace(/[&<>"]/g, (c) => `&#${c.charCodeAt(0)};`)}</text>\n${nested}`
    );
  });
  return (
    `<svg xmlns="http://www.w3.org/2000/svg" width="${units(centimeters)}cm" ` +
    `height="${units(place.height / PER_CENTIMETER)}cm" ` +
    `viewBox="0 0 ${units(place.width)} ${units(place.height)}">\n${body.join('\n')}</svg>\n`
  );
}

/** One PNG out of several, `width` pixels wide; `paint`: what is behind the names, null for nothing. */
export async function joinPng(
  parts: readonly Part<Blob>[],
  width: number,
  stacked: boolean,
  ink: string,
  paint: string | null,
): Promise<Blob> {
  const place = layout(parts, width, stacked);
  const canvas = document.createElement('canvas');
  canvas.width = Math.round(place.width);
  canvas.height = Math.round(place.height);
  const context = canvas.getContext('2d');
  if (!context) throw new Error('This browser gives no 2D canvas to write the picture to.');
  if (paint) {
    context.fillStyle = paint;
    context.fillRect(0, 0, canvas.width, canvas.height);
  }
  context.fillStyle = ink;
  context.font = `600 ${0.62 * place.title}px sans-serif`;
  for (const [i, { picture, title }] of parts.entries()) {
    const { x, y, width: w, height } = place.boxes[i]!;
    context.fillText(title, x, y - 0.32 * place.title);
    const image = await createImageBitmap(picture);
    context.drawImage(image, x, y, w, height);
    image.close();
  }
  return new Promise((resolve, reject) => {
    canvas.toBlob(
      (blob) =>
        blob ? resolve(blob) : reject(new Error('The picture is too large to be encoded.')),
      'image/png',
    );
  });
}
