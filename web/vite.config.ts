import { fileURLToPath } from 'node:url';
import { svelte } from '@sveltejs/vite-plugin-svelte';
import { defineConfig } from 'vite';
import { VitePWA } from 'vite-plugin-pwa';

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));

// The page: a static site that any file server can serve, from any folder (hence the relative base).
export default defineConfig({
  root: here('.'),
  base: './',
  resolve: { alias: { circumball: here('../wasm/circumball.mjs') } },
  server: { fs: { allow: ['..'] } },
  worker: { format: 'es' },
  build: {
    outDir: here('../dist/site'),
    emptyOutDir: true,
    target: 'es2022',
    chunkSizeWarningLimit: 900,
  },
  plugins: [
    svelte({ configFile: here('svelte.config.js') }),
    VitePWA({
      registerType: 'autoUpdate',
      // Everything is kept at the first visit: afterwards the page works without a network.
      workbox: {
        globPatterns: ['**/*.{js,css,html,svg,png,woff2,wasm,json,webmanifest}'],
        maximumFileSizeToCacheInBytes: 8 * 1024 * 1024,
      },
      manifest: {
        name: 'Circumball',
        short_name: 'Circumball',
        description: 'Delaunay refinement that you can watch, and trust',
        display: 'standalone',
        start_url: './',
        theme_color: '#0b3a53',
        background_color: '#15171a',
        icons: [{ src: 'icon.svg', sizes: 'any', type: 'image/svg+xml', purpose: 'any' }],
      },
    }),
  ],
});
