import AxeBuilder from '@axe-core/playwright';
import { expect, type Page, test } from '@playwright/test';
import { finished, json, open, openFiles, position } from './page.ts';

/** One face in its plane, and feature sizes at what is picked: chapter 4 as a student would look at it. */

const space = (page: Page) => page.getByTestId('pane-1').locator('canvas');
const pane = (page: Page) => page.getByTestId('face-pane');
const inspector = (page: Page) => page.getByTestId('space-inspector');

/** What is on the canvas of the face, as text: equal pictures are equal texts. */
async function faceOf(page: Page): Promise<string> {
  await page.waitForTimeout(400); // what moves has landed
  return pane(page)
    .locator('canvas')
    .evaluate((c) => (c as HTMLCanvasElement).toDataURL());
}

/** A square, and half of it above: a roof without walls. */
const roof = {
  circumball: 1,
  dimension: 3,
  vertices: [
    [0, 0, 0],
    [2, 0, 0],
    [2, 2, 0],
    [0, 2, 0],
    [0, 0, 0.4],
    [2, 0, 0.4],
    [2, 2, 0.4],
  ],
  faces: [{ loops: [[0, 1, 2, 3]] }, { loops: [[4, 5, 6]] }],
};

async function openRoof(page: Page): Promise<void> {
  await open(page);
  await openFiles(page, json(roof, 'roof.json'));
  await finished(page);
  await page.locator('select').first().selectOption('feature-size');
  await space(page).focus();
  await page.keyboard.press('Control+Enter');
  await expect(page.getByText(/^Step 2b/).first()).toBeVisible();
  await finished(page);
  await page.keyboard.press('End');
  await page.keyboard.press('8'); // from above
  await page.waitForTimeout(400);
}

/** Presses along lines from below the middle of the picture upwards until something of a sort is picked. */
async function pickAlong(page: Page, wanted: RegExp): Promise<void> {
  const box = (await space(page).boundingBox())!;
  const title = page.getByRole('heading', { name: /^Picked: / });
  for (const part of [0.36, 0.39, 0.33, 0.45]) {
    const x = box.x + box.width * part;
    for (let y = box.y + box.height * 0.6; y > box.y + 10; y -= 5) {
      await page.mouse.click(x, y);
      if ((await title.count()) > 0 && wanted.test((await title.textContent()) ?? '')) return;
    }
  }
  throw new Error(`nothing like ${wanted} was met`);
}

test.describe('a face in its plane', () => {
  test('is shown beside space, follows the playhead, and goes to the next one', async ({
    page,
  }) => {
    await openRoof(page);
    await page.keyboard.press('o');
    await expect(pane(page)).toBeVisible();
    await expect(pane(page).getByRole('spinbutton')).toHaveValue('0');
    const last = await faceOf(page);
    await expect(page.getByTestId('face-counts')).toContainText(/[2-9]\d* triangles/);
    await page.keyboard.press('Shift+1');
    await page.keyboard.press('Shift+4');
    expect(await faceOf(page)).not.toBe(last);
    await page.keyboard.press('Home');
    await expect(page.getByTestId('face-counts')).toHaveText('0 vertices, 0 triangles');
    await page.keyboard.press('End');
    expect(await faceOf(page)).toBe(last);
    await page.keyboard.press('n');
    await expect(pane(page).getByRole('spinbutton')).toHaveValue('1');
    expect(await faceOf(page)).not.toBe(last);
    await page.keyboard.press('Shift+N');
    expect(await faceOf(page)).toBe(last);
    await pane(page).getByRole('spinbutton').fill('1');
    await pane(page).getByRole('spinbutton').press('Enter');
    await expect(pane(page)).toHaveAttribute('aria-label', 'Face 1');
    await pane(page).getByRole('button', { name: 'Close the face' }).click();
    await expect(pane(page)).toHaveCount(0);
  });

  test('what is picked in it is picked in space, and the other way round', async ({ page }) => {
    await openRoof(page);
    await page.keyboard.press('o');
    const canvas = pane(page).locator('canvas');
    const box = (await canvas.boundingBox())!;
    await page.waitForTimeout(400);
    await canvas.click({ position: { x: box.width / 2 + 3, y: box.height / 2 + 5 } });
    await expect(
      page.getByRole('heading', { name: /^Picked: (Triangle|Vertex|Subs)/ }),
    ).toBeVisible();
    const unpicked = await faceOf(page);
    await page
      .getByRole('region', { name: /^Picked/ })
      .getByRole('button', { name: 'Close', exact: true })
      .click();
    expect(await faceOf(page)).not.toBe(unpicked);
    await pickAlong(page, /Triangle|Vertex/);
    await expect(inspector(page)).toBeVisible();
  });

  test('goes with the face in which something happens', async ({ page }) => {
    await openRoof(page);
    await page.keyboard.press('o');
    await pane(page).getByRole('button', { name: 'Follow' }).click();
    const seen = new Set<string>();
    for (let i = 0; i < 40 && seen.size < 2; i++) {
      await page.keyboard.press('Shift+1');
      seen.add(await pane(page).getByRole('spinbutton').inputValue());
      await page.keyboard.press('ArrowLeft');
    }
    expect([...seen].sort()).toEqual(['0', '1']);
  });
});

test.describe('a subsegment in space', () => {
  test('tells its feature sizes with witnesses, the spheres, and the theorems of the moment', async ({
    page,
  }) => {
    await openRoof(page);
    await pickAlong(page, /Subsegment/);
    const sizes = page.getByTestId('segment-sizes');
    await expect(sizes).toContainText(/lfs\(s\)\s*\d/);
    await expect(sizes).toContainText(/(vertex|segment|face) \d+ and (vertex|segment|face) \d+/);
    const bounds = page.getByTestId('segment-bounds');
    await expect(bounds).toContainText('Theorem 4.1 holds');
    await expect(bounds).toContainText('Theorem 4.2 holds');
    const both = await space(page).evaluate((c) => (c as HTMLCanvasElement).toDataURL());
    await page.getByRole('button', { name: 'lfs', exact: true }).click();
    await page.waitForTimeout(300);
    const one = await space(page).evaluate((c) => (c as HTMLCanvasElement).toDataURL());
    expect(one).not.toBe(both);
    await page.keyboard.press('ArrowLeft'); // step 2b has not ended there
    await expect(bounds).not.toContainText('Theorem 4.2');
  });

  test('a vertex tells its simplex, lfs, N and its ancestry', async ({ page }) => {
    await openRoof(page);
    await pickAlong(page, /Vertex/);
    await expect(page.getByTestId('space-vertex')).toContainText(/lfs\(q\)\s*\d/);
    await expect(page.getByTestId('space-vertex')).toContainText(/N\(q\), to vertex \d+/);
    await expect(page.getByRole('heading', { name: 'Ancestry' })).toBeVisible();
  });
});

test('Table 4.1 grows with the run, with what the thesis counts beside it', async ({ page }) => {
  await page.goto('/?plain#example=wheel');
  await expect(page.getByTestId('pane-1')).toBeVisible();
  await page.getByRole('tab', { name: 'Mesh' }).click();
  const table = page.getByTestId('steps');
  await expect(table).toContainText('Table 4.1 has');
  await space(page).focus();
  await page.keyboard.press('Home');
  await page.keyboard.press('4');
  const row = (name: string) =>
    table.getByRole('row').filter({ has: page.getByRole('rowheader', { name, exact: true }) });
  await expect(row('0').getByRole('cell')).toHaveText(['72', '72', '65', '42']);
  await expect(row('1a').getByRole('cell')).toHaveText(['', '202', '', '']);
  for (let i = 0; i < 3; i++) {
    await expect
      .poll(async () => {
        const before = await position(page);
        await page.keyboard.press('4');
        return (await position(page)) > before;
      })
      .toBe(true);
  }
  await expect(row('1a').getByRole('cell').first()).toHaveText('202');
  await expect(row('1b').getByRole('cell').first()).toHaveText('518');
  await expect(row('2a').getByRole('cell').first()).toHaveText('2,051');
});

test('axe finds nothing beside a face, in both themes', async ({ page }) => {
  await openRoof(page);
  await page.keyboard.press('o');
  await pickAlong(page, /Subsegment/);
  await expect(page.getByTestId('segment-bounds')).toBeVisible();
  expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
  await page.getByRole('tab', { name: 'Mesh' }).click();
  expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
  await page.keyboard.press('Shift+D');
  await page.getByRole('tab', { name: 'Why' }).click();
  expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
});
