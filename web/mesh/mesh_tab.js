// The Mesh tab: what the mesher is told. Options that matter most have a control of their own.
/** @import { App } from '../app' */
/** @import { MakeField } from './form.js' */
import { h, withSubscripts } from '../panels/dom.js';
import { icon } from '../panels/icons.js';
import { areaOf } from '../sketch/model/drawing.js';
import { createChoices, createNumber, createSlider, frame } from './fields.js';
import { installForm } from './form.js';
import { mainOptions, sizeRange, valueOf } from './options.js';
import { createSizeField } from './size_field.js';
import { ballIcon, createBall } from './unit_ball.js';

/** @param {App} app */
export function installMeshTab(app) {
  const { store } = app;
  installForm(app, ({ options }) => options, mainOptions, {
    size: (info, give) => createSizeField(info, give, () => sizeRange(store.project.drawing), () => areaOf(store.project.drawing)),
    norm: normField, iterations: iterationsField, seed: seedField(app),
  });
}

/** @type {MakeField} */
function normField(info, give) {
  const ball = createBall();
  const choices = createChoices(info.name, [2, 4, 6, 8], give,
    (p) => h('span', { className: 'ball-choice' }, ballIcon(p), String(p)));
  const number = createNumber(info, give);
  const { element, changed } = frame(info, give,
    h('div', { className: 'with-ball' }, ball.element, h('div', null, choices.element, number.element)),
    h('p', { className: 'help' }, ...withSubscripts('All points at distance 1 in the L_p norm, turned to the cross of the field. '
      + 'The larger p, the squarer the cells become.')));
  return { element, show: (value) => {
    ball.show(Number(value));
    choices.show(value);
    number.show(value);
    changed(value !== info.default);
  } };
}

/** @type {MakeField} */
function iterationsField(info, give) {
  const number = createNumber(info, give);
  const slider = createSlider(info, { max: '200', step: '1' }, give);
  const { element, changed } = frame(info, give, h('div', { className: 'with-slider' }, slider, number.element));
  return { element, show: (value) => {
    number.show(value);
    slider.value = String(value === -1 ? 80 : value);
    slider.setAttribute('aria-valuetext', value === -1 ? 'automatic' : String(value));
    changed(value !== info.default);
  } };
}

/** @param {App} app  @returns {MakeField} */
const seedField = ({ store }) => (info, give) => {
  const number = createNumber(info, give);
  const next = () => give(Number(valueOf(store.project.options, info)) + 1);
  const other = h('button', { type: 'button', onclick: next }, icon('next'), 'Another');
  const { element, changed } = frame(info, give, h('div', { className: 'with-slider' }, number.element, other));
  return { element, show: (value) => { number.show(value); changed(value !== info.default); } };
};
