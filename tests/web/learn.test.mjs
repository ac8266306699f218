// The tour: its words, and its live figures as a reader goes through them.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { chapters } from '../../web/learn/chapters.js';
import { tickOf } from '../../web/learn/figure.js';
import { startPlayground } from './support.mjs';

test('every chapter has 80 to 120 words, a formula in MathML, its words, and its source', () => {
  assert.equal(chapters.length, 7);
  assert.equal(new Set(chapters.map(({ id }) => id)).size, 7);
  for (const { id, text, formula, spoken, source } of chapters) {
    const words = text.trim().split(/\s+/).length;
    assert.ok(words >= 80 && words <= 120, `${id}: ${words} words`);
    assert.match(formula, /^<m\w+>/);
    assert.ok(spoken.length > 20 && !/["<&]/.test(spoken));
    assert.match(source, /Eq\.|section/);
  }
});

test('a place is found in what was run', () => {
  const history = [{ tick: 0, stage: 'seeds', iteration: 0 }, { tick: 1, stage: 'optimise', iteration: 0 }, { tick: 9, stage: 'optimise', iteration: 8 },
    { tick: 10, stage: 'match', iteration: 0 }];
  assert.equal(tickOf(history, { stage: 'optimise', iteration: 0 }), 1);
  assert.equal(tickOf(history, { stage: 'optimise', iteration: 5 }), 6);
  assert.equal(tickOf(history, { stage: 'optimise', iteration: 99 }), 9);
  assert.equal(tickOf(history, { stage: 'match' }), 10);
  assert.equal(tickOf(history, { stage: 'done' }), undefined);
});

let playground;
before(async () => { playground = await startPlayground(); });
after(() => playground.close());

const shown = (page, { project, at }) => page.waitForFunction(({ layers, at }) => {
  const { store, runner: { run, busy } } = globalThis.playground;
  return !busy && String(store.project.layers) === layers && run.project === store.project && run.state?.stage === at.stage
    && run.frame?.tick === run.state.tick && (at.iteration === undefined || run.state.iteration === at.iteration);
}, { layers: String(project.layers), at });

test('keys lead through all chapters and back, and undo leads out', async () => {
  const page = await playground.open();
  await page.getByRole('tab', { name: 'Learn' }).click();
  const before = await page.evaluate(() => globalThis.playground.store.project.options);
  await page.getByRole('button', { name: 'Start the tour' }).click();
  for (const [k, chapter] of chapters.entries()) {
    await page.getByRole('heading', { name: chapter.title }).waitFor();
    await shown(page, chapter);
    await page.waitForFunction((hash) => location.hash === hash, `#chapter=${chapter.id}`);
    assert.ok(await page.locator('#panel-learn math').isVisible());
    if (k < chapters.length - 1) await page.keyboard.press('n');
  }
  await page.keyboard.press('Shift+N');
  await shown(page, chapters.at(-2));
  assert.match(await page.getAttribute('[data-action="edit.undo"]', 'title'), /^Undo: Tour: /);
  for (let k = 0; k < chapters.length + 1; ++k) await page.keyboard.press('Control+z');
  assert.deepEqual(await page.evaluate(() => globalThis.playground.store.project.options), before);
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test('every chapter has its own link', async () => {
  for (const chapter of [chapters[2], chapters[5]]) {
    const page = await playground.open({ hash: `#chapter=${chapter.id}` });
    await page.getByRole('heading', { name: chapter.title }).waitFor();
    await shown(page, chapter);
    assert.equal(await page.getByRole('tab', { name: 'Learn' }).getAttribute('aria-selected'), 'true');
    assert.deepEqual(page.errors, []);
    await page.context().close();
  }
});

test('a changed figure is shared with its chapter', async () => {
  const page = await playground.open({ hash: '#preset=plate&chapter=field&options=size:0.1' });
  await page.getByRole('heading', { name: 'Which way is up?' }).waitFor();
  assert.deepEqual(await page.evaluate(() => globalThis.playground.store.project.options), { size: 0.1 });
  await page.context().close();
});

test('watching plays the figure from its start', async () => {
  const page = await playground.open({ hash: '#chapter=norm' });
  await shown(page, chapters[3]);
  await page.getByRole('button', { name: 'Watch it happen' }).click();
  await page.waitForFunction(() => globalThis.playground.runner.run.phase === 'done');
  assert.deepEqual(page.errors, []);
  await page.context().close();
});
