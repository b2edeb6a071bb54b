import { createHash } from 'node:crypto';
import AxeBuilder from '@axe-core/playwright';
import { expect, type Page, test } from '@playwright/test';
import { finished, json, length, open, openFiles, position, sentence } from './page.ts';

/** The picture in space, used as a student, a teacher and a researcher would. */

const canvas = (page: Page) => page.getByTestId('pane-1').locator('canvas');

/** What is on the canvas, in short: equal pictures have equal texts. */
async function picture(page: Page): Promise<string> {
  await page.waitForTimeout(400); // a flight of the view has ended
  const pixels = await canvas(page).evaluate((c) => (c as HTMLCanvasElement).toDataURL());
  return createHash('sha1').update(pixels).digest('hex');
}

async function openExample(page: Page, id: string): Promise<void> {
  await page.goto(`/?plain#example=${id}`);
  await expect(page.getByRole('button', { name: 'View from above' })).toBeVisible();
}

const tetrahedron = {
  circumball: 1,
  dimension: 3,
  vertices: [
    [0, 0, 0],
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ],
  segments: [
    [0, 1],
    [1, 2],
    [2, 0],
    [0, 3],
    [1, 3],
    [2, 3],
  ],
  faces: [
    { loops: [[0, 1, 2]] },
    { loops: [[0, 1, 3]] },
    { loops: [[1, 2, 3]] },
    { loops: [[2, 0, 3]] },
  ],
};

test.describe('space', () => {
  test('an example of the gallery opens in space and turns with the pointer and the keyboard', async ({
    page,
  }) => {
    await openExample(page, 'pyramid');
    await finished(page);
    await page.keyboard.press('End'); // it plays by itself no longer
    const first = await picture(page);
    const box = (await canvas(page).boundingBox())!;
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 120, y + 40, { steps: 5 });
    await page.mouse.up();
    const turned = await picture(page);
    expect(turned).not.toBe(first);
    await page.keyboard.press('Shift+ArrowLeft');
    expect(await picture(page)).not.toBe(turned);
    await page.keyboard.press('7');
    const above = await picture(page);
    await page.keyboard.press('6');
    await page.keyboard.press('7');
    expect(await picture(page)).toBe(above); // a standard view is always the same
  });

  test('a clip plane is set, moved, turned over and taken away', async ({ page }) => {
    await openExample(page, 'pyramid');
    await finished(page);
    await canvas(page).focus();
    await page.keyboard.press('End'); // it plays by itself no longer
    await page.keyboard.press('t'); // the first tetrahedra come with a plane that opens them
    await expect(page.getByRole('slider', { name: 'Place of the clip plane' })).toBeVisible();
    await page.keyboard.press('p');
    const whole = await picture(page);
    await page.keyboard.press('p');
    const half = await picture(page);
    expect(half).not.toBe(whole);
    await page.getByRole('slider', { name: 'Place of the clip plane' }).fill('0.4');
    const moved = await picture(page);
    expect(moved).not.toBe(half);
    await page.getByRole('button', { name: 'Show the other half' }).click();
    expect(await picture(page)).not.toBe(moved);
    await page.getByLabel('Cut cells').check();
    await page.getByRole('button', { name: 'Remove the clip plane' }).click();
    expect(await picture(page)).toBe(whole);
  });

  test('a file of space is opened, and a link carries it with the view', async ({ page }) => {
    await open(page);
    await openFiles(page, json(tetrahedron, 'tetrahedron.json'));
    await expect(page.getByTestId('notice')).toContainText('Opened tetrahedron.json');
    await page.getByRole('button', { name: 'View from above' }).click();
    await page.keyboard.press('f');
    const before = await picture(page);
    await page.getByRole('tab', { name: 'Setup' }).click();
    await expect(page.getByText('4 faces')).toBeVisible();
    await page.getByRole('button', { name: 'Share' }).click();
    const link = await page.getByRole('dialog').locator('input, textarea').first().inputValue();
    await page.keyboard.press('Escape');
    await page.goto('about:blank');
    await page.goto(`/?plain${link.slice(link.indexOf('#'))}`);
    await expect(page.getByRole('button', { name: 'View from above' })).toBeVisible();
    await expect.poll(() => picture(page), { timeout: 10_000 }).toBe(before);
  });

  test('bad input is drawn with the sentence of the core, and the drawing is still there', async ({
    page,
  }) => {
    await open(page);
    const bad = {
      ...tetrahedron,
      vertices: [...tetrahedron.vertices, [0.25, 0.25, -0.5], [0.25, 0.25, 0.2]],
      segments: [...tetrahedron.segments, [4, 5]],
    };
    await openFiles(page, json(bad, 'pierced.json'));
    await expect(page.getByTestId('defects')).toContainText(/face 0/i);
    await page.getByTestId('defects').getByRole('button').first().click();
    await page.getByRole('button', { name: 'Close, back to the drawing' }).click();
    await expect(page.getByRole('toolbar', { name: 'Tools' })).toBeVisible();
  });

  test('axe finds nothing, in both themes', async ({ page }) => {
    await openExample(page, 'pyramid');
    await picture(page);
    await canvas(page).focus();
    await page.keyboard.press('p');
    for (const tab of ['Why', 'Mesh', 'Setup']) {
      await page.getByRole('tab', { name: tab }).click();
      expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
    }
    await page.keyboard.press('Shift+D');
    expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
  });
});

test.describe('a run in space', () => {
  test('plays, steps, scrubs, and says why', async ({ page }) => {
    await openExample(page, 'pyramid');
    await finished(page);
    await page.keyboard.press('Space');
    await page.keyboard.press('Home');
    expect(await position(page)).toBe(0);
    const start = await picture(page);
    await page.keyboard.press('ArrowRight');
    expect(await position(page)).toBe(1);
    await page.keyboard.press('End');
    expect(await position(page)).toBe(await length(page));
    await expect(sentence(page)).toContainText(/ends/);
    expect(await picture(page)).not.toBe(start);
    await page.keyboard.press('Shift+1');
    await expect(sentence(page)).toContainText(/is inserted/);
    await page.getByRole('tab', { name: 'Mesh' }).click();
    await expect(page.getByRole('group', { name: 'Histogram of angles' })).toBeVisible();
  });
});

test.describe('collars in space', () => {
  test('are drawn, told of, hidden and carried by a link with the face beside them', async ({
    page,
  }) => {
    await page.goto('/?plain#example=pyramid&algorithm=collar&step=2c');
    await finished(page);
    await expect(sentence(page)).toContainText('Step 2c ends');
    const legend = page.getByLabel('Legend of the picture');
    await expect(legend).toContainText('Protected piece');
    await page.getByRole('tab', { name: 'Mesh' }).click();
    const drawn = await picture(page);
    await page.getByLabel('Collars', { exact: true }).uncheck();
    await expect(legend).not.toContainText('Protected piece');
    expect(await picture(page)).not.toBe(drawn);
    await page.getByLabel('Collars', { exact: true }).check();
    expect(await picture(page)).toBe(drawn);
    await canvas(page).focus();
    await page.keyboard.press('ArrowLeft');
    await page.keyboard.press('ArrowLeft');
    await expect(sentence(page)).toContainText('is drawn');
    await page.keyboard.press('o');
    const face = page.getByRole('spinbutton', { name: 'Number of the face' });
    await face.fill('2');
    await face.press('Enter');
    await page.getByRole('button', { name: 'Share' }).click();
    const link = await page.getByRole('dialog').locator('input, textarea').first().inputValue();
    await page.goto('about:blank');
    await page.goto(`/?plain${link.slice(link.indexOf('#'))}`);
    await finished(page);
    await expect(face).toHaveValue('2');
    await expect(sentence(page)).toContainText('is drawn');
  });

  test('say which of them stops a tetrahedron that is left above tau', async ({ page }) => {
    await page.goto('/?plain#example=schoenhardt&algorithm=collar&step=3');
    await finished(page);
    await page.getByRole('tab', { name: 'Mesh' }).click();
    const before = await picture(page);
    await page
      .getByRole('button', { name: /^tetrahedron / })
      .first()
      .click();
    await expect(page.getByTestId('space-inspector')).toContainText('Theorem 6.11');
    await expect(page.getByTestId('space-inspector')).toContainText(
      /in the ball of .*collar simplex/,
    );
    expect(await picture(page)).not.toBe(before);
  });

  test('stand beside the same input without them, in step by steps, with one view', async ({
    page,
  }) => {
    await page.goto('/?plain#example=schoenhardt&algorithm=ruppert&compare=collar&maxVertices=300');
    await expect(page.getByRole('radio', { name: 'steps' })).toBeChecked();
    await page.getByRole('button', { name: 'View from above' }).click();
    const right = page.getByTestId('pane-2');
    await expect(right.getByTestId('pane-counts')).toContainText('Vertices');
    await page.keyboard.press('End');
    await expect(page.getByTestId('differences')).toContainText('by a limit');
    await expect(page.getByTestId('differences')).toContainText('by itself');
  });
});
