import assert from 'node:assert/strict';
import { test } from 'node:test';
import { emptyProject } from '../../web/state/project.js';
import { Store } from '../../web/state/store.js';

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
