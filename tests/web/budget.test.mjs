// What the page costs to load.
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { gzipSync } from 'node:zlib';
import { folder } from './support.mjs';

const assets = join(folder, 'assets');

/** The scripts that a page can come to load: those it names, and those that they name, workers and lazy parts too. */
function scriptsOf(page) {
  const all = readdirSync(assets).filter((name) => name.endsWith('.js'));
  const found = new Set(), open = [readFileSync(join(folder, page), 'utf8')];
  while (open.length > 0) {
    const text = open.pop();
    for (const name of all) {
      if (found.has(name) || !text.includes(name)) continue;
      found.add(name);
      open.push(readFileSync(join(assets, name), 'utf8'));
    }
  }
  return [...found];
}

const packed = (names) => names.reduce((sum, name) => sum + gzipSync(readFileSync(join(assets, name)), { level: 9 }).length, 0);

// Space has three.js, which is more than all the rest.
for (const [page, most] of [['index.html', 150_000], ['space.html', 225_000]])
  test(`the scripts of ${page}, workers and lazy parts included, stay within ${most / 1000} kB`, (t) => {
    const bytes = packed(scriptsOf(page));
    t.diagnostic(`${(bytes / 1000).toFixed(1)} kB of JavaScript`);
    assert.ok(bytes > 50_000 && bytes <= most, `${bytes} bytes`);
  });

test('the page for the plane never loads what draws in space', () => {
  const onlySpace = scriptsOf('space.html').filter((name) => name.startsWith('space-'));
  assert.ok(onlySpace.length > 0);
  for (const name of onlySpace) assert.ok(!scriptsOf('index.html').includes(name), name);
});

test('the licence of what is in the scripts goes with them', () => {
  assert.match(readFileSync(join(assets, 'three.LICENSE.txt'), 'utf8'), /MIT License[^]*three\.js authors/);
  assert.match(readFileSync(join(assets, 'third-party.txt'), 'utf8'), /Eigen[^]*Niels Lohmann[^]*musl/);
});

test('what the first paint waits for is small: the page, its style, and no script', (t) => {
  const html = readFileSync(join(folder, 'index.html'), 'utf8'), gzipped = (bytes) => gzipSync(bytes, { level: 9 }).length;
  const styles = [...html.matchAll(/<link[^>]*rel="stylesheet"[^>]*href="([^"]+)"/g)].map(([, href]) => readFileSync(join(folder, href)));
  const bytes = [Buffer.from(html), ...styles].reduce((sum, file) => sum + gzipped(file), 0);
  t.diagnostic(`${bytes} bytes in ${1 + styles.length} files`);
  assert.ok(styles.length >= 1 && bytes <= 30_000, `${bytes} bytes`);
  for (const [script] of html.matchAll(/<script[^>]*>/g)) assert.match(script, /type="module"/);
});

for (const page of ['index.html', 'space.html'])
  test(`${page} asks nobody else for anything`, () => {
    const html = readFileSync(join(folder, page), 'utf8');
    assert.doesNotMatch(html, /(?:src|href)="(?:https?:)?\/\//);
    assert.doesNotMatch(html, /(?:src|href)="\//);  // from any folder
  });
