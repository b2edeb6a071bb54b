import { defineConfig, devices } from '@playwright/test';

// The page, used in a real browser as a student, a teacher and a researcher would use it. `npm test` builds the site
// first; CHROMIUM names another browser.
const port = Number(process.env.E2E_PORT ?? 4173);
const launchOptions = {
  executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
  args: [
    '--no-sandbox',
    '--enable-unsafe-swiftshader',
    '--disable-quic',
    '--no-first-run',
    '--disable-background-networking',
    '--disable-component-update',
    '--disable-sync',
  ],
};

export default defineConfig({
  testDir: 'tests/e2e',
  testMatch: '*.spec.ts',
  outputDir: 'build/e2e',
  timeout: 60_000,
  expect: { timeout: 15_000 },
  workers: process.env.CI ? 2 : 1,
  reporter: [['list']],
  use: {
    baseURL: `http://localhost:${port}/`,
    launchOptions,
    trace: 'retain-on-failure',
    serviceWorkers: 'block',
  },
  projects: [
    {
      name: 'desktop',
      testIgnore: 'phone.spec.ts',
      // Software rendering draws every pixel: a small window keeps the tests quick.
      use: { viewport: { width: 1000, height: 640 } },
    },
    {
      name: 'phone',
      testMatch: ['accessibility.spec.ts', 'phone.spec.ts'],
      use: { ...devices['Pixel 5'], defaultBrowserType: 'chromium' },
    },
  ],
  webServer: {
    command: `node node_modules/vite/bin/vite.js preview --config web/vite.config.ts --port ${port} --strictPort`,
    port,
    reuseExistingServer: false,
  },
});
