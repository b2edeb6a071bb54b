import { expect, type Page, test } from '@playwright/test';
import { finished, json, open, openFiles, sentence, square } from './page.ts';

const canvas = (page: Page) => page.locator('canvas[role=application]').first();

/** A square: its smallest ball at (0.3, 0.4) reaches from the bottom side to the top side. */
async function openSquare(page: Page): Promise<void> {
  await open(page);
  await finished(page);
  await openFiles(page, json(square));
  await expect(page.locator('.topbar')).toContainText('drawing.json');
  await finished(page);
}

async function picture(page: Page): Promise<Buffer> {
  await page.waitForTimeout(500);
  return canvas(page).screenshot();
}

test.describe('a student looks at the theory', () => {
  test('switches each overlay on, finds it in the legend and sees the picture change', async ({
    page,
  }) => {
    await open(page);
    await finished(page);
    await page.getByRole('button', { name: 'Examples' }).click();
    await page.locator('[data-example=fan-intestine]').click();
    await finished(page);
    // It opens beside its collars: one picture is enough here.
    await page.getByTestId('pane-2').waitFor();
    await page.keyboard.press('c');
    await expect(page.getByTestId('pane-2')).toHaveCount(0);
    await page.keyboard.press('End');
    await page.getByRole('button', { name: 'Overlays' }).click();
    const names = {
      featureSize: 'Local feature size',
      neighbors: 'N against lfs',
      diametral: 'Diametral disks',
      spindles: 'Spindles',
      collars: 'Collars',
      intestines: 'Intestines',
    };
    for (const [id, name] of Object.entries(names)) {
      const off = await picture(page);
      await page.locator(`[data-overlay=${id}]`).check();
      const legend = page.getByRole('complementary', { name: 'Legend' });
      await expect(legend.first()).toContainText(name);
      // At the end no subsegment acts, so that there is no spindle to see.
      if (id !== 'spindles') expect((await picture(page)).equals(off)).toBe(false);
      await page.locator(`[data-overlay=${id}]`).uncheck();
    }
  });

  test('folds the legend away and back', async ({ page }) => {
    await open(page);
    await finished(page);
    const legend = page.getByRole('complementary', { name: 'Legend of the picture' });
    await legend.getByRole('button', { name: 'Fold the legend' }).click();
    await expect(legend).toHaveCount(0);
    await page.getByRole('button', { name: 'Legend', exact: true }).click();
    await expect(legend).toBeVisible();
  });

  test('returns from a mesh of Figure 7.1 while local feature size is shown', async ({ page }) => {
    await open(page, '#example=unit-square&function=smooth');
    await finished(page);
    await page.keyboard.press('f');
    await expect(page.getByTestId('ball')).toBeVisible();
    await page.getByRole('combobox', { name: 'Mesh' }).selectOption({ index: 1 });
    await page.getByRole('button', { name: 'Back to the run' }).click();
    await expect(page.getByTestId('still')).toHaveCount(0);
  });

  test('points at the picture and reads the sentence of the ball; a picked point stays', async ({
    page,
  }) => {
    await openSquare(page);
    await page.keyboard.press('f');
    await expect(page.getByTestId('ball')).toContainText('Point at the picture');
    const box = (await canvas(page).boundingBox())!;
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await expect(page.getByTestId('ball')).toContainText(
      /^lfs = 0\.\d+: the smallest closed ball there that meets two disjoint input features; it meets segment \d and touches segment \d\.\s*$/,
    );
    await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2 + 20);
    await expect(page.getByTestId('ball')).toContainText(/^lfs\(0\.\d+, 0\.\d+\) = 0\.\d+/);
    const kept = await page.getByTestId('ball').textContent();
    await page.mouse.move(box.x + box.width / 2 + 60, box.y + box.height / 2);
    await page.waitForTimeout(300);
    expect(await page.getByTestId('ball').textContent()).toBe(kept);
    await page.getByRole('button', { name: 'Let the point go' }).click();
    await expect(page.getByTestId('ball')).not.toContainText('lfs(');
  });

  test('gives a point by its numbers, without a pointer', async ({ page }) => {
    await openSquare(page);
    await page.keyboard.press('Shift+O');
    await expect(page.locator('[data-overlay=featureSize]')).toBeFocused();
    await page.keyboard.press('Space');
    await page.getByLabel('At the point, x').fill('0.3');
    await page.getByLabel('At the point, y').fill('0.4');
    await page.keyboard.press('Enter');
    await expect(page.getByTestId('ball')).toContainText(
      'lfs(0.3, 0.4) = 0.6: the smallest closed ball there that meets two disjoint input features; it meets segment 0 and touches segment 2.',
    );
    await expect(page.getByTestId('field-key').first()).toBeVisible();
  });

  test('sees what overlays and their field are made of in an exported figure, and in a link', async ({
    page,
    context,
  }) => {
    await openSquare(page);
    await page.keyboard.press('f');
    await page.keyboard.press('d');
    await expect(page.getByTestId('field-key').first()).toBeVisible();
    await page.keyboard.press('ControlOrMeta+s');
    const download = page.waitForEvent('download');
    await page.locator('[data-export=svg-figure]').click();
    const stream = await (await download).createReadStream();
    let svg = '';
    for await (const part of stream) svg += part;
    expect(svg).toContain('href="data:image/png;base64,');
    expect(svg).toContain('#8a7400'); // the tint of lfs
    await page.keyboard.press('Escape');
    await page.keyboard.press('Shift+S');
    const link = await page.getByTestId('link').inputValue();
    const other = await context.newPage();
    await other.addInitScript(() => localStorage.clear());
    await other.goto(`/?plain${link.slice(link.indexOf('#'))}`);
    await finished(other);
    await other.getByRole('tab', { name: 'Mesh' }).click();
    await expect(other.locator('[data-overlay=featureSize]')).toBeChecked();
    await expect(other.locator('[data-overlay=diametral]')).toBeChecked();
    await expect(other.locator('[data-overlay=collars]')).not.toBeChecked();
  });

  test('picks a vertex and follows its ancestry back to the input', async ({ page }) => {
    await open(page);
    await finished(page);
    await page.keyboard.press('End');
    await page.getByRole('tab', { name: 'Mesh' }).click();
    await page.getByLabel('Pick a vertex by number').fill('60');
    await page.getByRole('button', { name: 'Pick', exact: true }).click();
    const inspector = page.getByTestId('vertex-inspector');
    await expect(inspector).toContainText('lfs(q)');
    const ratio = inspector.getByRole('row', { name: 'lfs(q) / r_q' });
    await expect(ratio).toContainText(/\d/);
    await expect(page.getByTestId('bound')).toContainText('Theorem 2.2 bounds it by C');
    const chain = page.getByTestId('ancestry').getByRole('listitem');
    const length = await chain.count();
    expect(length).toBeGreaterThan(1);
    await expect(chain.last()).toContainText('of the input');
    const parent = await chain.nth(1).getByRole('button').textContent();
    await chain.nth(1).getByRole('button').click();
    await expect(page.getByRole('heading', { name: `Picked: ${parent}` })).toBeVisible();
    await page.getByRole('button', { name: 'Back to vertex 60' }).click();
    await expect(page.getByRole('heading', { name: 'Picked: Vertex 60' })).toBeVisible();
    await page.getByRole('button', { name: 'Show that moment' }).click();
    await expect(sentence(page)).toContainText('Vertex 60 is inserted');
  });

  test('a box domain is shown with its box, and the last event tells the end', async ({ page }) => {
    await open(page);
    await finished(page);
    await page.getByRole('button', { name: 'Examples' }).click();
    await page.locator('[data-example=cracks]').click();
    await finished(page);
    await page.keyboard.press('End');
    await expect(sentence(page)).toContainText('Step 2 ends');
    // The corners of the box are in sight: a click near the left upper one picks it.
    const shown = await picture(page);
    await page.keyboard.press('0');
    expect((await picture(page)).equals(shown)).toBe(true);
  });
});
