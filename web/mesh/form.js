// The form of a mesher's options, from the library's own table: what matters most comes first, the rest,
// whatever the library holds, below.
/** @import { Description, OptionInfo } from 'lpquad' */
/** @import { Field, Give } from './fields.js' */
/** @import { Value } from './options.js' */
import { h } from '../panels/dom.js';
import { whenDescribed } from '../run/description.js';
import { createField } from './fields.js';
import { nameOfOption, valueOf, withOption } from './options.js';

/**
 * What the form needs of a page, plane or space.
 * @typedef {{store: import('../state/store.js').Store<any>, tabs: import('../panels/tabs.js').Tabs,
 *   runner: import('../run/description.js').Described}} Page
 * @typedef {(info: OptionInfo, give: Give) => Field} MakeField
 */

/** The tab "Mesh", filled once the mesher has told its options.
 * @param {Page} page  @param {(description: Description) => OptionInfo[]} optionsOf  @param {string[]} main  shown first, in this order
 * @param {Record<string, MakeField>} special  options with a control of their own */
export function installForm({ store, tabs, runner }, optionsOf, main, special) {
  const body = tabs.add('mesh', 'Mesh', h('p', { className: 'quiet' }, 'Loading the mesher …'));
  whenDescribed(runner, (description) => body.replaceChildren(createForm(store, optionsOf(description), main, special)));
}

/** @param {Page['store']} store  @param {OptionInfo[]} infos  @param {string[]} main  @param {Record<string, MakeField>} special */
function createForm(store, infos, main, special) {
  /** @type {(() => void)[]} */
  const shows = [];
  const fieldOf = (/** @type {OptionInfo} */ info) => {
    const field = (special[info.name] ?? createField)(info, giveTo(store, info));
    shows.push(() => field.show(valueOf(store.project.options, info)));
    return field.element;
  };
  const known = infos.filter(({ type }) => ['number', 'integer', 'boolean', 'choice'].includes(type));
  const first = main.flatMap((name) => known.filter((info) => info.name === name));
  const more = known.filter(({ name }) => !main.includes(name));
  const form = h('form', { className: 'options', onsubmit: (/** @type {Event} */ event) => event.preventDefault() },
    ...first.map(fieldOf), h('details', null, h('summary', null, 'More options'), ...more.map(fieldOf)));
  const show = () => shows.forEach((one) => one());
  store.subscribe(show);
  show();
  return form;
}

let gestures = 0;

/** How a field changes its option: one gesture is undone at once, and the same value again is no change.
 * @param {Page['store']} store  @param {OptionInfo} info  @returns {Give} */
function giveTo(store, info) {
  let gesture = '';
  return (value, more = false) => {
    if (more && gesture === '') gesture = `option ${info.name} ${++gestures}`;
    store.change(`${nameOfOption(info.name)} ${value}`, ({ options }) =>
      ({ options: valueOf(options, info) === value ? options : withOption(options, info, value) }), gesture);
    if (more) return;
    if (gesture !== '') store.settle();
    gesture = '';
  };
}
