// What is in the package, and that everything that is said twice says the same.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { test } from 'node:test';
import { gzipSync } from 'node:zlib';

import { createLpquad, dist, path } from './support.mjs';

const lpquad = await createLpquad();
// Bytes after gzip -9; what meshes surfaces is loaded by those who do.
const wasmBudget = (name) => (name.startsWith('lpquad-surface') ? 400 : 300) * 1024;
const text = (file) => readFileSync(dist(file), 'utf8');
const node = (...args) => spawnSync(process.execPath, args, { encoding: 'utf8', cwd: path('') });

test('the package holds what its package.json names, and nothing else', () => {
  const manifest = JSON.parse(readFileSync(path('package.json')));
  assert.deepEqual(manifest.files, ['dist', 'LICENSE', 'README.md']);
  for (const kind of ['dependencies', 'optionalDependencies']) assert.equal(manifest[kind], undefined);
  // What reads CAD files has another licence (LGPL): nobody gets it without asking.
  assert.deepEqual(Object.keys(manifest.peerDependencies), ['occt-import-js']);
  assert.deepEqual(manifest.peerDependenciesMeta, { 'occt-import-js': { optional: true } });
  assert.equal(node('wasm/package.mjs', '--check').status, 0);
  for (const target of Object.values(manifest.exports).filter((t) => typeof t === 'object')) {
    assert.equal(Object.keys(target)[0], 'types');
    assert.equal(Object.keys(target).at(-1), 'default');
  }
  const known = /\.(js|d\.ts|wasm|cjs)$|^third-party\.txt$/;
  for (const file of readdirSync(dist(''))) assert.match(file, known);
});

test('the project says in the same words everywhere what it is', () => {
  const { description } = JSON.parse(readFileSync(path('package.json')));
  for (const file of ['README.md', 'CMakeLists.txt', 'wasm/js/index.d.ts', 'core/cli/help.cpp'])
    assert.ok(readFileSync(path(file), 'utf8').toLowerCase().includes(description.toLowerCase()), file);
});

test('the .wasm files stay within their budget', (t) => {
  for (const name of readdirSync(dist('')).filter((file) => file.endsWith('.wasm') && file !== 'cli.wasm')) {
    const { length } = gzipSync(readFileSync(dist(name)), { level: 9 });
    t.diagnostic(`${name}: ${(length / 1024).toFixed(1)} KiB gzip`);
    assert.ok(length <= wasmBudget(name), `${name}: ${length} bytes`);
  }
});

test('no code is made from text, so that strict content security policies hold', () => {
  for (const file of readdirSync(dist('')).filter((name) => /\.c?js$/.test(name) && !name.endsWith('-wasm.js')))
    assert.doesNotMatch(text(file), /\bnew\s+Function\b|\bFunction\s*\(|\beval\s*\(/, file);
});

test('the web entries need nothing of Node', () => {
  for (const file of ['index.js', 'inline.js', 'inline-surface.js', 'worker.js', 'worker-entry.js', 'glue.js', 'readers-glue.js',
    'surface-glue.js', 'load.js', 'api.js', 'cad.js', 'cad-repeats.js', 'session.js', 'handle.js', 'client.js', 'domain.js', 'surface.js', 'fields.js',
    'base64.js', 'checks.js', 'errors.js', 'lists.js', 'worker-thread.js'])
    assert.doesNotMatch(text(file), /node:|require\(|__dirname|from 'fs'/, file);
});

test('names of the package\'s files are written alike: words joined by hyphens', () => {
  for (const file of readdirSync(dist('')))
    assert.match(file, /^[a-z0-9]+(-[a-z0-9]+)*(\.d)?\.[a-z]+$/, file);
});

test('importing does nothing', () => {
  const watched = ['index.js', 'cad.js', 'inline.js', 'inline-surface.js', 'node.js', 'worker.js', 'worker-node.js']
    .map((file) => `await import(${JSON.stringify(dist(file).href)});`).join('');
  const { status, stdout, stderr } = node('--input-type=module', '-e',
    `for (const f of ['compile','instantiate','Module']) WebAssembly[f] = () => { throw new Error(f); };
     globalThis.fetch = () => { throw new Error('fetch'); };
     const before = Object.keys(globalThis).length;
     ${watched}
     if (Object.keys(globalThis).length !== before) throw new Error('a global');`);
  assert.equal(`${status}${stdout}${stderr}`, '0');
});

test('the types of options, codes and formats are those of the option tables', () => {
  const { status, stderr } = node('wasm/types.mjs', '--check');
  assert.equal(status, 0, stderr);
  const declared = text('generated.d.ts');
  for (const option of [...lpquad.options, ...lpquad.surfaceOptions, ...lpquad.writeOptions])
    assert.ok(declared.includes(`  ${option.name}?: `) && declared.includes(option.help), option.name);
  for (const code of lpquad.errorCodes) assert.match(declared, new RegExp(` \\* - \`${code}\`: \\w`));
});

test('the command line has the same options, defaults and help', () => {
  const { status, stdout } = node(path('dist/cli.js'), 'mesh', '--help');
  assert.equal(status, 0);
  const help = stdout.replace(/\s+/g, ' ');
  const flagOf = ({ name, default: usual }) =>
    `--${usual === true ? '[no-]' : ''}${name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`)}`;
  // What is the same for surfaces and domains is described once, and listed.
  const isShared = (option) => lpquad.options.some((other) =>
    other.name === option.name && other.help === option.help && other.default === option.default);
  const [, shared] = help.match(/surfaces know (.*?) as above;/);
  assert.deepEqual(shared.split(', ').sort(), lpquad.surfaceOptions.filter(isShared).map(flagOf).sort());
  const own = lpquad.surfaceOptions.filter((option) => !isShared(option));
  assert.ok(own.some(({ name }) => name === 'size'));
  const surfaces = help.indexOf(' Surfaces Of the method');
  for (const option of [...lpquad.options, ...own, ...lpquad.writeOptions]) {
    const flag = flagOf(option);
    const at = help.indexOf(`${flag} `, own.includes(option) ? surfaces : 0);
    assert.ok(at >= 0, flag);
    const entry = help.slice(at, at + 700);
    assert.ok(entry.includes(option.help.replace(/\s+/g, ' ')), `${flag}: ${option.help}`);
    if (option.type !== 'boolean') assert.ok(entry.includes(String(option.default)), `${flag}: ${option.default}`);
    for (const choice of option.choices ?? []) assert.ok(entry.includes(choice), `${flag}: ${choice}`);
  }
  assert.equal(node(path('dist/cli.js'), '--version').stdout.trim().split(' ').at(-1), lpquad.version);
});

const tsc = path('node_modules/typescript/bin/tsc');
for (const resolution of ['node', 'bundler'])
  test(`the declarations hold for ${resolution} projects`,
    { skip: existsSync(tsc) ? false : 'SKIPPED: typescript is not installed (npm ci)' }, () => {
      const { status, stdout } = node(tsc, '-p', `tests/wasm/types/${resolution}.json`);
      assert.equal(status, 0, stdout);
    });
