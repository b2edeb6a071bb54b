import { readFileSync } from 'node:fs';
import { expect, type Page, test } from '@playwright/test';
import { finished, json, open, openFiles, square } from './page.ts';

async function openSquare(page: Page): Promise<void> {
  await open(page);
  await finished(page);
  await openFiles(page, json(square, 'square.json'));
  await expect(page.locator('header .title')).toHaveText('square.json');
  await finished(page);
  await page.keyboard.press('Shift+N');
  await expect(page.getByTestId('error-h1')).toBeVisible();
}

/** The numbers after H¹ and L². */
async function orders(page: Page): Promise<[number, number]> {
  const text = (await page.getByTestId('orders').textContent()) ?? '';
  const [h1, l2] = [...text.matchAll(/[HL][¹²]\D*?([−-]?\d+\.\d+)/g)].map((m) =>
    Number(m[1]!.replace('−', '-')),
  );
  return [h1 ?? Number.NaN, l2 ?? Number.NaN];
}

async function study(page: Page, meshes = 5): Promise<void> {
  await page.getByLabel('meshes').fill(String(meshes));
  await page.getByRole('button', { name: 'Refine and watch' }).click();
  await expect(page.getByTestId('study').locator('tbody tr')).toHaveCount(meshes, {
    timeout: 40_000,
  });
  await expect(page.getByRole('button', { name: 'Refine and watch' })).toBeEnabled();
}

async function numberIn(page: Page, id: string): Promise<number> {
  return Number(await page.getByTestId(id).textContent());
}

test.describe('a student of numerical methods', () => {
  test('opens the families of Figure 7.1 from the gallery, and comes back to a run', async ({
    page,
  }) => {
    const h1: number[] = [];
    for (const id of ['figure-7-1a', 'figure-7-1b']) {
      await open(page, `#example=${id}`);
      await expect(page.getByTestId('error-h1')).toBeVisible();
      await expect(page.getByRole('tab', { name: 'Numerics' })).toHaveAttribute(
        'aria-selected',
        'true',
      );
      await expect(page.getByTestId('still')).toContainText('degeneration 8');
      h1.push(await numberIn(page, 'error-h1'));
    }
    expect(h1[1]!).toBeGreaterThan(1.5 * h1[0]!); // the largest angle is what costs
    await open(page, '#example=poisson');
    await expect(page.getByRole('radio', { name: 'Poisson’s equation' })).toBeChecked();
    await expect(page.getByTestId('still')).toHaveCount(0);
  });

  test('chooses a function, sees where the error is, and reads the orders 1 and 2', async ({
    page,
  }) => {
    await openSquare(page);
    await page.getByLabel('Choose a function').selectOption('smooth');
    await expect(page.getByLabel('u(x, y)')).toHaveValue('sin(pi*x) * sin(pi*y)');
    await expect(page.getByRole('complementary', { name: 'Legend' }).first()).toContainText(
      'Error on each triangle',
    );
    await study(page);
    for (const method of ['Interpolant', 'Poisson’s equation']) {
      await page.getByRole('radio', { name: method, exact: true }).check();
      const [h1, l2] = await orders(page);
      expect(h1).toBeGreaterThan(0.9);
      expect(h1).toBeLessThan(1.15);
      expect(l2).toBeGreaterThan(1.8);
      expect(l2).toBeLessThan(2.25);
    }
    await expect(page.getByTestId('study-plot').locator('canvas')).toBeVisible();
    const download = page.waitForEvent('download');
    await page.getByRole('button', { name: 'Numbers (CSV)' }).click();
    const text = readFileSync(await (await download).path(), 'utf8');
    expect(text.trim().split('\r\n').length).toBe(6);
    expect(text).toContain('poisson_h1');
    const image = page.waitForEvent('download');
    await page.getByRole('button', { name: 'Plot (PNG)' }).click();
    expect(
      readFileSync(await (await image).path())
        .subarray(1, 4)
        .toString(),
    ).toBe('PNG');
  });

  test('looks at a mesh of the study, and goes back to the run', async ({ page }) => {
    await openSquare(page);
    await study(page);
    const canvas = page.locator('canvas[role=application]');
    await expect(page.getByTestId('still')).toContainText('The mesh of the study');
    await page.getByTestId('study').locator('tbody button').first().click();
    const triangles = page.getByTestId('errors').getByRole('row', { name: /^triangles/ });
    const coarse = await triangles.textContent();
    const picture = await canvas.screenshot();
    await page.getByTestId('study').locator('tbody button').last().click();
    await expect(triangles).not.toHaveText(coarse!);
    await page.waitForTimeout(300);
    expect((await canvas.screenshot()).equals(picture)).toBe(false);
    await page.getByRole('button', { name: 'Back to the run' }).click();
    await expect(page.getByTestId('still')).toHaveCount(0);
  });

  test('stops a study, and keeps what it has', async ({ page }) => {
    await openSquare(page);
    await page.getByLabel('meshes').fill('8');
    await page.getByRole('button', { name: 'Refine and watch' }).click();
    await expect(page.getByTestId('study').locator('tbody tr').nth(1)).toBeVisible();
    await page.getByRole('button', { name: 'Stop', exact: true }).click();
    await expect(page.getByRole('button', { name: 'Refine and watch' })).toBeEnabled();
    const rows = await page.getByTestId('study').locator('tbody tr').count();
    expect(rows).toBeLessThan(8);
    // The page goes on: another function is measured.
    const before = await page.getByTestId('error-l2').textContent();
    await page.getByLabel('u(x, y)').fill('x^3 - y');
    await page.getByLabel('u(x, y)').press('Enter');
    await expect(page.getByTestId('error-l2')).not.toHaveText(before!);
  });

  test('types an expression, reads what is wrong with it, and mends it', async ({ page }) => {
    await openSquare(page);
    const field = page.getByLabel('u(x, y)');
    await field.fill('sin(pi*');
    await field.press('Enter');
    await expect(field).toHaveAttribute('aria-invalid', 'true');
    await expect(page.locator('#u-about')).toContainText(/expect|end|place|\d/i);
    await field.fill('x + 2*y');
    await field.press('Enter');
    await expect(field).toHaveAttribute('aria-invalid', 'false');
    await expect.poll(() => numberIn(page, 'error-h1')).toBeLessThan(1e-12);
  });

  test('sees the error follow the circumradius in the family with large angles', async ({
    page,
  }) => {
    await openSquare(page);
    await page.getByLabel('Mesh', { exact: true }).last().selectOption('large-angles');
    await expect(page.getByTestId('still')).toContainText('degeneration 4');
    await page.getByRole('radio', { name: 'degeneration' }).check();
    await study(page);
    const [h1, l2] = await orders(page);
    expect(h1).toBeGreaterThan(0.8);
    expect(Math.abs(l2)).toBeLessThan(0.3);
    await page.getByLabel('Mesh', { exact: true }).last().selectOption('narrow');
    await study(page);
    expect(Math.abs((await orders(page))[0])).toBeLessThan(0.1);
  });

  test('reads the order 1 of the averaged interpolant of a rough function', async ({ page }) => {
    await openSquare(page);
    await page.getByLabel('Choose a function').selectOption('steep-shore');
    await page.getByRole('radio', { name: 'Averaged interpolant' }).check();
    await study(page, 4);
    const [, l2] = await orders(page);
    expect(l2).toBeGreaterThan(0.85);
  });

  test('opens the domain that a function is meant for', async ({ page }) => {
    await openSquare(page);
    await page.getByLabel('Choose a function').selectOption('corner');
    await page.getByRole('button', { name: /Open the domain of/ }).click();
    await finished(page);
    await expect(page.locator('header .title')).toHaveText('A corner singularity');
    await expect(page.getByRole('button', { name: /Open the domain of/ })).toHaveCount(0);
    await page.getByRole('radio', { name: 'Poisson’s equation' }).check();
    await study(page);
    const [h1] = await orders(page);
    expect(h1).toBeGreaterThan(0.5); // 2/3 for a corner of 270 degrees
    expect(h1).toBeLessThan(0.8);
  });

  test('shares the function and the method', async ({ page }) => {
    await openSquare(page);
    await page.getByLabel('u(x, y)').fill('x*y^2');
    await page.getByLabel('u(x, y)').press('Enter');
    await page.getByRole('radio', { name: 'Poisson’s equation' }).check();
    await page.getByRole('button', { name: 'Share' }).click();
    const link = await page.getByTestId('link').inputValue();
    await page.evaluate(() => localStorage.clear());
    await page.goto('about:blank');
    await open(page, link.slice(link.indexOf('#')));
    await expect(page.getByLabel('u(x, y)')).toHaveValue('x*y^2');
    await expect(page.getByRole('radio', { name: 'Poisson’s equation' })).toBeChecked();
    await expect(page.getByTestId('errors')).toContainText('unknowns');
  });
});

test.describe('in the triangle laboratory a student', () => {
  async function enter(page: Page): Promise<void> {
    await open(page);
    await finished(page);
    await page.keyboard.press('Shift+T');
    await expect(page.getByTestId('per-R')).not.toHaveText('–');
  }

  test('drags the apex down, and reads the constants', async ({ page }) => {
    await enter(page);
    await expect(page.getByTestId('triangle-seen')).toContainText('well-shaped');
    const perH = await numberIn(page, 'per-h');
    const apex = (await page.getByRole('slider', { name: 'Corner C' }).boundingBox())!;
    const foot = (await page.getByRole('slider', { name: 'Corner A' }).boundingBox())!;
    const middle = (b: typeof apex) => [b.x + b.width / 2, b.y + b.height / 2] as const;
    await page.mouse.move(...middle(apex));
    await page.mouse.down();
    await page.mouse.move(middle(apex)[0], middle(foot)[1] - 12, { steps: 8 });
    await page.mouse.up();
    await expect(page.getByTestId('triangle-seen')).toContainText('Large angles are the danger');
    expect(await numberIn(page, 'per-h')).toBeGreaterThan(2 * perH);
    expect(await numberIn(page, 'per-R')).toBeLessThan(1);
    expect(await numberIn(page, 'triangle-ratio')).toBeLessThan(1);
  });

  test('uses the keyboard, number fields and shapes instead', async ({ page }) => {
    await enter(page);
    const apex = page.getByRole('slider', { name: 'Corner C' });
    await apex.focus();
    const before = await apex.getAttribute('aria-valuetext');
    await page.keyboard.press('ArrowDown');
    await expect(apex).not.toHaveAttribute('aria-valuetext', before!);
    await page.getByLabel('Corner C, x').fill('0');
    await page.getByLabel('Corner C, y').fill('0.05');
    await page.getByLabel('Corner C, y').press('Enter');
    await expect(page.getByTestId('triangle-seen')).toContainText('Small angles alone do no harm');
    await page.getByRole('button', { name: 'Flat, isosceles' }).click();
    await expect(page.getByTestId('triangle-angles')).toContainText('168.6°');
    const perH = await numberIn(page, 'per-h');
    await page.getByRole('button', { name: 'Halve the height' }).click();
    await expect.poll(() => numberIn(page, 'per-h')).toBeGreaterThan(1.9 * perH);
    await page.getByRole('button', { name: 'Take the worst quadratic' }).click();
    const perR = await numberIn(page, 'per-R');
    await expect.poll(() => numberIn(page, 'triangle-ratio')).toBeCloseTo(perR, 2);
  });

  test('reloads, and finds the triangle again; a link carries it to others', async ({
    page,
    context,
  }) => {
    await context.grantPermissions(['clipboard-read', 'clipboard-write']);
    await enter(page);
    await page.getByRole('button', { name: 'Flat, skew' }).click();
    await page.getByRole('button', { name: 'Copy a link to this triangle' }).click();
    const link = await page.evaluate(() => navigator.clipboard.readText());
    await page.evaluate(() => localStorage.clear());
    await page.goto('about:blank');
    await open(page, link.slice(link.indexOf('#')));
    await expect(page.getByRole('dialog', { name: 'Triangle laboratory' })).toBeVisible();
    await expect(page.getByLabel('Corner C, x')).toHaveValue('0.2');
  });
});
