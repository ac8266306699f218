// The Mesh tab, as a person uses it: drags, types, chooses, errs, takes back.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { helpInWords } from '../../web/mesh/help.js';
import { finished, startPlayground } from './support.mjs';

let playground, page;
before(async () => {
  playground = await startPlayground();
  page = await playground.open({ hash: '#preset=plate&options=size:0.055,method:paper,seeds:isotropic,seed:34' });
  await finished(page);
  await page.getByRole('tab', { name: 'Mesh' }).click();
});
after(() => playground.close());

const options = () => page.evaluate(() => globalThis.playground.store.project.options);
const meshed = () => page.waitForFunction(() => {
  const { runner, store } = globalThis.playground;
  return runner.run.phase === 'done' && runner.run.frameOf === store.project && globalThis.playground.scene().freshness === 'current';
});
const field = (name) => page.getByRole('group', { name, exact: true });
const undo = () => page.evaluate(() => globalThis.playground.actions.run('edit.undo'));

test('a drag of the size slider is one change, previewed, and meshed at the end', async () => {
  const slider = field('Size of the quads').getByRole('slider');
  const before = await options();
  const box = await slider.boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width * 0.62, box.y + box.height / 2, { steps: 8 });
  assert.notEqual(await page.evaluate(() => globalThis.playground.store.gesture), '');
  await page.locator('.freshness').waitFor();
  await page.mouse.move(box.x + box.width * 0.7, box.y + box.height / 2, { steps: 8 });
  await page.mouse.up();
  assert.equal(await page.evaluate(() => globalThis.playground.store.gesture), '');
  await meshed();
  const { size } = await options();
  assert.ok(size > before.size * 1.2);
  assert.equal(await page.evaluate(() => globalThis.playground.runner.run.result.report.options.size), size);
  await undo();
  assert.deepEqual(await options(), before);
  await meshed();
});

test('a number of quads takes the place of the size', async () => {
  await field('Number of quads').getByRole('textbox').fill('700');
  await page.keyboard.press('Enter');
  assert.equal('size' in await options(), false);
  assert.equal(await field('Size of the quads').getByRole('textbox').inputValue(), 'automatic');
  await meshed();
  const { quads } = await page.evaluate(() => globalThis.playground.runner.run.result.report);
  assert.ok(Math.abs(quads - 700) < 100, `${quads} quads`);
  await undo();
  assert.equal((await options()).quads, undefined);
  await meshed();
});

test('p is chosen by its ball, or typed', async () => {
  await field('Exponent p').getByRole('radio', { name: '4' }).check();
  assert.equal((await options()).norm, 4);
  assert.match(await page.locator('.ball-figure').getAttribute('aria-label'), /p = 4/);
  await field('Exponent p').getByRole('textbox').fill('3');
  await page.keyboard.press('Enter');
  assert.equal((await options()).norm, 3);
  assert.equal(await field('Exponent p').getByRole('radio', { checked: true }).count(), 0);
  await field('Exponent p').getByRole('button', { name: 'Exponent p: back to 6' }).click();
  assert.equal('norm' in await options(), false);
  await meshed();
});

test('what cannot be is refused in words, and nothing changes', async () => {
  const before = await options();
  const input = field('Iterations').getByRole('textbox');
  for (const [text, words] of [['2.5', 'A whole number is needed.'], ['many', 'A number is needed.'], ['-7', 'At least 0.']]) {
    await input.fill(text);
    await page.keyboard.press('Enter');
    assert.equal(await field('Iterations').getByRole('alert').textContent(), words);
    assert.equal(await input.getAttribute('aria-invalid'), 'true');
  }
  assert.deepEqual(await options(), before);
  await page.keyboard.press('Escape');
  assert.equal(await input.inputValue(), 'automatic');
  assert.equal(await field('Iterations').locator('.problem').textContent(), '');
});

test('every option of the library is there, explained, and arrives at the mesher', async () => {
  await page.getByText('More options').click();
  const described = await page.evaluate(async () => (await (await globalThis.playground.runner.engine()).ready()).options);
  for (const info of described) {
    const { name } = info, element = page.locator(`[data-option="${name}"]`);
    assert.equal(await element.count(), 1, name);
    assert.ok((await element.textContent()).includes(helpInWords(info).replaceAll('L_p', 'Lp')), name);  // with a lower p
  }
  const { seed } = await options();
  await field('Method').getByRole('radio', { name: 'best' }).check();
  await page.getByRole('checkbox', { name: 'Allow one added point' }).check();
  await field('Growth of sizes').getByRole('textbox').fill('0,5');
  await page.keyboard.press('Enter');
  await field('Random seed').getByRole('button', { name: 'Another' }).click();
  await meshed();
  const used = await page.evaluate(() => globalThis.playground.runner.run.result.report.options);
  assert.equal(used.method, 'best');
  assert.equal(used.allowAddedPoint, true);
  assert.equal(used.growth, 0.5);
  assert.equal(used.seed, seed + 1);
  for (let i = 0; i < 4; ++i) await undo();
  assert.equal('growth' in await options(), false);
  assert.deepEqual(page.errors, []);
});
