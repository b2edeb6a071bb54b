import AxeBuilder from '@axe-core/playwright';
import { expect, type Page, test } from '@playwright/test';
import { finished, open } from './page.ts';

async function check(page: Page): Promise<void> {
  const { violations } = await new AxeBuilder({ page })
    .withTags(['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa', 'best-practice'])
    .analyze();
  expect(
    violations.map((v) => `${v.id}: ${v.nodes.map((n) => n.target.join(' ')).join(', ')}`),
  ).toEqual([]);
}

for (const theme of ['light', 'dark'] as const) {
  test.describe(`axe finds nothing (${theme})`, () => {
    test.use({ colorScheme: theme, reducedMotion: 'reduce' } as never);

    test('on the page, in every tab', async ({ page }) => {
      await open(page);
      await finished(page);
      for (const tab of ['Mesh', 'Setup', 'Numerics', 'Why']) {
        const button = page.getByRole('tab', { name: tab });
        if (!(await button.isVisible())) await page.getByRole('button', { name: 'Panel' }).click();
        await button.click();
        await check(page);
      }
    });

    test('with every overlay, the ball at a point and a picked vertex', async ({ page }) => {
      await open(page);
      await finished(page);
      const button = page.getByRole('tab', { name: 'Mesh' });
      if (!(await button.isVisible())) await page.getByRole('button', { name: 'Panel' }).click();
      await button.click();
      for (const overlay of await page.locator('[data-overlay]').all()) await overlay.check();
      await page.getByLabel('At the point, x').fill('5');
      await page.getByLabel('At the point, y').fill('4');
      await page.keyboard.press('Enter');
      await expect(page.getByTestId('ball')).toContainText('lfs(5, 4) =');
      await check(page);
      await page.getByLabel('Pick a vertex by number').fill('50');
      await page.getByRole('button', { name: 'Pick', exact: true }).click();
      await expect(page.getByTestId('ancestry')).toBeVisible();
      await check(page);
    });

    test('after a study, and in the triangle laboratory', async ({ page }) => {
      await open(page);
      await finished(page);
      await page.keyboard.press('Shift+N');
      await page.getByLabel('meshes').fill('2');
      await page.getByRole('button', { name: 'Refine and watch' }).click();
      await expect(page.getByTestId('study').locator('tbody tr')).toHaveCount(2);
      await check(page);
      await page.keyboard.press('Shift+T');
      await expect(page.getByTestId('per-R')).not.toHaveText('–');
      await check(page);
    });

    test('while drawing', async ({ page }) => {
      await open(page);
      await finished(page);
      await page.getByRole('button', { name: 'Polygon' }).click();
      await check(page);
    });

    test('while comparing, beside a run that does not end', async ({ page }) => {
      await open(page, '#example=fan&compare=collar');
      await expect(page.getByTestId('pane-2')).toBeVisible();
      await finished(page);
      const tab = page.getByRole('tab', { name: 'Compare' });
      if (!(await tab.isVisible())) await page.getByRole('button', { name: 'Panel' }).click();
      await tab.click();
      await expect(page.getByTestId('repetition')).toBeVisible();
      await check(page);
    });

    test('in examples, export, share and help', async ({ page }) => {
      await open(page);
      await finished(page);
      for (const name of ['Examples', 'Export', 'Share', 'Help']) {
        await page.getByRole('button', { name, exact: true }).first().click();
        await expect(page.getByRole('dialog')).toBeVisible();
        await check(page);
        await page.keyboard.press('Escape');
        await expect(page.getByRole('dialog')).toHaveCount(0);
      }
    });
  });
}
