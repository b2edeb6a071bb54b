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

  test('two pictures lie one above the other, and their differences in the sheet', async ({
    page,
  }) => {
    await open(page, '#example=fan&compare=collar');
    await finished(page);
    const { width } = page.viewportSize()!;
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(
      width,
    );
    const first = (await page.getByTestId('pane-1').locator('canvas').boundingBox())!;
    const second = (await page.getByTestId('pane-2').locator('canvas').boundingBox())!;
    expect(second.y).toBeGreaterThan(first.y + first.height);
    expect(second.width).toBeCloseTo(first.width, 0);
    expect(Math.min(first.height, second.height)).toBeGreaterThan(120);
    await expect(page.getByTestId('pane-1').getByTestId('pane-sentence')).toBeInViewport();
    await expect(page.getByTestId('pane-2').getByTestId('pane-sentence')).toBeInViewport();
    await page.getByRole('button', { name: 'Panel' }).tap();
    await expect(page.getByTestId('differences')).toBeInViewport();
    await expect(page.locator('[data-action=play]')).toBeInViewport();
  });

  test('a tap shows the ball of the local feature size, and nothing covers its key', async ({
    page,
  }) => {
    await open(page);
    await finished(page);
    await page.locator('[data-action=overlays]').tap();
    await page.locator('[data-overlay=featureSize]').tap();
    await page.getByRole('button', { name: 'Panel' }).tap();
    const box = (await page.locator('canvas[role=application]').boundingBox())!;
    await page.touchscreen.tap(box.x + box.width / 2 + 20, box.y + box.height / 2);
    const ball = page.getByTestId('ball');
    await expect(ball).toContainText(/lfs\(.*\) = .*meets .* and touches/);
    await expect(ball).toBeInViewport({ ratio: 1 });
    const key = (await page.getByTestId('field-key').first().boundingBox())!;
    const buttons = (await page.locator('[data-action=overlays]').boundingBox())!;
    expect(key.y + key.height).toBeLessThanOrEqual(buttons.y);
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(
      page.viewportSize()!.width,
    );
  });
});
