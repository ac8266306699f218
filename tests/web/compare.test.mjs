// Comparisons, as a person uses them, and what they are made of.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { createLpquad } from '../../dist/node.js';
import { comparisons, difference, lines, projectOf } from '../../web/compare/comparisons.js';
import { presets } from '../../web/sketch/presets.js';
import { finished, startPlayground } from './support.mjs';

let playground;
before(async () => { playground = await startPlayground(); });
after(() => playground.close());

test('each comparison changes one thing, and the library takes both sides', async () => {
  const { options: infos } = await createLpquad();
  for (const { id, sides: [a, b] } of comparisons) {
    const names = new Set([...Object.keys(a.options), ...Object.keys(b.options)]);
    const changed = [...names].filter((name) => a.options[name] !== b.options[name]);
    assert.equal(changed.length, 1, id);
    for (const name of names) assert.ok(infos.some((info) => info.name === name), name);
  }
});

test('a side keeps its mesh while nothing changes that decides it', () => {
  const [{ project }] = presets, [side] = comparisons[0].sides;
  const made = projectOf(project, side, null);
  const again = projectOf({ ...project, layers: ['quads'] }, side, { project, side, made });
  assert.equal(again.options, made.options);
  assert.deepEqual(again.layers, ['quads']);
  const other = projectOf({ ...project, options: { size: 0.1 } }, side, { project, side, made });
  assert.equal(other.options.size, 0.1);
});

test('a difference has a sign, and says whether it is for the better', () => {
  const line = (name) => lines.find((one) => one.name.startsWith(name));
  assert.deepEqual(difference(line('Squareness, mean'), { etaMean: 0.8 }, { etaMean: 0.95 }), { text: '+0.150', good: 1 });
  assert.deepEqual(difference(line('Irregular'), { irregular: 8 }, { irregular: 12 }), { text: '+4', good: -1 });
  assert.deepEqual(difference(line('Quads'), { quads: 1200 }, { quads: 100 }), { text: '−1,100', good: 0 });
  assert.deepEqual(difference(line('Triangles'), { triangles: 0 }, { triangles: 0 }), { text: '0', good: 0 });
  assert.deepEqual(difference(line('Right angles'), {}, { tau: 1 }), { text: '–', good: 0 });
});

const both = (page) => page.waitForFunction(() => {
  const led = globalThis.playground.led();
  return led.length === 2 && led.every(({ run }) => run.phase === 'done');
});

/** A preset in both norms, meshed: the page, and the reports of the two. */
async function compareNorms(preset) {
  const page = await playground.open({ hash: `#preset=${preset}` });
  await finished(page);
  await page.getByRole('tab', { name: 'Compare' }).click();
  await page.getByRole('radio', { name: 'p = 2 and p = 6' }).check();
  await both(page);
  return { page, reports: await page.evaluate(() => globalThis.playground.led().map(({ run }) => run.result.report)) };
}

test('two meshes side by side, one clock, one view, and a table of what differs', async () => {
  const page = await playground.open();
  await finished(page);
  await page.getByRole('tab', { name: 'Compare' }).click();
  await page.getByRole('radio', { name: 'Without and with Lp' }).check();
  await both(page);
  const table = page.getByRole('table', { name: 'Differences' });
  const row = async (name) => (await table.getByRole('row', { name }).getByRole('cell').allTextContents());
  const [a, b, by] = await row(/mean η/);
  assert.ok(Number(b) > Number(a), `${a} ${b}`);
  assert.ok(by.startsWith('+'));
  assert.match(await page.getByRole('group', { name: 'Mesh B' }).textContent(), /80 iterations of Lp.*done: .* quads/);

  await page.keyboard.press('Shift+E');  // one clock
  await page.waitForFunction(() => globalThis.playground.led().every(({ run }) => run.state.tick === 0 && run.frame.tick === 0));
  await page.keyboard.press('.');
  await page.waitForFunction(() => globalThis.playground.led().every(({ run }) => run.frame.tick === 1));
  const [first, second] = await page.evaluate(() => globalThis.playground.led().map(({ run }) => JSON.stringify([...(run.frame.triangles ?? run.frame.cells).points])));
  assert.equal(first.length > 1000, true);
  await page.keyboard.press('e');
  await both(page);

  const canvas = page.locator('.side-stage canvas[role=img]').first();  // one view
  const box = await canvas.boundingBox();
  const leftmost = () => page.locator('.side-stage canvas[aria-hidden]').evaluateAll((all) => all.map((one) => {
    const { width, height } = one;
    const { data } = one.getContext('2d').getImageData(0, 0, width, height);
    for (let x = 0; x < width; ++x) for (let y = 0; y < height; ++y) if (data[4 * (y * width + x) + 3] > 0) return x;
    return -1;
  }));
  const [start] = await leftmost();
  await page.mouse.move(box.x + 30, box.y + 30);
  await page.mouse.down();
  await page.mouse.move(box.x + 90, box.y + 50, { steps: 3 });
  await page.mouse.up();
  await page.waitForTimeout(300);
  const [left, right] = await leftmost();
  assert.ok(Math.abs(left - start - 60) <= 2 && Math.abs(left - right) <= 2, `${start} ${left} ${right}`);

  await page.getByRole('button', { name: 'End the comparison' }).click();
  await finished(page);
  assert.equal(await page.locator('#compare').isVisible(), false);
  assert.equal(await page.evaluate(() => globalThis.playground.led().length), 1);
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test('every comparison runs on a phone, stacked, by keyboard, and is undone', async () => {
  const page = await playground.open({ width: 360, height: 740, touch: true });
  await finished(page);
  for (const { id, sides } of comparisons) {
    await page.keyboard.press('Shift+C');
    assert.equal(await page.evaluate(() => globalThis.playground.store.project.comparison), id);
    await both(page);
    const [a, b] = await page.evaluate(() => [...document.querySelectorAll('.side-stage')].map((one) => one.getBoundingClientRect().toJSON()));
    assert.ok(b.top >= a.bottom && a.height > 60 && b.height > 60 && a.width <= 360, `${a.height} ${b.height}`);
    const used = await page.evaluate(() => globalThis.playground.led().map(({ run }) => run.result.report.options));
    sides.forEach(({ options }, i) => Object.entries(options).forEach(([name, value]) => assert.equal(used[i][name], value, `${id} ${name}`)));
  }
  for (let i = 0; i < comparisons.length; ++i) await page.keyboard.press('Control+z');
  assert.equal(await page.locator('#compare').isVisible(), false);
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test('a change of the drawing runs both again; meanwhile both are out of date', async () => {
  const page = await playground.open();
  await finished(page);
  await page.keyboard.press('Shift+C');
  await both(page);
  await page.evaluate(() => {
    globalThis.drag = (width) => globalThis.playground.store.change('Move', ({ drawing }) => ({
      drawing: { ...drawing, regions: [{ name: '', loops: [[[0, 0], [width, 0], [width, 1], [0, 1]]] }] },
    }), 'move 1');
    globalThis.drag(1.5);
  });
  assert.deepEqual(await page.locator('.side-stage').evaluateAll((all) => all.map((one) => one.dataset.freshness)), ['old', 'old']);
  await page.evaluate(() => { globalThis.drag(1.75); globalThis.playground.store.settle(); });
  await page.waitForFunction(() => {
    const led = globalThis.playground.led();
    return led.every(({ run }) => run.phase === 'done' && Math.max(...run.frame.quads.points) === 1.75);
  });
  assert.deepEqual(await page.locator('.side-stage').evaluateAll((all) => all.map((one) => one.dataset.freshness)), ['current', 'current']);
  await page.context().close();
});

test('figures, fingerprint and legends are of the side that is chosen', async () => {
  const { page, reports } = await compareNorms('gear');
  const hashes = reports.map(({ hash }) => hash);
  assert.ok(!hashes.includes(await page.evaluate(() => globalThis.playground.runner.run.result?.report.hash)));
  for (const [at, name] of [[1, 'B: p = 6'], [0, 'A: p = 2']]) {
    await page.getByRole('tab', { name: 'Figures' }).click();
    const choice = page.locator('#panel-figures').getByRole('button', { name });
    if (at === 0) await choice.click();
    assert.equal(await choice.getAttribute('aria-pressed'), 'true');
    await page.locator('.hash', { hasText: reports[at].hash }).waitFor();
    assert.equal(Number(await page.locator('[data-figure="etaMean"]').getAttribute('data-value')), reports[at].quality.etaMean);
    await page.getByRole('tab', { name: 'Layers' }).click();
    await page.locator('.legend', { hasText: `${reports[at].quality.fourValentPercent.toFixed(1)} % of` }).waitFor();
  }
  await page.keyboard.press('Control+z');
  await page.getByRole('tab', { name: 'Figures' }).click();
  assert.equal(await page.locator('#panel-figures .side-choice').isVisible(), false);
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test('what leaves the page is of the side that is chosen, and says so', async () => {
  const { page, reports } = await compareNorms('square');
  assert.notEqual(reports[0].hash, reports[1].hash);
  await page.getByRole('tab', { name: 'Files' }).click();
  const panel = page.locator('#panel-files');
  const saved = async (name) => {
    const [download] = await Promise.all([page.waitForEvent('download'), panel.getByRole('button', { name }).click()]);
    return { name: download.suggestedFilename(), text: readFileSync(await download.path(), 'utf8') };
  };
  for (const [at, letter, name] of [[1, 'B', 'B: p = 6'], [0, 'A', 'A: p = 2']]) {
    const choice = panel.getByRole('button', { name });
    if (at === 0) await choice.click();
    assert.equal(await choice.getAttribute('aria-pressed'), 'true');
    assert.equal(await panel.locator('.fingerprint').textContent(), reports[at].hash);
    const mesh = await saved('Download .json'), report = await saved('Report of the run');
    assert.equal(mesh.name, `square-${letter}.json`);
    assert.equal(JSON.parse(mesh.text).quads.length, reports[at].quads);
    assert.equal(report.name, `square-${letter}.report.json`);
    assert.equal(JSON.parse(report.text).hash, reports[at].hash);
    assert.equal(/norm: 2/.test(await panel.locator('.code').textContent()), at === 0);
    assert.equal((await saved('Picture (.svg)')).name, `square-${letter}.picture.svg`);
  }
  const pictures = [];
  for (const name of ['A: p = 2', 'B: p = 6']) {
    await panel.getByRole('button', { name }).click();
    pictures.push((await saved('Picture (.svg)')).text);
  }
  assert.notEqual(pictures[0], pictures[1]);
  await page.keyboard.press('Control+z');
  await finished(page);
  assert.equal(await panel.locator('.side-choice').isVisible(), false);
  assert.equal((await saved('Download .json')).name, 'square.json');
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

for (const [width, height] of [[360, 740], [1440, 900]])
  test(`what the colours mean is said beside both meshes: ${width} px`, async () => {
    const page = await playground.open({ width, height, hash: '#preset=plate&comparison=lp' });
    await page.locator('#compare canvas').first().waitFor();
    const key = page.locator('.key', { hasText: 'Quality η' });
    await key.waitFor();
    const [inSight, above] = await key.evaluate((element) => {
      const { left, top, width, height } = element.getBoundingClientRect(), compare = document.querySelector('#compare').getBoundingClientRect();
      element.style.pointerEvents = 'auto';  // to be found at its place
      const found = document.elementFromPoint(left + width / 2, top + height / 2);
      return [top >= compare.top && top + height <= compare.bottom, element.contains(found)];
    });
    assert.ok(inSight && above, `in sight ${inSight}, above the meshes ${above}`);
    assert.deepEqual(page.errors, []);
    await page.context().close();
  });
