// The run as a person sees it: it starts by itself, is played, stopped, scrubbed and cancelled.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { finished, startPlayground } from './support.mjs';

let playground;
before(async () => { playground = await startPlayground(); });
after(() => playground.close());

const stageName = (page) => page.locator('.stage-name');
const shows = (page, text) => stageName(page).filter({ hasText: text }).waitFor();

/** Tick, stage and a fingerprint of the points on the screen. */
const picture = (page) => page.evaluate(() => {
  const { frame } = globalThis.playground.scene();
  const points = (frame.triangles ?? frame.cells ?? frame.quads ?? frame.crosses).points;
  return { tick: frame.tick, stage: frame.stage, points: [...points].join() };
});
const fractionDrawn = (page) => page.evaluate(() => {
  const canvas = document.querySelector('#mesh-canvas');
  const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
  let drawn = 0;
  for (let i = 3; i < data.length; i += 4) drawn += data[i] > 0 ? 1 : 0;
  return drawn / (data.length / 4);
});

test('opens on cells that settle and become quads, without a click', async () => {
  const page = await playground.open({ still: false, watch: ({ runner }) => {
    globalThis.seen = [];
    runner.subscribe(({ frame }) => { if (frame) globalThis.seen.push(frame.stage + frame.iteration); });
  } });
  await shows(page, 'cells settle');
  await finished(page);
  const seen = [...new Set(await page.evaluate(() => globalThis.seen))];
  assert.ok(seen.filter((name) => name.startsWith('optimise')).length >= 5, seen.join());
  assert.ok(await fractionDrawn(page) > 0.2);
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test('with reduced motion stages are shown without moving, then the mesh, and it can be scrubbed', async () => {
  const page = await playground.open({ still: true, watch: ({ runner }) => {
    globalThis.seen = new Map();
    runner.subscribe(({ frame }) => {
      if (frame && !globalThis.seen.has(frame.tick)) globalThis.seen.set(frame.tick, { stage: frame.stage, iteration: frame.iteration, at: performance.now() });
    });
  } });
  await finished(page);
  const [first, ...rest] = await page.evaluate(() => [...globalThis.seen.values()]);
  assert.deepEqual([first.stage, first.iteration], ['optimise', 0]);  // the triangulation
  assert.equal(rest.pop().stage, 'done');
  rest.forEach(({ at }, i) => assert.ok(at - (i === 0 ? first : rest[i - 1]).at > 1500, 'a film'));  // of a slow machine only
  await page.locator('#tick').focus();
  await page.keyboard.press('Home');
  await shows(page, 'cross field');
  await page.keyboard.press('ArrowRight');
  await shows(page, 'triangles');
  await page.keyboard.press('End');
  await finished(page);
  await page.context().close();
});

test('going back shows exactly the points that were there', async () => {
  const page = await playground.open();
  await finished(page);
  const key = async (name, text) => {
    await page.keyboard.press(name);
    await shows(page, text);
    return picture(page);
  };
  await key('Shift+E', 'cross field');
  const seen = [];
  for (let tick = 1; tick <= 5; ++tick) seen[tick] = await key('.', tick === 1 ? 'triangles' : `iteration ${tick - 1} of`);
  await page.keyboard.press('e');
  await finished(page);
  for (const tick of [4, 2, 5]) {
    await page.locator('#tick').fill(String(tick));
    await shows(page, `iteration ${tick - 1} of`);
    assert.deepEqual(await picture(page), seen[tick]);
  }
  assert.deepEqual(await key(',', 'iteration 3 of'), seen[4]);
  assert.notEqual(seen[4].points, seen[5].points);
  await page.context().close();
});

test('the slider under a hand asks for the latest place only', async () => {
  const page = await playground.open();
  await finished(page);
  const box = await page.locator('#tick').boundingBox();
  await page.mouse.move(box.x + box.width - 10, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width * 0.3, box.y + box.height / 2, { steps: 40 });
  const held = Number(await page.locator('#tick').inputValue());
  await page.mouse.up();
  await shows(page, `iteration ${held - 1} of`);
  assert.equal((await picture(page)).tick, held);
  await page.context().close();
});

test('is paused and goes on with the space bar; speed is remembered for the session', async () => {
  const page = await playground.open({ still: false });
  await page.getByRole('combobox', { name: 'Speed' }).selectOption('0.25');
  await shows(page, 'cells settle');
  await page.locator('#overlay-canvas').focus();
  await page.keyboard.press('Space');
  await page.waitForFunction(() => globalThis.playground.runner.run.phase === 'paused');
  await page.waitForTimeout(300);  // a step that was under way still ends
  const before = await picture(page);
  await page.waitForTimeout(300);
  assert.deepEqual(await picture(page), before);
  for (let i = 0; i < 5; ++i) await page.keyboard.press('>');
  assert.equal(await page.getByRole('combobox', { name: 'Speed' }).inputValue(), '8');
  await page.keyboard.press('Space');
  await finished(page);
  await page.reload();
  assert.equal(await page.getByRole('combobox', { name: 'Speed' }).inputValue(), '8');
  await page.context().close();
});

test('cancel ends a long run at once, and says so', async () => {
  const page = await playground.open();
  await finished(page);
  await page.evaluate(() => globalThis.playground.store.change('Size', { options: { size: 0.005 } }));
  await page.waitForFunction(() => globalThis.playground.runner.run.phase === 'playing');
  assert.equal(await page.locator('.freshness').textContent(), 'Out of date');
  await page.keyboard.press('Escape');
  await shows(page, 'cancelled');
  assert.match(await page.locator('#announcer').textContent(), /^cancelled/);
  await page.keyboard.press('Control+z');
  await finished(page);
  assert.equal(await page.locator('.freshness').isVisible(), false);
  await page.context().close();
});

test('while a drag goes on a coarse preview follows, pale; at rest the mesh is run', async () => {
  const page = await playground.open();
  await finished(page);
  await page.evaluate(() => {
    const { store } = globalThis.playground;
    globalThis.drag = (width) => store.change('Move', ({ drawing }) => ({
      drawing: { ...drawing, regions: [{ name: '', loops: [[[0, 0], [width, 0], [width, 1], [0, 1]]] }] },
    }), 'move 1');
    globalThis.seen = [];
    globalThis.playground.runner.subscribe(({ phase }) => globalThis.seen.push(phase));
    globalThis.moving = setInterval(() => globalThis.drag(2 + Math.random()), 50);
  });
  await page.locator('.freshness', { hasText: 'Preview' }).waitFor();
  const preview = await page.evaluate(() => ({ ...globalThis.playground.scene(), palette: 0, layers: 0, quads: globalThis.playground.scene().frame.quads.quads.length / 4 }));
  assert.equal(preview.freshness, 'preview');
  assert.match(await stageName(page).textContent(), /^out of date/);
  assert.equal(preview.result, null);
  assert.ok(preview.quads > 150 && preview.quads < 900, `${preview.quads} quads`);
  await page.evaluate(() => { clearInterval(globalThis.moving); globalThis.drag(2.5); });
  await page.locator('.freshness').waitFor({ state: 'hidden' });  // it rests, though the gesture is not over
  await finished(page);
  await page.evaluate(() => { globalThis.drag(2.25); globalThis.playground.store.settle(); });
  await page.waitForFunction(() => {
    const { runner, store } = globalThis.playground;
    return runner.run.phase === 'done' && runner.run.frameOf === store.project;
  });
  const right = await page.evaluate(() => Math.max(...globalThis.playground.scene().frame.quads.points));
  assert.equal(right, 2.25);
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test('a drawing with faults is not given to the mesher', async () => {
  const page = await playground.open();
  await finished(page);
  await page.evaluate(() => {
    const { store } = globalThis.playground;
    globalThis.playground.problemsOf = () => [{ code: 'SELF_INTERSECTION', message: 'Two edges cross.', where: { x: 0, y: 0 } }];
    const called = () => { throw new Error('called'); };
    globalThis.playground.runner.engine = called;
    store.change('Cross', ({ drawing }) => ({ drawing: { ...drawing } }), 'drag 1');
    store.settle();
  });
  await shows(page, 'no mesh: Two edges cross.');
  assert.equal(await page.locator('.freshness').textContent(), 'Out of date');
  await page.context().close();
});

test('a vertex is dragged on the stage: a preview follows, then the mesh', async () => {
  const page = await playground.open();
  await finished(page);
  const corner = await page.evaluate(() => {
    const { view, overlay } = globalThis.playground.stage;
    const { left, top } = overlay.getBoundingClientRect();
    return [left + (2 - view.left) * view.scale, top + (view.top - 1) * view.scale];
  });
  await page.mouse.move(...corner);
  await page.mouse.down();
  for (let i = 1; i <= 20; ++i) await page.mouse.move(corner[0] - i, corner[1] + 2 * i);
  await page.locator('.freshness').waitFor();
  await page.mouse.up();
  await finished(page);
  await page.locator('.freshness').waitFor({ state: 'hidden' });
  const same = await page.evaluate(() => {
    const { runner, store } = globalThis.playground;
    const { points } = runner.run.result;
    const [x, y] = store.project.drawing.regions[0].loops[0][2];
    for (let i = 0; i < points.length; i += 2) if (points[i] === x && points[i + 1] === y) return true;
    return false;
  });
  assert.ok(same, 'the corner is where it was dragged to');
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test('crossings are never given to the mesher, and going back heals', async () => {
  const page = await playground.open();
  await finished(page);
  await page.evaluate(() => {
    const { store } = globalThis.playground;
    store.change('Cross', { drawing: { regions: [{ name: '', loops: [[[0, 0], [2, 1], [2, 0], [0, 1]]] }], polylines: [], points: [] } });
  });
  await shows(page, /^no mesh/);
  assert.equal(await page.evaluate(() => globalThis.playground.scene().freshness), 'old');
  await page.keyboard.press('Control+z');
  await finished(page);
  assert.equal(await page.evaluate(() => globalThis.playground.scene().freshness), 'current');
  await page.context().close();
});
