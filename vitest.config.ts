import { fileURLToPath } from 'node:url';
import { svelte } from '@sveltejs/vite-plugin-svelte';
import { defineConfig } from 'vitest/config';

// Logic of the page (tests/web), contract of the core (tests/wasm), and the command (tests/cli), in Node.
export default defineConfig({
  plugins: [svelte()],
  resolve: {
    alias: { circumball: fileURLToPath(new URL('wasm/circumball.mjs', import.meta.url)) },
    conditions: ['browser'],
  },
  test: {
    include: ['tests/{web,wasm,cli}/**/*.test.ts'],
    environment: 'node',
    testTimeout: 30_000,
    benchmark: { include: ['bench/*.bench.ts'] },
  },
});
