import { readFileSync } from 'node:fs';
import { expect, type Page, test } from '@playwright/test';
import { fingerprint, finished, open, position, sentence } from './page.ts';

async function link(page: Page): Promise<string> {
  await page.getByRole('button', { name: 'Share' }).click();
  const text = await page.getByTestId('link').inputValue();
  await page.getByRole('dialog').getByRole('button', { name: 'Close' }).click();
  return text;
}

test.describe('a teacher', () => {
  test('sends a link that restores input, parameters, moment and view exactly', async ({
    page,
    browser,
  }) => {
    await open(page);
    await finished(page);
    await page.keyboard.press('Home');
    await page.keyboard.press('3');
    await page.keyboard.press('3');
    await page.getByRole('button', { name: 'Zoom in' }).click();
    const said = await sentence(page).textContent();
    const at = await position(page);
    const sent = await link(page);
    const mesh = await fingerprint(page);

    const context = await browser.newContext();
    const other = await context.newPage();
    await other.goto(sent);
    await expect.poll(() => position(other)).toBe(at);
    await expect(sentence(other)).toHaveText(said!);
    expect(await link(other)).toBe(sent);
    expect(await fingerprint(other)).toBe(mesh);
    await context.close();
  });

  test('is told when a link was cut off', async ({ page }) => {
    await open(page, '#v1=q1ZKzi8tKs7');
    await expect(page.getByTestId('notice')).toContainText('The link is damaged');
  });

  test('exports the moment as a vector figure and as an image at print size', async ({ page }) => {
    await open(page);
    await finished(page);
    await page.keyboard.press('Space');
    await page.keyboard.press('End');
    await page.getByRole('button', { name: 'Export' }).click();
    await page.getByLabel('Width in centimeters').fill('8');
    const [svg] = await Promise.all([
      page.waitForEvent('download'),
      page.getByRole('button', { name: /SVG/ }).click(),
    ]);
    expect(svg.suggestedFilename()).toBe('first-light-figure.svg');
    const text = readFileSync(await svg.path(), 'utf8');
    expect(text).toMatch(/^<svg|^<\?xml/);
    expect(text).toContain('viewBox');
    const [png] = await Promise.all([
      page.waitForEvent('download'),
      page.getByRole('button', { name: /PNG/ }).click(),
    ]);
    const bytes = readFileSync(await png.path());
    expect(bytes.subarray(1, 4).toString()).toBe('PNG');
    expect(bytes.readUInt32BE(16)).toBe(Math.round((8 / 2.54) * 300)); // width in the header
  });

  test('gets a caption with everything that is needed to make the figure again', async ({
    page,
  }) => {
    await open(page);
    await finished(page);
    await page.keyboard.press('Space');
    await page.getByRole('button', { name: 'Export' }).click();
    const caption = page.locator('.caption');
    await expect(caption).toContainText("Ruppert's algorithm");
    await expect(caption).toContainText(/τ = 1\.41/);
    await expect(caption).toContainText(/fingerprint [0-9a-f]{16}/);
  });
});
