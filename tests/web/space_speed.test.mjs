// How fast a run in space is shown: the control of the page for the plane, with its keys.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { SurfaceRunner } from '../../web/space/run/runner.js';
import { startPlayground } from './support.mjs';

let playground;
before(async () => { playground = await startPlayground(); });
after(() => playground.close());

/** A session of one chart whose cells never rest. */
function session() {
  const stages = ['features', 'field', 'charts', ...Array(30).fill('mesh'), 'seams', 'shape', 'done'];
  let tick = 0, pictures = 0;
  const state = () => ({ stage: stages[tick], chart: 0, chartCount: 1, tick, share: 0 });
  return { get state() { return state(); }, step: async () => { ++tick; return state(); }, dispose: async () => {}, finish: async () => ({ report: { quads: 1 } }),
    snapshot: async ({ cells }) => (cells ? { cells: { chart: 0, sites: [0], uv: Float64Array.of(++pictures) } } : {}) };
}

/** Milliseconds that a run waits so that people see it. */
async function waited(t, speed, watched) {
  const waits = [];
  t.mock.method(globalThis, 'setTimeout', (go, milliseconds) => { waits.push(milliseconds); queueMicrotask(go); });
  const runner = new SurfaceRunner(async () => ({ startSurface: async () => session() }), () => watched);
  runner.speed = speed;
  await runner.start({ surface: null, options: {} });
  assert.equal(runner.run.phase, 'done');
  t.mock.restoreAll();
  return waits.reduce((sum, one) => sum + one, 0);
}

test('a run is seen for a time that the speed divides', async (t) => {
  const usual = await waited(t, 1, true);
  assert.ok(usual > 500, `${usual} ms`);
  assert.ok(Math.abs(await waited(t, 8, true) - usual / 8) < 1e-9);
  assert.ok(await waited(t, 0.25, true) >= 4 * usual);
});

test('where movement is not wanted, stages are seen for longer if it is to be slower', async (t) => {
  assert.equal(await waited(t, 1, false), 0);
  assert.equal(await waited(t, 8, false), 0);
  assert.ok(await waited(t, 0.5, false) > 500);
});

for (const [width, height] of [[360, 740], [1440, 900]])
  test(`looks as on the page for the plane, has its keys and remembers, at ${width} px`, async () => {
    const page = await playground.open({ width, height });
    const speed = page.getByRole('combobox', { name: 'Speed' });
    const look = () => speed.evaluate((one) => {
      const { width, height } = one.getBoundingClientRect(), { right } = document.querySelector('#timeline').getBoundingClientRect();
      return { width, height, toTheRight: right - one.getBoundingClientRect().right, title: one.title, html: one.innerHTML };
    });
    const inPlane = await look();
    await page.locator('body').press('>');
    assert.equal(await speed.inputValue(), '2');
    await page.getByRole('link', { name: 'Space' }).click();
    await page.waitForFunction(() => globalThis.playground?.viewer);
    assert.deepEqual(await look(), inPlane);
    assert.equal(await speed.inputValue(), '2');
    for (let i = 0; i < 5; ++i) await page.keyboard.press('<');
    assert.equal(await speed.inputValue(), '0.25');
    assert.equal(await page.evaluate(() => globalThis.playground.runner.speed), 0.25);
    await speed.selectOption('8');
    assert.equal(await page.evaluate(() => globalThis.playground.runner.speed), 8);
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
    assert.deepEqual(page.errors, []);
    await page.context().close();
  });
