// The tour: its words, and its live figures as a reader goes through them.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { chapters } from '../../web/learn/chapters.js';
import { tickOf } from '../../web/learn/figure.js';
import { finished, startPlayground } from './support.mjs';

test('every chapter has 80 to 120 words, a formula in MathML, its words, and its source', () => {
  assert.equal(chapters.length, 7);
  assert.equal(new Set(chapters.map(({ id }) => id)).size, 7);
  for (const { id, text, formula, spoken, source } of chapters) {
    const words = text.trim().split(/\s+/).length;
    for (const part of text.split('\n\n')) assert.ok(part.trim().split(/\s+/).length <= 60, `${id}: a wall of text`);
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

test('who takes the tour by keyboard is led to its first chapter', async () => {
  const page = await playground.open();
  await page.locator('.welcome button').focus();
  await page.keyboard.press('Enter');
  await page.getByRole('heading', { name: chapters[0].title }).waitFor();
  assert.equal(await page.evaluate(() => document.activeElement.textContent), chapters[0].title);
  await page.context().close();
});

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

const projectOf = (page) => page.evaluate(() => globalThis.playground.store.project);
/** All of the plate, and not much else. */
const inSight = (page) => page.waitForFunction(() => {
  const { scale, left, top, width, height } = globalThis.playground.stage.view;
  return left < 0 && left + width / scale > 2 && top > 1 && top - height / scale < 0 && 2 * scale > width / 2;
});
const chapterOpen = (page, k) => page.getByRole('heading', { name: chapters[k].title }).waitFor();

test('the tour takes its layers and its address with it', async () => {
  const page = await playground.open();
  await page.getByRole('tab', { name: 'Learn' }).click();
  for (const leave of ['preset.gear', 'sketch.empty']) {
    await page.getByRole('link', { name: 'Which way is up?' }).click();
    await shown(page, chapters[4]);
    await inSight(page);
    await page.evaluate((id) => globalThis.playground.actions.run(id), leave);
    assert.equal((await projectOf(page)).layers, 'auto', leave);
    await page.waitForFunction(() => location.hash.includes('preset=gear') || location.hash === '');
    assert.doesNotMatch(await page.evaluate(() => location.hash), /chapter|layers/, leave);
    await page.getByRole('tab', { name: 'Learn' }).click();
  }
  await page.getByRole('link', { name: 'Which way is up?' }).click();  // from where nothing was drawn
  await inSight(page);
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');  // the figure is there again, and so is its address
  await page.waitForFunction(() => location.hash === '#chapter=field');
  await page.evaluate(() => globalThis.playground.actions.run('layer.sizes'));
  await page.evaluate(() => globalThis.playground.store.change('Own', ({ drawing }) => ({ preset: '', drawing: { ...drawing } })));
  await page.waitForFunction(() => location.hash.includes('data='));
  assert.doesNotMatch(await page.evaluate(() => location.hash), /chapter/);
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test('layers chosen before the tour come back after it', async () => {
  const page = await playground.open({ hash: '#preset=square&layers=quads' });
  await page.evaluate(() => globalThis.playground.actions.run('learn.start'));
  await page.keyboard.press('n');
  await shown(page, chapters[1]);
  await page.evaluate(() => globalThis.playground.actions.run('preset.l'));
  assert.deepEqual((await projectOf(page)).layers, ['quads']);
  await page.context().close();
});

test('N chooses a vertex, and turns the page only where the tour is read', async () => {
  const page = await playground.open({ hash: '#preset=square' });
  await page.getByRole('button', { name: 'Next vertex' }).click();
  await page.keyboard.press('n');
  await page.locator('.hint', { hasText: 'Vertex 1 of 0–3' }).waitFor();
  await page.keyboard.press('p');
  await page.locator('.hint', { hasText: 'Vertex 0 of 0–3' }).waitFor();
  await page.getByRole('tab', { name: 'Learn' }).click();
  await page.keyboard.press('n');  // no chapter is open yet
  assert.equal((await projectOf(page)).preset, 'square');
  await page.getByRole('button', { name: 'Start the tour' }).click();
  await chapterOpen(page, 0);
  await page.keyboard.press('n');
  await chapterOpen(page, 1);
  await page.getByRole('tab', { name: 'Layers' }).click();
  await page.keyboard.press('n');
  assert.equal(await page.evaluate(() => globalThis.playground.tabs.current), 'layers');
  await page.context().close();
});

test('the focus goes to the heading of a chapter, and Back to the chapter before', async () => {
  const page = await playground.open({ hash: '#preset=square' });
  await finished(page);
  await page.getByRole('tab', { name: 'Learn' }).click();
  await page.getByRole('button', { name: 'Start the tour' }).click();
  for (const k of [0, 1]) {
    assert.equal(await page.evaluate(() => document.activeElement.textContent), chapters[k].title);
    await page.waitForFunction((hash) => location.hash === hash, `#chapter=${chapters[k].id}`);
    if (k === 0) await page.getByRole('button', { name: 'Next chapter' }).click();
  }
  await page.goBack();
  await chapterOpen(page, 0);
  await page.goBack();
  await page.waitForFunction(() => globalThis.playground.store.project.preset === 'square');
  await page.goForward();
  await chapterOpen(page, 0);
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test('what is watched can be seen at every stage, and the figure comes back', async () => {
  const page = await playground.open({ hash: '#chapter=matching' });
  await shown(page, chapters[5]);
  await page.getByRole('button', { name: 'Watch it happen' }).click();
  assert.equal((await projectOf(page)).layers, 'auto');
  await page.waitForFunction(() => globalThis.playground.runner.run.phase === 'done');
  await page.getByRole('button', { name: 'Show its figure' }).click();
  await page.waitForFunction(() => {
    const { store, runner: { run } } = globalThis.playground;
    return String(store.project.layers) === 'boundary,matching' && run.frame.stage === 'clean' && run.frame.matching?.triangles.length > 0;
  });
  await page.context().close();
});

test('the paper can be found, from the tour and from the help', async () => {
  const page = await playground.open();
  await page.getByRole('tab', { name: 'Learn' }).click();
  const link = page.locator('#panel-learn .reference a');
  assert.equal(await link.getAttribute('href'), 'https://doi.org/10.1007/s00366-012-0290-x');
  assert.match(await page.locator('#panel-learn .reference').textContent(), /Carrier Baudouin.*2012.*Lp norm/);
  await page.keyboard.press('?');
  assert.equal(await page.locator('dialog .reference a').isVisible(), true);
  await page.context().close();
});

test('the first visit says what the page is; later ones do not', async () => {
  const page = await playground.open();
  await finished(page);
  const { etaMin } = await page.evaluate(() => globalThis.playground.runner.run.result.report.quality);
  assert.ok(etaMin > 0.5, `the first mesh has a quad of ${etaMin}`);
  await page.getByRole('button', { name: /Take the tour/ }).click();
  await chapterOpen(page, 0);
  await page.goto('about:blank');
  await page.goto(`${playground.address}#preset=square`);
  await finished(page);
  assert.equal(await page.getByRole('button', { name: /Take the tour/ }).count(), 0);
  await page.context().close();
});

/** A drawing of the visitor's own, with the tour open over it. */
async function tourOverOwn(hash = '') {
  const page = await playground.open({ hash: '#preset=square&options=size:0.25' });
  await finished(page);
  await page.evaluate(() => globalThis.playground.store.change('Own', ({ drawing }) => ({ preset: '', name: 'mine', drawing: { ...drawing } })));
  if (hash === '') await page.evaluate(() => globalThis.playground.actions.run('learn.start'));
  else await page.evaluate((to) => { location.hash = to; }, hash);
  await page.waitForFunction(() => location.hash.includes('chapter='));
  return page;
}

for (const [way, hash] of [['started', ''], ['opened by a link', '#chapter=field'], ['opened by a link with a changed figure', '#preset=plate&chapter=field&options=size:0.1']])
  test(`a tour that was ${way} keeps the visitor's drawing, over a reload and to the next visit`, async () => {
    const page = await tourOverOwn(hash);
    await page.reload();
    await page.waitForFunction(() => globalThis.playground?.keeping.inTour);
    assert.equal((await projectOf(page)).preset, 'plate');
    await page.getByRole('button', { name: 'Back to my drawing' }).click();
    assert.equal((await projectOf(page)).name, 'mine');
    await page.keyboard.press('Control+z');  // into the tour again
    await page.waitForFunction(() => globalThis.playground.store.project.preset === 'plate');
    await page.goto('about:blank');
    await page.goto(playground.address);
    await page.waitForFunction(() => globalThis.playground !== undefined);
    assert.equal((await projectOf(page)).name, 'mine');
    assert.deepEqual((await projectOf(page)).options, { size: 0.25 });
    assert.deepEqual(page.errors, []);
    await page.context().close();
  });

test('a drawing that the tour was left for with Undo is kept as it is changed', async () => {
  const page = await playground.open();  // the first preset: the tour has the same drawing
  await finished(page);
  await page.evaluate(() => globalThis.playground.actions.run('learn.start'));
  await page.evaluate(() => globalThis.playground.store.undo());
  await page.evaluate(() => globalThis.playground.store.change('Size', { options: { size: 0.2 } }));
  await page.goto('about:blank');
  await page.goto(playground.address);
  await page.waitForFunction(() => globalThis.playground !== undefined);
  assert.deepEqual((await projectOf(page)).options, { size: 0.2 });
  await page.context().close();
});

test('the last chapter leads back to the drawing, and no further', async () => {
  const page = await playground.open({ hash: `#chapter=${chapters.at(-1).id}` });
  await chapterOpen(page, chapters.length - 1);
  assert.equal(await page.getByRole('button', { name: 'Next chapter' }).count(), 0);
  await page.getByRole('button', { name: 'Back to my drawing' }).click();
  await page.waitForFunction(() => !location.hash.includes('chapter'));
  assert.equal(await page.evaluate(() => globalThis.playground.tabs.current), 'domain');
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

for (const [width, height] of [[320, 740], [360, 640], [360, 740], [390, 844], [1440, 900]])
  test(`the way on is in sight in every chapter, and the text has room: ${width} x ${height}`, async () => {
    const page = await playground.open({ width, height, touch: width < 500, hash: `#chapter=${chapters[0].id}` });
    await chapterOpen(page, 0);
    for (let k = 0; k < chapters.length; ++k) {
      const body = page.locator('#panel-learn');
      const [on, panel] = await body.evaluate((element) => [element.querySelector('.onwards .primary'), element].map((one) => one.getBoundingClientRect().toJSON()));
      assert.ok(on.top >= panel.top && on.bottom <= Math.min(panel.bottom, height), `${chapters[k].id}: ${JSON.stringify(on)}`);
      assert.equal(await body.evaluate((element) => element.scrollTop), 0);
      assert.ok(on.top - panel.top > 0.25 * height, `${chapters[k].id}: ${on.top - panel.top} px for the text`);
      assert.equal(await page.locator('article > p:not(.quiet)').count(), chapters[k].text.split('\n\n').length);
      if (k < chapters.length - 1) await page.locator('.onwards .primary').click();
    }
    assert.deepEqual(page.errors, []);
    await page.context().close();
  });
