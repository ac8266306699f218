// axe-core finds nothing to object to, of any severity: in every tab, in every dialog, dark and
// light, on a phone and on a desk.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { finished, startPlayground } from './support.mjs';
import { violations } from './violations.mjs';

let playground;
before(async () => { playground = await startPlayground(); });
after(() => playground.close());

const judge = async (page, what) => assert.deepEqual(await violations(page), [], what);

for (const width of [360, 1280])
  for (const dark of [false, true])
    test(`${width} px, ${dark ? 'dark' : 'light'}`, async () => {
      const page = await playground.open({ width, dark });
      await finished(page);
      for (const tab of await page.getByRole('tab').all()) {
        await tab.click();
        await page.evaluate(() => document.querySelectorAll('[role=tabpanel] details').forEach((details) => { details.open = true; }));
        await judge(page, await tab.textContent());
      }
      await page.getByRole('tab', { name: 'Learn' }).click();
      await page.getByRole('button', { name: 'Start the tour' }).click();
      await judge(page, 'a chapter');
      for (const key of ['?', 'Shift+S']) {
        await page.locator('#overlay-canvas').focus();
        await page.keyboard.press(key);
        await page.locator('dialog[open]').waitFor();
        await judge(page, key);
        await page.keyboard.press('Escape');
      }
      await page.evaluate(() => { location.hash = '#data=damaged'; });
      await page.locator('.notice').waitFor();
      await judge(page, 'a notice');
      assert.deepEqual(page.errors, []);
      await page.context().close();
    });

test('a drawing with a fault', async () => {
  const page = await playground.open({ hash: '#preset=square' });
  await finished(page);
  await page.evaluate(() => globalThis.playground.store.change('Cross', { drawing: { regions: [{ name: '', loops: [[[0, 0], [1, 1], [1, 0], [0, 1.2]]] }], polylines: [], points: [] } }));
  await page.waitForFunction(() => globalThis.playground.runner.run.phase === 'failed');
  await judge(page, 'the error');
  await page.context().close();
});
