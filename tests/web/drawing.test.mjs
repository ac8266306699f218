import assert from 'node:assert/strict';
import { test } from 'node:test';
import * as model from '../../web/sketch/model/drawing.js';

const square = (x, y, side) => [[x, y], [x + side, y], [x + side, y + side], [x, y + side]];
const drawing = (...regions) => ({ regions, polylines: [], points: [] });
const region = (loops, tags) => ({ name: '', loops, ...(tags && { tags }) });
const place = (r, loop, vertex = 0) => ({ region: r, loop, vertex });
const pair = drawing(region([square(0, 0, 1)], [['south', 'joint', 'north', 'west']]), region([square(1, 0, 1)]));

/** Freezes all of a value: a change in place throws. */
function frozen(value) {
  if (typeof value === 'object' && value !== null) Object.values(Object.freeze(value)).forEach(frozen);
  return value;
}
frozen(pair);

test('a shared vertex moves in all regions, lines and points that have it', () => {
  const before = frozen({ ...pair, polylines: [{ points: [[1, 1], [0.5, 0.5]], tag: 'weld' }], points: [{ position: [1, 1], tag: '' }] });
  const after = model.moveVertex(before, place(0, 0, 2), [1.1, 0.9]);
  assert.deepEqual(after.regions[0].loops[0][2], [1.1, 0.9]);
  assert.deepEqual(after.regions[1].loops[0][3], [1.1, 0.9]);
  assert.deepEqual(after.polylines[0].points[0], [1.1, 0.9]);
  assert.deepEqual(after.points[0].position, [1.1, 0.9]);
  assert.equal(before.regions[0].loops[0][2][0], 1);
});

test('a vertex on a shared edge comes to both, with the tag on both halves', () => {
  const after = model.addVertex(pair, place(1, 0, 3), [1, 0.5]);
  assert.deepEqual(after.regions[0].loops[0], [[0, 0], [1, 0], [1, 0.5], [1, 1], [0, 1]]);
  assert.deepEqual(after.regions[0].tags[0], ['south', 'joint', 'joint', 'north', 'west']);
  assert.deepEqual(after.regions[1].loops[0], [[1, 0], [2, 0], [2, 1], [1, 1], [1, 0.5]]);
});

test('removing a vertex keeps a tag on every edge, and undoes adding it', () => {
  const added = model.addVertex(pair, place(0, 0, 1), [1, 0.5]);
  assert.deepEqual(model.removeVertex(added, place(0, 0, 2)), pair);
  const without = model.removeVertex(pair, place(0, 0, 0));
  assert.deepEqual(without.regions[0].tags[0], ['joint', 'north', 'west']);
  assert.equal(without.regions[0].loops[0].length, 3);
});

test('of fewer than three vertices no loop is left, of fewer than two no line', () => {
  const one = frozen({ ...drawing(region([square(0, 0, 4), [[1, 1], [2, 1], [1, 2]]])), polylines: [{ points: [[3, 3], [3, 2]], tag: '' }], points: [{ position: [0.5, 3], tag: '' }] });
  assert.equal(model.removeVertex(one, place(0, 1, 1)).regions[0].loops.length, 1);
  assert.equal(model.removeVertex(one, place(-1, 0, 1)).polylines.length, 0);
  assert.equal(model.removeVertex(one, place(-2, 0, 0)).points.length, 0);
  const triangle = drawing(region([[[0, 0], [1, 0], [0, 1]]]));
  assert.deepEqual(model.removeVertex(triangle, place(0, 0, 1)).regions, []);
});

test('a loop becomes a hole, an island, a region beside, or a region around', () => {
  const plate = drawing(region([square(0, 0, 10)], [['', '', '', 'inlet']]));
  const hole = model.addLoop(plate, square(2, 2, 4));
  assert.equal(hole.regions.length, 1);
  assert.deepEqual(hole.regions[0].tags, [['', '', '', 'inlet'], ['', '', '', '']]);
  const island = model.addLoop(hole, square(3, 3, 1));
  assert.equal(island.regions.length, 2);
  assert.deepEqual(island.regions[1].loops, [square(3, 3, 1)]);
  assert.equal(model.addLoop(plate, square(20, 0, 1)).regions.length, 2);
  const around = model.addLoop(pair, square(-1, -1, 5));
  assert.deepEqual(around.regions[2].loops, [square(-1, -1, 5), square(0, 0, 1), square(1, 0, 1)]);
});

test('with its outline a region goes, with a hole only the hole', () => {
  const holed = drawing(region([square(2, 2, 1), square(0, 0, 10)], [['a', '', '', ''], ['b', '', '', '']]));
  assert.deepEqual(model.removePath(holed, place(0, 1)).regions, []);
  assert.deepEqual(model.removePath(holed, place(0, 0)).regions[0].tags, [['b', '', '', '']]);
});

test('a whole loop moves with what shares its vertices', () => {
  const after = model.shiftPath(pair, place(0, 0), 0, 1);
  assert.deepEqual(after.regions[0].loops[0], square(0, 1, 1));
  assert.deepEqual(after.regions[1].loops[0], [[1, 1], [2, 0], [2, 1], [1, 2]]);
});

test('repeated points are merged', () => {
  const doubled = drawing(region([[[0, 0], [0, 0], [1, 0], [1, 1], [1, 1], [0, 1], [0, 0]]], [['x', 'a', 'b', 'y', 'c', 'd', 'z']]));
  const merged = model.mergeRepeated(doubled);
  assert.equal(merged.regions[0].loops[0].length, 4);
  assert.equal(merged.regions[0].tags[0].length, 4);
});

test('the longest edge that is no other region\'s', () => {
  const wide = drawing(region([[[0, 0], [1, 0], [1, 3], [0, 3]]]), region([[[1, 0], [2, 0], [2, 3], [1, 3]]]));
  assert.deepEqual(model.longestEdge(wide, 0), place(0, 0, 3));
  assert.equal(model.areaOf(wide), 6);
});

test('the area of a drawing is what would be meshed', () => {
  const square = (from, to) => [[from, from], [to, from], [to, to], [from, to]];
  assert.equal(model.areaOf(drawing()), 0);
  assert.equal(model.areaOf(drawing(region([]))), 0);
  assert.equal(model.areaOf(drawing(region([square(1, 2).reverse(), square(0, 4)]), region([square(5, 6)]))), 16);
  const all = square(0, 4);
  assert.equal(model.areaOf(drawing(region([all, all, all, all]))), 0, 'while it is drawn, holes may be more than their outline');
});
