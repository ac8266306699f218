// The Mesh tab: the options of the surface mesher, from the library's own table.
/** @import { OptionInfo } from 'lpquad' */
/** @import { SpaceApp } from '../types' */
import { createField, createNumber, createSlider, frame } from '../../mesh/fields.js';
import { inWords, nameOfOption, placeOf, sizeAt, valueOf, withOption } from '../../mesh/options.js';
import { h, setText } from '../../panels/dom.js';
import { areaOf, boxOf } from '../model/work.js';

const main = ['size', 'featureAngle', 'turn', 'growth', 'effort'];

/** @param {SpaceApp} app */
export function installMeshTab(app) {
  const body = app.tabs.add('mesh', 'Mesh', h('p', { className: 'quiet' }, 'Loading the mesher …'));
  const load = async () => {
    try {
      const { surfaceOptions } = await (await app.runner.engine()).ready();
      body.replaceChildren(createForm(app, surfaceOptions));
      stop();
    } catch { /* the run says so, and tries again */ }
  };
  const stop = app.runner.subscribe(({ state }) => { if (state !== null) void load(); });
  void load();
}

/** @param {SpaceApp} app  @param {OptionInfo[]} infos */
function createForm({ store }, infos) {
  let gestures = 0, gesture = '';
  /** @type {(() => void)[]} */
  const shows = [];
  const fieldOf = (/** @type {OptionInfo} */ info) => {
    const give = (/** @type {import('../../mesh/options.js').Value} */ value, more = false) => {
      if (more && gesture === '') gesture = `option ${info.name} ${++gestures}`;
      const options = withOption(/** @type {any} */ (store.project.options), info, value);
      store.change(`${nameOfOption(info.name)} ${value}`, { options: /** @type {any} */ (options) }, gesture);
      if (more) return;
      if (gesture !== '') store.settle();
      gesture = '';
    };
    const field = info.name === 'size' ? sizeField(store, info, give) : createField(info, give);
    shows.push(() => field.show(valueOf(/** @type {any} */ (store.project.options), info)));
    return field.element;
  };
  const first = main.flatMap((name) => infos.filter((info) => info.name === name));
  const form = h('form', { className: 'options', onsubmit: (/** @type {Event} */ event) => event.preventDefault() }, ...first.map(fieldOf),
    h('details', null, h('summary', null, 'More options'), ...infos.filter(({ name }) => !main.includes(name)).map(fieldOf)));
  const show = () => shows.forEach((one) => one());
  store.subscribe(show);
  show();
  return form;
}

/** @param {SpaceApp['store']} store  @param {OptionInfo} info  @param {import('../../mesh/fields.js').Give} give */
function sizeField(store, info, give) {
  const number = createNumber(info, give);
  const range = () => {
    const { radius } = boxOf(store.project.surface.points);
    return { least: radius / 150, most: radius / 2.5 };
  };
  const slider = createSlider(info, { max: '1', step: '0.005' }, (place, more) => give(sizeAt(range(), place), more));
  const count = h('span', { className: 'quiet numbers' });
  const { element, changed } = frame(info, give, h('div', { className: 'with-slider' }, slider, number.element), count);
  return { element, show: (/** @type {import('../../mesh/options.js').Value} */ value) => {
    const size = Number(value) || sizeAt(range(), 0.5);
    number.show(value);
    slider.value = String(placeOf(range(), size));
    slider.setAttribute('aria-valuetext', value === 0 ? 'automatic' : inWords(size));
    setText(count, value === 0 ? '' : `about ${Number((areaOf(store.project.surface) / size ** 2).toPrecision(2)).toLocaleString('en')} quads`);
    changed(value !== info.default);
  } };
}
