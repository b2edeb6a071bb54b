/** The scene as SVG: the same display lists, widths, shapes and dashes as on the canvas. A pure function. */

import { type Background, Label, type Point, VertexKind, type View } from '../shared/types';
import { clipPolygon, clipSegment } from './clip';
import {
  type Dash,
  type DiskItem,
  dashes,
  type Items,
  type LineItem,
  type MarkItem,
  type TextItem,
} from './items';
import { vertexMark } from './marks';
import { pngBytes, toBase64 } from './png-bytes';
import type { Scene } from './scene';
import { type Size, toScreen, visibleBounds } from './view';

/** Pixels that drawings may reach beyond the paper; farther, lines are cut. */
const margin = 60;

/** `centimeters` wide on paper. */
export function sceneToSvg(
  scene: Scene,
  view: View,
  size: Size,
  centimeters: number,
  background: Background = 'theme',
): string {
  const height = (centimeters * size.height) / size.width;
  const { theme } = scene;
  const paint = background === 'white' ? '#ffffff' : theme.background;
  const paper = new Paper(view, size);
  const parts: string[] = [];
  const group = (id: string, items: Items) => {
    const text = paper.items(items);
    if (text) parts.push(`<g id="${id}">\n${text}</g>`);
  };
  group('grid', scene.background(view, size));
  if (scene.meshed && scene.overlays.mesh) parts.push(meshToSvg(scene, paper, view, size));
  parts.push(imageToSvg(scene, view, size));
  group('field', scene.field(view));
  const { under, features } = scene.middle(view, size);
  group('moment', under);
  group('features', features);
  if (scene.meshed && scene.overlays.vertices) {
    const marks: string[] = [];
    const seen = visibleBounds(view, size, margin);
    const scale = scene.vertexSize(view, size);
    for (let v = 0; v < scene.model.vertexCount; ++v) {
      const at = scene.place(v);
      const kind = scene.model.vertexKind[v]!;
      if (!scene.model.vertexAlive[v] || kind === VertexKind.input || scale === 0) continue;
      if (at[0] < seen.minX || at[0] > seen.maxX || at[1] < seen.minY || at[1] > seen.maxY)
        continue;
      const mark = vertexMark(kind, at, theme);
      marks.push(
        paper.mark({ ...mark, size: mark.size * scale, width: (mark.width ?? 0) * scale }),
      );
    }
    if (marks.length > 0) parts.push(`<g id="vertices">\n${marks.join('')}</g>`);
  }
  group('marks', scene.top(view, size));
  return (
    `<svg xmlns="http://www.w3.org/2000/svg" width="${number(centimeters)}cm" height="${number(height)}cm" ` +
    `viewBox="0 0 ${number(size.width)} ${number(size.height)}">\n` +
    (background === 'transparent' ? '' : `<rect width="100%" height="100%" fill="${paint}"/>\n`) +
    `${parts.filter(Boolean).join('\n')}\n</svg>\n`
  );
}

function meshToSvg(scene: Scene, paper: Paper, view: View, size: Size): string {
  const { model, theme, coloring, overlays } = scene;
  const box = visibleBounds(view, size, margin);
  const fills: string[] = [];
  const edges = new Map<string, { a: Point; b: Point; outside: boolean }>();
  const colored = coloring.scale !== null;
  for (let slot = 0; slot < model.triangleCount; ++slot) {
    const label = model.labels[slot]!;
    const outside = label === Label.outside;
    if (outside && !overlays.outside) continue;
    const vertices = [0, 1, 2].map((k) => model.triangles[3 * slot + k]!);
    const corners = clipPolygon(
      vertices.map((v) => scene.place(v)),
      box,
    );
    if (corners.length < 3) continue;
    const fill = outside ? theme.fillOutside : colored ? coloring.css(slot) : theme.fill;
    const stressed = overlays.highlight?.has(model.triangleSlots.numbers[slot]!);
    const opacity =
      (label === Label.unknown ? 0.55 : 1) * (overlays.highlight && !stressed ? 0.28 : 1);
    fills.push(
      `<path d="${paper.path(corners)}Z" fill="${fill}"${opacity < 1 ? ` fill-opacity="${number(opacity)}"` : ''}/>\n`,
    );
    for (let k = 0; k < 3; ++k) {
      const a = vertices[k]!;
      const b = vertices[(k + 1) % 3]!;
      const key = a < b ? `${a} ${b}` : `${b} ${a}`;
      const edge = edges.get(key);
      if (edge) edge.outside &&= outside;
      else edges.set(key, { a: scene.place(a), b: scene.place(b), outside });
    }
  }
  const lines = { inside: '', outside: '' };
  for (const { a, b, outside } of edges.values()) {
    const part = clipSegment(a, b, box);
    if (part) lines[outside ? 'outside' : 'inside'] += paper.path(part);
  }
  const path = (d: string, color: string) =>
    d
      ? `<path d="${d}" fill="none" stroke="${color}" stroke-width="1" stroke-linecap="round"/>\n`
      : '';
  return `<g id="mesh">\n${fills.join('')}${path(lines.outside, theme.inkFaint)}${path(lines.inside, theme.edge)}</g>`;
}

/** The tint of lfs, as an image inside: a field has no outlines. */
function imageToSvg(scene: Scene, view: View, size: Size): string {
  const image = scene.image();
  if (!image) return '';
  const { minX, minY, maxX, maxY } = image.bounds;
  const [x, y] = toScreen(view, size, [minX, maxY]);
  const bytes = pngBytes(image.pixels, image.width, image.height);
  return (
    `<image x="${number(x)}" y="${number(y)}" width="${number((maxX - minX) * view.scale)}" ` +
    `height="${number((maxY - minY) * view.scale)}" preserveAspectRatio="none" ` +
    `href="data:image/png;base64,${toBase64(bytes)}"/>`
  );
}

class Paper {
  private readonly view: View;
  private readonly size: Size;

  constructor(view: View, size: Size) {
    this.view = view;
    this.size = size;
  }

  items(items: Items): string {
    const box = visibleBounds(this.view, this.size, margin);
    let out = '';
    for (const item of items.polygons) {
      const points = clipPolygon(item.points, box);
      if (points.length < 3) continue;
      out += `<path d="${this.path(points)}Z" fill="${item.fill}"${opacity('fill-opacity', item.opacity)}/>\n`;
    }
    for (const item of items.disks) out += this.disk(item);
    for (const item of items.lines) out += this.line(item);
    for (const item of items.marks) out += this.mark(item);
    for (const item of items.texts) out += this.text(item);
    return out;
  }

  path(points: readonly Point[]): string {
    return points.map((p, i) => `${i === 0 ? 'M' : 'L'}${this.at(p)}`).join('');
  }

  mark(item: MarkItem): string {
    const [x, y] = toScreen(this.view, this.size, item.at);
    if (
      x < -margin ||
      y < -margin ||
      x > this.size.width + margin ||
      y > this.size.height + margin
    ) {
      return '';
    }
    const r = item.size / 2;
    const open = item.shape === 'cross' || item.shape === 'plus';
    const paint =
      ` fill="${item.fill && !open ? item.fill : 'none'}"` +
      (item.stroke ? ` stroke="${item.stroke}" stroke-width="${number(item.width ?? 1.5)}"` : '') +
      (open ? ' stroke-linecap="round"' : '') +
      opacity('opacity', item.opacity);
    const path = (points: readonly (readonly [number, number])[]) =>
      `<path d="M${points.map(([px, py]) => `${number(x + px)} ${number(y + py)}`).join('L')}Z"${paint}/>\n`;
    const turn = (px: number, py: number) => {
      const angle = item.angle ?? 0;
      const c = Math.cos(angle);
      const s = Math.sin(angle);
      return [c * px - s * py, -(s * px + c * py)] as const;
    };
    switch (item.shape) {
      case 'disc':
        return `<circle cx="${number(x)}" cy="${number(y)}" r="${number(r)}"${paint}/>\n`;
      case 'square': {
        const h = 0.88 * r;
        return path([
          [-h, -h],
          [h, -h],
          [h, h],
          [-h, h],
        ]);
      }
      case 'diamond': {
        const h = 1.2 * r;
        return path([
          [-h, 0],
          [0, -h],
          [h, 0],
          [0, h],
        ]);
      }
      case 'triangle':
        return path([
          [0, -1.2 * r],
          [1.04 * r, 0.6 * r],
          [-1.04 * r, 0.6 * r],
        ]);
      case 'arrow':
        return path([turn(0, 0), turn(-2 * r, 0.84 * r), turn(-2 * r, -0.84 * r)]);
      case 'cross':
        return `<path d="M${number(x - r)} ${number(y - r)}L${number(x + r)} ${number(y + r)}M${number(x - r)} ${number(y + r)}L${number(x + r)} ${number(y - r)}"${paint}/>\n`;
      case 'plus':
        return `<path d="M${number(x - r)} ${number(y)}H${number(x + r)}M${number(x)} ${number(y - r)}V${number(y + r)}"${paint}/>\n`;
    }
  }

  private line(item: LineItem): string {
    const part = clipSegment(item.a, item.b, visibleBounds(this.view, this.size, margin));
    if (!part) return '';
    return (
      `<path d="${this.path(part)}" fill="none" stroke="${item.color}" stroke-width="${number(item.width)}" ` +
      `stroke-linecap="round"${dashArray(item.dash)}${opacity('stroke-opacity', item.opacity)}/>\n`
    );
  }

  private disk(item: DiskItem): string {
    const [x, y] = toScreen(this.view, this.size, item.center);
    const r = item.radius * this.view.scale;
    if (!Number.isFinite(r) || r > 1e6) return '';
    return (
      `<circle cx="${number(x)}" cy="${number(y)}" r="${number(r)}" ` +
      `fill="${item.fill ?? 'none'}"${item.fill ? opacity('fill-opacity', item.fillOpacity) : ''} ` +
      `stroke="${item.stroke}" stroke-width="${number(item.width)}"${dashArray(item.dash)}` +
      `${opacity('stroke-opacity', item.opacity)}/>\n`
    );
  }

  private text(item: TextItem): string {
    const [x, y] = toScreen(this.view, this.size, item.at);
    const halo = item.halo
      ? ` stroke="${item.halo}" stroke-width="3" stroke-linejoin="round" paint-order="stroke"`
      : '';
    return (
      `<text x="${number(x + item.dx)}" y="${number(y - item.dy)}" font-family="sans-serif" ` +
      `font-size="${number(item.size)}" text-anchor="${item.anchor}" fill="${item.color}"${halo}>${escapeXml(item.text)}</text>\n`
    );
  }

  private at(p: Point): string {
    const [x, y] = toScreen(this.view, this.size, p);
    return `${number(x)} ${number(y)}`;
  }
}

function dashArray(dash: Dash | undefined): string {
  return dash && dash !== 'solid' ? ` stroke-dasharray="${dashes[dash].join(' ')}"` : '';
}

function opacity(name: string, value: number | undefined): string {
  return value === undefined || value >= 1 ? '' : ` ${name}="${number(value)}"`;
}

function number(value: number): string {
  return String(Math.round(value * 100) / 100);
}

function escapeXml(text: string): string {
  return text.replace(/[&<>"]/g, (c) => `&#${c.charCodeAt(0)};`);
}
