// CAD files on the page for surfaces: occt-import-js, a package with a licence of its own, fetched with the
// first such file.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { stepBoxes } from '../wasm/step_boxes.mjs';
import { folder, startPlayground } from './support.mjs';
import { violations } from './violations.mjs';

const root = fileURLToPath(new URL('../../', import.meta.url));
let playground;
before(async () => { playground = await startPlayground(); });
after(() => playground.close());

const patience = 180000;
const boxes = Buffer.from(stepBoxes([{ name: 'plate', at: [0, 0, 0], size: [4, 2, 1] }, { name: 'block', at: [10, 0, 0], size: [1, 1, 1] }]));
const step = (name, buffer = boxes) => ({ name, mimeType: 'model/step', buffer });
const over = (page) => page.locator('.stage-name', { hasText: /^done/ }).waitFor({ timeout: patience });
const ofThePackage = (url) => url.includes('/occt-import-js/');

async function openSpace(how = {}) {
  const page = await playground.open({ ...how, hash: 'space.html#preset=saddle&size=0.3' });
  await over(page);
  return page;
}

async function choose(page, file, name = file.name) {
  await page.locator('input[type=file]').setInputFiles(file);
  await page.locator('#project-name', { hasText: name }).waitFor({ timeout: patience });
  await over(page);
}

const seen = (page) => page.evaluate(() => {
  const { store, runner } = globalThis.playground;
  const { report } = runner.run.result;
  return { names: store.project.surface.groupNames, faces: report.faces, parts: report.repairs.components, quads: report.quads,
    triangles: report.triangles, hash: report.hash };
});

test('a STEP file is opened with its faces as groups, by a reader that no other file fetches', async () => {
  const page = await openSpace();
  const fetched = [];
  page.on('request', (request) => { if (ofThePackage(request.url())) fetched.push(request.url()); });
  await page.locator('input[type=file]').setInputFiles({ name: 'x.obj', mimeType: 'model/obj', buffer: Buffer.from('v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n') });
  await page.locator('#project-name', { hasText: 'x.obj' }).waitFor({ timeout: patience });
  await over(page);
  assert.deepEqual(fetched, []);
  await choose(page, step('boxes.step'));
  const { names, faces, parts, triangles } = await seen(page);
  assert.deepEqual(names, ['plate', 'block'].flatMap((body) => [1, 2, 3, 4, 5, 6].map((n) => `${body} face ${n}`)));
  assert.deepEqual([faces, parts, triangles], [12, 2, 0]);
  assert.ok(await page.locator('.notice').isHidden());
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test('its code makes the same mesh', async () => {
  const page = await openSpace();
  await choose(page, step('two boxes.stp'));
  const { hash } = await seen(page);
  await page.getByRole('tab', { name: 'Files' }).click();
  await page.locator('pre.code', { hasText: "import { readCad } from 'lpquad/cad'" }).waitFor();
  const script = await page.locator('pre.code').textContent();
  await page.getByLabel('Language').selectOption('Command line');
  await page.locator('pre.code', { hasText: /^npx lpquad convert/ }).waitFor();
  const commands = (await page.locator('pre.code').textContent()).trim().split('\n');
  const place = mkdtempSync(join(tmpdir(), 'lpquad-code-'));
  try {
    writeFileSync(join(place, 'two boxes.stp'), boxes);
    // What npm would find: the package, and the other one beside it.
    const dist = (file) => new URL(`../../dist/${file}`, import.meta.url).href;
    writeFileSync(join(place, 'script.mjs'), script.replace("'lpquad'", `'${dist('node.js')}'`).replace("'lpquad/cad'", `'${dist('cad.js')}'`));
    assert.equal(execFileSync(process.execPath, ['script.mjs'], { cwd: place, encoding: 'utf8' }).trim(), hash);
    const cli = `'${process.execPath}' '${join(root, 'dist/cli.js')}'`;
    for (const command of commands)
      execFileSync('sh', ['-c', `${command.replace(/^(npx )?lpquad/, cli)}${command.includes(' mesh ') ? ' --report report.json' : ''}`], { cwd: place });
    assert.equal(JSON.parse(readFileSync(join(place, 'report.json'), 'utf8')).hash, hash);
  } finally {
    rmSync(place, { recursive: true });
  }
  await page.context().close();
});

test('a file that is no STEP file is refused in words, and the run stays', async () => {
  const page = await openSpace();
  const { hash } = await page.evaluate(() => globalThis.playground.runner.run.result.report);
  await page.locator('input[type=file]').setInputFiles(step('broken.step', Buffer.from('ISO-10303-21;')));
  await page.locator('.notice', { hasText: 'broken.step could not be opened: The file cannot be read as STEP.' }).waitFor({ timeout: patience });
  assert.equal(await page.evaluate(() => globalThis.playground.runner.run.result.report.hash), hash);
  await page.context().close();
});

test('a reader that cannot be loaded is said, and tried again with the next file', async () => {
  const page = await openSpace();
  for (const [file, fail] of [['*.wasm', (route) => route.fulfill({ status: 404 })], ['*.js', (route) => route.abort()]]) {
    const pattern = `**/occt-import-js/${file}`;
    await page.route(pattern, fail);
    await page.locator('input[type=file]').setInputFiles(step('boxes.step'));
    await page.locator('.notice', { hasText: /boxes\.step could not be opened: the reader of CAD files could not be loaded/ }).waitFor({ timeout: patience });
    await page.getByRole('button', { name: 'Close the notice' }).click();
    await page.unroute(pattern);
  }
  await choose(page, step('boxes.step'));
  assert.equal((await seen(page)).faces, 12);
  await page.context().close();
});

test('progress is said while the reader is loaded; of two files the second is opened', async () => {
  const page = await openSpace();
  let hold;
  const held = new Promise((resolve) => { hold = resolve; });
  await page.route('**/occt-import-js/*.wasm', async (route) => {
    await new Promise(hold);
    await route.continue();
  }, { times: 1 });
  await page.locator('input[type=file]').setInputFiles(step('first.step'));
  await page.locator('.notice', { hasText: 'Loading the reader of CAD files' }).waitFor();
  const release = await held;  // before, it would be the second file's request that is held for ever
  await choose(page, step('second.step'));
  release();
  await page.waitForTimeout(500);
  assert.equal(await page.evaluate(() => globalThis.playground.store.project.name), 'second.step');
  await page.context().close();
});

test('once used, the reader is there without a network', async () => {
  const page = await openSpace({ offline: true });
  await choose(page, step('boxes.step'));
  const kept = () => page.evaluate(async () => {
    const names = await caches.keys();
    const urls = (await Promise.all(names.map(async (name) => (await (await caches.open(name)).keys()).map(({ url }) => url)))).flat();
    return urls.filter((url) => url.includes('/occt-import-js/')).length === 2;
  });
  for (let waited = 0; !await kept(); waited += 200) {
    assert.ok(waited < patience);
    await page.waitForTimeout(200);
  }
  await page.context().setOffline(true);
  await page.goto('about:blank');
  await page.goto(`${playground.address}space.html#preset=saddle&size=0.3`);
  await over(page);
  await choose(page, step('again.step'));
  assert.equal((await seen(page)).faces, 12);
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test('a file opened on the page for the plane is taken to space', async () => {
  const page = await playground.open();
  await page.locator('input[type=file]').first().setInputFiles(step('boxes.step'));
  await page.waitForURL(/space\.html/, { timeout: patience });
  await page.locator('#project-name', { hasText: 'boxes.step' }).waitFor({ timeout: patience });
  await page.context().close();
});

test('the reader lies apart from the page, unchanged, with licence and source beside it', async () => {
  const files = readdirSync(join(folder, 'occt-import-js'));
  const one = (pattern) => {
    const found = files.filter((name) => pattern.test(name));
    assert.equal(found.length, 1, String(pattern));
    return readFileSync(join(folder, 'occt-import-js', found[0]));
  };
  const published = (name) => readFileSync(join(root, 'node_modules/occt-import-js/dist', name));
  assert.ok(one(/\.wasm$/).equals(published('occt-import-js.wasm')));
  assert.ok(one(/\.js$/).equals(published('occt-import-js.js')));
  assert.match(one(/^license\.occt-import-js.*\.txt$/).toString(), /LESSER GENERAL PUBLIC LICENSE/);
  assert.match(one(/^license\.occt-(?!import).*\.txt$/).toString(), /LESSER GENERAL PUBLIC LICENSE/);
  const { version } = JSON.parse(readFileSync(join(root, 'node_modules/occt-import-js/package.json'), 'utf8'));
  const notice = one(/^README\.txt$/).toString();
  assert.match(notice, /LGPL-2\.1/);
  assert.ok(notice.includes(`https://github.com/kovacsv/occt-import-js/tree/${version}`));
  const [lists] = readFileSync(join(folder, 'service_worker.js'), 'utf8').match(/\{.*\}/);
  assert.ok(JSON.parse(lists).files.every((file) => !file.startsWith('occt-import-js')));
  assert.ok(JSON.parse(lists).later.some((file) => file.endsWith('.wasm')));
  for (const name of readdirSync(join(folder, 'assets')).filter((name) => name.endsWith('.js')))
    assert.ok(!readFileSync(join(folder, 'assets', name), 'utf8').includes('ReadBrepFile:'), name);
});

for (const [width, dark] of [[360, true], [1440, false]])
  test(`what is said about the reader fits at ${width} px, and its links lead somewhere`, async () => {
    const page = await openSpace({ width, height: 800, dark });
    await page.getByText('What reads STEP, IGES and BREP').click();
    assert.ok(!await page.evaluate(() => document.documentElement.scrollWidth > innerWidth));
    assert.deepEqual(await violations(page), []);
    const links = await page.locator('details a').evaluateAll((all) => all.map(({ href }) => href));
    for (const link of links.filter((href) => href.startsWith(playground.address))) assert.equal((await page.request.get(link)).status(), 200, link);
    assert.equal(links.length, 3);
    await page.context().close();
  });

// Files of the benchmark data, where they lie beside the project.
const data = new URL('../../../shared/data/step/', import.meta.url);
for (const [name, faces] of [['base_interface_AP203.STEP', 30], ['Cube_10x10.igs', 6], ['capot.brep', 18]])
  test(`${name} is opened and meshed`, { skip: existsSync(data) ? false : 'SKIPPED: no benchmark data' }, async () => {
    const page = await openSpace();
    await choose(page, fileURLToPath(new URL(name, data)), name);
    const found = await seen(page);
    assert.equal(found.names.length, faces);
    assert.ok(found.quads > 500 && found.triangles === 0);
    assert.deepEqual(page.errors, []);
    await page.context().close();
  });
