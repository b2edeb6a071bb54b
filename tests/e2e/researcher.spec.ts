import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { expect, test } from '@playwright/test';
import {
  crossing,
  fingerprint,
  finished,
  json,
  length,
  open,
  openFiles,
  position,
  sentence,
  square,
} from './page.ts';

const root = fileURLToPath(new URL('../../', import.meta.url));
const file = `${root}examples/airfoil.poly`;

test.describe('a researcher', () => {
  test('is told beside the parameters what is wrong with a size', async ({ page }) => {
    await open(page);
    await openFiles(page, file);
    await finished(page);
    await page.getByRole('tab', { name: 'Setup' }).click();
    const size = page.getByLabel('size', { exact: true });
    await size.fill('0.3 + x*(');
    await size.press('Enter');
    await expect(page.getByTestId('refused')).toContainText('character');
    await expect(page.getByTestId('position')).toHaveText('0');
    await size.fill('0.3 + x^2');
    await size.press('Enter');
    await page.getByRole('button', { name: 'Refine', exact: true }).first().click();
    await finished(page);
    await expect(page.getByTestId('refused')).toHaveCount(0);
  });

  test('opens a .poly, changes a parameter, verifies, and takes the mesh along', async ({
    page,
  }) => {
    await open(page);
    await openFiles(page, file);
    await finished(page);
    const before = await fingerprint(page);
    await page.getByRole('tab', { name: 'Setup' }).click();
    await page.getByLabel('min-angle').fill('28');
    await page.getByLabel('min-angle').press('Enter');
    await page.getByRole('tab', { name: 'Mesh' }).click();
    await expect(page.getByTestId('fingerprint')).not.toHaveText(before);
    await page.getByRole('button', { name: 'Verify the mesh' }).click();
    await expect(page.getByTestId('checks')).toContainText('radius-edge');
    await expect(page.getByRole('tabpanel')).toContainText('Every promised check holds.');
    await page.getByRole('button', { name: 'Export' }).click();
    const [download] = await Promise.all([
      page.waitForEvent('download'),
      page.locator('[data-export=".vtu"]').click(),
    ]);
    expect(readFileSync(await download.path(), 'utf8')).toContain('<VTKFile');
  });

  test('gets the mesh that the command gets, bit for bit', async ({ page }) => {
    await open(page);
    await openFiles(page, file);
    await finished(page);
    const command = [
      `${root}build/wasm/circumball.mjs`,
      'mesh',
      file,
      '--algorithm',
      'ruppert',
      '--report',
      '-',
      '--quiet',
    ];
    const report = JSON.parse(execFileSync(process.execPath, command, { encoding: 'utf8' }));
    expect(await fingerprint(page)).toBe(report.fingerprint);
  });

  test('stops a long run and keeps what there is', async ({ page }) => {
    await open(page);
    await openFiles(page, json(square));
    await finished(page);
    await page.getByRole('tab', { name: 'Setup' }).click();
    await page.getByLabel('at most').fill('2000000');
    await page.getByLabel('at most').blur();
    await finished(page);
    await page.getByLabel('size', { exact: true }).fill('0.0008');
    await page.getByLabel('size', { exact: true }).press('Enter');
    const stop = page.getByRole('button', { name: 'Stop computing' });
    await expect(stop).toBeVisible();
    await expect.poll(() => length(page)).toBeGreaterThan(20_000);
    await stop.click();
    await expect(stop).toHaveCount(0);
    const total = await length(page);
    expect(total).toBeGreaterThan(20_000);
    await page.keyboard.press('Home');
    await page.getByRole('slider', { name: 'Timeline' }).press('PageUp');
    expect(await position(page)).toBe(Math.round(total / 20));
    await page.getByRole('slider', { name: 'Timeline' }).press('End');
    await expect(sentence(page)).toContainText('stopped by hand');
  });

  test('is shown bad input with the sentence of the core, and has crossings split', async ({
    page,
  }) => {
    await open(page);
    await openFiles(page, json(crossing));
    await expect(page.getByTestId('notice')).toContainText(/cross/);
    await expect(page.getByTestId('defects')).toContainText(/cross/);
    await page.getByRole('button', { name: 'Split crossings' }).first().click();
    await expect(page.getByTestId('defects')).toHaveCount(0);
    await page.getByRole('button', { name: 'Refine' }).first().click();
    await finished(page);
    await expect(sentence(page)).toContainText('ends');
  });

  test('is told why a file cannot be read', async ({ page }) => {
    await open(page);
    await finished(page);
    await openFiles(page, {
      name: 'broken.poly',
      mimeType: 'text/plain',
      buffer: Buffer.from('4 2 0 0\n1 0 0\n2 1'),
    });
    await expect(page.getByTestId('notice')).toContainText('broken.poly could not be opened.');
    expect(await length(page)).toBeGreaterThan(0); // what was there stays
  });

  test('pastes a complex as text', async ({ page }) => {
    await open(page);
    await finished(page);
    await page.evaluate((text) => {
      const data = new DataTransfer();
      data.setData('text/plain', text);
      document.body.dispatchEvent(
        new ClipboardEvent('paste', { clipboardData: data, bubbles: true }),
      );
    }, JSON.stringify(square));
    await expect(page.locator('.title')).toHaveText('pasted text');
    await finished(page);
  });

  test('finds the work again after a reload', async ({ page }) => {
    await open(page);
    await openFiles(page, file);
    await finished(page);
    const mesh = await fingerprint(page);
    await page.getByRole('slider', { name: 'Timeline' }).focus();
    await page.keyboard.press('Home');
    await page.keyboard.press('PageUp');
    const at = await position(page);
    await page.reload();
    await expect.poll(() => position(page)).toBe(at);
    await expect(page.locator('.title')).toHaveText('airfoil.poly');
    expect(await fingerprint(page)).toBe(mesh);
  });

  test('loses nothing when the core crashes: it is replaced', async ({ page }) => {
    await open(page);
    await openFiles(page, json(square));
    await finished(page);
    const total = await length(page);
    await page.workers()[0]!.evaluate(() => {
      setTimeout(() => {
        throw new Error('crash of a test');
      }, 0);
    });
    await expect(page.getByTestId('notice')).toContainText('was started again');
    expect(await length(page)).toBe(total);
    await page.keyboard.press('Control+Enter');
    await finished(page);
    expect(await length(page)).toBe(total);
    await expect(sentence(page)).toContainText('ends');
  });
});
