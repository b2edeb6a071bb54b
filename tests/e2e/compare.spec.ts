import { readFileSync } from 'node:fs';
import { expect, type Page, test } from '@playwright/test';
import { finished, json, length, open, openFiles, position, square } from './page.ts';

const counts = (page: Page, pane: 1 | 2) =>
  page.getByTestId(`pane-${pane}`).getByTestId('pane-counts');
const says = (page: Page, pane: 1 | 2) =>
  page.getByTestId(`pane-${pane}`).getByTestId('pane-sentence');
const cell = (page: Page, row: string | RegExp, column: number) =>
  page.getByTestId('differences').getByRole('row', { name: row }).getByRole('cell').nth(column);

async function compare(page: Page): Promise<void> {
  await page.keyboard.press('c');
  await expect(page.getByTestId('pane-2')).toBeVisible();
  await finished(page);
}

async function example(page: Page, id: string): Promise<void> {
  await page.getByRole('button', { name: 'Examples' }).click();
  await page.locator(`[data-example=${id}]`).click();
  await finished(page);
}

async function link(page: Page): Promise<string> {
  await page.getByRole('button', { name: 'Share' }).click();
  const text = await page.getByTestId('link').inputValue();
  await page.getByRole('dialog').getByRole('button', { name: 'Close' }).click();
  return text;
}

test.describe('a student compares', () => {
  test('two algorithms in step: the same number of vertices until one has ended', async ({
    page,
  }) => {
    await open(page);
    await finished(page);
    await compare(page);
    await page.keyboard.press('Home');
    for (let i = 0; i < 12; i++) {
      await page.keyboard.press('1');
      await expect(counts(page, 1)).toContainText(`Vertices${i + 1}`);
      await expect(counts(page, 2)).toContainText(`Vertices${i + 1}`);
    }
    await page.keyboard.press('End');
    expect(await position(page)).toBe(await length(page));
    await expect(says(page, 1)).toContainText('Done.');
    await expect(says(page, 2)).toContainText('Done.');
    await expect(page.getByRole('region', { name: 'Differences' })).toContainText('at the end');
    const vertices = async () => {
      const row = [0, 1, 2].map(async (i) => (await cell(page, 'Vertices', i).textContent())!);
      const [first, second, difference] = await Promise.all(row);
      return Number(second) - Number(first) - Number(difference!.replace('−', '-'));
    };
    await expect.poll(vertices).toBe(0);
    await expect(cell(page, 'Vertices', 2)).not.toHaveText('0');
    await page.getByRole('button', { name: 'Verify both meshes' }).click();
    await expect(cell(page, 'Checks that hold', 0)).toContainText(/^(\d+) of \1$/);
    await expect(cell(page, 'Checks that hold', 1)).toContainText(/^(\d+) of \1$/);
  });

  test('by the share of the run: both begin and end together', async ({ page }) => {
    await open(page);
    await finished(page);
    await compare(page);
    await page.getByRole('radio', { name: 'share of the run' }).check();
    await page.keyboard.press('Escape');
    await page.locator('canvas[role=application]').first().focus();
    await page.keyboard.press('End');
    await expect(says(page, 1)).toContainText('Done.');
    await expect(says(page, 2)).toContainText('Done.');
    await page.keyboard.press('ArrowLeft');
    await page.keyboard.press('ArrowLeft');
    await page.keyboard.press('ArrowLeft');
    await expect(says(page, 1)).not.toContainText('Done.');
    await expect(says(page, 2)).not.toContainText('Done.');
  });

  test('one view: what is zoomed in one picture is zoomed in the other', async ({ page }) => {
    await open(page);
    await finished(page);
    await compare(page);
    const second = page.getByTestId('pane-2').locator('canvas');
    const before = await second.screenshot();
    const box = (await page.getByTestId('pane-1').locator('canvas').boundingBox())!;
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.mouse.wheel(0, -400);
    await page.waitForTimeout(500);
    expect((await second.screenshot()).equals(before)).toBe(false);
  });

  test('chooses other algorithms and parameters on either side, and what the panel is about', async ({
    page,
  }) => {
    await open(page);
    await finished(page);
    await compare(page);
    await page.getByRole('combobox', { name: 'Second algorithm' }).selectOption('delaunay');
    await finished(page);
    await expect(cell(page, 'Vertices', 1)).toHaveText('13'); // those of the input
    await page.getByRole('button', { name: /The panel is about: Delaunay/ }).click();
    await page.getByRole('tab', { name: 'Why' }).click();
    await expect(page.getByRole('tabpanel')).toContainText('Insert the next input vertex');
  });

  test('closes the comparison, and nothing of it is left', async ({ page }) => {
    await open(page);
    await finished(page);
    const whole = await length(page);
    await compare(page);
    expect(page.workers().length).toBe(2);
    await page.keyboard.press('c');
    await expect(page.getByTestId('pane-2')).toHaveCount(0);
    await expect(page.getByRole('tab', { name: 'Compare' })).toHaveCount(0);
    await expect.poll(() => page.workers().length).toBe(1);
    expect(await length(page)).toBe(whole);
    await page.keyboard.press('ArrowLeft');
    await expect(page.getByTestId('sentence')).toBeVisible();
  });

  test('draws another input, and both refine it', async ({ page }) => {
    await open(page);
    await finished(page);
    await compare(page);
    await openFiles(page, json(square));
    await expect(cell(page, 'Vertices', 0)).toHaveText(/^4$|^5$/);
    await page.getByRole('button', { name: 'Rectangle' }).click();
    await expect(page.getByTestId('pane-2')).toHaveCount(0); // drawing takes the whole stage
    await page.keyboard.press('w');
    await expect(page.getByTestId('pane-2')).toBeVisible();
  });
});

test.describe('a student whose refinement does not end', () => {
  test('opens an example, presses the zoom, reads the factor, compares with collars', async ({
    page,
  }) => {
    await open(page);
    await example(page, 'pinwheel');
    await page.keyboard.press('Space');
    await page.getByRole('button', { name: 'Zoom into the repetition' }).first().click();
    await expect(page.getByTestId('cycle')).toContainText('Cycle 2 of 13', { timeout: 20_000 });
    await page.getByRole('button', { name: 'Stop the zoom' }).click();
    const numbers = page.getByTestId('repetition');
    await expect(numbers).toContainText(/Shrink factor\s*0\.5/);
    await expect(numbers).toContainText('7 insertions: 7 midpoints');
    const panel = page.getByRole('tabpanel');
    await expect(panel).toContainText('Stopped by the bound on the shortest edge');
    await expect(panel).toContainText('there is no end');
    await page.getByRole('button', { name: 'Compare with collars' }).click();
    await finished(page);
    await page.locator('canvas[role=application]').first().focus();
    await page.keyboard.press('End');
    await expect(says(page, 1)).toContainText('Stopped by a limit.');
    await expect(says(page, 2)).toContainText('Done.');
    await expect(cell(page, 'Ends', 0)).toHaveText('by a limit');
    await expect(cell(page, 'Ends', 1)).toHaveText('by itself');
    await expect(cell(page, 'Left unacceptable', 0)).not.toHaveText('0');
  });

  test('sees the same picture at the beginning of every cycle', async ({ page }) => {
    await open(page);
    await example(page, 'pinwheel');
    await page.keyboard.press('Space');
    const canvas = page.locator('canvas[role=application]');
    const box = (await canvas.boundingBox())!;
    // Around the limit vertex, clear of tools, legend and scale bar.
    const clip = {
      x: box.x + box.width * 0.35,
      y: box.y + box.height * 0.3,
      width: 180,
      height: 160,
    };
    const shots: Buffer[] = [];
    for (let i = 0; i < 8; i++) {
      await page.keyboard.press('.');
      await page.waitForTimeout(500);
      if (i >= 4) shots.push(await page.screenshot({ clip }));
    }
    for (const shot of shots.slice(1))
      expect(await difference(page, shots[0]!, shot)).toBeLessThan(0.004);
  });

  test('who asked for reduced motion gets steps of one cycle', async ({ browser }) => {
    const context = await browser.newContext({ reducedMotion: 'reduce' });
    const page = await context.newPage();
    await open(page);
    await example(page, 'fan');
    await page.keyboard.press('z');
    const first = await position(page);
    await page.keyboard.press('z');
    await expect(page.getByTestId('cycle')).toContainText('Cycle 2 of');
    expect(await position(page)).toBeGreaterThan(first);
    await page.waitForTimeout(400);
    await expect(page.getByTestId('cycle')).toContainText('Cycle 2 of');
    await context.close();
  });
});

test.describe('a teacher', () => {
  test('sends a link that restores the comparison and its moment', async ({ page, browser }) => {
    await open(page);
    await finished(page);
    await compare(page);
    await page.getByRole('radio', { name: 'share of the run' }).check();
    await page.locator('canvas[role=application]').first().focus();
    await page.keyboard.press('Home');
    await page.keyboard.press('3');
    const at = await position(page);
    const said = [await says(page, 1).textContent(), await says(page, 2).textContent()];
    const sent = await link(page);
    const context = await browser.newContext();
    const other = await context.newPage();
    await other.goto(sent);
    await expect.poll(() => position(other)).toBe(at);
    await expect(says(other, 1)).toHaveText(said[0]!);
    await expect(says(other, 2)).toHaveText(said[1]!);
    expect(await link(other)).toBe(sent);
    await context.close();
  });

  test('writes a link by hand, and is told of a name that there is not', async ({ page }) => {
    await open(page, '#example=pav&compare=collar');
    await expect(page.getByTestId('pane-2')).toBeVisible();
    await finished(page);
    await expect(page.getByRole('combobox', { name: 'Second algorithm' })).toHaveValue('collar');
    await expect(cell(page, 'Ends', 0)).toHaveText('by a limit');
    await expect(cell(page, 'Ends', 1)).toHaveText('by itself');
    await open(page, '#example=nothing');
    await expect(page.getByTestId('notice')).toContainText('no example “nothing”');
  });

  test('opens an example that asks for a comparison, and exports both pictures', async ({
    page,
  }) => {
    await open(page);
    await example(page, 'fan-collar');
    await expect(page.getByTestId('pane-2')).toBeVisible();
    await page.getByRole('button', { name: 'Export' }).click();
    await expect(page.locator('.caption')).toContainText('Refinement with collars');
    await expect(page.locator('.caption')).toContainText("Ruppert's algorithm");
    const [svg] = await Promise.all([
      page.waitForEvent('download'),
      page.getByRole('button', { name: /SVG/ }).click(),
    ]);
    const text = readFileSync(await svg.path(), 'utf8');
    expect(text.match(/<svg/g)).toHaveLength(3); // two within one
    expect(text).toContain('Refinement with collars');
    const ids = [...text.matchAll(/ id="([^"]*)"/g)].map((m) => m[1]);
    expect(new Set(ids).size).toBe(ids.length);
    const [png] = await Promise.all([
      page.waitForEvent('download'),
      page.getByRole('button', { name: /PNG/ }).click(),
    ]);
    const bytes = readFileSync(await png.path());
    expect(bytes.readUInt32BE(16)).toBe(Math.round((16 / 2.54) * 300));
  });
});

/** The part of the pixels of two screenshots that differ visibly. */
async function difference(page: Page, a: Buffer, b: Buffer): Promise<number> {
  return page.evaluate(
    async ([x, y]) => {
      const pixels = async (base64: string) => {
        const image = new Image();
        image.src = `data:image/png;base64,${base64}`;
        await image.decode();
        const canvas = document.createElement('canvas');
        canvas.width = image.width;
        canvas.height = image.height;
        const context = canvas.getContext('2d')!;
        context.drawImage(image, 0, 0);
        return context.getImageData(0, 0, image.width, image.height).data;
      };
      const [p, q] = [await pixels(x!), await pixels(y!)];
      let other = 0;
      for (let i = 0; i < p.length; i += 4)
        if (Math.abs(p[i]! - q[i]!) + Math.abs(p[i + 1]! - q[i + 1]!) > 48) other++;
      return (4 * other) / p.length;
    },
    [a.toString('base64'), b.toString('base64')],
  );
}
