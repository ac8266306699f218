import assert from 'node:assert/strict';
import { test } from 'node:test';
import { emptyProject } from '../../web/state/project.js';
import { Store } from '../../web/state/store.js';
import { weightBeside } from '../../web/state/weight.js';

test('undo goes back through hundreds of changes, and redo forth again', () => {
  const store = new Store(emptyProject);
  for (let i = 1; i <= 300; ++i) store.change(`size ${i}`, { options: { size: i } });
  for (let i = 300; i >= 1; --i) {
    assert.equal(store.project.options.size, i);
    assert.equal(store.undoLabel, `size ${i}`);
    store.undo();
  }
  assert.equal(store.project, emptyProject);
  assert.equal(store.canUndo, false);
  for (let i = 0; i < 300; ++i) store.redo();
  assert.equal(store.project.options.size, 300);
});

test('what belongs to one gesture is undone at once', () => {
  const store = new Store(emptyProject);
  let told = 0;
  store.subscribe(() => ++told);
  for (let i = 1; i <= 5; ++i) store.change('Drag', { options: { size: i } }, 'drag 1');
  assert.equal(store.gesture, 'drag 1');
  store.settle();
  assert.equal(store.gesture, '');
  assert.equal(told, 6);
  store.change('Drag', { options: { size: 9 } }, 'drag 1');
  store.undo();
  assert.equal(store.project.options.size, 5);
  store.undo();
  assert.equal(store.project, emptyProject);
});

test('a change that changes nothing is not remembered', () => {
  const store = new Store(emptyProject);
  store.change('Nothing', { options: emptyProject.options });
  assert.equal(store.canUndo, false);
});

const points = (count, shift = 0) => Array.from({ length: count }, (_, i) => [i + shift, i]);
const withLoop = (loop) => ({ drawing: { regions: [{ name: '', loops: [loop] }], polylines: [], points: [] } });

/** How often a store can be undone. */
function stepsBack(store) {
  let steps = 0;
  for (; store.canUndo; ++steps) store.undo();
  return steps;
}

test('of a very large drawing as many states are kept as memory allows, the newest', () => {
  const store = new Store(emptyProject), count = 100_000;
  for (let i = 1; i <= 60; ++i) store.change(`Move ${i}`, withLoop(points(count, i)));
  const steps = stepsBack(store);
  assert.ok(steps >= 10 && steps <= 30, `${steps} states`);  // 4 MB each, and 100 MB are allowed
  assert.deepEqual(store.project.drawing.regions[0].loops[0][0], [60 - steps, 0]);
  for (let i = 0; i < steps; ++i) store.redo();
  assert.equal(store.project.drawing.regions[0].loops[0][0][0], 60);
});

test('a state too large for memory can still be undone', () => {
  const store = new Store({ surface: new Float64Array(2e7), options: {} });  // 160 MB
  store.change('Open', { surface: new Float64Array(2e7) });
  store.change('Size', { options: { size: 1 } });
  assert.equal(store.undoLabel, 'Size');
  assert.equal(stepsBack(store), 1);
});

test('what states share is counted once: small changes of a large drawing are all kept', () => {
  const store = new Store({ ...emptyProject, ...withLoop(points(100_000)) });
  for (let i = 1; i <= 300; ++i) store.change(`Size ${i}`, { options: { size: i } });
  assert.equal(stepsBack(store), 300);
});

test('a point that was added or taken away weighs itself and the new list, not all points again', () => {
  const few = points(1000), more = few.toSpliced(500, 0, [0.5, 0.5]);
  for (const [a, b] of [[more, few], [few, more]]) {
    const bytes = weightBeside(a, b);
    assert.ok(bytes >= 8 * a.length && bytes < 8 * a.length + 100, `${bytes} bytes`);
  }
  assert.equal(weightBeside(few, few), 0);
  assert.ok(weightBeside(few) > 30 * few.length);
});
