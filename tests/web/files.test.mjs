// What leaves the page: every format, the report, and programs that make the same mesh.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { createLpquad } from '../../dist/node.js';
import { toCommand } from '../../web/files/code/command.js';
import { toCpp } from '../../web/files/code/cpp.js';
import { toJavaScript } from '../../web/files/code/javascript.js';
import { presets } from '../../web/sketch/presets.js';
import { emptyProject, toCall } from '../../web/state/project.js';
import { toFragment } from '../../web/state/link.js';
import { finished, startPlayground } from './support.mjs';

const root = fileURLToPath(new URL('../../', import.meta.url));
const folder = mkdtempSync(join(tmpdir(), 'lpquad-files-'));
const lpquad = await createLpquad();
after(() => rmSync(folder, { recursive: true, force: true }));

const third = 1 / 3;
const parts = {
  ...emptyProject, name: 'two parts', options: { size: 0.13, method: 'paper', norm: 2.5, iterations: 12, allowAddedPoint: false, smoothing: -1 },
  drawing: {
    regions: [
      { name: 'steel “quoted” \\ \'s', loops: [[[0, -0], [1, 0], [1, 1], [0, 1 + third / 8]]], tags: [['bottom', '', '', 'in "1"']] },
      { name: 'copper', loops: [[[1, 0], [2, 0], [2, 1], [1, 1]], [[1.3, 0.3], [1.7, 0.3], [1.5, third * 2]]] },
    ],
    polylines: [{ points: [[0.3, 0.3], [0.5, third]], tag: 'line' }], points: [{ position: [0.7, 0.7], tag: 'probe' }],
  },
};
const painted = { ...parts, options: {}, sizes: [[0, 0, 0.05], [2, 1, 0.2]] };
const presetOf = (id) => presets.find((preset) => preset.id === id).project;
const projects = { plate: presets[0].project, square: presetOf('square'), 'paper-d': presetOf('paper-d'), parts, painted };
const hashes = Object.fromEntries(Object.entries(projects).map(([name, project]) => {
  const { domain, options } = toCall(project);
  return [name, lpquad.meshDomain(domain, options).report.hash];
}));

test('the JavaScript runs as it is and makes the same mesh', () => {
  mkdirSync(join(folder, 'node_modules'), { recursive: true });
  symlinkSync(root, join(folder, 'node_modules/lpquad'), 'dir');
  for (const [name, project] of Object.entries(projects)) {
    const file = join(folder, `${name}.mjs`);
    writeFileSync(file, toJavaScript(project, lpquad.options, name));
    const said = execFileSync(process.execPath, [file], { cwd: folder, encoding: 'utf8' });
    assert.match(said, new RegExp(`quads, hash ${hashes[name]}\n`), name);
    assert.ok(existsSync(join(folder, `${name}.msh`)));
  }
});

test('the command line does too, native where it is built', () => {
  const native = join(root, 'build/release/bin/lpquad');
  const command = existsSync(native) ? `'${native}'` : `'${process.execPath}' '${join(root, 'dist/cli.js')}'`;
  for (const [name, project] of Object.entries(projects)) {
    const script = `lpquad() { ${command} "$@"; }\n${toCommand(project, lpquad.options, name)}`;
    execFileSync('bash', ['-eu', '-c', script], { cwd: folder, stdio: 'pipe' });
    assert.equal(JSON.parse(readFileSync(join(folder, `${name}.report.json`))).hash, hashes[name], name);
  }
});

const libraries = ['io/liblpquad_io.a', 'liblpquad.a'].map((name) => join(root, 'build/release/core', name));
const built = libraries.every(existsSync);
test('the C++ does too, where the library is built', { skip: built ? false : 'the native library is not built' }, () => {
  for (const [name, project] of Object.entries(projects)) {
    const [source, program] = [join(folder, `${name}.cpp`), join(folder, name)];
    writeFileSync(source, toCpp(project, lpquad.options, name));
    execFileSync('g++', ['-std=c++20', '-O1', '-ffp-contract=off', `-I${join(root, 'core')}`, source, '-o', program, ...libraries], { stdio: 'pipe' });
    assert.match(execFileSync(program, { cwd: folder, encoding: 'utf8' }), new RegExp(`quads, hash ${hashes[name]}\n`), name);
  }
});

test('only what differs from the defaults is written', () => {
  const project = { ...parts, options: { size: 0.1, norm: 6, method: 'best', strict: true } };
  for (const [write, wanted] of [[toJavaScript, '{ size: 0.1, strict: true }'], [toCommand, '--size 0.1 --strict\n'], [toCpp, 'options.size = 0.1;\n  options.strict = true;\n']]) {
    const code = write(project, lpquad.options, 'x');
    assert.ok(code.includes(wanted), code);
    assert.ok(!/norm|best/.test(code), code);
  }
});

/** What a click saves. A click whose file takes long to write is no longer the browser's reason to let it be saved: a person clicks again. */
async function saved(page, selector) {
  for (let k = 0; k < 4; ++k) {
    const download = page.waitForEvent('download', { timeout: 20000 }).catch(() => null);
    await page.click(selector);
    const file = await download;
    if (file) return file;
  }
  throw new Error(`${selector} saves nothing`);
}

let playground;
before(async () => { playground = await startPlayground(); });
after(() => playground.close());

test('every format of the library is one click, named after the project, and the library\'s bytes', async () => {
  const page = await playground.open({ hash: await toFragment(parts) });
  await page.getByRole('tab', { name: 'Files' }).click();
  await finished(page);
  const { domain, options } = toCall(parts);
  const mesh = lpquad.meshDomain(domain, options);
  assert.equal(await page.locator('.fingerprint').textContent(), hashes.parts);
  for (const format of lpquad.meshFormats) {
    const file = await saved(page, `[data-format="${format}"]`);
    assert.equal(file.suggestedFilename(), `two_parts.${format}`);
    assert.equal(readFileSync(await file.path(), 'utf8'), lpquad.writeMesh(mesh, format), format);
  }
  await page.locator('li', { has: page.locator('[data-format="msh"]') }).getByRole('combobox').selectOption('2.2');
  const old = await saved(page, '[data-format="msh"]');
  assert.equal(readFileSync(await old.path(), 'utf8'), lpquad.writeMesh(mesh, 'msh', { mshVersion: '2.2' }));
  for (const [ending, head] of [['svg', '<svg'], ['png', '\x89PNG']]) {
    const picture = await saved(page, `[data-action="file.${ending}"]`);
    assert.equal(picture.suggestedFilename(), `two_parts.picture.${ending}`);
    assert.ok(readFileSync(await picture.path(), 'latin1').slice(0, 200).includes(head));
  }
  const report = await saved(page, '[data-action="file.report"]');
  assert.equal(JSON.parse(readFileSync(await report.path())).hash, hashes.parts);
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test('the code on the screen is the code that is copied', async () => {
  const page = await playground.open({ hash: await toFragment(parts) });
  await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
  await page.getByRole('tab', { name: 'Files' }).click();
  for (const [language, write] of [['javascript', toJavaScript], ['cpp', toCpp], ['command', toCommand]]) {
    await page.getByRole('combobox', { name: 'Language' }).selectOption(language);
    await page.click('[data-action="file.code"]');
    await page.locator('.notice', { hasText: 'is copied' }).waitFor();
    const code = await page.evaluate(() => navigator.clipboard.readText());
    assert.equal(code, write(parts, lpquad.options, 'two_parts'));
    assert.equal(await page.locator('.code').textContent(), code);
    await page.click('.notice button');
  }
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test('nothing is exported while there is no mesh, and the reason is said', async () => {
  const crossed = { ...emptyProject, drawing: { regions: [{ name: '', loops: [[[0, 0], [1, 1], [1, 0], [0, 1.2]]] }], polylines: [], points: [] } };
  const page = await playground.open({ hash: await toFragment(crossed) });
  await page.getByRole('tab', { name: 'Files' }).click();
  await page.locator('#export-reason', { hasText: 'There is no mesh' }).waitFor();
  assert.equal(await page.getAttribute('[data-format="msh"]', 'aria-disabled'), 'true');
  await page.locator('[data-format="msh"]').click({ force: true });
  await page.locator('.notice').waitFor();
  assert.deepEqual(page.errors, []);
  await page.context().close();
});
