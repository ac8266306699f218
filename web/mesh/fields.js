// Form fields for options: each says what it does, takes only what the mesher takes, and can be set
// back. A field is {element, show}: `show` puts the option's value into it.
/** @import { OptionInfo } from 'lpquad' */
/** @import { Value } from './options.js' */
import { h, setText, withSubscripts } from '../panels/dom.js';
import { icon } from '../panels/icons.js';
import { helpInWords, isAutomatic, wordsOf } from './help.js';
import { inWords, nameOfOption, numberOf, problemWith, rangeInWords } from './options.js';

/**
 * @typedef {{element: HTMLElement, show: (value: Value) => void}} Field
 * @typedef {(value: Value, gesture?: boolean) => void} Give  `gesture`: more will follow at once
 */

/** The frame about a control: name, way back, help. @param {OptionInfo} info  @param {Give} give */
export function frame(info, give, /** @type {Node[]} */ ...controls) {
  const name = nameOfOption(info.name);
  const reset = h('button', { type: 'button', className: 'reset', title: `Back to ${inDefault(info)}`,
    'aria-label': `${name}: back to ${inDefault(info)}`, onclick: () => give(info.default) }, icon('again'));
  const range = rangeInWords(info);
  const help = h('p', { className: 'help', id: `help-${info.name}` }, ...withSubscripts(helpInWords(info)), range && ` (${range})`);
  const title = h('span', { id: `name-${info.name}`, className: 'option-name' }, name);
  const element = h('div',
    { className: 'option', role: 'group', 'aria-labelledby': `name-${info.name}`, 'data-option': info.name },
    h('div', { className: 'option-head' }, title, reset), ...controls, help);
  return { element, changed: (/** @type {boolean} */ changed) => { reset.hidden = !changed; } };
}

/** @param {OptionInfo} info */
const inDefault = (info) => (isAutomatic(info) ? 'automatic' : String(info.default));

/** @param {OptionInfo} info  @param {Give} give @returns {Field} */
export function createField(info, give) {
  if (info.type === 'boolean') return booleanField(info, give);
  if (info.type === 'choice') return choiceField(info, give);
  const number = createNumber(info, give);
  const { element, changed } = frame(info, give, number.element);
  return { element, show: (value) => { number.show(value); changed(value !== info.default); } };
}

/** A number to type, with what is wrong with it. @param {OptionInfo} info  @param {Give} give @returns {Field} */
export function createNumber(info, give) {
  const problem = h('p', { className: 'problem', id: `problem-${info.name}`, role: 'alert' });
  const input = h('input', { type: 'text', inputMode: 'decimal', autocomplete: 'off', id: `option-${info.name}`,
    'aria-label': nameOfOption(info.name), 'aria-describedby': `problem-${info.name} help-${info.name}`, onchange: take,
    onkeydown: (/** @type {KeyboardEvent} */ event) => { if (event.key === 'Escape') show(shown); } });
  let shown = info.default;
  function take() {
    const typed = input.value.trim();
    const text = typed === '' || typed === 'automatic' ? String(info.default) : typed;
    const wrong = problemWith(info, text);
    setText(problem, wrong);
    input.setAttribute('aria-invalid', String(wrong !== ''));
    const value = numberOf(text, info.type === 'integer');
    if (wrong === '') give(value);
    if (wrong === '' && value === shown) show(shown);
  }
  function show(/** @type {Value} */ value) {
    shown = value;
    setText(problem, '');
    input.removeAttribute('aria-invalid');
    input.value = value === info.default && isAutomatic(info) ? 'automatic' : inWords(Number(value));
  }
  return { element: h('div', { className: 'number' }, input, problem), show };
}

/** @param {OptionInfo} info  @param {Give} give @returns {Field} */
function booleanField(info, give) {
  const box = h('input', { type: 'checkbox', id: `option-${info.name}`, 'aria-describedby': `help-${info.name}`,
    onchange: () => give(box.checked) });
  const { element, changed } = frame(info, give);
  const name = /** @type {HTMLElement} */ (element.querySelector('.option-name'));
  name.replaceWith(h('label', { className: 'check' }, box, name.cloneNode(true)));
  return { element, show: (value) => { box.checked = Boolean(value); changed(value !== info.default); } };
}

/** @param {OptionInfo} info  @param {Give} give @returns {Field} */
function choiceField(info, give) {
  const choices = createChoices(info.name, info.choices ?? [], give);
  const { element, changed } = frame(info, give, choices.element);
  return { element, show: (value) => { choices.show(value); changed(value !== info.default); } };
}

/** Radio buttons in a row.
 * @param {string} name  @param {Value[]} values  @param {Give} give  @param {(value: any) => Node | string} [look] */
export function createChoices(name, values, give, look = wordsOf) {
  const radios = values.map((value) =>
    h('input', { type: 'radio', name: `option-${name}`, value: String(value), onchange: () => give(value) }));
  const element = h('div', { className: 'choices', role: 'radiogroup', 'aria-labelledby': `name-${name}`,
    'aria-describedby': `help-${name}` },
  ...radios.map((radio, i) => h('label', null, radio, h('span', null, look(values[i])))));
  const show = (/** @type {Value} */ value) => {
    radios.forEach((radio, i) => { radio.checked = values[i] === value; });
  };
  return { element, show };
}

/** From 0; a drag is one gesture, over when the slider is let go.
 * @param {OptionInfo} info  @param {{max: string, step: string}} range
 * @param {(value: number, gesture: boolean) => void} give */
export function createSlider(info, range, give) {
  let held = false;
  const over = () => { if (held) give(Number(slider.value), held = false); };
  const slider = h('input', { type: 'range', min: '0', ...range,
    'aria-label': nameOfOption(info.name), 'aria-describedby': `help-${info.name}`,
    oninput: () => give(Number(slider.value), held = true),
    // Not only onchange: there is none if the slider is let go where it began.
    onchange: over, onpointerup: over, onpointercancel: over, onblur: over });
  return slider;
}
