// How fast the playground is there and draws, in a software-rendered Chromium: when something and when
// the mesh is first seen, milliseconds per layer for 20,000 elements, and the longest task of the page while 10,000 quads are computed and drawn. Prints;
// judges nothing.
// usage: node tests/bench/web_bench.mjs   (after npm run build and vite build -c web/vite.config.js)
import { fileURLToPath } from 'node:url';
import { createLpquad } from '../../dist/node.js';
import { serve } from '../package/server.mjs';
import { startPlayground } from '../web/support.mjs';

const folder = (path) => fileURLToPath(new URL(`../../${path}`, import.meta.url));
const row = (name, ...values) => console.log(name.padEnd(34), ...values.map((value) => String(value).padStart(9)));

/** A square with about 20,000 of everything, as plain arrays. */
async function frameOf20k() {
  const session = (await createLpquad()).start({ loops: [[[0, 0], [1, 0], [1, 1], [0, 1]]] },
    { size: 1 / 141, method: 'paper', seeds: 'isotropic', iterations: 8, smoothing: 4 });
  while (session.state.stage !== 'done') session.step(4);
  return session.snapshot({ triangles: true, cells: true, crosses: true, sizes: true, matching: true, quads: true });
}

/** In the page: first and median time of each layer, of all that is done for a picture. */
async function timeLayers([text, rounds]) {
  const [{ draw }, { BitmapPen }, { dark }, { elementAt }] = await Promise.all(
    ['draw', 'bitmap_pen', 'palette', 'hit'].map((name) => import(`/source/draw/${name}.js`)));
  const revive = (_, value) => (value?.array ? new globalThis[value.array](value.values) : value);
  const drawing = { regions: [{ name: '', loops: [[[0, 0], [1, 0], [1, 1], [0, 1]]] }], polylines: [], points: [] };
  const base = { drawing, frame: null, result: null, freshness: 'current', palette: dark, norm: 6 };
  const canvas = document.body.appendChild(Object.assign(document.createElement('canvas'), { width: 900, height: 700 }));
  const shown = canvas.getContext('2d'), sheet = new BitmapPen(), view = { scale: 650, left: -0.2, top: 1.04, width: 900, height: 700 };
  const picture = (scene) => {
    const start = performance.now();
    sheet.begin(view.width, view.height, 1);
    draw(sheet.pen, scene, view);
    sheet.end();
    shown.drawImage(sheet.canvas, 0, 0);
    shown.getImageData(0, 0, 1, 1);  // no drawing is put off
    return performance.now() - start;
  };
  const results = {};
  const sets = [['triangles'], ['cells'], ['density'], ['cells', 'density', 'boundary'], ['crosses'], ['sizes'], ['matching'], ['quads'], ['quality'],
    ['boundary', 'quads', 'quality', 'valence']];
  for (const layers of sets) {
    const scene = { ...base, frame: JSON.parse(text, revive), layers: new Set(layers) };
    const first = picture(scene), later = Array.from({ length: rounds }, () => picture(scene)).sort((a, b) => a - b);
    results[layers.join(' + ')] = [first, later[0], later[rounds >> 1]];
  }
  for (const layers of [['quads'], ['cells'], ['triangles']]) {
    const scene = { ...base, frame: JSON.parse(text, revive), layers: new Set(layers) };
    const start = performance.now();
    elementAt(scene, [0.5, 0.5], 1e-4);
    const built = performance.now();
    for (let i = 0; i < 1000; ++i) elementAt(scene, [(i * 0.618) % 1, (i * 0.414) % 1], 1e-4);
    results[`hit test, ${layers}`] = [built - start, (performance.now() - built) / 1000, (performance.now() - built) / 1000];
  }
  return results;
}

async function layers(playground, server) {
  const frame = await frameOf20k();
  const text = JSON.stringify(frame, (_, value) => (ArrayBuffer.isView(value) ? { array: value.constructor.name, values: [...value] } : value));
  const page = await playground.open();
  await page.route('**/blank', (route) => route.fulfill({ contentType: 'text/html', body: '<!doctype html>' }));
  await page.goto(`${server.origin}/blank`);
  console.log(`${frame.cells.sites.length} cells, ${frame.triangles.triangles.length / 3} triangles, ${frame.quads.quads.length / 4} quads; 900 x 700 pixels`);
  row('ms for', 'first', 'least', 'median');
  for (const [name, times] of Object.entries(await page.evaluate(timeLayers, [text, 15]))) row(name, ...times.map((time) => time.toFixed(time < 0.1 ? 4 : 1)));
  await page.context().close();
}

/** Processor time of the tasks of a page's main thread, in milliseconds. @param {string} trace */
function tasksOf(trace) {
  const { traceEvents } = JSON.parse(trace);
  const mains = traceEvents.filter(({ name, args }) => name === 'thread_name' && args.name === 'CrRendererMain');
  const byThread = mains.map(({ pid, tid }) => traceEvents.filter((event) => event.pid === pid && event.tid === tid && event.name.endsWith('RunTask') && event.tdur !== undefined));
  const busiest = byThread.sort((a, b) => b.length - a.length)[0] ?? [];
  return busiest.map(({ tdur }) => tdur / 1000);
}

/** Runs something in a page, and tells of its main thread meanwhile. */
async function traced(playground, page, what, ...given) {
  await playground.browser.startTracing(page, { categories: ['toplevel', 'disabled-by-default-devtools.timeline', 'devtools.timeline'] });
  const told = await page.evaluate(what, ...given);
  const tasks = tasksOf((await playground.browser.stopTracing()).toString());
  const long = tasks.filter((time) => time > 50).length;
  return { told, text: `${tasks.length} tasks, ${long} over 50 ms of processor time, longest ${Math.max(0, ...tasks).toFixed(0)} ms` };
}

/** In the page: to the end of a run of about 10,000 quads. */
async function mesh(layers) {
  const { store, runner } = globalThis.playground;
  const loops = [[[0, 0], [1, 0], [1, 1], [0, 1]]], options = { size: 0.01, method: 'paper', seeds: 'isotropic', iterations: 30 };
  const done = new Promise((resolve) => runner.subscribe(({ phase, project }) => { if (phase === 'done' && project.options === options) resolve(); }));
  store.change('Bench', { drawing: { regions: [{ name: '', loops }], polylines: [], points: [] }, options, layers, preset: 'bench' });
  globalThis.playground.stage.fit();
  await done;
  return runner.run.result.quads.length / 4;
}

/** In the page: 90 pictures of a moving view; the median time between them. */
async function panAndZoom() {
  const { stage } = globalThis.playground, gaps = [];
  let before = await new Promise(requestAnimationFrame);
  for (let i = 0; i < 90; ++i) {
    stage.look({ ...stage.view, left: stage.view.left + 0.002, scale: stage.view.scale * (i % 2 ? 1.01 : 0.99) });
    const now = await new Promise(requestAnimationFrame);
    gaps.push(now - before);
    before = now;
  }
  return gaps.sort((a, b) => a - b)[45];
}

/** @param {'auto' | string[]} layers */
async function longTasks(playground, layers) {
  const page = await playground.open({ width: 1440, height: 900, still: false });
  await page.locator('.stage-name', { hasText: /^done/ }).waitFor({ timeout: 120000 });
  const meshing = await traced(playground, page, mesh, layers);
  console.log(`\n${meshing.told} quads, layers ${layers}\n  meshing: ${meshing.text}`);
  const panning = await traced(playground, page, panAndZoom);
  console.log(`  panning: ${panning.text}; ${panning.told.toFixed(1)} ms between pictures`);
  await page.context().close();
}

/** In the page: a ring of 500 nodes, coarse enough to be drawn at once. */
async function showRing() {
  const { store, runner, stage } = globalThis.playground;
  const loop = Array.from({ length: 500 }, (_, i) => [Math.cos(i * Math.PI / 250), Math.sin(i * Math.PI / 250)]);
  const options = { size: 0.05 };
  const done = new Promise((resolve) => runner.subscribe(({ phase, project }) => { if (phase === 'done' && project.options === options) resolve(); }));
  store.change('Bench', { drawing: { regions: [{ name: '', loops: [loop] }], polylines: [], points: [] }, options, preset: 'bench' });
  stage.fit();
  await done;
  const { scale, left, top } = stage.view, { x, y } = stage.overlay.getBoundingClientRect();
  return [x + (1 - left) * scale, y + top * scale];
}

/** In the page: times between pictures while somebody drags. */
function watchPictures() {
  const gaps = globalThis.gaps = [];
  let before = performance.now();
  const next = (now) => { gaps.push(now - before); before = now; requestAnimationFrame(next); };
  requestAnimationFrame(next);
}

/** A vertex of 500 is dragged about by the pointer, the mesh following. */
async function dragging(playground) {
  const page = await playground.open({ width: 1440, height: 900 });
  await page.locator('.stage-name', { hasText: /^done/ }).waitFor({ timeout: 120000 });
  const [x, y] = await page.evaluate(showRing);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.evaluate(watchPictures);
  for (let i = 1; i <= 180; ++i) await page.mouse.move(x + 40 * Math.sin(i / 12), y + 30 * Math.sin(i / 7));
  const gaps = (await page.evaluate(() => globalThis.gaps)).slice(2).sort((a, b) => a - b);
  await page.mouse.up();
  const at = (share) => gaps[Math.floor(share * (gaps.length - 1))].toFixed(1);
  console.log(`\ndragging one vertex of 500: ${gaps.length} pictures, ${at(0.5)} ms between them in the median, ${at(0.95)} ms at the 95th percentile`);
  await page.context().close();
}

/** In the page: when its first contents were painted, and when the first picture of a mesh was drawn. */
async function firstSights() {
  const painted = new Promise((resolve) => {
    new PerformanceObserver((list) => {
      for (const { name, startTime } of list.getEntries()) if (name === 'first-contentful-paint') resolve(startTime);
    }).observe({ type: 'paint', buffered: true });
  });
  while (!globalThis.playground?.runner.run.frame) await new Promise(requestAnimationFrame);
  await new Promise(requestAnimationFrame);
  return [await painted, performance.now()];
}

/** New visitors, one after the other: nothing of the page is in their caches. */
async function loading(playground, visitors = 9) {
  const times = [];
  for (let k = 0; k < visitors; ++k) {
    const page = await playground.open({ width: 1440, height: 900, still: false });
    times.push(await page.evaluate(firstSights));
    await page.context().close();
  }
  const at = (what, share) => times.map((one) => one[what]).sort((a, b) => a - b)[Math.floor(share * (visitors - 1))].toFixed(0);
  console.log(`after a click on the link, ms: first paint ${at(0, 0.5)} in the median, ${at(0, 1)} at worst; first mesh ${at(1, 0.5)}, ${at(1, 1)}\n`);
}

const playground = await startPlayground(), server = await serve({ source: { folder: folder('web') } });
await loading(playground);
await layers(playground, server);
await longTasks(playground, 'auto');
await longTasks(playground, ['boundary', 'cells', 'density', 'triangles', 'sizes', 'quads', 'quality', 'valence']);
await dragging(playground);
await playground.close();
server.close();
