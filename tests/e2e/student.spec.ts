import { expect, test } from '@playwright/test';
import { finished, length, open, position, sentence } from './page.ts';

test.describe('a student', () => {
  test('sees the first example play by itself, and stops it by a key', async ({ page }) => {
    await open(page);
    await expect.poll(() => position(page)).toBeGreaterThan(3);
    await expect(sentence(page)).toContainText('inserted');
    await page.keyboard.press('Space');
    await expect(page.getByRole('button', { name: 'Play', exact: true })).toBeVisible();
    const here = await position(page);
    await page.waitForTimeout(600);
    expect(await position(page)).toBe(here);
  });

  test('steps forwards and backwards, to the start and to the end', async ({ page }) => {
    await open(page);
    await finished(page);
    await page.keyboard.press('Space');
    await page.keyboard.press('Home');
    expect(await position(page)).toBe(0);
    for (let i = 0; i < 5; i++) await page.keyboard.press('ArrowRight');
    expect(await position(page)).toBe(5);
    await page.getByRole('button', { name: 'Step back' }).click();
    expect(await position(page)).toBe(4);
    await page.keyboard.press('End');
    expect(await position(page)).toBe(await length(page));
    await expect(sentence(page)).toContainText(/ends/);
  });

  test('scrubs along the timeline', async ({ page }) => {
    await open(page);
    await finished(page);
    const strip = page.getByRole('slider', { name: 'Timeline' });
    const box = (await strip.boundingBox())!;
    await page.mouse.move(box.x + box.width * 0.25, box.y + box.height / 2);
    await page.mouse.down();
    const quarter = await position(page);
    await page.mouse.move(box.x + box.width * 0.75, box.y + box.height / 2, { steps: 6 });
    await page.mouse.up();
    const total = await length(page);
    expect(Math.abs(quarter - total / 4)).toBeLessThan(total / 50);
    expect(Math.abs((await position(page)) - (total * 3) / 4)).toBeLessThan(total / 50);
  });

  test('jumps to a yield and reads which rule acts, why, and who waits', async ({ page }) => {
    await open(page);
    await finished(page);
    await page.keyboard.press('Home');
    await page.keyboard.press('3');
    await expect(sentence(page)).toContainText(
      /circumcenter of triangle .* encroaches upon subsegment .* yields/,
    );
    const lit = page.locator('[aria-current=step]');
    await expect(lit).toHaveCount(1);
    await expect(lit).toContainText('Action');
    await page.keyboard.press('ArrowRight');
    await page.keyboard.press('ArrowRight');
    await expect(page.getByTestId('queue-length')).toContainText('waiting');
    await page.keyboard.press('Shift+1');
    await expect(sentence(page)).toContainText('is inserted');
  });

  test('sees another picture at every moment', async ({ page }) => {
    await open(page);
    await finished(page);
    await page.keyboard.press('Space');
    const canvas = page.locator('canvas[role=application]');
    await page.keyboard.press('Home');
    await page.waitForTimeout(400);
    const start = await canvas.screenshot();
    await page.keyboard.press('End');
    await page.waitForTimeout(600);
    const end = await canvas.screenshot();
    expect(start.equals(end)).toBe(false);
    await page.keyboard.press('Home');
    await page.waitForTimeout(400);
    expect((await canvas.screenshot()).equals(start)).toBe(true);
  });

  test('chooses another example, of which there are at least eight', async ({ page }) => {
    await open(page);
    await page.getByRole('button', { name: 'Examples' }).click();
    const examples = page.locator('[data-example]');
    expect(await examples.count()).toBeGreaterThanOrEqual(8);
    await page.locator('[data-example=unit-square]').click();
    await finished(page);
    await expect(page.locator('header select')).toHaveValue('chew');
    await expect(page.getByRole('tabpanel')).toContainText('Algorithm 7.2');
  });

  test('who asked for reduced motion gets no film', async ({ browser }) => {
    const context = await browser.newContext({ reducedMotion: 'reduce' });
    const page = await context.newPage();
    await open(page);
    await finished(page);
    await expect(page.getByRole('button', { name: 'Play', exact: true })).toBeVisible();
    await context.close();
  });

  test('draws a rectangle and has it refined', async ({ page }) => {
    await open(page);
    await finished(page);
    await page.getByRole('button', { name: 'Rectangle' }).click();
    await page.getByRole('button', { name: 'Clear all' }).click();
    const box = (await page.locator('canvas[role=application]').boundingBox())!;
    await page.mouse.move(box.x + 200, box.y + 120);
    await page.mouse.down();
    await page.mouse.move(box.x + 420, box.y + 300, { steps: 5 });
    await page.mouse.up();
    await expect(page.getByRole('tabpanel')).toContainText('4 vertices, 4 segments');
    await page.keyboard.press('Control+z');
    await expect(page.getByRole('tabpanel')).toContainText('0 vertices');
    await page.keyboard.press('Control+Shift+z');
    await page.getByRole('button', { name: 'Refine' }).first().click();
    await finished(page);
    await expect(sentence(page)).toContainText('ends');
  });
});
