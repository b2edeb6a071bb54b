import { expect, test } from '@playwright/test';
import { finished, length, open } from './page.ts';

test.use({ serviceWorkers: 'allow' });

test('after the first visit the page works without a network', async ({ page, context }) => {
  await open(page);
  await finished(page);
  await page.evaluate(async () => {
    const registration = await navigator.serviceWorker.ready;
    const worker = registration.active!;
    if (worker.state === 'activated') return;
    await new Promise<void>((resolve) => {
      worker.addEventListener('statechange', () => worker.state === 'activated' && resolve());
    });
  });
  await context.setOffline(true);
  await page.reload();
  await finished(page);
  expect(await length(page)).toBeGreaterThan(0);
});
