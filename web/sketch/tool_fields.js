// What the tool in hand can be told by numbers: every one of them works without a pointer.
/** @import { App } from '../app' */
/** @import { Point } from '../types' */
/** @import { Field } from './fields.js' */
/** @import { Sketch } from './sketch.js' */
/** @import { Tools } from './tools.js' */
import { h } from '../panels/dom.js';
import { numberField, row } from './fields.js';
import { addLoop } from './model/drawing.js';
import { circle, rectangle } from './model/shapes.js';

/** @typedef {{content: Node[], fields: Field[]}} Made */

/** @param {App} app  @param {Sketch} sketch  @param {Tools} tools  @param {string} id  @returns {Made} */
export function toolFields(app, sketch, tools, id) {
  const { polygon, line, point, brush, guide } = tools;
  switch (id) {
    case 'polygon': return pointFields('Add point', (p) => polygon.addPoint(p), { label: 'Close the outline', run: () => polygon.finish() });
    case 'line': return pointFields('Add point', (p) => line.addPoint(p), { label: 'End the line', run: () => line.finish() });
    case 'point': return pointFields('Add point', point.addPoint);
    case 'circle': return circleFields(sketch);
    case 'rectangle': return rectangleFields(sketch);
    case 'brush': return brushFields(app, sketch, brush.addPoint);
    case 'guide': return guideFields(app, sketch, guide);
    default: return { content: [], fields: [] };
  }
}

/** @param {string} label  @param {() => void} run */
const button = (label, run) => h('button', { type: 'button', onclick: run }, label);

/** Enter in a field does what the first button does. @param {() => void} run  @param {...Node} content */
const form = (run, ...content) => h('form', { className: 'fields', onsubmit: (/** @type {Event} */ event) => {
  event.preventDefault();
  run();
} }, ...content);

/** @param {string} label  @param {(p: Point) => void} add  @param {{label: string, run: () => void}} [then]  @returns {Made} */
function pointFields(label, add, then) {
  const x = numberField({ label: 'x' }), y = numberField({ label: 'y' });
  const run = () => {
    const at = [x.value(), y.value()];
    if (at[0] !== null && at[1] !== null) add([at[0], at[1]]);
    x.element.querySelector('input')?.select();
  };
  return { fields: [], content: [
    form(run, x.element, y.element, h('button', { type: 'submit' }, label)),
    ...(then ? [h('div', { className: 'buttons' }, button(then.label, then.run))] : []),
  ] };
}

/** @param {Field[]} fields  @returns {number[] | null} */
function valuesOf(fields) {
  const values = fields.map((field) => field.value());
  return values.every((value) => value !== null) ? /** @type {number[]} */ (values) : null;
}

/** @param {Sketch} sketch  @returns {Made} */
function circleFields(sketch) {
  const x = numberField({ label: 'Centre x' }), y = numberField({ label: 'Centre y' });
  const radius = numberField({ label: 'Radius', min: 1e-300 });
  const count = numberField({ label: 'Points', min: 3, whole: true, get: () => sketch.circleCount, set: (circleCount) => sketch.set({ circleCount }) });
  const run = () => {
    const [cx, cy, r] = valuesOf([x, y, radius]) ?? [];
    if (r !== undefined) sketch.change('Draw a circle', addLoop(sketch.drawing, circle(cx, cy, r, count.value() ?? sketch.circleCount)));
  };
  return { fields: [count], content: [form(run, x.element, y.element, radius.element, count.element, h('button', { type: 'submit' }, 'Add circle'))] };
}

/** @param {Sketch} sketch  @returns {Made} */
function rectangleFields(sketch) {
  const fields = [numberField({ label: 'Left' }), numberField({ label: 'Bottom' }),
    numberField({ label: 'Width', min: 1e-300 }), numberField({ label: 'Height', min: 1e-300 })];
  const run = () => {
    const [left, bottom, width, height] = valuesOf(fields) ?? [];
    if (height !== undefined) sketch.change('Draw a rectangle', addLoop(sketch.drawing, rectangle(left, bottom, left + width, bottom + height)));
  };
  return { fields: [], content: [form(run, ...fields.map(({ element }) => element), h('button', { type: 'submit' }, 'Add rectangle'))] };
}

/** @param {string} label  @param {() => boolean} get  @param {(on: boolean) => void} set */
function checkbox(label, get, set) {
  const input = h('input', { type: 'checkbox', checked: get(), onchange: () => set(input.checked) });
  return h('label', { className: 'check' }, input, label);
}

/** @param {App} app  @param {Sketch} sketch  @param {(p: Point) => void} add  @returns {Made} */
function brushFields({ store, announce }, sketch, add) {
  const radius = numberField({ label: 'Radius', min: 1e-300, get: () => sketch.brushNow.radius, set: (value) => sketch.set({ brush: { ...sketch.brush, radius: value } }) });
  const size = numberField({ label: 'Size', min: 1e-300, title: 'Target edge length under the brush', get: () => sketch.brushNow.size,
    set: (value) => sketch.set({ brush: { ...sketch.brush, size: value } }) });
  const dabs = pointFields('Paint here', add);
  return { fields: [radius, size], content: [
    row(radius, size), checkbox('Erase', () => sketch.brush.erase, (erase) => sketch.set({ brush: { ...sketch.brush, erase } })),
    ...dabs.content,
    h('div', { className: 'buttons' }, button('Erase all painted sizes', () => {
      store.change('Erase all sizes', { sizes: [] });
      announce('All painted sizes erased');
    })),
  ] };
}

/** @param {App} app  @param {Sketch} sketch  @param {Tools['guide']} guide  @returns {Made} */
function guideFields({ store, announce }, sketch, guide) {
  const points = pointFields('Add point', (p) => guide.addPoint(p), { label: 'End the stroke', run: () => guide.finish() });
  return { fields: [], content: [
    checkbox('Erase', () => sketch.eraseGuides, (eraseGuides) => sketch.set({ eraseGuides })), ...points.content,
    h('div', { className: 'buttons' }, button('Erase all guides', () => {
      store.change('Erase all guides', { guides: [] });
      announce('All guides erased');
    })),
  ] };
}
