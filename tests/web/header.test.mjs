// The bar at the top and the ways round the page, as a person uses them.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { startPlayground } from './support.mjs';

let playground;
before(async () => { playground = await startPlayground(); });
after(() => playground.close());

test('the theme can be chosen, is drawn, and is kept', async () => {
  const page = await playground.open({ dark: true });
  const background = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  const system = await background();
  await page.click('[data-action="page.theme"]');
  const light = await background();
  assert.notEqual(light, system);
  await page.reload();
  assert.equal(await background(), light);
  await page.click('[data-action="page.theme"]');
  assert.equal(await background(), system);
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test('the help lists every action with its keys, finds them, and runs them', async () => {
  const page = await playground.open();
  await page.keyboard.press('?');
  const dialog = page.getByRole('dialog', { name: 'Help' });
  await dialog.waitFor();
  for (const label of ['Undo', 'Play or pause', 'Show all']) assert.equal(await dialog.getByRole('button', { name: label }).count(), 1);
  assert.equal(await dialog.locator('li', { hasText: /^Undo/ }).locator('kbd').first().textContent(), 'Ctrl+Z');
  await dialog.getByRole('searchbox').fill('colour or light');
  assert.equal(await dialog.locator('li:visible').count(), 0);
  await dialog.getByRole('searchbox').fill('as the system');
  assert.equal(await dialog.locator('li:visible').count(), 1);
  await dialog.locator('li:visible button').click();
  assert.equal(await page.evaluate(() => document.documentElement.dataset.scheme), 'light');
  assert.equal(await dialog.isVisible(), false);
  await page.keyboard.press('?');
  await page.keyboard.press('Escape');
  assert.equal(await dialog.isVisible(), false);
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

for (const place of ['', 'space.html'])
  test(`a dialog keeps the keyboard when nothing in it has the focus, and Escape closes it: ${place || 'plane'}`, async () => {
    const page = await playground.open({ hash: place });
    const phase = () => page.evaluate(() => { const { run, going } = globalThis.playground.runner; return `${run.phase} ${going}`; });
    await page.locator('.stage-name', { hasText: /^done/ }).waitFor();
    for (const opener of ['page.help', ...place ? [] : ['page.share']]) {
      const before = await phase();
      await page.click(`[data-action="${opener}"]`);
      await page.evaluate(() => document.activeElement.blur());  // as Tab does at its end
      await page.keyboard.press('Space');
      assert.equal(await phase(), before);
      await page.keyboard.press('Escape');
      await page.waitForFunction(() => document.querySelector('dialog[open]') === null, null, { timeout: 5000 });
      assert.equal(await page.evaluate(() => document.activeElement.dataset.action), opener);
    }
    assert.deepEqual(page.errors, []);
    await page.context().close();
  });

test('the help has words for every group, and a key does one thing at a time', async () => {
  const page = await playground.open();
  await page.keyboard.press('?');
  const headings = await page.locator('dialog h3').allTextContents();
  for (const heading of headings) assert.match(heading, /^[A-Z]/);
  assert.equal(new Set(headings).size, headings.length);
  assert.equal(await page.locator('dialog li', { hasText: /^Next vertex/ }).locator('kbd').textContent(), 'N');
  const shared = await page.evaluate(() => {
    const { actions } = globalThis.playground, keys = actions.all.flatMap(({ keys: own = [] }) => own);
    return keys.filter((key, i) => keys.indexOf(key) !== i);
  });
  assert.deepEqual(shared, ['Escape', 'N']);  // the file that is read, else the run; the page of the tour, where that is read, and elsewhere the vertex
  await page.context().close();
});

for (const [place, parts] of [['', ['HEADER', 'NAV', 'MAIN', 'FOOTER', 'ASIDE']], ['space.html', ['HEADER', 'MAIN', 'FOOTER', 'ASIDE']]])
  test(`F6 goes round the parts of the page, Shift+F6 back: ${place || 'plane'}`, async () => {
    const page = await playground.open({ hash: place });
    await page.locator('.stage-name', { hasText: /./ }).waitFor();
    const at = () => page.evaluate(() => document.activeElement?.closest('#tools, header, main, footer, aside')?.tagName);
    for (const [key, order] of [['F6', parts], ['Shift+F6', [...parts].reverse()]]) {
      const seen = [];
      await page.evaluate(() => document.activeElement?.blur());
      for (let k = 0; k < parts.length; ++k) {
        await page.keyboard.press(key);
        seen.push(await at());
      }
      const first = order.indexOf(seen[0]);  // backwards it begins before the first part
      assert.deepEqual(seen, order.map((_, k) => order[(first + k) % order.length]), key);
    }
    assert.deepEqual(page.errors, []);
    await page.context().close();
  });

test('no button lacks a name or shows a character for a picture', async () => {
  const page = await playground.open();
  const odd = await page.locator('button').evaluateAll((buttons) =>
    buttons.filter((b) => !(b.getAttribute('aria-label') ?? b.textContent).trim() || /[^\x20-\x7e…ηθτ₀-₉×–’ïé]/.test(b.textContent)).map((b) => b.outerHTML));
  assert.deepEqual(odd, []);
  await page.context().close();
});

for (const place of ['', 'space.html'])
  for (const [width, height] of [[720, 450], [740, 360], [360, 740], [360, 640], [1024, 600], [640, 400], [320, 256]])
    test(`there is room to look at the mesh: ${place || 'plane'}, ${width} × ${height}`, async () => {
      const page = await playground.open({ hash: place, width, height });
      await page.locator('.stage-name', { hasText: /./ }).waitFor();
      const [stage, panel] = await page.evaluate(() => ['stage', 'panel'].map((id) => document.getElementById(id).getBoundingClientRect().toJSON()));
      assert.ok(stage.height >= 0.28 * height && stage.height >= 190 && stage.width >= 300, `stage ${stage.width} × ${stage.height}`);
      assert.ok(panel.height >= 150 && panel.width >= 200, `panel ${panel.width} × ${panel.height}`);
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
      if (height > 300) assert.ok(await page.evaluate(() => document.documentElement.scrollHeight <= innerHeight));
      if (width === 1024) {
        const tops = (selector) => page.locator(selector).evaluateAll((all) => new Set(all.map((one) => one.getBoundingClientRect().top)).size);
        assert.equal(await tops('[role=tab]'), 1);
        assert.ok((await page.locator('#timeline').boundingBox()).height < 60);
      }
      await page.context().close();
    });

test('the view is moved by keys: nearer, farther, and by arrows where nothing is chosen; compared meshes too', async () => {
  const page = await playground.open();
  await page.locator('.stage-name', { hasText: /^done/ }).waitFor();
  const view = () => page.evaluate(() => ({ ...globalThis.playground.stage.view }));
  const middle = ({ left, top, width, height, scale }) => [left + width / 2 / scale, top - height / 2 / scale];
  const first = await view();
  await page.focus('#overlay-canvas');
  await page.keyboard.press('+');
  const near = await view();
  assert.ok(Math.abs(near.scale / first.scale - 1.2) < 1e-9);
  middle(near).forEach((at, i) => assert.ok(Math.abs(at - middle(first)[i]) < 1e-9));
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('ArrowUp');
  const moved = await view();
  assert.ok(middle(moved)[0] > middle(near)[0] && middle(moved)[1] > middle(near)[1]);
  await page.keyboard.press('-');
  assert.ok(Math.abs((await view()).scale / first.scale - 1) < 1e-9);
  await page.keyboard.press('n');  // now an arrow moves the vertex
  const before = await view();
  await page.keyboard.press('ArrowLeft');
  assert.deepEqual(await view(), before);
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Shift+C');
  const side = page.locator('.side-stage canvas[role=img]').first();
  await page.locator('.side-head output', { hasText: /^done/ }).first().waitFor();
  await side.focus();
  const pictures = () => page.locator('.side-stage canvas:first-child').evaluateAll((all) => all.map((one) => one.toDataURL()));
  for (const key of ['ArrowDown', '+']) {
    const were = await pictures();
    await page.keyboard.press(key);
    await page.waitForFunction((were) => [...document.querySelectorAll('.side-stage canvas:first-child')].every((one, i) => one.toDataURL() !== were[i]), were, { timeout: 10000 });
  }
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

for (const place of ['', 'space.html'])
  test(`what has the focus has all of its frame in sight: ${place || 'plane'}`, async () => {
    const page = await playground.open({ hash: place });
    await page.locator('.stage-name', { hasText: /./ }).waitFor();
    const cut = await page.evaluate(() => [...document.querySelectorAll('canvas[tabindex], [role=tab], [role=tabpanel]')].filter((one) => one.checkVisibility()).filter((one) => {
      one.focus({ focusVisible: true });
      if (document.activeElement !== one) return true;
      const { outlineOffset, outlineWidth, outlineStyle } = getComputedStyle(one);
      return outlineStyle === 'none' || parseFloat(outlineOffset) + parseFloat(outlineWidth) > 0;  // they fill what cuts them off
    }).map(({ outerHTML }) => outerHTML.slice(0, 80)));
    assert.deepEqual(cut, []);
    await page.context().close();
  });
