/** A small atlas of the characters that numbers and the names of feature sizes are written with. */

import { CanvasTexture, LinearFilter, LinearMipmapLinearFilter, NoColorSpace } from 'three';

const characters = '0123456789.-+×eE/ abcdflnps°₁';
const cell = 64;
const columns = 8;
const fontSize = 40;
/** Stack that the page uses for numbers; all of them have figures of one width. */
export const glyphFont = 'system-ui, "Segoe UI", Roboto, "Noto Sans", "DejaVu Sans", sans-serif';

export interface Glyphs {
  readonly texture: CanvasTexture;
  /** Advance of a character for type of size 1. */
  advance(c: string): number;
  /** u0, v0, u1, v1 of the cell of a character. */
  uv(c: string): readonly [number, number, number, number];
  /** Side of a cell, and how far its left and lower edges lie from the pen, for type of size 1. */
  readonly cellSize: number;
  readonly padX: number;
  readonly padY: number;
}

export function makeGlyphs(): Glyphs {
  const rows = Math.ceil(characters.length / columns);
  const canvas = document.createElement('canvas');
  canvas.width = columns * cell;
  canvas.height = rows * cell;
  const context = canvas.getContext('2d')!;
  context.font = `500 ${fontSize}px ${glyphFont}`;
  context.textBaseline = 'alphabetic';
  context.lineJoin = 'round';
  context.globalCompositeOperation = 'lighter';
  const padX = 12;
  const padY = 18;
  const advances = new Map<string, number>();
  [...characters].forEach((c, i) => {
    const x = (i % columns) * cell + padX;
    const y = Math.floor(i / columns) * cell + cell - padY;
    context.strokeStyle = '#0f0';
    context.lineWidth = 12;
    context.strokeText(c, x, y);
    context.fillStyle = '#0f0';
    context.fillText(c, x, y);
    context.fillStyle = '#f00';
    context.fillText(c, x, y);
    const width = context.measureText(/\d/.test(c) ? '0' : c).width;
    advances.set(c, width / fontSize);
  });
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = NoColorSpace;
  texture.premultiplyAlpha = false;
  texture.minFilter = LinearMipmapLinearFilter;
  texture.magFilter = LinearFilter;
  return {
    texture,
    advance: (c) => advances.get(c) ?? 0.3,
    uv: (c) => {
      const i = Math.max(characters.indexOf(c), 0);
      const u = (i % columns) / columns;
      const v = 1 - (Math.floor(i / columns) + 1) / rows;
      return [u, v, u + 1 / columns, v + 1 / rows];
    },
    cellSize: cell / fontSize,
    padX: padX / fontSize,
    padY: padY / fontSize,
  };
}

export function textWidth(glyphs: Glyphs, text: string, size: number): number {
  let width = 0;
  for (const c of text) width += glyphs.advance(c) * size;
  return width;
}
