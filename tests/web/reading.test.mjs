// Files that take long to read: the page says so, and lets them be given up.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { finished, startPlayground } from './support.mjs';

let playground;
before(async () => { playground = await startPlayground(); });
after(() => playground.close());

const square = 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n';

/** A page whose files are read as slowly as the test wants: `globalThis.arrive()` lets the bytes of the last one come. */
async function slowPage(hash) {
  const page = await playground.open({ hash });
  await finished(page);
  await page.evaluate(() => {
    const { arrayBuffer } = File.prototype;
    File.prototype.arrayBuffer = async function slow() {
      await new Promise((resolve) => { globalThis.arrive = resolve; });
      return arrayBuffer.call(this);
    };
  });
  return page;
}

const open = (page, name, text = square) =>
  page.locator('input[type=file]').first().setInputFiles({ name, mimeType: 'model/obj', buffer: Buffer.from(text) });
const arrive = (page) => page.evaluate(() => globalThis.arrive());
const name = (page) => page.locator('#project-name').textContent();
const notice = (page, text) => page.locator('.notice', { hasText: text });

for (const [place, file] of [['space.html#preset=saddle&size=0.3', 'slow.obj'], ['#preset=plate', 'slow.svg'], ['#preset=plate', 'slow.obj']])
  test(`reading that takes long is said and can be given up: ${file} in ${place.split('#')[0] || 'the plane'}`, async () => {
    const page = await slowPage(place), before = await name(page);
    for (const giveUp of [() => page.getByRole('button', { name: 'Cancel reading' }).click(), () => page.keyboard.press('Escape')]) {
      await open(page, file);
      await notice(page, `Reading ${file} …`).waitFor();
      assert.equal(await page.getByRole('button', { name: 'Close the notice' }).isVisible(), false);  // it would go on behind
      await giveUp();
      await notice(page, 'Reading').waitFor({ state: 'hidden' });
      await arrive(page);
      await page.waitForTimeout(300);
      assert.equal(await name(page), before);
      assert.equal(await page.locator('.notice:visible, .error-bar:visible').count(), 0);
    }
    assert.match(await page.locator('.stage-name').textContent(), /^done/);  // Escape was for the file, not for the run
    assert.deepEqual(page.errors, []);
    await page.context().close();
  });

test('what was slow is opened all the same, and its notice goes', async () => {
  const page = await slowPage('space.html#preset=saddle&size=0.3');
  await open(page, 'slow.obj');
  await notice(page, 'Reading slow.obj').waitFor();
  await arrive(page);
  await page.locator('#project-name', { hasText: 'slow.obj' }).waitFor();
  await notice(page, 'Reading').waitFor({ state: 'hidden' });
  assert.equal(await page.evaluate(() => globalThis.playground.actions.all.find(({ id }) => id === 'file.cancel').enabled()), false);
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test('of two files that are opened the second is taken, though the first comes later', async () => {
  const page = await slowPage('space.html#preset=saddle&size=0.3');
  await open(page, 'first.obj');
  await page.waitForFunction(() => globalThis.arrive);
  await page.evaluate(() => {
    globalThis.arriveFirst = globalThis.arrive;
    globalThis.arrive = undefined;
  });
  await open(page, 'second.obj');
  await page.waitForFunction(() => globalThis.arrive);
  await arrive(page);
  await page.locator('#project-name', { hasText: 'second.obj' }).waitFor();
  await page.evaluate(() => globalThis.arriveFirst());
  await page.waitForTimeout(300);
  assert.equal(await name(page), 'second.obj');
  assert.equal(await page.locator('.notice:visible').count(), 0);
  assert.deepEqual(page.errors, []);
  await page.context().close();
});
