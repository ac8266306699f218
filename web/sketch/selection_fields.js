// The chosen vertex and its outline in numbers.
/** @import { App } from '../app' */
/** @import { Point } from '../types' */
/** @import { Sketch } from './sketch.js' */
import { h, setText } from '../panels/dom.js';
import { numberField } from './fields.js';
import * as model from './model/drawing.js';
import { boxOf } from './model/geometry.js';
import { circle, circleOf, rectangle, rectangleOf } from './model/shapes.js';
import { nameOf } from './sketch.js';
import { insertAfter, removeSelected } from './tools/edit.js';

/** @param {App} app  @param {Sketch} sketch */
export function selectionSection({ actions, stage }, sketch) {
  const path = () => sketch.selected ? model.pathOf(sketch.drawing, sketch.selected) : [];
  const chosen = () => sketch.selected !== null;
  const editing = () => stage.tool.id === 'edit';
  actions.add(
    { id: 'vertex.previous', label: 'Previous vertex', icon: 'previous', keys: ['P'], enabled: editing, run: () => sketch.selectNext(-1) },
    { id: 'vertex.next', label: 'Next vertex', icon: 'next', keys: ['N'], enabled: editing, run: () => sketch.selectNext(1) },
    { id: 'vertex.add', label: 'Add a vertex after it', icon: 'plus', enabled: chosen, run: () => insertAfter(sketch) },
    { id: 'vertex.remove', label: 'Remove this vertex', icon: 'minus', enabled: chosen, run: () => removeSelected(sketch) },
    { id: 'outline.remove', label: 'Remove this outline', icon: 'remove', enabled: chosen,
      run: () => sketch.selected && sketch.change('Remove an outline', model.removePath(sketch.drawing, sketch.selected)) },
  );
  const name = h('p', { className: 'hint in-one-line' });
  const coordinates = vertexFields(sketch), shape = shapeFields(sketch, path), tag = tagField(sketch);
  // Keep their room without a vertex, too: what is below must not jump when one is chosen.
  const details = h('fieldset', { className: 'chosen-fields', 'aria-label': 'Numbers of the chosen vertex' },
    h('div', { className: 'fields' }, ...coordinates.map(({ element }) => element), tag.element),
    h('div', { className: 'one-of' }, ...shape.groups.map(({ element }) => element)));
  const some = h('div', null, name, details);
  const none = h('p', { className: 'hint' }, 'No vertex is chosen. Choose one on the stage, or with the first two buttons: its place, '
    + 'the name of its edge and the extent of its outline are then here, to be changed as numbers.');
  const element = h('section', { className: 'selection-section', 'aria-label': 'Chosen vertex' },
    h('div', { className: 'buttons', role: 'group', 'aria-label': 'Vertices' },
      ...['vertex.previous', 'vertex.next', 'vertex.add', 'vertex.remove', 'outline.remove', 'sketch.whole'].map((id) => actions.button(id))),
    h('div', { className: 'chosen-or-none' }, some, none));

  let wasChosen = false;
  const refresh = () => {
    const { selected } = sketch;
    if (chosen() !== wasChosen) actions.refresh();
    wasChosen = chosen();
    details.disabled = selected === null;
    some.classList.toggle('away', selected === null);
    none.classList.toggle('away', selected !== null);
    setText(name, selected ? nameOf(sketch.drawing, selected) : '\u00a0');
    for (const field of coordinates) field.refresh();
    tag.refresh();
    shape.refresh();
  };
  return { element, refresh };
}

/** @param {Sketch} sketch */
function vertexFields(sketch) {
  return ['x', 'y'].map((label, axis) => numberField({ label,
    get: () => (sketch.selected && model.vertexAt(sketch.drawing, sketch.selected)?.[axis]) ?? null,
    set: (value) => {
      const { selected, drawing } = sketch;
      const at = selected && model.vertexAt(drawing, selected);
      if (selected && at) sketch.change('Move a vertex', model.moveVertex(drawing, selected, axis === 0 ? [value, at[1]] : [at[0], value]));
    } }));
}

/** Name of the edge after the vertex: boundaries have names in the files. @param {Sketch} sketch */
function tagField(sketch) {
  const get = () => (sketch.selected && model.tagOf(sketch.drawing, sketch.selected)) ?? '';
  const input = h('input', { type: 'text', autocomplete: 'off', title: 'Name of the edge after this vertex, for the files', onchange: () => {
    if (sketch.selected) sketch.change('Name an edge', model.withTag(sketch.drawing, sketch.selected, input.value.trim()));
  } });
  return {
    element: h('label', { className: 'field wide' }, h('span', null, 'Edge name'), input),
    refresh: () => {
      if (document.activeElement !== input && input.value !== get()) input.value = get();
      input.disabled = sketch.selected?.region === model.pointRegion;
    },
  };
}

/** @typedef {ReturnType<typeof outlineOf>} Outline */

/** The chosen outline: what it is, worked out again only when it changed, and how it is replaced. @param {Sketch} sketch  @param {() => Point[]} path */
function outlineOf(sketch, path) {
  let known = { path: /** @type {Point[]} */ ([]), round: circleOf([]), box: rectangleOf([]) };
  return {
    path,
    now() {
      if (known.path !== path()) known = { path: path(), round: circleOf(path()), box: rectangleOf(path()) };
      return known;
    },
    /** @param {string} label  @param {Point[]} points */
    replace(label, points) {
      const { selected, drawing } = sketch;
      if (selected) sketch.change(label, points.length === path().length ? model.movePath(drawing, selected, points) : model.replacePath(drawing, selected, points));
    },
  };
}

/** @param {Outline} outline */
function circleFields({ now, replace }) {
  /** @param {string} label  @param {'x' | 'y' | 'radius' | 'count'} key  @param {{min?: number, whole?: boolean}} [how] */
  const field = (label, key, how) => numberField({ label, ...how, get: () => now().round?.[key] ?? null, set: (value) => {
    const { round } = now();
    if (!round) return;
    const changed = { ...round };
    changed[key] = value;
    replace('Change a circle', circle(changed.x, changed.y, changed.radius, changed.count, changed.start));
  } });
  return [field('Centre x', 'x'), field('Centre y', 'y'), field('Radius', 'radius', { min: 1e-300 }), field('Points', 'count', { min: 3, whole: true })];
}

/** @param {Outline} outline */
function rectangleFields({ path, now, replace }) {
  /** @param {string} label  @param {'left' | 'bottom' | 'width' | 'height'} key  @param {{min?: number}} [how] */
  const field = (label, key, how) => numberField({ label, ...how, get: () => now().box?.[key] ?? null, set: (value) => {
    const { box } = now();
    if (!box) return;
    const { left, bottom, width, height } = Object.assign({ ...box }, { [key]: value });
    replace('Change a rectangle', path().map(([x, y]) => [x === box.left ? left : left + width, y === box.bottom ? bottom : bottom + height]));
  } });
  return [field('Left', 'left'), field('Bottom', 'bottom'), field('Width', 'width', { min: 1e-300 }), field('Height', 'height', { min: 1e-300 })];
}

/** Middle and extent. @param {Sketch} sketch  @param {Outline} outline */
function boxFields(sketch, { path, replace }) {
  const middle = (/** @type {number} */ axis) => {
    const box = boxOf(path());
    return path().length > 0 ? (box[axis] + box[axis + 2]) / 2 : null;
  };
  const extent = (/** @type {number} */ axis) => {
    const box = boxOf(path());
    return box[axis + 2] > box[axis] ? box[axis + 2] - box[axis] : null;  // null: nothing to stretch
  };
  const middleField = (/** @type {string} */ label, /** @type {number} */ axis) => numberField({ label, get: () => middle(axis), set: (value) => {
    const by = value - (middle(axis) ?? value);
    if (sketch.selected) sketch.change('Move an outline', model.shiftPath(sketch.drawing, sketch.selected, axis === 0 ? by : 0, axis === 1 ? by : 0));
  } });
  const extentField = (/** @type {string} */ label, /** @type {number} */ axis) => numberField({ label, min: 1e-300, get: () => extent(axis), set: (value) => {
    const fixed = middle(axis), by = value / (extent(axis) ?? NaN);
    if (fixed === null || !Number.isFinite(by)) return;
    const stretched = (/** @type {number} */ at) => fixed + by * (at - fixed);
    replace('Stretch an outline', path().map(([x, y]) => axis === 0 ? [stretched(x), y] : [x, stretched(y)]));
  } });
  return [middleField('Middle x', 0), middleField('Middle y', 1), extentField('Extent x', 0), extentField('Extent y', 1)];
}

/** A circle, a rectangle, or the middle and extent of anything else: groups of four, so that none leaves room that another needs. @param {Sketch} sketch  @param {() => Point[]} path */
function shapeFields(sketch, path) {
  const outline = outlineOf(sketch, path);
  const groups = [group('Circle', circleFields(outline)), group('Rectangle', rectangleFields(outline)), group('Outline', boxFields(sketch, outline))];
  return { groups, refresh: () => {
    const { round, box } = outline.now();
    const shown = round ? 0 : box ? 1 : 2;
    groups.forEach(({ element, fields }, i) => {
      element.classList.toggle('away', i !== shown);
      if (i === shown) for (const field of fields) field.refresh();
    });
  } };
}

/** @param {string} title  @param {import('./fields.js').Field[]} fields */
const group = (title, fields) => ({
  fields, element: h('div', { className: 'fields', role: 'group', 'aria-label': title }, h('span', { className: 'group-title' }, title), ...fields.map(({ element }) => element)),
});
