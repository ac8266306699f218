// The page for surfaces as a person uses it.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { startPlayground } from './support.mjs';
import { violations } from './violations.mjs';

let playground;
before(async () => { playground = await startPlayground(); });
after(() => playground.close());

const patience = 180000;
const over = (page) => page.locator('.stage-name', { hasText: /^done/ }).waitFor({ timeout: patience });
const run = (page) => page.evaluate(() => {
  const { phase, result, frame } = globalThis.playground.runner.run;
  return { phase, hash: result?.report.hash, quads: result?.report.quads, charts: frame.charts ? Math.max(...frame.charts.charts) + 1 : 0 };
});

async function openSpace(hash = '#preset=saddle&size=0.25', how = {}) {
  const page = await playground.open({ ...how, hash: `space.html${hash}` });
  await over(page);
  return page;
}

/** An open box of two triangles a side, as ASCII STL. */
function boxStl() {
  const p = (i) => [i & 1, (i >> 1) & 1, (i >> 2) & 1].join(' ');
  const sides = [[0, 2, 3, 1], [0, 1, 5, 4], [1, 3, 7, 5], [3, 2, 6, 7], [2, 0, 4, 6]];
  const facet = (a, b, c) => `facet normal 0 0 0\nouter loop\nvertex ${p(a)}\nvertex ${p(b)}\nvertex ${p(c)}\nendloop\nendfacet\n`;
  return `solid box\n${sides.map(([a, b, c, d]) => facet(a, b, c) + facet(a, c, d)).join('')}endsolid box\n`;
}

test('a preset is meshed at once, and every layer can be shown', async () => {
  const page = await openSpace();
  const { quads, charts } = await run(page);
  assert.ok(quads > 50 && charts >= 1);
  await page.getByRole('tab', { name: 'Layers' }).click();
  for (const name of ['Surface', 'Sharp edges', 'Cross field', 'Charts', 'Cells', 'Quads', 'Quality η', 'Irregular vertices']) {
    const button = page.locator('.layers').getByRole('button', { name, exact: true });
    const was = await button.getAttribute('aria-pressed');
    await button.click();
    await page.locator(`.layers button[aria-pressed="${was === 'true' ? 'false' : 'true'}"]`, { hasText: name }).waitFor();
  }
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test('of several files that are dropped the surface is opened, wherever it stands', async () => {
  const page = await openSpace();
  await page.evaluate((stl) => {
    const data = new DataTransfer();
    for (const [name, text] of [['readme.md', 'Words.'], ['box.stl', stl]]) data.items.add(new File([text], name));
    document.getElementById('stage').dispatchEvent(new DragEvent('drop', { dataTransfer: data, bubbles: true, cancelable: true }));
  }, boxStl());
  await page.locator('#project-name', { hasText: 'box.stl' }).waitFor({ timeout: patience });
  assert.equal(await page.locator('.notice:visible').count(), 0);
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test('the preset on the screen is the one that is pressed, and no other once a file is', async () => {
  const page = await openSpace();
  const pressed = () => page.locator('.space-presets button[aria-pressed="true"]').evaluateAll((all) => all.map(({ dataset }) => dataset.action));
  assert.deepEqual(await pressed(), ['preset.saddle']);
  await page.locator('[data-action="preset.panel"]').click();
  assert.deepEqual(await pressed(), ['preset.panel']);
  await page.locator('input[type=file]').setInputFiles({ name: 'box.stl', mimeType: 'model/stl', buffer: Buffer.from(boxStl()) });
  await page.locator('#project-name', { hasText: 'box.stl' }).waitFor({ timeout: patience });
  assert.deepEqual(await pressed(), []);
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test('the planes are drawn when what they show has changed, not at every step', async () => {
  const page = await openSpace();
  const { drawn, steps, changes } = await page.evaluate(async () => {
    const { runner, store } = globalThis.playground;
    const context = document.querySelector('#plane-view canvas').getContext('2d');
    const counts = { drawn: 0, steps: 0, changes: 0 };
    const { setTransform } = context;
    context.setTransform = (...matrix) => { ++counts.drawn; setTransform.apply(context, matrix); };
    let before = runner.run;
    const stop = runner.subscribe((run) => {
      ++counts.steps;
      if (['charts', 'cells'].some((part) => run.frame[part] !== before.frame[part]) || run.result !== before.result) ++counts.changes;
      before = run;
    });
    await runner.start(store.project);
    await new Promise((painted) => requestAnimationFrame(() => requestAnimationFrame(painted)));
    stop();
    return counts;
  });
  assert.ok(drawn >= 2 && drawn <= changes, `${drawn} pictures of ${changes} changes`);
  assert.ok(steps > changes);
  await page.context().close();
});

test('the picture changes when the surface is turned by key', async () => {
  const page = await openSpace();
  const canvas = page.locator('#space-view canvas');
  const picture = () => page.evaluate(() => globalThis.playground.viewer.canvas.toDataURL());
  const first = await picture();
  await canvas.focus();
  await page.keyboard.press('ArrowLeft');
  await page.waitForFunction((old) => globalThis.playground.viewer.canvas.toDataURL() !== old, first);
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test('all of the surface stays in view when the view becomes high and narrow, unless it was turned', async () => {
  const page = await openSpace('#preset=saddle&size=0.3', { width: 1440, height: 500 });
  const far = () => page.evaluate(() => new Promise((done) => {
    const { camera, controls } = globalThis.playground.viewer;
    requestAnimationFrame(() => requestAnimationFrame(() => done(camera.position.distanceTo(controls.target))));
  }));
  const first = await far();
  await page.setViewportSize({ width: 1440, height: 1400 });
  await page.waitForFunction((old) => { const { camera, controls } = globalThis.playground.viewer; return camera.position.distanceTo(controls.target) > old; }, first);
  await page.locator('#space-view canvas').focus();
  await page.keyboard.press('ArrowLeft');
  const turned = await far();
  await page.setViewportSize({ width: 1440, height: 1600 });
  assert.ok(Math.abs(await far() - turned) < 1e-9);
  await page.context().close();
});

test('a chart that is pointed at lights up in both views', async () => {
  const page = await openSpace('#preset=bored&size=0.2');
  await page.keyboard.press('4');
  await page.locator('#plane-view canvas').focus();
  await page.keyboard.press('ArrowRight');
  assert.equal(await page.evaluate(() => globalThis.playground.pointed.chart), 0);
  const place = await page.evaluate(() => {
    const { x, y, width, height } = document.querySelector('#plane-view').getBoundingClientRect();
    return { x, y, width, height };
  });
  let found = -1;
  for (let i = 1; i < 20 && found < 0; ++i) {
    await page.mouse.move(place.x + place.width * i / 20, place.y + place.height * 0.4);
    found = await page.evaluate(() => globalThis.playground.pointed.chart);
  }
  assert.ok(found >= 0);
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test('a chart lights up in both views with the layers that a finished mesh has', async () => {
  const page = await openSpace('#preset=bored&size=0.2');
  assert.ok(!await page.evaluate(() => globalThis.playground.layers().has('charts')));
  const pictures = () => page.evaluate(() => new Promise((done) => {
    const canvases = [globalThis.playground.viewer.canvas, document.querySelector('#plane-view canvas')];
    requestAnimationFrame(() => requestAnimationFrame(() => done(canvases.map((canvas) => canvas.toDataURL()))));
  }));
  const before = await pictures();
  const { x, y, width, height } = await page.locator('#space-view canvas').boundingBox();
  await page.mouse.move(x + width / 2, y + height * 0.7);
  const inSpace = await page.evaluate(() => globalThis.playground.pointed.chart);
  assert.ok(inSpace >= 0, 'no chart is found under the quads');
  const lit = await pictures();
  assert.ok(lit.every((picture, i) => picture !== before[i]), 'a view shows nothing');
  await page.locator('#plane-view canvas').focus();
  await page.keyboard.press('ArrowRight');
  const next = await pictures();
  assert.ok(next.every((picture, i) => picture !== lit[i]), 'a view does not follow the key');
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test('a run that fails says why over the view until another is begun, and is undone there', async () => {
  const page = await openSpace();
  const { hash } = await run(page);
  const bar = page.locator('#space-view .error-bar');
  const size = (value) => page.evaluate((size) => globalThis.playground.store.change('Size', { options: { size } }), value);
  await size(0.00001);
  await bar.getByText('“Most elements”').waitFor({ timeout: patience });
  assert.doesNotMatch(await bar.textContent(), /maxElements|e\+\d/);
  assert.match(await page.locator('.stage-name').textContent(), /^failed: [a-z ]+$/);
  assert.deepEqual(await violations(page), []);
  await size(0.2);
  await bar.waitFor({ state: 'hidden' });
  await over(page);
  assert.ok(await bar.isHidden());
  assert.ok(await page.locator('.notice').isHidden());
  await size(0.00001);
  await bar.getByRole('button', { name: 'Undo' }).click();
  await over(page);
  await size('nonsense');
  await bar.getByRole('button', { name: 'Usual options' }).click();
  await bar.waitFor({ state: 'hidden' });
  await over(page);
  assert.notEqual((await run(page)).hash, hash);
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test('a run goes to the end without pictures on the way, and shows all of them then', async () => {
  const page = await openSpace('#preset=saddle&size=0.25', { still: false });
  await page.evaluate(() => {
    const { runner, store } = globalThis.playground;
    globalThis.pictures = 0;
    let frame = {};
    runner.subscribe((run) => {
      if (['cells', 'quads'].some((part) => run.frame[part] && run.frame[part] !== frame[part])) ++globalThis.pictures;
      frame = run.frame;
    });
    store.change('Size', { options: { size: 0.15 } });
  });
  await page.waitForFunction(() => globalThis.playground.runner.run.phase === 'running');
  await page.keyboard.press('e');
  await over(page);
  const { pictures, layers, hash } = await page.evaluate(() => ({ pictures: globalThis.pictures, layers: Object.keys(globalThis.playground.runner.run.frame),
    hash: globalThis.playground.runner.run.result.report.hash }));
  assert.equal(pictures, 1);
  for (const layer of ['features', 'crosses', 'charts', 'quads']) assert.ok(layers.includes(layer), layer);
  await page.evaluate(() => globalThis.playground.runner.start(globalThis.playground.store.project));
  assert.equal((await run(page)).hash, hash);
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test('a run on the way to the end can be held, and is looked at there', async () => {
  const page = await openSpace();
  await page.evaluate(() => {
    const { runner, store } = globalThis.playground;
    runner.subscribe(({ state, paused }) => { if (state?.stage === 'seams' && !paused && !globalThis.held) runner.pause(globalThis.held = true); });
    store.change('Size', { options: { size: 0.1 } });
    runner.end();
  });
  await page.locator('.stage-name', { hasText: /\(paused\)/ }).waitFor({ timeout: patience });
  await page.keyboard.press('.');
  await page.waitForFunction(() => { const { frame } = globalThis.playground.runner.run; return frame.quads && frame.charts && frame.features; });
  await page.keyboard.press('e');
  await over(page);
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test('an option is changed, undone, and said in the address', async () => {
  const page = await openSpace();
  const { hash, quads } = await run(page);
  await page.getByRole('tab', { name: 'Mesh' }).click();
  await page.locator('#option-size').fill('0.15');
  await page.keyboard.press('Enter');
  await page.waitForFunction((old) => { const { phase, result } = globalThis.playground.runner.run; return phase === 'done' && result.report.quads > old; },
    quads, { timeout: patience });
  await page.waitForFunction(() => location.hash.includes('preset=saddle&size=0.15'));
  await page.locator('header').getByRole('button', { name: 'Undo' }).click();
  assert.match(await page.locator('#announcer').textContent(), /^Undone: Size of the quads/);
  await page.waitForFunction((old) => globalThis.playground.runner.run.result?.report.hash === old, hash, { timeout: patience });
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test('a link opens though the address bar has followed something else meanwhile', async () => {
  const page = await openSpace();
  const { quads } = await run(page);
  await page.evaluate(() => {
    const { hash } = location;
    location.hash = '#preset=saddle&size=0.15';
    history.replaceState(null, '', hash);  // before the browser tells of the change
  });
  await page.waitForFunction((old) => { const { phase, result } = globalThis.playground.runner.run; return phase === 'done' && result.report.quads > old; },
    quads, { timeout: patience });
  await page.context().close();
});

test('a file is opened, meshed and saved', async () => {
  const page = await openSpace();
  await page.locator('input[type=file]').setInputFiles({ name: 'box.stl', mimeType: 'model/stl', buffer: Buffer.from(boxStl()) });
  await page.locator('#project-name', { hasText: 'box.stl' }).waitFor({ timeout: patience });
  await over(page);
  await page.getByRole('tab', { name: 'Files' }).click();
  await page.getByLabel('Language').selectOption('Command line');
  await page.locator('pre.code', { hasText: /^lpquad mesh 'box\.stl' -o box-quads\.msh --size / }).waitFor();
  const [saved] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: 'Download .obj' }).click()]);
  const text = readFileSync(await saved.path(), 'utf8');
  assert.equal(saved.suggestedFilename(), 'box.obj');
  assert.equal(text.match(/^f \d+ \d+ \d+ \d+$/gm).length, (await run(page)).quads);
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test('what cannot be read is said in words', async () => {
  const page = await openSpace();
  await page.locator('input[type=file]').setInputFiles({ name: 'x.stl', mimeType: 'model/stl', buffer: Buffer.from('solid nothing') });
  await page.locator('.notice', { hasText: 'x.stl could not be opened' }).waitFor({ timeout: patience });
  assert.equal((await run(page)).phase, 'done');
  await page.context().close();
});

test('a surface that is opened in the plane goes to space, and a drawing back', async () => {
  const page = await playground.open();
  await page.locator('input[type=file]').first().setInputFiles({ name: 'box.stl', mimeType: 'model/stl', buffer: Buffer.from(boxStl()) });
  await page.waitForURL(/space\.html/, { timeout: patience });
  await page.locator('#project-name', { hasText: 'box.stl' }).waitFor({ timeout: patience });
  const square = { loops: [[[0, 0], [1, 0], [1, 1], [0, 1]]] };
  await page.locator('input[type=file]').first().setInputFiles({ name: 'square.json', mimeType: 'application/json', buffer: Buffer.from(JSON.stringify(square)) });
  await page.waitForURL((url) => !url.pathname.endsWith('space.html'), { timeout: patience });
  await page.waitForFunction((loops) => JSON.stringify(globalThis.playground?.store.project.drawing.regions[0].loops) === loops,
    JSON.stringify(square.loops), { timeout: patience });
  await page.context().close();
});

test('what cannot be handed to the other page is refused in words, on both', async () => {
  const box = { name: 'box.stl', mimeType: 'model/stl', buffer: Buffer.from(boxStl()) };
  const square = { name: 'square.json', mimeType: 'application/json', buffer: Buffer.from('{"loops": [[[0, 0], [1, 0], [1, 1]]]}') };
  for (const [address, file, words] of [['', box, '.error-bar'], ['space.html#preset=saddle&size=0.25', square, '.notice']]) {
    const page = await playground.open({ hash: address });
    await page.evaluate(() => { IDBFactory.prototype.open = () => { throw new DOMException('refused', 'SecurityError'); }; });
    await page.locator('input[type=file]').first().setInputFiles(file);
    await page.locator(words, { hasText: `${file.name}` }).filter({ hasText: 'does not let it be handed over' }).waitFor();
    assert.deepEqual(page.errors, []);
    await page.context().close();
  }
});

test('a file in the plane that asks for a mesher that cannot start is refused in words', async () => {
  const page = await playground.open();
  await page.locator('.stage-name', { hasText: /^done/ }).waitFor();
  await page.evaluate(() => { globalThis.Worker = class { constructor() { throw new Error('There are no workers.'); } }; });
  await page.locator('input[type=file]').first().setInputFiles({ name: 'box.obj', mimeType: 'model/obj', buffer: Buffer.from('v 0 0 0') });
  await page.locator('.error-bar', { hasText: 'box.obj' }).waitFor();
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test('a run is cancelled at once, and begun again', async () => {
  const page = await openSpace();
  await page.evaluate(() => globalThis.playground.store.change('Size', { options: { size: 0.01 } }));
  await page.locator('.stage-name', { hasText: /meshing|mapping|solving/ }).waitFor({ timeout: patience });
  await page.keyboard.press('Escape');
  await page.locator('.stage-name', { hasText: /^cancelled$/ }).waitFor({ timeout: patience });
  await page.evaluate(() => globalThis.playground.store.change('Size', { options: { size: 0.3 } }));
  await over(page);
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test('progress moves through seams and shape, and a run is held there and stepped', async () => {
  const page = await openSpace();
  await page.evaluate(() => {
    const { runner, store } = globalThis.playground;
    globalThis.seen = [];
    runner.subscribe(({ phase, state, paused }) => {
      if (phase !== 'running' || state === null) return;
      globalThis.seen.push({ stage: state.stage, share: state.share, bar: document.querySelector('progress').value });
      const { seams = false, shape = false } = globalThis.held ??= {};
      if (!paused && ((state.stage === 'seams' && !seams) || (state.stage === 'shape' && !shape))) {
        globalThis.held[state.stage] = true;
        runner.pause();
      }
    });
    store.change('Size', { options: { size: 0.1 } });
  });
  for (const [stage, words] of [['seams', /seams \(paused\)/], ['shape', /vertices \(paused\)/]]) {
    await page.locator('.stage-name', { hasText: words }).waitFor({ timeout: patience });
    const tick = () => page.evaluate(() => globalThis.playground.runner.run.state.tick);
    const before = await tick();
    await page.keyboard.press('.');
    await page.waitForFunction((old) => globalThis.playground.runner.run.state.tick === old + 1, before, { timeout: patience });
    assert.equal(await page.evaluate(() => globalThis.playground.runner.run.state.stage), stage);
    await page.keyboard.press('Space');
  }
  await over(page);
  const seen = await page.evaluate(() => globalThis.seen);
  for (const stage of ['seams', 'shape']) {
    const shares = seen.filter((state) => state.stage === stage).map(({ share }) => share);
    assert.ok(new Set(shares).size > 2, `${stage}: ${shares}`);
  }
  assert.ok(seen.every(({ bar }, i) => i === 0 || bar >= seen[i - 1].bar));
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test('the cells of a chart are seen step by step, in both views', async () => {
  const page = await openSpace();
  await page.evaluate(() => globalThis.playground.store.change('Size', { options: { size: 0.2 } }));
  await page.waitForFunction(() => globalThis.playground.runner.run.phase === 'running');
  await page.keyboard.press('Space');
  await page.locator('.stage-name', { hasText: /paused/ }).waitFor({ timeout: patience });
  while (await page.evaluate(() => globalThis.playground.runner.run.frame.cells === undefined)) {
    await page.keyboard.press('.');
    await page.waitForTimeout(50);
  }
  const { chart, pieces, points } = await page.evaluate(() => {
    const { cells } = globalThis.playground.runner.run.frame;
    return { chart: cells.chart, pieces: cells.sites.length, points: cells.points.length / 3 };
  });
  assert.equal(chart, 0);
  assert.ok(pieces > 50 && points > 3 * pieces);
  assert.ok(await page.evaluate(() => globalThis.playground.layers().has('cells')));
  await page.keyboard.press('Space');
  await over(page);
  assert.equal(await page.evaluate(() => globalThis.playground.runner.run.frame.cells), undefined);
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test('a picture that the browser took away is missed in words, and drawn again when it is given back', async () => {
  const page = await openSpace();
  const drawn = () => page.waitForFunction(() => {
    const { canvas } = globalThis.playground.viewer, { width, height } = canvas;
    const copy = new OffscreenCanvas(width, height).getContext('2d');
    copy.drawImage(canvas, 0, 0);
    return copy.getImageData(0, 0, width, height).data.filter((value, i) => i % 4 === 3 && value > 0).length > width * height / 50;
  });
  await drawn();
  await page.evaluate(() => {
    globalThis.context = globalThis.playground.viewer.canvas.getContext('webgl2').getExtension('WEBGL_lose_context');
    globalThis.context.loseContext();
  });
  const line = page.getByText('has taken the picture away');
  await line.waitFor();
  await page.evaluate(() => globalThis.context.restoreContext());
  await line.waitFor({ state: 'detached' });
  await drawn();
  await page.context().close();
});

test('without WebGL the page says so, and meshes, shows charts and saves all the same', async () => {
  const page = await playground.open({ hash: 'space.html#preset=saddle&size=0.25' });
  await page.addInitScript(() => {
    const get = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (kind, ...more) { return /webgl/.test(kind) ? null : get.call(this, kind, ...more); };
  });
  await page.reload();
  await page.getByText('no WebGL').waitFor();
  await over(page);
  assert.ok((await run(page)).quads > 50);
  assert.ok(await page.locator('#plane-view canvas').isVisible());
  await page.getByRole('tab', { name: 'Files' }).click();
  await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: 'Download .obj' }).click()]);
  assert.deepEqual(await violations(page), []);
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

for (const [width, dark] of [[360, true], [1440, false]])
  test(`nothing overflows at ${width} px, and axe finds nothing`, async () => {
    const page = await openSpace('#preset=saddle&size=0.25', { width, height: 800, dark });
    for (const tab of ['Surface', 'Mesh', 'Layers', 'Figures', 'Files', 'Learn']) {
      await page.getByRole('tab', { name: tab }).click();
      const wide = await page.evaluate(() => document.documentElement.scrollWidth > innerWidth);
      assert.ok(!wide, `${tab} overflows`);
      assert.deepEqual(await violations(page), [], tab);
    }
    assert.deepEqual(page.errors, []);
    await page.context().close();
  });
