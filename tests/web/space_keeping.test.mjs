// What is on the page for surfaces outlives it: on the way to the plane and back, and when it is loaded again.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { finished, startPlayground } from './support.mjs';

let playground;
before(async () => { playground = await startPlayground(); });
after(() => playground.close());

/** A square of two triangles, bent a little. */
const bent = { name: 'bent.obj', mimeType: 'model/obj', buffer: Buffer.from('v 0 0 0\nv 1 0 0.1\nv 1 1 0\nv 0 1 0.1\nf 1 2 3\nf 1 3 4\n') };
const work = (page) => page.evaluate(() => {
  const { name, preset, options, layers, surface } = globalThis.playground.store.project;
  return { name, preset, options, layers, triangles: surface.triangles.length / 3, points: [...surface.points].slice(0, 12) };
});
const ready = (page) => page.waitForFunction(() => globalThis.playground !== undefined);
const go = async (page, place) => {
  await page.locator('header nav').getByRole('link', { name: place }).click();
  await page.waitForURL((url) => url.pathname.endsWith('space.html') === (place === 'Space'));
  await ready(page);
};
const opened = async (page, file = bent) => {
  await page.locator('input[type=file]').setInputFiles(file);
  await page.locator('#project-name', { hasText: file.name }).waitFor();
  await page.evaluate(() => globalThis.playground.store.change('Size', { options: { size: 0.2, turn: 20 }, layers: ['quads', 'charts'] }));
  await finished(page);
  return work(page);
};

test('a preset with its options and layers is there again after a look at the plane', async () => {
  const page = await playground.open({ hash: 'space.html#preset=saddle&size=0.3&layers=quads' });
  await finished(page);
  const before = await work(page);
  await go(page, 'Plane');
  await go(page, 'Space');
  assert.deepEqual(await work(page), before);
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test('so is a file, also when the page is loaded again, until another link is opened', async () => {
  const page = await playground.open({ hash: 'space.html#preset=saddle&size=0.3' });
  await finished(page);
  const before = await opened(page);
  await go(page, 'Plane');
  await go(page, 'Space');
  assert.deepEqual(await work(page), before);
  await finished(page);
  await page.reload();
  await ready(page);
  assert.deepEqual(await work(page), before);
  await page.goto(`${playground.address}?another#`);
  await page.goto(`${playground.address}space.html#preset=gear&size=0.3`);
  await ready(page);
  assert.equal((await work(page)).preset, 'gear');
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test('a file that the browser does not keep is missed in words', async () => {
  const page = await playground.open({ hash: 'space.html#preset=saddle&size=0.3' });
  await page.evaluate(() => { IDBFactory.prototype.open = () => { throw new DOMException('refused', 'SecurityError'); }; });
  await page.locator('input[type=file]').setInputFiles(bent);
  await page.locator('.notice', { hasText: 'does not keep bent.obj' }).waitFor();
  await finished(page);
  await go(page, 'Plane');
  await go(page, 'Space');
  await page.locator('.notice', { hasText: 'bent.obj was here last' }).waitFor();
  assert.equal((await work(page)).preset, 'panel');
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test('a link that names no surface says so and leaves what was there last', async () => {
  const page = await playground.open({ hash: 'space.html#preset=saddle&size=0.3' });
  await finished(page);
  const before = await work(page);
  await page.evaluate(() => { location.hash = '#preset=nonsense'; });
  await page.locator('.notice', { hasText: 'no surface “nonsense”' }).waitFor();
  assert.deepEqual(await work(page), before);
  await page.reload();
  await ready(page);
  await page.locator('.notice', { hasText: 'no surface “nonsense”' }).waitFor();
  assert.deepEqual(await work(page), before);
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test('a link with options that cannot be says so, and is not kept', async () => {
  const page = await playground.open({ hash: 'space.html#preset=saddle&size=0.3' });
  await finished(page);
  const before = await work(page);
  for (const [bad, words] of [['size=abc', 'size is a number'], ['x=1', 'there is no option “x”']]) {
    await page.goto('about:blank');
    await page.goto(`${playground.address}space.html#preset=torus&${bad}`);
    await ready(page);
    await page.locator('.notice', { hasText: `This link could not be opened: ${words}.` }).waitFor();
    assert.deepEqual(await work(page), before);
  }
  await finished(page);
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test('a file over the page is shown to be welcome; one of no use hears what would be', async () => {
  const page = await playground.open({ hash: 'space.html#preset=saddle&size=0.3' });
  const fire = (kind, types) => page.evaluate(([kind, types]) => {
    const transfer = new DataTransfer();
    if (types === 'Files') transfer.items.add(new File(['x'], 'notes.md'));
    else transfer.setData('text/plain', 'x');
    window.dispatchEvent(new DragEvent(kind, { dataTransfer: transfer, cancelable: true }));
    return document.querySelector('#stage').classList.contains('dropping');
  }, [kind, types]);
  assert.equal(await fire('dragover', 'text'), false);
  assert.equal(await fire('dragover', 'Files'), true);
  assert.equal(await fire('dragleave', 'Files'), false);
  await page.locator('input[type=file]').setInputFiles({ name: 'notes.md', mimeType: 'text/plain', buffer: Buffer.from('# Notes') });
  await page.locator('.notice', { hasText: /notes\.md.*\.stl.*\.step, \.iges and \.brep/ }).waitFor();
  assert.deepEqual(page.errors, []);
  await page.context().close();
});
