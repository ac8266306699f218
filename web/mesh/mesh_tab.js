// The Mesh tab: what the mesher is told. What matters most comes first and has a control of its own;
// the rest comes from the library's own table, whatever it holds.
/** @import { OptionInfo } from 'lpquad' */
/** @import { App } from '../app' */
/** @import { Field, Give } from './fields.js' */
import { h, setText } from '../panels/dom.js';
import { icon } from '../panels/icons.js';
import { areaOf } from '../run/preview.js';
import { counted } from '../run/words.js';
import { createChoices, createField, createNumber, createSlider, frame } from './fields.js';
import { inWords, mainOptions, nameOfOption, placeOf, sizeAt, sizeRange, valueOf, withOption } from './options.js';
import { ballIcon, createBall } from './unit_ball.js';

/** @param {App} app */
export function installMeshTab(app) {
  const body = app.tabs.add('mesh', 'Mesh', h('p', { className: 'quiet' }, 'Loading the mesher …'));
  const load = async () => {
    try {
      const { options } = await (await app.runner.engine()).ready();
      body.replaceChildren(createForm(app, options));
      stop();
    } catch { /* the run says so, and tries again */ }
  };
  const stop = app.runner.subscribe(({ phase }) => { if (phase === 'paused' || phase === 'playing') void load(); });
  void load();
}

/** @param {App} app  @param {OptionInfo[]} infos */
function createForm(app, infos) {
  let gestures = 0, gesture = '';
  /** @type {Field[]} */
  const fields = [];
  const fieldOf = (/** @type {OptionInfo} */ info) => {
    /** @type {Give} */
    const give = (value, more = false) => {
      if (more && gesture === '') gesture = `option ${info.name} ${++gestures}`;
      app.store.change(`${nameOfOption(info.name)} ${value}`, ({ options }) => {
        const changed = withOption(options, info, value);
        return { options: valueOf(options, info) === value ? options : changed };
      }, gesture);
      if (more) return;
      if (gesture !== '') app.store.settle();
      gesture = '';
    };
    const field = special[info.name]?.(app, info, give) ?? createField(info, give);
    fields.push({ element: field.element, show: () => field.show(valueOf(app.store.project.options, info)) });
    return field.element;
  };
  const known = infos.filter(({ type }) => ['number', 'integer', 'boolean', 'choice'].includes(type));
  const main = mainOptions.flatMap((name) => known.filter((info) => info.name === name));
  const more = known.filter((info) => !mainOptions.includes(info.name));
  const form = h('form', { className: 'options', onsubmit: (/** @type {Event} */ event) => event.preventDefault() },
    ...main.map(fieldOf), h('details', null, h('summary', null, 'More options'), ...more.map(fieldOf)));
  const show = () => fields.forEach((field) => field.show(0));
  app.store.subscribe(show);
  show();
  return form;
}

/** @type {Record<string, (app: App, info: OptionInfo, give: Give) => Field>} */
const special = { size: sizeField, norm: normField, iterations: iterationsField, seed: seedField };

/** @type {typeof special.size} */
function sizeField({ store }, info, give) {
  const number = createNumber(info, give);
  const slider = createSlider(info, { max: '1', step: '0.005' },
    (place, more) => give(sizeAt(sizeRange(store.project.drawing), place), more));
  const count = h('span', { className: 'quiet numbers' });
  const { element, changed } = frame(info, give, h('div', { className: 'with-slider' }, slider, number.element), count);
  const show = (/** @type {import('./options.js').Value} */ value) => {
    const { drawing } = store.project;
    const range = sizeRange(drawing);
    const size = Number(value) || sizeAt(range, 0.5);
    number.show(value);
    slider.value = String(placeOf(range, size));
    slider.setAttribute('aria-valuetext', value === 0 ? 'automatic' : inWords(size));
    setText(count, value === 0 ? '' : `about ${counted(Number((areaOf(drawing) / size ** 2).toPrecision(2)), 'quad')}`);
    changed(value !== info.default);
  };
  return { element, show };
}

/** @type {typeof special.size} */
function normField(app, info, give) {
  const ball = createBall();
  const choices = createChoices(info.name, [2, 4, 6, 8], give,
    (p) => h('span', { className: 'ball-choice' }, ballIcon(p), String(p)));
  const number = createNumber(info, give);
  const { element, changed } = frame(info, give,
    h('div', { className: 'with-ball' }, ball.element, h('div', null, choices.element, number.element)),
    h('p', { className: 'help' }, 'All points at distance 1 in the L_p norm, turned to the cross of the field. '
      + 'The larger p, the squarer the cells become.'));
  return { element, show: (value) => {
    ball.show(Number(value));
    choices.show(value);
    number.show(value);
    changed(value !== info.default);
  } };
}

/** @type {typeof special.size} */
function iterationsField(app, info, give) {
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

/** @type {typeof special.size} */
function seedField({ store }, info, give) {
  const number = createNumber(info, give);
  const next = () => give(Number(valueOf(store.project.options, info)) + 1);
  const other = h('button', { type: 'button', onclick: next }, icon('next'), 'Another');
  const { element, changed } = frame(info, give, h('div', { className: 'with-slider' }, number.element, other));
  return { element, show: (value) => { number.show(value); changed(value !== info.default); } };
}
