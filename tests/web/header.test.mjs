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
