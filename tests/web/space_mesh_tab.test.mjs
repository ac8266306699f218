// The Mesh tab of the page for surfaces, as a person uses it: what is on the screen in the end is the mesh
// of the options that are shown.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { finished, startPlayground } from './support.mjs';

let playground, page;
before(async () => {
  playground = await startPlayground();
  page = await playground.open({ hash: 'space.html#preset=saddle&size=0.3' });
  await finished(page);
  await page.getByRole('tab', { name: 'Mesh' }).click();
  await page.evaluate(() => {
    const { runner } = globalThis.playground;
    globalThis.works = new Set();
    runner.subscribe(({ work }) => globalThis.works.add(work));
  });
});
after(() => playground.close());

const now = () => page.evaluate(() => {
  const { store, runner } = globalThis.playground;
  return { size: store.project.options.size, gesture: store.gesture, runs: globalThis.works.size, phase: runner.run.phase, undo: store.undoLabel };
});
/** The mesh on the screen is that of the size in the form. */
const meshed = () => page.waitForFunction(() => {
  const { runner: { run }, store } = globalThis.playground;
  return run.phase === 'done' && run.result.report.options.size === store.project.options.size;
});
const size = () => page.getByRole('group', { name: 'Size of the quads', exact: true });

test('a drag of the size slider is one change, meshed when the slider is let go', async () => {
  const before = await now();
  const box = await size().getByRole('slider').boundingBox();
  const at = (share) => [box.x + box.width * share, box.y + box.height / 2];
  await page.mouse.move(...at(0.75));
  await page.mouse.down();
  await page.mouse.move(...at(0.85), { steps: 5 });
  const during = await now();
  assert.notEqual(during.gesture, '');
  assert.notEqual(during.size, before.size);
  assert.equal(during.runs, before.runs, 'nothing is meshed under the hand');
  await page.mouse.up();
  await meshed();
  const after = await now();
  assert.equal(after.gesture, '');
  assert.notEqual(after.size, before.size);
  await page.evaluate(() => globalThis.playground.actions.run('edit.undo'));
  assert.equal((await now()).size, before.size);
  await meshed();
});

test('the size slider is meshed after an arrow key', async () => {
  const before = await now();
  await size().getByRole('slider').focus();
  for (const key of ['ArrowRight', 'ArrowRight', 'ArrowLeft', 'ArrowRight']) await page.keyboard.press(key);
  await meshed();
  const { size: bigger, gesture } = await now();
  assert.ok(bigger > before.size);
  assert.equal(gesture, '');
  assert.deepEqual(page.errors, []);
});

test('a slider that comes back to where it was leaves the mesh as it is', async () => {
  await meshed();
  const before = await now();
  await page.evaluate(() => {
    const { store } = globalThis.playground, { options } = store.project;
    for (const size of [options.size / 2, options.size]) store.change('Size', { options: { ...options, size } }, 'a drag');
    store.settle();
  });
  const after = await now();
  assert.deepEqual([after.size, after.runs, after.phase], [before.size, before.runs, 'done']);
});

test('the same size again is no change, to undo or to mesh', async () => {
  await meshed();
  const before = await now();
  const input = page.locator('#option-size');
  await page.evaluate(() => { globalThis.project = globalThis.playground.store.project; });
  for (const text of [` ${before.size}`, `0${before.size}`, `${before.size}0`]) {
    await input.fill(text);
    await page.keyboard.press('Enter');
    assert.equal(await input.inputValue(), String(before.size));
  }
  assert.ok(await page.evaluate(() => globalThis.playground.store.project === globalThis.project));
  assert.deepEqual(await now(), before);
});

test('the address follows once the slider rests, not at every step', async () => {
  const steps = 60;
  await page.evaluate(() => {
    const replace = history.replaceState.bind(history);
    globalThis.addresses = [];
    history.replaceState = (state, unused, url) => { globalThis.addresses.push(url); replace(state, unused, url); };
  });
  const wanted = await page.evaluate((count) => {
    const { store } = globalThis.playground;
    for (let k = 0; k < count; ++k) store.change('Size', ({ options }) => ({ options: { ...options, size: 0.3 + k / 1000 } }), 'a drag');
    store.settle();
    return `size=${store.project.options.size}`;
  }, steps);
  await page.waitForFunction((text) => location.hash.includes(text), wanted);
  const count = await page.evaluate(() => globalThis.addresses.length);
  assert.ok(count < steps / 2, `${count} addresses for ${steps} changes`);
  assert.deepEqual(page.errors, []);
});
