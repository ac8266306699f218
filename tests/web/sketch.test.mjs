// Snapping, strokes of the hand, the size brush, shapes, files and presets: all without a page.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { createLpquad } from '../../dist/node.js';
import { problemsOf } from '../../web/sketch/crossings.js';
import { erased, painted } from '../../web/sketch/model/painting.js';
import { circle, circleOf, rectangle, rectangleOf } from '../../web/sketch/model/shapes.js';
import { tidied } from '../../web/sketch/model/smooth.js';
import { fittingGrid, snap, toGrid } from '../../web/sketch/model/snap.js';
import { presets } from '../../web/sketch/presets.js';
import { airfoil } from '../../web/sketch/presets/outlines.js';
import { jitteredGrid, splitMix64 } from '../../web/sketch/presets/paper_squares.js';
import { toCall } from '../../web/state/project.js';

const drawing = { regions: [{ name: '', loops: [rectangle(0, 0, 10, 10)] }], polylines: [], points: [] };
const plain = { vertices: true, grid: false, gridSize: 0, angles: false, angleStep: 15 };

test('a pointer snaps to a vertex, to directions and their crossing, to the grid', () => {
  const near = snap([9.95, 0.04], 0.01, { drawing, snapping: plain });
  assert.deepEqual([near.at, near.to], [[10, 0], 'vertex']);
  const straight = snap([5, 2.05], 0.001, { drawing, snapping: plain, anchors: [[1, 2]], shift: true });
  assert.deepEqual([straight.at, straight.to, straight.rays[0].degrees], [[5, 2], 'angle', 0]);
  const corner = snap([5.01, 2.01], 0.01, { drawing, snapping: { ...plain, angles: true }, anchors: [[1, 2], [5, 7]] });
  assert.deepEqual(corner.at, [5, 2]);
  assert.equal(corner.rays.length, 2);
  const grid = snap([3.14, 2.71], 0.001, { drawing, snapping: { ...plain, grid: true, gridSize: 0.1 } });
  assert.deepEqual([grid.at, grid.to], [[3.1, 2.7], 'grid']);
  assert.equal(snap([3.14, 2.71], 0.001, { drawing, snapping: plain }).to, '');
});

test('grids are round and at least twelve pixels wide', () => {
  for (const pixel of [1e-9, 0.003, 0.01, 0.5, 7, 1e6]) {
    const step = fittingGrid(pixel);
    assert.ok(step >= 12 * pixel * (1 - 1e-12) && step <= 30.001 * pixel, `${pixel}: ${step}`);
    assert.match(step.toExponential(6), /^[125]\.0+e/);
  }
  assert.equal(toGrid(0.30000001, 0.1), 0.3);
  assert.equal(toGrid(123456.7, 50), 123450);
});

test('a shaky circle becomes one of few points', () => {
  const shake = (i) => 1.5 * Math.sin(37.7 * i) + Math.cos(91.3 * i);
  const stroke = circle(300, 300, 200, 500).map(([x, y], i) => [x + shake(i), y + shake(i + 1000)]);
  const loop = tidied(stroke, true, 1);
  assert.ok(loop.length >= 16 && loop.length <= 70, String(loop.length));
  for (const [x, y] of loop) assert.ok(Math.abs(Math.hypot(x - 300, y - 300) - 200) < 4);
  const line = tidied(Array.from({ length: 100 }, (_, i) => [3 * i, 0.3 * Math.sin(i)]), false, 1);
  assert.deepEqual(line.length, 2);
});

test('the brush covers its disc, replaces other sizes and erases them', () => {
  const first = painted([], [1, 1], 0.5, 0.05);
  assert.ok(first.length > 30 && first.length < 100);
  assert.equal(painted(first, [1, 1], 0.5, 0.05), first);
  const second = painted(first, [1, 1], 0.5, 0.02);
  assert.ok(second.every(([, , h]) => h === 0.02));
  assert.deepEqual(erased(second, [1, 1], 0.6), []);
  assert.equal(erased(first, [9, 9], 0.5), first);
});

test('circles and rectangles are known again', () => {
  const found = circleOf(circle(3, -2, 0.7, 24, 0.3));
  assert.ok(Math.abs(found.x - 3) < 1e-12 && Math.abs(found.radius - 0.7) < 1e-12 && Math.abs(found.start - 0.3) < 1e-12);
  assert.equal(circleOf(airfoil('2412', 20)), null);
  assert.deepEqual(rectangleOf(rectangle(1, 2, 4, 8)), { left: 1, bottom: 2, width: 3, height: 6 });
  assert.equal(rectangleOf([[0, 0], [1, 0], [1, 1], [0.1, 1]]), null);
});

test('the starts of the paper are those of the core\'s generator', () => {
  const next = splitMix64(1);
  assert.equal(next(), Number(0x6E789E6AA1B965F4n >> 11n) * 2 ** -53);  // the well-known second output from the state 0
  const grid = jitteredGrid(11, 0.6, 1);
  assert.equal(grid.length, 81);
  assert.ok(grid.every(([x, y]) => x >= 0.03 && x <= 0.97 && y >= 0.03 && y <= 0.97));
});

test('every preset becomes quads only, without a word of complaint', async () => {
  const lib = await createLpquad();
  assert.ok(presets.length >= 14);
  assert.equal(new Set(presets.map(({ id }) => id)).size, presets.length);
  for (const { id, title, why, project } of presets) {
    assert.ok(title && why && project.preset === id);
    assert.deepEqual(problemsOf(project.drawing), [], id);
    const { domain, options } = toCall(project);
    const { report } = lib.meshDomain(domain, options);
    assert.equal(report.triangles, 0, id);
    assert.deepEqual(report.warnings, [], id);
    assert.ok(report.quality.etaMin > 0.2, `${id}: ${report.quality.etaMin}`);
    assert.ok(report.quads < 2500, id);
  }
});

test('the paper\'s squares end as grids, the worst start nearly', async () => {
  const lib = await createLpquad();
  for (const { id, project } of presets.filter((preset) => preset.id.startsWith('paper-'))) {
    const { domain, options } = toCall(project);
    const { report } = lib.meshDomain(domain, options);
    if (id === 'paper-d') assert.ok(Math.abs(report.quads - 100) <= 5);
    else assert.equal(report.quads, 100, id);
  }
});

test('the country is the one of the fixtures', () => {
  const { loops } = JSON.parse(readFileSync(new URL('../fixtures/domains/denmark.json', import.meta.url), 'utf8'));
  const { drawing: { regions } } = presets.find(({ id }) => id === 'denmark').project;
  assert.equal(regions[0].loops[0].length, loops[0].length);
});
