import { expect, test } from '@playwright/test';
import { finished, open, position, sentence } from './page.ts';

test.describe('on a phone', () => {
  test('nothing overflows and the transport lies in reach of a thumb', async ({ page }) => {
    await open(page);
    await finished(page);
    const { width, height } = page.viewportSize()!;
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(
      width,
    );
    const play = (await page.locator('[data-action=play]').boundingBox())!;
    expect(play.y).toBeGreaterThan(height * 0.75);
    expect(Math.min(play.width, play.height)).toBeGreaterThanOrEqual(42);
    await page.locator('[data-action=play]').tap();
    const before = await position(page);
    await page.locator('[data-action=step]').tap();
    expect(await position(page)).toBe(before + 1);
    await expect(sentence(page)).toBeInViewport();
  });

  test('the panel is a sheet that is pulled up, and the transport stays', async ({ page }) => {
    await open(page);
    await finished(page);
    await expect(page.getByRole('tabpanel')).toBeHidden();
    await page.getByRole('button', { name: 'Panel' }).tap();
    await expect(page.getByRole('tabpanel')).toBeInViewport();
    await expect(page.getByRole('tabpanel')).toContainText('Unacceptability');
    await expect(page.locator('[data-action=play]')).toBeInViewport();
    await page.getByRole('button', { name: 'Panel' }).tap();
    await expect(page.getByRole('tabpanel')).toBeHidden();
  });
});
