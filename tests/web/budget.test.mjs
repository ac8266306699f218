// What the page costs to load.
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { gzipSync } from 'node:zlib';
import { folder } from './support.mjs';

const assets = join(folder, 'assets');
const packed = (ending) => readdirSync(assets).filter((name) => name.endsWith(ending))
  .reduce((sum, name) => sum + gzipSync(readFileSync(join(assets, name)), { level: 9 }).length, 0);

test('all scripts together, workers and lazy parts included, stay within 150 kB', (t) => {
  const bytes = packed('.js');
  t.diagnostic(`${(bytes / 1000).toFixed(1)} kB of JavaScript, ${(packed('.css') / 1000).toFixed(1)} kB of style`);
  assert.ok(bytes <= 150_000, `${bytes} bytes`);
});

test('what the first paint waits for is small: the page, its style, and no script', (t) => {
  const html = readFileSync(join(folder, 'index.html'), 'utf8'), gzipped = (bytes) => gzipSync(bytes, { level: 9 }).length;
  const styles = [...html.matchAll(/<link[^>]*rel="stylesheet"[^>]*href="([^"]+)"/g)].map(([, href]) => readFileSync(join(folder, href)));
  const bytes = [Buffer.from(html), ...styles].reduce((sum, file) => sum + gzipped(file), 0);
  t.diagnostic(`${bytes} bytes in ${1 + styles.length} files`);
  assert.ok(styles.length >= 1 && bytes <= 30_000, `${bytes} bytes`);
  for (const [script] of html.matchAll(/<script[^>]*>/g)) assert.match(script, /type="module"/);
});

test('the page asks nobody else for anything', () => {
  const html = readFileSync(join(folder, 'index.html'), 'utf8');
  assert.doesNotMatch(html, /(?:src|href)="(?:https?:)?\/\//);
  assert.doesNotMatch(html, /(?:src|href)="\//);  // from any folder
});
