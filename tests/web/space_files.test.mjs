// The Files tab of the page for surfaces: what leaves the page is what is on the screen, and can be had all the same
// where the browser does not help.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { finished, startPlayground } from './support.mjs';

let playground, page;
before(async () => {
  playground = await startPlayground();
  page = await playground.open({ hash: 'space.html#preset=saddle&size=0.3' });
  await finished(page);
  await page.getByRole('tab', { name: 'Files' }).click();
  await page.locator('[data-format="msh"][aria-disabled="false"]').waitFor();
});
after(() => playground.close());

const saved = async (selector) => {
  const [file] = await Promise.all([page.waitForEvent('download'), page.click(selector)]);
  return { name: file.suggestedFilename(), text: readFileSync(await file.path(), 'utf8') };
};

test('formats come with their versions; elements, of which a surface has one kind, are not asked for', async () => {
  const row = page.locator('li', { has: page.locator('[data-format="msh"]') });
  for (const version of await row.getByRole('combobox').locator('option').allTextContents()) {
    await row.getByRole('combobox').selectOption(version);
    const { name, text } = await saved('[data-format="msh"]');
    assert.equal(name, 'saddle.msh');
    assert.ok(text.startsWith(`$MeshFormat\n${version} `), text.slice(0, 30));
  }
  assert.equal(await page.locator('li', { has: page.locator('[data-format="inp"]') }).getByRole('combobox').count(), 0);
  assert.match((await saved('[data-format="inp"]')).text, /S4/);
});

test('no mesh leaves the page while a slider is held or another mesh is made', async () => {
  const change = (size, gesture) => page.evaluate(([size, gesture]) =>
    globalThis.playground.store.change('Size', ({ options }) => ({ options: { ...options, size } }), gesture), [size, gesture]);
  await change(0.2, 'a drag');
  await page.locator('#export-reason', { hasText: 'still changing' }).waitFor();
  assert.equal(await page.getAttribute('[data-format="obj"]', 'aria-disabled'), 'true');
  await page.locator('[data-format="obj"]').click({ force: true });
  await page.locator('.notice', { hasText: 'still changing' }).waitFor();
  const reason = await page.evaluate(() => {
    globalThis.playground.store.settle();
    return document.querySelector('#export-reason').textContent;  // at once: the run may be short
  });
  assert.match(reason, /not finished/);
  await finished(page);
  await page.locator('[data-format="obj"][aria-disabled="false"]').waitFor();
  const { text } = await saved('[data-format="obj"]');
  assert.equal(text.match(/^f /gm).length, await page.evaluate(() => globalThis.playground.runner.run.result.report.quads));
  assert.match(await page.locator('.code').textContent(), /size: 0\.2/);
});

test('the link says what is on the screen before the address does', async () => {
  await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
  const link = await page.evaluate(async () => {
    const { actions, store } = globalThis.playground;
    store.change('Layers', { layers: ['quads'] });
    actions.run('page.share');
    return new Promise((done) => { setTimeout(() => done(navigator.clipboard.readText())); });
  });
  assert.match(link, /space\.html#preset=saddle&size=0\.2&layers=quads$/);
});

test('the triangles of the surface have a name of their own, which the code reads', async () => {
  const { name, text } = await saved('[data-action="file.surface"]');
  assert.equal(name, 'saddle-surface.obj');
  assert.doesNotMatch(text, /^f \S+ \S+ \S+ \S+$/m);
  assert.notEqual(name, (await saved('[data-format="obj"]')).name);
  assert.match(await page.locator('.code').textContent(), /readFileSync\("saddle-surface\.obj"\)/);
});

test('code that the browser does not copy is selected', async () => {
  await page.evaluate(() => { navigator.clipboard.writeText = () => Promise.reject(new Error('no')); });
  await page.click('[data-action="file.code"]');
  await page.locator('.notice', { hasText: 'selected' }).waitFor();
  const [chosen, shown] = await page.evaluate(() => [getSelection().toString(), document.querySelector('.code').textContent]);
  assert.equal(chosen.trim(), shown.trim());
  assert.deepEqual(page.errors, []);
});

test('a surface from a file has no link, and the page says why', async () => {
  assert.ok(await page.getByText('No link holds a file').isHidden());
  await page.locator('input[type=file]').setInputFiles({ name: 'two.obj', mimeType: 'model/obj', buffer: Buffer.from('v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n') });
  await page.getByText('No link holds a file: pass two.obj on').waitFor();
  assert.equal(await page.getAttribute('[data-action="page.share"]', 'aria-disabled'), 'true');
  await finished(page);
  assert.deepEqual(page.errors, []);
});
