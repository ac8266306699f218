// The Figures tab, as a person uses it.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { createLpquad } from '../../dist/node.js';
import { finished, startPlayground } from './support.mjs';

let playground, page;
before(async () => {
  playground = await startPlayground();
  page = await playground.open();
  await finished(page);
  await page.getByRole('tab', { name: 'Figures' }).click();
});
after(() => playground.close());

const figure = async (name) => Number(await page.locator(`[data-figure="${name}"]`).getAttribute('data-value'));
const titled = (text) => page.locator('.figures-of', { hasText: text }).waitFor();
const curve = () => page.getByRole('slider', { name: 'Energy F by iteration' });

test('at the end the numbers are those that the library gives anywhere', async () => {
  const { drawing, options } = await page.evaluate(() => globalThis.playground.store.project);
  const { report } = (await createLpquad()).meshDomain(drawing, options);
  await titled('Finished mesh');
  for (const name of ['tau', 'quads', 'triangles', 'vertices', 'boundaryNodes', 'singularities']) assert.equal(await figure(name), report[name], name);
  for (const name of ['etaMean', 'etaMin', 'etaP5', 'fourValentPercent']) assert.equal(await figure(name), report.quality[name], name);
  for (const name of ['p10', 'p50', 'p90']) assert.equal(await figure(name), report.size[name], name);
  assert.equal(await figure('energy'), report.lp.energy.at(-1));
  assert.equal(await figure('irregular'), report.quality.interiorVertices - report.quality.valenceHistogram[4]);
  assert.ok((await page.locator('#panel-figures .hash').textContent()).includes(report.hash));
  assert.equal(await page.locator('.bars li').count(), Object.keys(report.cpuSeconds).length);
  for (const label of await page.locator('.bars li > :first-child').allTextContents()) assert.ok(!(label in report.cpuSeconds), label);
});

test('pointing at the curve shows that iteration, as long as the pointer is there', async () => {
  const box = await curve().boundingBox();
  await page.mouse.move(box.x + box.width * 0.5, box.y + box.height / 2);
  await titled('Cells settle');
  const iteration = Number(await curve().getAttribute('aria-valuenow'));
  assert.ok(iteration > 20 && iteration < 60);
  await page.mouse.move(box.x + box.width * 0.5, box.y - 400);
  await titled('Finished mesh');
  await page.mouse.click(box.x + box.width * 0.5, box.y + box.height / 2);
  await page.mouse.move(box.x + box.width * 0.5, box.y - 400);
  await titled(`iteration ${iteration} of`);
  assert.equal(await page.locator('[data-figure="etaMean"]').textContent(), '–');
  assert.ok(await figure('tau') > 0.9);
});

test('arrow keys go along the curve, and the text says where', async () => {
  await curve().focus();
  await page.keyboard.press('Home');
  await titled('Triangles');
  for (let i = 1; i <= 3; ++i) {
    await page.keyboard.press('ArrowRight');
    await titled(`iteration ${i} of`);
  }
  assert.match(await curve().getAttribute('aria-valuetext'), /^iteration 3: \d\.\d+$/);
  await page.keyboard.press('End');
  await titled('Triangles to merge');
  await page.evaluate(() => globalThis.playground.runner.end());
  await titled('Finished mesh');
});

test('histograms have their numbers as tables', async () => {
  const report = await page.evaluate(() => globalThis.playground.runner.run.result.report.quality);
  for (const [i, numbers] of [report.etaHistogram, report.valenceHistogram.slice(2)].entries()) {
    const table = page.locator('.as-table').nth(i);
    await table.locator('summary').click();
    await table.locator('td').first().waitFor();
    assert.deepEqual((await table.locator('td').allTextContents()).map(Number), numbers);
  }
});

test('numbers of another drawing are said to be out of date', async () => {
  await page.evaluate(() => {
    const { store } = globalThis.playground;
    globalThis.playground.problemsOf = () => [{ code: 'SELF_INTERSECTION', message: 'Two edges cross.', where: {} }];
    store.change('Cross', ({ drawing }) => ({ drawing: { ...drawing } }));
  });
  await titled('Out of date');
  assert.deepEqual(page.errors, []);
});
