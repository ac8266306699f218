// What the panels of the page for surfaces say.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
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
