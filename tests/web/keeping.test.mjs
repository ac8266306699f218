// Links, the address bar, the browser's storage and project files, as a person meets them.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { presets } from '../../web/sketch/presets.js';
import { toFragment } from '../../web/state/link.js';
import { projectText, readProject } from '../../web/state/project_file.js';
import { emptyProject } from '../../web/state/project.js';
import { finished, startPlayground } from './support.mjs';

let playground;
before(async () => { playground = await startPlayground(); });
after(() => playground.close());

const square = presets.find(({ id }) => id === 'square').project;
const small = { ...square, options: { size: 0.2 } };
const count = async (page) => {
  await finished(page);
  return page.locator('.stage-name').textContent();
};

test('a link opens its project, and the address bar follows', async () => {
  const page = await playground.open({ hash: await toFragment(small) });
  assert.equal(await count(page), 'done: 25 quads');
  assert.equal(await page.locator('#project-name').textContent(), 'Square');
  await page.evaluate((hash) => { location.hash = hash; }, await toFragment({ ...square, options: { size: 0.25 } }));
  await page.locator('.stage-name', { hasText: 'done: 16 quads' }).waitFor();
  await page.click('[data-action="edit.undo"]');
  await page.locator('.stage-name', { hasText: 'done: 25 quads' }).waitFor();
  await page.waitForFunction(() => location.hash.includes('size:0.2') && !location.hash.includes('0.25'));
  assert.match(await page.getAttribute('[data-action="edit.redo"]', 'title'), /^Redo: Open a link/);
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test('a link that names a comparison only opens it on the first domain', async () => {
  const page = await playground.open({ hash: await toFragment(small) });
  await count(page);
  await page.evaluate(() => { location.hash = '#comparison=lp'; });
  await page.locator('.differences').waitFor({ state: 'attached' });
  await page.waitForFunction(() => globalThis.playground.led().every(({ run }) => run.phase === 'done') && globalThis.playground.led().length === 2);
  assert.equal(await page.locator('#project-name').textContent(), presets[0].title);
  await page.keyboard.press('Control+z');
  assert.equal(await count(page), 'done: 25 quads');
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test('a link opens though the address bar has followed something else meanwhile', async () => {
  const page = await playground.open({ hash: await toFragment(small) });
  await count(page);
  const follow = (hash) => page.evaluate((to) => {
    const { hash: before } = location;
    location.hash = to;
    history.replaceState(null, '', before);  // before the browser tells of the change
  }, hash);
  await follow(await toFragment({ ...square, options: { size: 0.25 } }));
  await page.locator('.stage-name', { hasText: 'done: 16 quads' }).waitFor();
  await follow('#data=damaged');
  await page.locator('.notice', { hasText: 'This link could not be opened' }).waitFor();
  await page.context().close();
});

test('a link stands at its tick', async () => {
  const page = await playground.open({ hash: '#preset=plate&tick=7' });
  await page.waitForFunction(() => document.querySelector('#tick').value === '7');
  await page.waitForFunction(() => location.hash.includes('tick=7'));
  await page.context().close();
});

test('a hostile link leaves the page in order and says why', async () => {
  for (const hash of ['#data=%00%ff', '#preset=<img src=x onerror=alert(1)>', '#preset=plate&options=size:NaN', '#%']) {
    const page = await playground.open({ hash });
    await page.locator('.notice', { hasText: 'This link could not be opened' }).waitFor();
    await finished(page);
    await page.click('.notice button');
    assert.equal(await page.locator('.notice').isVisible(), false);
    assert.deepEqual(page.errors, []);
    await page.context().close();
  }
});

test('a link to a chapter or a comparison that there is not says so, when it is opened first and later', async () => {
  const page = await playground.open({ hash: '#chapter=nowhere' });
  await page.locator('.notice', { hasText: 'This link could not be opened: there is no chapter “nowhere”.' }).waitFor();
  await finished(page);
  await page.click('.notice button');
  await page.evaluate(() => { location.hash = '#preset=gear&comparison=nothing-like-it'; });
  await page.locator('.notice', { hasText: 'there is no comparison “nothing-like-it”' }).waitFor();
  assert.equal(await page.locator('#project-name').textContent(), 'Plate with a hole');
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test('the next visit finds the project, with or without storage', async () => {
  const page = await playground.open({ hash: await toFragment(small) });
  await count(page);
  await page.goto('about:blank');
  await page.goto(playground.address);
  assert.equal(await count(page), 'done: 25 quads');
  await page.evaluate(() => localStorage.setItem('lpquad.project', '{"lpquadProject":1,"drawing":7}'));
  await page.goto('about:blank');
  await page.goto(playground.address);
  await finished(page);
  assert.deepEqual(page.errors, []);
  await page.context().close();

  const context = await playground.browser.newContext();
  const blocked = await context.newPage();
  const errors = [];
  blocked.on('pageerror', (error) => errors.push(error.message));
  await blocked.addInitScript(() => Object.defineProperty(window, 'localStorage', { get() { throw new DOMException('no', 'SecurityError'); } }));
  await blocked.goto(`${playground.address}${await toFragment(small)}`);
  assert.equal(await count(blocked), 'done: 25 quads');
  await blocked.locator('.notice', { hasText: 'keeps nothing' }).waitFor();
  assert.deepEqual(errors, []);
  await context.close();
});

test('sharing copies a link, and offers a file where a link would be too long', async () => {
  const page = await playground.open({ hash: await toFragment(small) });
  await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
  await count(page);
  await page.keyboard.press('Shift+S');
  await page.getByRole('button', { name: 'Copy the link' }).click();
  await page.locator('#share-words', { hasText: 'copied' }).waitFor();
  const link = await page.evaluate(() => navigator.clipboard.readText());
  assert.equal(link, `${playground.address}${await toFragment(small)}`);
  await page.keyboard.press('Escape');

  const loop = Array.from({ length: 1200 }, (_, i) => [Math.cos(i * Math.PI / 600), Math.sin(i * Math.PI / 600)]);
  const large = { ...emptyProject, name: 'ring.svg', options: { size: 0.3 }, drawing: { regions: [{ name: '', loops: [loop] }], polylines: [], points: [] } };
  await page.evaluate((hash) => { location.hash = hash; }, await toFragment(large));
  await page.locator('#project-name', { hasText: 'ring.svg' }).waitFor();
  await page.waitForFunction(() => location.hash === '');
  await page.keyboard.press('Shift+S');
  await page.locator('#share-words', { hasText: 'as a file' }).waitFor();
  assert.equal(await page.getByRole('button', { name: 'Copy the link' }).isVisible(), false);
  const [file] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: 'Save as a file' }).click()]);
  assert.equal(file.suggestedFilename(), 'ring.lpquad.json');
  const { readFileSync } = await import('node:fs');
  assert.deepStrictEqual(readProject(readFileSync(await file.path(), 'utf8')), large);
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test('a saved project opens like any file, and a damaged one is refused in words', async () => {
  const page = await playground.open();
  await finished(page);
  const open = (name, text) => page.locator('input[aria-label="Files to open"]').setInputFiles({ name, mimeType: 'application/json', buffer: Buffer.from(text) });
  await open('mine.lpquad.json', projectText({ ...small, preset: '', name: 'mine' }));
  await page.locator('.stage-name', { hasText: 'done: 25 quads' }).waitFor();
  assert.equal(await page.locator('#project-name').textContent(), 'mine');
  await open('bad.lpquad.json', '{"lpquadProject": 1, "drawing": {"regions": 7}}');
  await page.locator('.notice', { hasText: 'bad.lpquad.json could not be opened' }).waitFor();
  assert.equal(await page.locator('#project-name').textContent(), 'mine');
  assert.deepEqual(page.errors, []);
  await page.context().close();
});
