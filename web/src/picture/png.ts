/** The picture as a PNG of any width: rendered off screen tile by tile, so that no limit of the GPU is met. */

import {
  type Camera,
  type Scene,
  type Vector4,
  type WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import type { Rgba } from './color';
import type { Size } from './view';

const tileSize = 1024;
/** Canvases of browsers end about here. */
const widest = 16000;

export interface PngJob {
  readonly renderer: WebGLRenderer;
  readonly scene: Scene;
  readonly camera: Camera;
  readonly uniforms: { readonly uPixel: { value: number }; readonly uTile: { value: Vector4 } };
  readonly depth?: boolean; // things hide each other
  readonly size: Size; // what is seen, in CSS pixels
  readonly width: number; // of the image
  readonly background: Rgba;
}

export async function renderPng(job: PngJob): Promise<Blob> {
  const { renderer, uniforms, size } = job;
  const shrink = Math.min(1, widest / job.width, widest / (job.width * (size.height / size.width)));
  const width = Math.max(1, Math.round(job.width * shrink));
  const height = Math.max(1, Math.round((width * size.height) / size.width));
  const canvas = document.createElement('canvas');
  canvas.width = width;
  canvas.height = height;
  const context = canvas.getContext('2d');
  if (!context) throw new Error('This browser gives no 2D canvas to write the picture to.');
  const [r, g, b, a] = job.background;
  if (a > 0) {
    context.fillStyle = `rgba(${r * 255}, ${g * 255}, ${b * 255}, ${a})`;
    context.fillRect(0, 0, width, height);
  }
  const tile = document.createElement('canvas');
  tile.width = tileSize;
  tile.height = tileSize;
  const tileContext = tile.getContext('2d')!;
  const target = new WebGLRenderTarget(tileSize, tileSize, {
    depthBuffer: job.depth ?? false,
    samples: 4,
  });
  const bytes = new Uint8Array(4 * tileSize * tileSize);
  const pixelBefore = uniforms.uPixel.value;
  try {
    uniforms.uPixel.value = width / size.width;
    renderer.setClearColor(0, 0);
    for (let y = 0; y < height; y += tileSize) {
      for (let x = 0; x < width; x += tileSize) {
        // Rows of the target run upwards, those of the image downwards.
        const bottom = height - y - tileSize;
        uniforms.uTile.value.set(
          width / tileSize,
          height / tileSize,
          (width - 2 * x) / tileSize - 1,
          (height - 2 * bottom) / tileSize - 1,
        );
        renderer.setRenderTarget(target);
        renderer.clear();
        renderer.render(job.scene, job.camera);
        renderer.readRenderTargetPixels(target, 0, 0, tileSize, tileSize, bytes);
        tileContext.putImageData(straighten(bytes, tileContext), 0, 0);
        context.drawImage(tile, x, y);
      }
    }
  } finally {
    renderer.setRenderTarget(null);
    uniforms.uTile.value.set(1, 1, 0, 0);
    uniforms.uPixel.value = pixelBefore;
    target.dispose();
  }
  return new Promise((resolve, reject) => {
    canvas.toBlob(
      (blob) =>
        blob ? resolve(blob) : reject(new Error('The picture is too large to be encoded.')),
      'image/png',
    );
  });
}

/** From rows upwards with premultiplied alpha to rows downwards with straight alpha. */
function straighten(bytes: Uint8Array, context: CanvasRenderingContext2D): ImageData {
  const image = context.createImageData(tileSize, tileSize);
  const out = image.data;
  for (let row = 0; row < tileSize; ++row) {
    let from = 4 * tileSize * (tileSize - 1 - row);
    let to = 4 * tileSize * row;
    for (let i = 0; i < tileSize; ++i, from += 4, to += 4) {
      const alpha = bytes[from + 3]!;
      const factor = alpha > 0 ? 255 / alpha : 0;
      out[to] = bytes[from]! * factor;
      out[to + 1] = bytes[from + 1]! * factor;
      out[to + 2] = bytes[from + 2]! * factor;
      out[to + 3] = alpha;
    }
  }
  return image;
}
