// The command line for Node: what it writes where, and that it reads what the native program reads.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { closeSync, mkdtempSync, openSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';

import { createLpquad, path } from './support.mjs';

const scratch = mkdtempSync(join(tmpdir(), 'lpquad-cli-'));
after(() => rmSync(scratch, { recursive: true }));
const file = (name) => join(scratch, name);
const cli = path('dist/cli.js');
const lpquad = (...args) => spawnSync(process.execPath, [cli, ...args], { encoding: 'utf8' });

const square = file('square.json');
writeFileSync(square, JSON.stringify({ loops: [[[0, 0], [1, 0], [1, 1], [0, 1]]] }));
const meshing = ['mesh', square, '-o', file('square.obj'), '--size', '0.05'];

test('progress is drawn for eyes only', () => {
  assert.equal(lpquad(...meshing).stderr, '');
  const log = openSync(file('log'), 'w');
  const { status } = spawnSync(process.execPath, [cli, ...meshing], { stdio: ['ignore', 'ignore', log] });
  closeSync(log);
  assert.equal(status, 0);
  assert.equal(readFileSync(file('log'), 'utf8'), '');
});

const script = spawnSync('script', ['-qec', 'test -t 2', '/dev/null']).status === 0;
test('on a terminal there is a line of progress', { skip: script ? false : 'SKIPPED: no program script' }, () => {
  const { status, stdout } = spawnSync('script', ['-qec',
    [process.execPath, cli, ...meshing].map((word) => `'${word}'`).join(' '), '/dev/null'], { encoding: 'utf8' });
  assert.equal(status, 0, stdout);
  assert.match(stdout, /\r\x1b\[K[a-z]+/);
});

// A box in bytes of the other order, and a plate of two regions.
const seed = (name) => readFileSync(path(`tests/fuzz/corpus/${name}`)).subarray(1);
test('binary .msh files are read, by the package and by the command line', async () => {
  const reader = await createLpquad();
  const box = seed('surface_readers_fuzz/msh_bytes_big');
  assert.equal(await reader.isSurfaceFile(box, { name: 'box.msh' }), true);
  const { triangles, groupNames } = await reader.readSurface(box, { name: 'box.msh' });
  assert.equal(triangles.length % 36, 0);
  assert.deepEqual(groupNames, ['even', 'physical surface 2']);
  const plate = seed('domain_readers_fuzz/msh_bytes');
  assert.equal(await reader.isSurfaceFile(plate, { name: 'plate.msh' }), false);
  assert.equal((await reader.readDomain(plate, { name: 'plate.msh' })).regions.length, 2);
  writeFileSync(file('box.msh'), box);
  const { status, stderr } = lpquad('mesh', file('box.msh'), '-o', file('box.obj'), '--size', '0.5');
  assert.equal(status, 0, stderr);
  writeFileSync(file('plate.msh'), plate);
  assert.equal(lpquad('mesh', file('plate.msh'), '-o', file('plate.obj'), '--size', '0.1').status, 0);
  assert.match(lpquad('check', file('plate.msh')).stdout, /triangles 2/);
});
