import { expect, type Page } from '@playwright/test';
import { square } from '../support/square.ts';

/** What the tests do on the page, in the words of those who use it. */

/** Opens the page; `plain` turns antialiasing off, which software rendering pays for dearly. */
export async function open(page: Page, hash = ''): Promise<void> {
  await page.goto(`/?plain${hash}`);
  await expect(page.locator('select').first()).toBeEnabled();
}

export async function position(page: Page): Promise<number> {
  const text = await page.getByRole('slider', { name: 'Timeline' }).getAttribute('aria-valuenow');
  return Number(text);
}

export async function length(page: Page): Promise<number> {
  const text = await page.getByRole('slider', { name: 'Timeline' }).getAttribute('aria-valuemax');
  return Number(text);
}

export function sentence(page: Page) {
  return page.getByTestId('sentence');
}

/** Waits until a run has ended: the fingerprint is in the Mesh tab, but the stop button is gone from everywhere. */
export async function finished(page: Page): Promise<void> {
  await expect.poll(() => length(page), { timeout: 30_000 }).toBeGreaterThan(0);
  await expect(page.locator('[data-action=stop]')).toHaveCount(0, { timeout: 30_000 });
}

/** Opens files as from the file dialog. */
export async function openFiles(
  page: Page,
  ...files: (string | { name: string; mimeType: string; buffer: Buffer })[]
): Promise<void> {
  await page.setInputFiles('#open-file', files as string[]);
}

export function json(complex: object, name = 'drawing.json') {
  return { name, mimeType: 'application/json', buffer: Buffer.from(JSON.stringify(complex)) };
}

export { square };

/** Two segments that cross in the middle of a square. */
export const crossing = {
  ...square,
  segments: [...square.segments, [0, 2], [1, 3]],
};

export async function fingerprint(page: Page): Promise<string> {
  await page.getByRole('tab', { name: 'Mesh' }).click();
  return (await page.getByTestId('fingerprint').textContent()) ?? '';
}
