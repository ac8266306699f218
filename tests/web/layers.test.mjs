// Layers and inspection as a person uses them: keys, buttons, pointer, touch.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { fileURLToPath } from 'node:url';
import { after, before, test } from 'node:test';
import { serve } from '../package/server.mjs';
import { recorder, sceneOf, square } from './recorder.mjs';
import { draw } from '../../web/draw/draw.js';
import { svgPicture } from '../../web/draw/picture.js';
import { layerNames } from '../../web/layers/names.js';
import { finished, startPlayground } from './support.mjs';

let playground;
before(async () => { playground = await startPlayground(); });
after(() => playground.close());

const button = (page, name) => page.locator(`#panel [data-action="layer.${name}"]`);
const pressed = (page, name) => button(page, name).getAttribute('aria-pressed');
const heard = (page) => page.locator('#announcer').textContent();
const card = (page) => page.locator('.inspection');
/** Where a point of the drawing is on the page. */
const placeOf = (page, x, y) => page.evaluate(([x, y]) => {
  const { view, overlay } = globalThis.playground.stage, { left, top } = overlay.getBoundingClientRect();
  return [left + (x - view.left) * view.scale, top + (view.top - y) * view.scale];
}, [x, y]);

/** The middle of a quad in the left half, far from the others' marks. */
const middleOfQuad = (page) => page.evaluate(() => {
  const { points, quads, excess } = globalThis.playground.scene().frame.quads;
  for (let f = 0; 4 * f < quads.length; ++f) {
    const corners = [...quads.subarray(4 * f, 4 * f + 4)];
    const mean = (axis) => corners.reduce((sum, v) => sum + points[2 * v + axis], 0) / 4;
    const [x, y] = [mean(0), mean(1)];
    if (x > 0.2 && x < 0.5 && y > 0.2 && y < 0.5 && corners.every((v) => excess[v] === 0)) return [x, y];
  }
  throw new Error('no such quad');
});

async function openLayers(how) {
  const page = await playground.open(how);
  await finished(page);
  await page.click('#tab-layers');
  return page;
}

test('each layer has a key and a button, and tells what its colours mean', async () => {
  const page = await openLayers();
  for (const { name, key } of layerNames) {
    const was = await pressed(page, name);
    await page.keyboard.press(key);
    assert.notEqual(await pressed(page, name), was, name);
    if (was === 'true') await button(page, name).click();
  }
  const legends = page.locator('.layers .legend');
  await page.waitForFunction(() => [...document.querySelectorAll('.legend')].every((legend) => legend.childElementCount > 0));
  for (const text of await legends.allTextContents()) assert.doesNotMatch(text, /Nothing yet/);
  const quads = await page.evaluate(() => globalThis.playground.runner.run.result.quads.length / 4);
  assert.match((await legends.allTextContents()).join(' '), new RegExp(`${quads} quads`));
  for (let i = 0; i < 30 && await page.locator('[data-action="layer.auto"]').getAttribute('aria-pressed') === 'false'; ++i) await page.keyboard.press('Control+z');
  assert.equal(await page.locator('[data-action="layer.auto"]').getAttribute('aria-pressed'), 'true');
  await page.keyboard.press('a');
  assert.match(await heard(page), /stay as they are/);
  await page.keyboard.press('a');
  assert.match(await heard(page), /follow the run/);
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test('what is under the pointer is told beside it; a click pins it, the arrow keys walk on', async () => {
  const page = await openLayers();
  const [x, y] = await placeOf(page, ...await middleOfQuad(page));
  await page.mouse.move(x, y);
  await card(page).filter({ hasText: /Quad \d+.*η.*angles.*sides.*wanted.*valences/ }).waitFor();
  const box = await card(page).boundingBox();
  assert.ok(x < box.x || x > box.x + box.width || y < box.y || y > box.y + box.height, 'the card covers the pointer');
  await page.mouse.move(x, 60);
  await card(page).waitFor({ state: 'hidden' });
  await page.mouse.click(x, y);
  await page.mouse.move(x, 60);
  await card(page).waitFor();
  const first = await heard(page);
  assert.match(first, /Quad \d+ /);
  await page.keyboard.press('ArrowRight');
  await page.waitForFunction((text) => document.querySelector('#announcer').textContent !== text, first);
  assert.match(await heard(page), /Quad \d+ /);
  await card(page).getByRole('button', { name: 'Close' }).click();
  await card(page).waitFor({ state: 'hidden' });
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test('without a pointer: I takes the middle of the view', async () => {
  const page = await openLayers();
  await page.keyboard.press('i');
  await card(page).filter({ hasText: /Quad \d+/ }).waitFor();
  await page.keyboard.press('3');
  for (const key of '890') await page.keyboard.press(key);
  await card(page).filter({ hasText: /Cell of point \d+.*energy.*density.*area/ }).waitFor();
  const first = await card(page).textContent();
  await page.keyboard.press('ArrowLeft');
  await page.waitForFunction((text) => document.querySelector('.inspection').textContent !== text, first);
  await page.keyboard.press('i');
  await card(page).waitFor({ state: 'hidden' });
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test('a tap pins, a drag pans', async () => {
  const page = await openLayers({ width: 360, height: 740, touch: true });
  const [x, y] = await placeOf(page, 0.31, 0.17);
  await page.touchscreen.tap(x, y);
  await card(page).filter({ hasText: /Quad|Vertex|edge/ }).waitFor();
  const box = await card(page).boundingBox();
  assert.ok(box.x >= 0 && box.x + box.width <= 360);
  const scene = await page.evaluate(() => globalThis.playground.stage.view.left);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 40, y, { steps: 4 });
  await page.mouse.up();
  assert.ok(await page.evaluate(() => globalThis.playground.stage.view.left) < scene);
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test('what is drawn stays right while panning and zooming', async () => {
  const page = await openLayers();
  const fingerprint = () => page.evaluate(async () => {
    for (let i = 0; i < 30; ++i) await new Promise(requestAnimationFrame);
    const canvas = document.querySelector('#mesh-canvas');
    return canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data.join().length;
  });
  const before = await fingerprint();
  const [x, y] = await placeOf(page, 1, 0.5);
  await page.mouse.move(x, y);
  for (const turn of [-300, 500, -200]) await page.mouse.wheel(0, turn);
  await page.keyboard.press('f');
  assert.equal(await fingerprint(), before);
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test('the panel and the card are accessible, dark and light', async () => {
  const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
  for (const dark of [false, true]) {
    const page = await openLayers({ dark });
    for (const { name } of layerNames) if (await pressed(page, name) === 'false') await button(page, name).click();
    await page.keyboard.press('i');
    await card(page).waitFor();
    await page.evaluate(axe);
    const { violations } = await page.evaluate(() => globalThis.axe.run(document));
    assert.deepEqual(violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html).join(' ')}`), []);
    await page.context().close();
  }
});

test('pictures: SVG that an XML parser reads, PNG of the size asked for', async () => {
  const { scene, view } = sceneOf([square], { size: 0.02 }, { layers: new Set(['boundary', 'quality', 'quads', 'valence', 'sizes', 'crosses']) });
  const svg = svgPicture(scene, view);
  const record = recorder();
  draw(record.pen, scene, view);
  const server = await serve({ source: { folder: fileURLToPath(new URL('../../web', import.meta.url)) } });
  const page = await playground.open();
  const parsed = await page.evaluate((text) => {
    const parsed = new DOMParser().parseFromString(text, 'image/svg+xml');
    return { error: parsed.querySelector('parsererror')?.textContent, fills: parsed.querySelectorAll('path[fill^=rgb]').length, root: parsed.documentElement.getAttribute('viewBox') };
  }, svg);
  assert.equal(parsed.error, undefined);
  assert.equal(parsed.root, '0 0 800 600');
  assert.equal(parsed.fills, record.calls.filter(({ name, fill }) => name === 'fill' && fill.startsWith('rgb')).length);
  await page.route('**/blank', (route) => route.fulfill({ contentType: 'text/html', body: '<!doctype html>' }));
  await page.goto(`${server.origin}/blank`);
  const png = await page.evaluate(async () => {
    const [{ pngPicture }, { dark }] = await Promise.all([import('/source/draw/picture.js'), import('/source/draw/palette.js')]);
    const drawing = { regions: [{ name: '', loops: [[[0, 0], [1, 0], [1, 1], [0, 1]]] }], polylines: [], points: [] };
    const scene = { drawing, frame: null, result: null, freshness: 'current', layers: new Set(['boundary']), palette: dark, norm: 6 };
    const image = await createImageBitmap(await pngPicture(scene, { scale: 100, left: -0.5, top: 1.5, width: 200, height: 200 }, 3));
    const canvas = new OffscreenCanvas(image.width, image.height), context = canvas.getContext('2d');
    context.drawImage(image, 0, 0);
    return { width: image.width, height: image.height, corner: [...context.getImageData(2, 2, 1, 1).data], middle: [...context.getImageData(300, 300, 1, 1).data] };
  });
  assert.deepEqual(png, { width: 600, height: 600, corner: [0x0f, 0x15, 0x1c, 255], middle: [0x13, 0x1b, 0x24, 255] });
  server.close();
  await page.context().close();
});

for (const [width, height, preset] of [[360, 740, 'plate'], [360, 740, 'gear'], [844, 390, 'gear'], [1440, 900, 'plate']])
  test(`what the colours mean is said on the stage, below the drawing: ${preset}, ${width} px`, async () => {
    const page = await playground.open({ width, height, hash: `#preset=${preset}`, touch: width < 900 });
    await finished(page);
    const key = page.locator('#stage .key');
    await key.filter({ hasText: /≤ 0.5.*Quality η.*1.*1 quad too/ }).waitFor();
    assert.equal(await key.locator('.ramp').count(), 1);
    assert.doesNotMatch(await key.textContent(), /quads,|mean/, 'how many there are is for the panel');
    const box = await key.boundingBox(), stage = await page.locator('#stage').boundingBox();
    const bottom = await page.evaluate(() => {
      const { view, overlay } = globalThis.playground.stage, { loops } = globalThis.playground.store.project.drawing.regions[0];
      return overlay.getBoundingClientRect().top + (view.top - Math.min(...loops.flat().map(([, y]) => y))) * view.scale;
    });
    assert.ok(box.y >= bottom && box.y + box.height <= stage.y + stage.height, `${JSON.stringify(box)} over the drawing, which ends at ${bottom}`);
    await page.keyboard.press('9');  // quality off
    await key.filter({ hasNotText: 'Quality' }).waitFor();
    await page.keyboard.press('5');
    await key.filter({ hasText: preset === 'plate' ? /directions of the sides.*five quads will meet/ : /directions of the sides/ }).waitFor();
    for (const name of ['5', '0']) await page.keyboard.press(name);
    await page.waitForFunction(() => document.querySelector('.key').childElementCount === 0);
    assert.deepEqual(page.errors, []);
    await page.context().close();
  });

test('in space the key lies in the view of the surface', async () => {
  const page = await playground.open({ hash: 'space.html#preset=saddle&size=0.25' });
  await finished(page);
  await page.keyboard.press('7');
  await page.locator('#space-view .key', { hasText: /Quality η/ }).waitFor();
  await page.keyboard.press('3');
  await page.locator('#space-view .key', { hasText: /directions of the sides/ }).waitFor();
  assert.equal(await page.locator('#space-view .key').evaluate((key) => getComputedStyle(key).pointerEvents), 'none');
  assert.deepEqual(page.errors, []);
  await page.context().close();
});
