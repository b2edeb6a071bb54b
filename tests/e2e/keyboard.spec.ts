import { expect, type Page, test } from '@playwright/test';
import { finished, length, open, position, sentence } from './page.ts';

/** Presses Tab until something with this name has the focus. */
async function tabTo(page: Page, name: string | RegExp): Promise<void> {
  for (let i = 0; i < 80; i++) {
    await page.keyboard.press('Tab');
    const label = await page.evaluate(() => {
      const e = document.activeElement;
      return e?.getAttribute('aria-label') ?? e?.textContent?.trim() ?? '';
    });
    if (typeof name === 'string' ? label === name : name.test(label)) return;
  }
  throw new Error(`Tab never came to ${name}`);
}

test.describe('by keyboard alone', () => {
  test('everything in the bar, the panel and the timeline can be reached', async ({ page }) => {
    await open(page);
    await finished(page);
    await page.keyboard.press('Space');
    await tabTo(page, 'Examples');
    await tabTo(page, 'Share');
    await tabTo(page, /^The mesh/);
    await tabTo(page, 'Watch');
    await tabTo(page, 'Why');
    await page.keyboard.press('ArrowRight');
    await expect(page.getByRole('tab', { name: 'Mesh' })).toHaveAttribute('aria-selected', 'true');
    await tabTo(page, 'Step');
    const before = await position(page);
    await page.keyboard.press('Enter');
    expect(await position(page)).toBe(before + 1);
    await tabTo(page, 'Timeline');
    await page.keyboard.press('End');
    expect(await position(page)).toBe(await length(page));
  });

  test('an example is chosen and a dialog gives the focus back', async ({ page }) => {
    await open(page);
    await finished(page);
    await tabTo(page, 'Examples');
    await page.keyboard.press('Enter');
    await expect(page.getByRole('dialog')).toBeVisible();
    await page.keyboard.press('Escape');
    await expect(page.getByRole('button', { name: 'Examples' })).toBeFocused();
  });

  test('a polygon is drawn, refined, undone', async ({ page }) => {
    await open(page);
    await finished(page);
    await page.keyboard.press('g');
    await expect(page.getByRole('button', { name: 'Polygon' })).toHaveAttribute(
      'aria-pressed',
      'true',
    );
    await tabTo(page, 'Clear all');
    await page.keyboard.press('Enter');
    await expect(page.getByRole('tabpanel')).toContainText('0 vertices');
    await page.locator('canvas[role=application]').focus();
    for (const [key, times] of [
      ['ArrowRight', 0],
      ['ArrowRight', 6],
      ['ArrowUp', 6],
      ['ArrowLeft', 6],
    ] as const) {
      for (let i = 0; i < times; i++) await page.keyboard.press(`Shift+${key}`);
      if (times === 0) await page.keyboard.press(key);
      await page.keyboard.press('Enter');
    }
    await page.keyboard.press('Enter');
    await expect(page.getByRole('tabpanel')).toContainText('4 vertices, 4 segments');
    await page.keyboard.press('Control+Enter');
    await finished(page);
    await expect(sentence(page)).toContainText('ends');
    await page.keyboard.press('Control+z');
    await expect(page.getByRole('tabpanel')).not.toContainText('4 vertices, 4 segments');
  });

  test('a point gets exact coordinates', async ({ page }) => {
    await open(page);
    await finished(page);
    await page.getByRole('tab', { name: 'Setup' }).click();
    await page.getByLabel('Add a point, x').fill('0.1');
    await page.getByLabel('Add a point, y').fill('1e-9');
    await page.keyboard.press('Enter');
    await page.getByRole('button', { name: 'Export' }).click();
    const [download] = await Promise.all([
      page.waitForEvent('download'),
      page.getByRole('dialog').getByRole('button', { name: '.json' }).last().click(),
    ]);
    const { readFileSync } = await import('node:fs');
    const complex = JSON.parse(readFileSync(await download.path(), 'utf8'));
    expect(complex.vertices.at(-1)).toEqual([0.1, 1e-9]);
  });

  test('the help sheet lists the keys; single ones can be turned off', async ({ page }) => {
    await open(page);
    await finished(page);
    await page.keyboard.press('Space');
    await page.keyboard.press('?');
    await expect(page.getByRole('dialog')).toContainText('Step back');
    await page.getByLabel(/Shortcuts of a single character/).uncheck();
    await page.keyboard.press('Escape');
    await expect(page.getByRole('dialog')).toHaveCount(0);
    await page.keyboard.press('Home');
    await page.keyboard.press('3');
    expect(await position(page)).toBe(0);
  });
});
