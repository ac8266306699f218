// What the panels of the page for surfaces say.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { inflateSync } from 'node:zlib';
import { pictureOf } from '../../web/space/presets/pictures.js';
import { presets } from '../../web/space/presets/presets.js';
import { stageInWords, stageNames } from '../../web/space/run/words.js';
import { startPlayground } from './support.mjs';

let playground, page;
before(async () => {
  playground = await startPlayground();
  page = await playground.open({ hash: 'space.html#preset=saddle&size=0.25' });
  await page.waitForFunction(() => globalThis.playground.runner.run.phase === 'done', null, { timeout: 180000 });
});
after(() => playground.close());

test('times are told by the words that the run has for its stages', async () => {
  await page.getByRole('tab', { name: 'Figures' }).click();
  const times = page.locator('figure', { hasText: 'Time by stage' });
  const labels = await times.locator('.bars li > :first-child').allTextContents();
  const names = await page.evaluate(() => Object.keys(globalThis.playground.runner.run.result.report.cpuSeconds));
  assert.deepEqual(labels, names.map((name) => stageNames[name]));
  for (const stage of ['features', 'field', 'charts', 'seams', 'shape'])
    assert.ok(labels.includes(stageInWords({ phase: 'running', state: { stage, share: 0, chart: 0, chartCount: 1 }, error: null, paused: false })), stage);
});

test('the paper is told of as in the help, with the p of Lp below the line', async () => {
  await page.getByRole('tab', { name: 'Learn' }).click();
  const told = page.locator('#panel-learn article p', { hasText: 'Baudouin' });
  await page.keyboard.press('F1');
  const inHelp = page.locator('dialog.help .reference');
  assert.equal(`The paper: ${await told.textContent()}`, await inHelp.textContent());
  assert.equal(await told.locator('sub').textContent(), 'p');
  assert.equal(await told.locator('a').getAttribute('href'), await inHelp.locator('a').getAttribute('href'));
  assert.deepEqual(page.errors, []);
});

test('every surface to begin with has a picture, and no two the same', async () => {
  const pictures = await page.locator('.space-presets button').evaluateAll((buttons) => Promise.all(buttons.map(async (button) => {
    const picture = button.querySelector('img');
    await picture.decode();
    const canvas = Object.assign(document.createElement('canvas'), { width: picture.naturalWidth, height: picture.naturalHeight });
    const context = canvas.getContext('2d');
    context.drawImage(picture, 0, 0);
    const pixels = new Uint32Array(context.getImageData(0, 0, canvas.width, canvas.height).data.buffer);
    return { name: button.textContent, wide: canvas.width, share: pixels.filter(Boolean).length / pixels.length, data: canvas.toDataURL(), shades: new Set(pixels).size };
  })));
  assert.equal(pictures.length, presets.length);
  assert.equal(new Set(pictures.map(({ data }) => data)).size, presets.length);
  for (const { name, wide, share, shades } of pictures)
    assert.ok(wide === 192 && share > 0.1 && share < 0.9 && shades > 8, `${name}: ${wide} px, ${share} of it, ${shades} shades`);
  assert.deepEqual(page.errors, []);
});

test('a picture has nothing in its corners, and all of its surface', () => {
  const bytes = pictureOf(presets.find(({ id }) => id === 'torus').make());
  assert.equal(bytes.toString('latin1', 1, 4), 'PNG');
  const at = bytes.indexOf('IDAT'), rows = inflateSync(bytes.subarray(at + 4, at + 4 + bytes.readUInt32BE(at - 4)));
  const opacity = (x, y) => rows[y * (4 * 192 + 1) + 1 + 4 * x + 3];
  for (const [x, y] of [[0, 0], [191, 0], [0, 127], [191, 127]]) assert.equal(opacity(x, y), 0);
  assert.equal(opacity(20, 64), 255, 'no gap in the ring');
  assert.equal(opacity(96, 64), 0, 'nor anything in its hole');
});
