// What is on the page keeps its place while a person points, chooses and runs again.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { startPlayground } from './support.mjs';

let playground;
before(async () => { playground = await startPlayground(); });
after(() => playground.close());

const sizes = [[360, 740], [1440, 900]];
const over = (page) => page.waitForFunction(() => globalThis.playground.runner.run.phase === 'done', null, { timeout: 180000 });

/** Where the parts are that can be seen, except what lies over them. */
const places = (page) => page.evaluate(() => Object.fromEntries(
  [...document.querySelectorAll('body > *, #stage > *, #panel > *, .tab-body > *, .tab-body section > *, .selection-section input')]
    .filter((one) => one.checkVisibility() && !one.closest('.inspection, .error-bar, .notice') && getComputedStyle(one).position !== 'absolute')
    .map((one, i) => [`${i} ${one.tagName} ${one.id} ${one.className}`, JSON.stringify(one.getBoundingClientRect())])));

const drawn = (page) => page.evaluate(() => new Promise((done) => { requestAnimationFrame(() => requestAnimationFrame(done)); }));

for (const [width, height] of sizes)
  test(`in the plane, nothing moves for a vertex that is pointed at or chosen, at ${width} px`, async () => {
    const page = await playground.open({ width, height, hash: '#preset=plate' });
    await over(page);
    const before = await places(page);
    const numbers = page.locator('.selection-section').getByLabel('x', { exact: true });
    assert.equal(await numbers.isDisabled(), true);
    const none = page.locator('.selection-section').getByText('No vertex is chosen.');
    assert.equal(await page.locator('.selection-section input:visible').count(), 0, 'empty fields of nothing');
    assert.equal(await none.isVisible(), true);
    const corner = await page.evaluate(() => {
      const { view, overlay } = globalThis.playground.stage, { left, top } = overlay.getBoundingClientRect();
      return { x: left + view.scale * (0 - view.left), y: top + view.scale * (view.top - 0) };
    });
    await page.mouse.move(corner.x, corner.y);
    await drawn(page);
    assert.deepEqual(await places(page), before, 'pointed at');
    await page.mouse.click(corner.x, corner.y);
    for (const what of [/^Vertex 0 of 0–3/, /^Vertex 0 of 0–\d\d/]) {  // of a rectangle, of a circle
      await page.locator('.selection-section .hint', { hasText: what }).waitFor();
      await drawn(page);
      assert.deepEqual(await places(page), before, String(what));
      assert.equal(await numbers.isDisabled(), false);
      assert.equal(await numbers.isVisible(), true);
      assert.equal(await none.isVisible(), false);
      for (let i = 0; i < 4; ++i) await page.locator('[data-action="vertex.next"]').evaluate((button) => button.click());
    }
    assert.deepEqual(page.errors, []);
    await page.context().close();
  });

for (const [width, height] of sizes)
  test(`in space, nothing moves for a place that is pointed at, in any panel, at ${width} px`, async () => {
    const page = await playground.open({ width, height, hash: 'space.html#preset=bored&size=0.2' });
    await over(page);
    const box = await page.locator('#space-view canvas').boundingBox();
    for (const tab of ['Surface', 'Mesh', 'Layers', 'Figures', 'Files']) {
      await page.getByRole('tab', { name: tab }).click();
      await page.mouse.move(box.x + 2, box.y + 2);
      const before = await places(page);
      await page.mouse.move(box.x + box.width / 2, box.y + box.height * 0.7);
      assert.ok(await page.evaluate(() => globalThis.playground.pointed.chart) >= 0, 'nothing is pointed at');
      await drawn(page);
      assert.deepEqual(await places(page), before, tab);
    }
    await page.context().close();
  });

for (const [width, height] of sizes)
  test(`in space, both views keep their places when it is run again, at ${width} px`, async () => {
    const page = await playground.open({ width, height, hash: 'space.html#preset=saddle&size=0.25' });
    await over(page);
    const seen = await page.evaluate(async () => {
      const { runner, store } = globalThis.playground;
      const all = new Set();
      let going = true;
      const look = () => {
        all.add(JSON.stringify(['#space-view', '#plane-view', '#timeline', '#panel'].map((part) => document.querySelector(part).getBoundingClientRect())));
        if (going) requestAnimationFrame(look);
      };
      look();
      const picture = () => new Promise((done) => { requestAnimationFrame(() => requestAnimationFrame(done)); });
      const running = runner.start(store.project);
      await picture();  // its charts are gone by now
      await running;
      await picture();
      going = false;
      return [...all];
    });
    assert.equal(seen.length, 1, seen.join('\n'));
    assert.equal(await page.locator('#plane-view .instead').isVisible(), false);
    await page.context().close();
  });
