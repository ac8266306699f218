// Drawing and changing domains as a person does: with the pointer, the keyboard and files.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { finished, startPlayground } from './support.mjs';

let playground;
before(async () => { playground = await startPlayground(); });
after(() => playground.close());

const stageBox = (page) => page.locator('#overlay-canvas').boundingBox();
const drawingOf = (page) => page.evaluate(() => globalThis.playground.store.project.drawing);
const loopsOf = async (page) => (await drawingOf(page)).regions.flatMap(({ loops }) => loops);
const tool = (page, id) => page.click(`#tools [data-action="tool.${id}"]`);
const undo = (page) => page.click('[data-action="edit.undo"]');

/** Where a place of the drawing is on the screen. */
async function onScreen(page, x, y) {
  const box = await stageBox(page);
  const { scale, left, top } = await page.evaluate(() => ({ ...globalThis.playground.stage.view }));
  return [box.x + (x - left) * scale, box.y + (top - y) * scale];
}

async function drag(page, from, to, steps = 6) {
  await page.mouse.move(...from);
  await page.mouse.down();
  await page.mouse.move(...to, { steps });
  await page.mouse.up();
}

/** A page with a preset on it. */
async function withPreset(id, how) {
  const page = await playground.open(how);
  await page.click(`[data-action="preset.${id}"]`);
  await finished(page);
  return page;
}

async function close(page) {
  assert.deepEqual(page.errors, []);
  await page.context().close();
}

test('a vertex is dragged, added on an edge, and removed by key; each is one undo', async () => {
  const page = await withPreset('square');
  await drag(page, await onScreen(page, 1, 1), await onScreen(page, 1.2, 1.1));
  const [[, , corner]] = await loopsOf(page);
  assert.ok(Math.hypot(corner[0] - 1.2, corner[1] - 1.1) < 0.01);
  await finished(page);
  await page.mouse.click(...await onScreen(page, 0.5, 0));
  assert.equal((await loopsOf(page))[0].length, 5);
  await page.keyboard.press('Delete');
  assert.equal((await loopsOf(page))[0].length, 4);
  for (let i = 0; i < 3; ++i) await undo(page);
  assert.deepEqual((await loopsOf(page))[0], [[0, 0], [1, 0], [1, 1], [0, 1]]);
  assert.equal(await page.evaluate(() => globalThis.playground.store.project.preset), 'square');
  await close(page);
});

test('dragging where there is nothing moves the view only', async () => {
  const page = await withPreset('square');
  const before = await page.evaluate(() => ({ left: globalThis.playground.stage.view.left, drawing: JSON.stringify(globalThis.playground.store.project.drawing) }));
  await drag(page, await onScreen(page, 0.5, 0.5), await onScreen(page, 0.7, 0.5));
  const after = await page.evaluate(() => ({ left: globalThis.playground.stage.view.left, drawing: JSON.stringify(globalThis.playground.store.project.drawing) }));
  assert.equal(after.drawing, before.drawing);
  assert.ok(Math.abs(after.left - before.left + 0.2) < 0.01);
  await close(page);
});

test('a shared vertex moves in both materials', async () => {
  const page = await withPreset('materials');
  await drag(page, await onScreen(page, 1, 0), await onScreen(page, 1.1, 0.05));
  const { regions } = await drawingOf(page);
  assert.deepEqual(regions[0].loops[0][1], regions[1].loops[0][0]);
  assert.ok(Math.abs(regions[0].loops[0][1][0] - 1.1) < 0.02);
  await finished(page);
  await close(page);
});

test('a hole is drawn by points, closed on its first, and cancelled by Escape', async () => {
  const page = await withPreset('square');
  await tool(page, 'polygon');
  for (const [x, y] of [[0.3, 0.3], [0.7, 0.3], [0.5, 0.7], [0.3, 0.3]]) {
    await page.mouse.click(...await onScreen(page, x, y));
    await page.waitForTimeout(400);  // slower than a double click
  }
  let loops = await loopsOf(page);
  assert.equal(loops.length, 2);
  assert.equal(loops[1].length, 3);
  await finished(page);
  await page.mouse.click(...await onScreen(page, 0.1, 0.1));
  await page.waitForTimeout(400);
  await page.mouse.click(...await onScreen(page, 0.2, 0.1));
  await page.keyboard.press('Escape');
  loops = await loopsOf(page);
  assert.equal(loops.length, 2);
  await close(page);
});

test('outlines by Enter and Backspace, by hand, circle and rectangle', async () => {
  const page = await withPreset('square');
  await tool(page, 'rectangle');
  await drag(page, await onScreen(page, 0.1, 0.1), await onScreen(page, 0.3, 0.3));
  await tool(page, 'circle');
  await drag(page, await onScreen(page, 0.7, 0.3), await onScreen(page, 0.85, 0.3));
  await tool(page, 'freehand');
  const path = await Promise.all(Array.from({ length: 40 }, (_, i) => onScreen(page, 0.3 + 0.12 * Math.cos(i * 0.155), 0.7 + 0.12 * Math.sin(i * 0.155))));
  await page.mouse.move(...path[0]);
  await page.mouse.down();
  for (const p of path) await page.mouse.move(...p);
  await page.mouse.up();
  await tool(page, 'polygon');
  for (const [x, y] of [[0.6, 0.6], [0.9, 0.6], [0.9, 0.9], [0.1, 0.95]]) {
    await page.mouse.click(...await onScreen(page, x, y));
    await page.waitForTimeout(400);
  }
  await page.keyboard.press('Backspace');
  await page.keyboard.press('Enter');
  const loops = await loopsOf(page);
  assert.deepEqual([loops[1].length, loops[2].length, loops[4].length], [4, 32, 3]);
  assert.ok(loops[3].length >= 8 && loops[3].length < 40, `by hand: ${loops[3].length}`);
  await finished(page);
  await close(page);
});

test('all of it by keyboard', async () => {
  const page = await withPreset('square');
  await page.focus('#overlay-canvas');
  await page.keyboard.press('n');
  await page.keyboard.press('n');
  await page.locator('.selection-section .hint', { hasText: /^Vertex 1 of 0–3, loop 0/ }).waitFor();
  await page.fill('.snap-section input', '0.01');
  await page.keyboard.press('Enter');
  await page.focus('#overlay-canvas');
  await page.keyboard.press('ArrowUp');
  await page.keyboard.press('Shift+ArrowRight');
  await page.keyboard.press('Alt+ArrowUp');
  assert.deepEqual((await loopsOf(page))[0][1], [1.1, 0.011]);
  await page.keyboard.press('Insert');
  assert.equal((await loopsOf(page))[0].length, 5);
  await page.keyboard.press('Backspace');
  await page.keyboard.press('Escape');
  assert.equal((await loopsOf(page))[0].length, 4);
  await page.keyboard.press('Shift+P');
  const section = page.locator('.tool-section');
  for (const [x, y] of [['0.4', '0.4'], ['0.6', '0.4'], ['0,5', '0.6']]) {
    await section.getByLabel('x', { exact: true }).fill(x);
    await section.getByLabel('y', { exact: true }).fill(y);
    await page.keyboard.press('Enter');
  }
  await section.getByRole('button', { name: 'Close the outline' }).press('Enter');
  assert.deepEqual((await loopsOf(page))[1], [[0.4, 0.4], [0.6, 0.4], [0.5, 0.6]]);
  await finished(page);
  await close(page);
});

test('numbers of the vertex, the circle and the rectangle', async () => {
  const page = await withPreset('plate');
  await page.click('[data-action="vertex.next"]');
  const section = page.locator('.selection-section');
  await section.getByLabel('Width').fill('2.5');
  await page.keyboard.press('Enter');
  assert.deepEqual((await loopsOf(page))[0], [[0, 0], [2.5, 0], [2.5, 1], [0, 1]]);
  await section.getByLabel('x', { exact: true }).fill('-0.25');
  await page.keyboard.press('Enter');
  assert.deepEqual((await loopsOf(page))[0][0], [-0.25, 0]);
  for (let i = 0; i < 4; ++i) await page.click('[data-action="vertex.next"]');
  await section.getByLabel('Radius').fill('0.3');
  await page.keyboard.press('Enter');
  await section.getByLabel('Points').fill('20');
  await page.keyboard.press('Enter');
  const [, hole] = await loopsOf(page);
  assert.equal(hole.length, 20);
  assert.ok(hole.every(([x, y]) => Math.abs(Math.hypot(x - 1, y - 0.5) - 0.3) < 1e-9));
  await section.getByLabel('Edge name').fill('bore');
  await page.keyboard.press('Enter');
  assert.equal((await drawingOf(page)).regions[0].tags[1].filter((tag) => tag === 'bore').length, 1);
  await finished(page);
  await close(page);
});

test('an outline of any shape is stretched about its middle', async () => {
  const page = await withPreset('square');
  await drag(page, await onScreen(page, 1, 1), await onScreen(page, 1.2, 1.1));
  await finished(page);
  const section = page.locator('.selection-section');
  await section.getByLabel('Extent x').fill('2.4');
  await page.keyboard.press('Enter');
  const xs = (await loopsOf(page))[0].map(([x]) => x);
  assert.ok(Math.abs(Math.max(...xs) - Math.min(...xs) - 2.4) < 1e-9 && Math.abs(Math.max(...xs) + Math.min(...xs) - 1.2) < 0.02, String(xs));
  await undo(page);
  assert.ok(Math.max(...(await loopsOf(page))[0].map(([x]) => x)) < 1.3);
  await close(page);
});

test('a vertex has the number by which messages and files call it', async () => {
  const page = await withPreset('square');
  const name = page.locator('.selection-section .in-one-line');
  await page.click('[data-action="vertex.next"]');
  await page.waitForFunction(() => document.querySelector('.selection-section .in-one-line').textContent === 'Vertex 0 of 0–3, loop 0');
  await page.evaluate(() => globalThis.playground.store.change('Cross', { drawing: { regions: [{ name: '', loops: [[[0, 0], [1, 1], [1, 0], [0, 1.2]]] }], polylines: [], points: [] } }));
  const message = await page.locator('.error-bar .details', { hasText: 'and the edge 2 of loop 0' }).textContent();
  const [, edge] = message.match(/and the edge (\d+) of loop 0/);  // starts at the vertex of its number
  for (let k = 0; k < Number(edge); ++k) await page.click('[data-action="vertex.next"]');
  await name.filter({ hasText: `Vertex ${edge} of 0–3` }).waitFor();
  await close(page);
});

test('whole outlines move, by pointer and by key', async () => {
  const page = await withPreset('plate');
  await page.keyboard.press('Shift+W');
  await drag(page, await onScreen(page, 1.22, 0.5), await onScreen(page, 1.42, 0.5));
  const [, hole] = await loopsOf(page);
  const middle = hole.reduce((sum, [x]) => sum + x, 0) / hole.length;
  assert.ok(Math.abs(middle - 1.2) < 0.01, String(middle));
  await page.keyboard.press('Delete');
  assert.equal((await loopsOf(page)).length, 1);
  await finished(page);
  await close(page);
});

test('the grid and right angles hold a drag', async () => {
  const page = await withPreset('square');
  await page.keyboard.press('#');
  await page.fill('.snap-section input', '0.25');
  await page.keyboard.press('Enter');
  await drag(page, await onScreen(page, 1, 1), await onScreen(page, 1.21, 1.27));
  assert.deepEqual((await loopsOf(page))[0][2], [1.25, 1.25]);
  await page.click('[data-action="snap.grid"]');
  await page.click('[data-action="view.fit"]');
  await page.keyboard.down('Shift');
  await drag(page, await onScreen(page, 1.25, 1.25), await onScreen(page, 1.3, 1.005));
  await page.keyboard.up('Shift');
  const [, , corner] = (await loopsOf(page))[0];
  const turns = [[1, 0], [0, 1]].map(([x, y]) => Math.atan2(corner[1] - y, corner[0] - x) * 180 / Math.PI / 15);
  assert.ok(turns.some((turn) => Math.abs(turn - Math.round(turn)) < 1e-6), String(turns));
  await close(page);
});

test('a crossing is shown, keeps the mesher out, and is mended by one button', async () => {
  const page = await withPreset('square');
  await drag(page, await onScreen(page, 1, 1), await onScreen(page, -0.3, 0.5));
  const bar = page.locator('.error-bar');
  await bar.getByText('Two edges cross.').waitFor();
  assert.equal(await page.evaluate(() => globalThis.playground.runner.run.phase), 'failed');
  const red = await page.evaluate(() => {
    const canvas = document.getElementById('overlay-canvas');
    const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
    let count = 0;
    for (let i = 0; i < data.length; i += 4) count += data[i + 3] > 200 && data[i] > 150 && data[i + 1] < 60 && data[i + 2] < 80 ? 1 : 0;
    return count;
  });
  assert.ok(red > 100, `${red} red pixels`);
  const { scale } = await page.evaluate(() => ({ ...globalThis.playground.stage.view }));
  await bar.getByRole('button', { name: 'Show me' }).click();
  assert.ok(await page.evaluate(() => globalThis.playground.stage.view.scale) > scale);
  await bar.getByRole('button', { name: 'Untangle' }).click();
  await bar.waitFor({ state: 'hidden' });
  await finished(page);
  await undo(page);
  await bar.getByText('Two edges cross.').waitFor();
  await close(page);
});

test('an odd boundary gets a node', async () => {
  const page = await withPreset('square');
  await page.evaluate(() => globalThis.playground.store.change('Keep the boundary', ({ options }) => ({ options: { ...options, keepBoundary: true } })));
  await finished(page);
  await page.focus('#overlay-canvas');
  await page.keyboard.press('n');
  await page.keyboard.press('Insert');
  const bar = page.locator('.error-bar');
  await bar.getByText('odd number of edges').waitFor();
  await bar.getByRole('button', { name: 'Add a node here' }).click();
  await finished(page);
  assert.equal((await loopsOf(page))[0].length, 6);
  await close(page);
});

test('sizes are painted and erased, guides drawn and erased', async () => {
  const page = await withPreset('square');
  const project = () => page.evaluate(() => globalThis.playground.store.project);
  const quads = async () => Number(/([\d,]+) quads/.exec(await page.textContent('.stage-name'))[1].replace(',', ''));
  const coarse = await quads();
  await tool(page, 'brush');
  await drag(page, await onScreen(page, 0.2, 0.2), await onScreen(page, 0.4, 0.2));
  assert.ok((await project()).sizes.length > 20);
  await finished(page);
  assert.ok(await quads() > 1.2 * coarse);
  await page.keyboard.down('Shift');
  await drag(page, await onScreen(page, 0.15, 0.2), await onScreen(page, 0.45, 0.2), 12);
  await page.keyboard.up('Shift');
  assert.equal((await project()).sizes.length, 0);
  await tool(page, 'guide');
  await drag(page, await onScreen(page, 0.2, 0.2), await onScreen(page, 0.8, 0.7), 20);
  const [guide] = (await project()).guides;
  assert.ok(guide.length >= 2 && guide.length < 12);
  await page.keyboard.down('Shift');
  await page.mouse.click(...await onScreen(page, 0.5, 0.45));
  await page.keyboard.up('Shift');
  assert.deepEqual((await project()).guides, []);
  await undo(page);
  assert.equal((await project()).guides.length, 1);
  await close(page);
});

test('every preset by keyboard, ending in quads only', async () => {
  const page = await playground.open();
  await finished(page);
  await page.focus('[data-action="preset.plate"]');
  const ids = await page.evaluate(() => [...document.querySelectorAll('.preset')].map((card) => card.dataset.action));
  assert.ok(ids.length >= 14);
  for (const id of ids.slice(1)) {
    await page.keyboard.press('Tab');
    assert.equal(await page.evaluate(() => document.activeElement.dataset.action), id);
    await page.keyboard.press('Enter');
    await page.waitForFunction((preset) => {
      const { run } = globalThis.playground.runner;
      return run.phase === 'done' && run.project.preset === preset;
    }, id.slice('preset.'.length), { timeout: 60000 });
    assert.equal(await page.evaluate(() => globalThis.playground.runner.run.result.triangles.length), 0);
    assert.equal(await page.locator('.error-bar').isVisible(), false);
  }
  await close(page);
});

const svg = '<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0H40V30H0Z"/></svg>';

/** Drops a file as a file manager does. */
async function drop(page, name, text) {
  const files = await page.evaluateHandle(([file, content]) => {
    const transfer = new DataTransfer();
    transfer.items.add(new File([content], file));
    return transfer;
  }, [name, text]);
  for (const event of ['dragover', 'drop']) await page.dispatchEvent('#panel', event, { dataTransfer: files });
}

test('files are opened by the button, dropped and pasted', async () => {
  const page = await playground.open();
  await finished(page);
  const [chooser] = await Promise.all([page.waitForEvent('filechooser'), page.click('[data-action="file.open"]')]);
  await chooser.setFiles(fileURLToPath(new URL('../fixtures/domains/two_materials.json', import.meta.url)));
  await page.waitForFunction(() => globalThis.playground.store.project.drawing.regions.length === 2);
  assert.deepEqual(await page.evaluate(() => globalThis.playground.store.project.options), { size: 0.1 });
  await finished(page);
  await drop(page, 'part.svg', svg);
  await page.waitForFunction(() => globalThis.playground.store.project.drawing.regions.length === 1);
  assert.equal((await loopsOf(page))[0].length, 4);
  assert.equal(await page.evaluate(() => globalThis.playground.store.project.options.size), 1.3);
  await finished(page);
  await page.focus('#overlay-canvas');
  await page.evaluate((text) => {
    const clipboardData = new DataTransfer();
    clipboardData.setData('text/plain', text);
    document.activeElement.dispatchEvent(new ClipboardEvent('paste', { clipboardData, bubbles: true, cancelable: true }));
  }, readFileSync(new URL('../fixtures/domains/l_shape.json', import.meta.url), 'utf8'));
  await page.waitForFunction(() => globalThis.playground.store.project.drawing.regions[0].loops[0].length === 6);
  await finished(page);
  const steering = { sizes: [[0.5, 0.5, 0.1]], guides: [[[0.2, 0.3], [0.8, 0.6]]], seedPoints: [[0.5, 0.5], [0.25, 0.75]] };
  await drop(page, 'steered.json', JSON.stringify({ loops: [[[0, 0], [1, 0], [1, 1], [0, 1]]], h: 0.2, ...steering }));
  await page.waitForFunction(() => globalThis.playground.store.project.seedPoints.length === 2);
  assert.deepEqual(await page.evaluate(() => (({ sizes, guides, seedPoints }) => ({ sizes, guides, seedPoints }))(globalThis.playground.store.project)), steering);
  await finished(page);
  for (let i = 0; i < 4; ++i) await undo(page);
  assert.equal(await page.evaluate(() => globalThis.playground.store.project.preset), 'plate');
  await close(page);
});

test('a file that cannot be read leaves the drawing and says why', async () => {
  const page = await playground.open();
  await finished(page);
  await drop(page, 'broken.json', '{"regions": [{"loops": [[[0,0],[1,');
  const bar = page.locator('.error-bar');
  await bar.getByText('This file cannot be read.').waitFor();
  const border = () => bar.evaluate((one) => [getComputedStyle(one).borderTopColor, one.getAttribute('aria-label')]);
  const [red, problem] = await border();
  assert.equal(problem, 'Problem');
  assert.equal(await bar.getByRole('button', { name: 'Open another file' }).count(), 1);
  assert.equal(await page.evaluate(() => globalThis.playground.store.project.preset), 'plate');
  await bar.getByRole('button', { name: 'Close this message' }).click();
  assert.equal(await bar.isVisible(), false);
  await drop(page, 'open.svg', svg.replace('/></svg>', '/><text>a</text><path d="M1 1L3 3"/></svg>'));
  await bar.getByText('was opened, with changes').waitFor();
  assert.notDeepEqual((await border())[0], red, 'what was opened is no failure');
  assert.equal((await border())[1], 'What is not as in the file');
  await close(page);
});

test('an opened file keeps its name, on the page and in what is exported', async () => {
  const page = await playground.open();
  await finished(page);
  await drop(page, 'part.svg', svg);
  await page.locator('#project-name', { hasText: 'part.svg' }).waitFor();
  await finished(page);
  await page.evaluate(() => globalThis.playground.store.change('Edit', ({ drawing }) => ({ preset: '', drawing: { ...drawing } })));
  assert.equal(await page.textContent('#project-name'), 'part.svg');
  const [file] = await Promise.all([page.waitForEvent('download'), page.keyboard.press('Control+s')]);
  assert.equal(file.suggestedFilename(), 'part.lpquad.json');
  await page.click('[data-action="preset.gear"]');
  assert.equal(await page.textContent('#project-name'), 'Gear');
  await close(page);
});

test('a file without outlines is refused as a file: nothing offers to replace the drawing', async () => {
  const page = await withPreset('square');
  await drop(page, 'text.svg', '<svg xmlns="http://www.w3.org/2000/svg"><text>a</text></svg>');
  const bar = page.locator('.error-bar');
  await bar.getByText('text.svg').waitFor();
  assert.doesNotMatch(await bar.textContent(), /yet/);
  assert.deepEqual(await bar.getByRole('button').evaluateAll((all) => all.map((one) => one.ariaLabel ?? one.textContent)), ['Open another file', 'Close this message']);
  assert.equal(await page.evaluate(() => globalThis.playground.store.project.preset), 'square');
  await drop(page, 'place.geojson', '{"type": "Point", "coordinates": [0, 0]}');
  await bar.getByText('place.geojson: It has no outline.').waitFor();
  assert.equal(await page.evaluate(() => globalThis.playground.store.project.preset), 'square');
  await drop(page, 'README.md', 'Words.');
  await bar.getByText(/Surfaces are read from .*\.stl.*domains in the plane from .*\.dxf/).waitFor();
  await close(page);
});

test('of a drawing that was replaced nothing stays on the stage; of one that was edited the mesh does', async () => {
  const page = await withPreset('gear');
  const frame = () => page.evaluate(() => globalThis.playground.scene().frame !== null);
  const cross = () => page.evaluate(() => globalThis.playground.store.change('Cross', ({ drawing }) => ({ preset: '', drawing: {
    ...drawing, regions: [{ name: '', loops: [[[0, 0], [1, 1], [1, 0], [0, 1]]] }] } })));
  await cross();
  await page.locator('.error-bar').waitFor();
  assert.equal(await frame(), true);
  await undo(page);
  await finished(page);
  await page.click('[data-action="sketch.empty"]');
  assert.equal(await frame(), false);
  await cross();
  assert.equal(await frame(), false);
  await drop(page, 'part.svg', svg);
  await finished(page);
  await drop(page, 'crossed.json', JSON.stringify({ loops: [[[0, 0], [1, 1], [1, 0], [0, 1]]] }));
  await page.locator('#project-name', { hasText: 'crossed.json' }).waitFor();
  assert.equal(await frame(), false);
  await close(page);
});

test('to begin empty is no error: the page says what to do', async () => {
  const page = await withPreset('square');
  await page.click('[data-action="sketch.empty"]');
  const bar = page.locator('.error-bar', { hasText: 'There is nothing to mesh yet.' });
  await bar.getByText('Click the corners of an outline here').waitFor();
  const [line, error] = await bar.evaluate((one) => {
    const probe = document.createElement('i');
    probe.style.color = 'var(--error)';
    one.append(probe);
    return [getComputedStyle(one).borderTopColor, getComputedStyle(probe).color];
  });
  assert.notEqual(line, error);
  await page.locator('.stage-name', { hasText: 'no mesh: There is nothing to mesh yet.' }).waitFor();
  await close(page);
});

test('the message about an error is not over its place, and complete on a phone', async () => {
  for (const [width, height] of [[1280, 800], [360, 740], [740, 360]]) {
    const page = await withPreset('square', { width, height });
    for (const y of [0.1, 0.9]) {  // of the crossing
      await page.evaluate((at) => {
        const { stage, store } = globalThis.playground;
        store.change('Cross', { preset: '', drawing: { regions: [{ name: '', loops: [[[0, 0], [1, 0], [1, 1], [0, 1], [0.4, at - 0.05], [0.6, at + 0.05], [0.4, at + 0.05], [0.6, at - 0.05]]] }], polylines: [], points: [] } });
        stage.fit();
      }, y);
      const bar = page.locator('.error-bar');
      await bar.waitFor();
      await page.waitForTimeout(200);
      const box = await bar.boundingBox(), [px, py] = await onScreen(page, 0.5, y);
      assert.ok(px < box.x || px > box.x + box.width || py < box.y || py > box.y + box.height, `${width} ${y}`);
      assert.equal(await bar.locator('.details').isVisible(), true);
      for (const button of await bar.getByRole('button').all()) {
        const { x, width: wide } = await button.boundingBox();
        assert.ok(x >= 0 && x + wide <= width, await button.textContent());
      }
    }
    await close(page);
  }
});

test('by touch: a finger drags a vertex', async () => {
  const page = await withPreset('square', { width: 360, height: 740, touch: true });
  const [x, y] = await onScreen(page, 1, 1);
  const client = await page.context().newCDPSession(page);
  const touch = (type, ...points) => client.send('Input.dispatchTouchEvent', { type, touchPoints: points.map(([px, py]) => ({ x: px, y: py })) });
  await touch('touchStart', [x + 8, y + 5]);
  for (let i = 1; i <= 5; ++i) await touch('touchMove', [x + 8 - 6 * i, y + 5 + 4 * i]);
  await touch('touchEnd');
  const [, , corner] = (await loopsOf(page))[0];
  assert.ok(corner[0] < 0.95 && corner[1] < 0.95, String(corner));
  await finished(page);
  await close(page);
});
