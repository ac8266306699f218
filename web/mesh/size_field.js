// The size of the quads, by slider or as a number, with about how many there will be.
/** @import { OptionInfo } from 'lpquad' */
/** @import { Field, Give } from './fields.js' */
/** @import { Value } from './options.js' */
import { h, setText } from '../panels/dom.js';
import { counted } from '../run/words.js';
import { createNumber, createSlider, frame } from './fields.js';
import { inWords, placeOf, sizeAt } from './options.js';

/** @param {OptionInfo} info  @param {Give} give  @param {() => {least: number, most: number}} range  sizes that make sense now
 * @param {() => number} area  of what is meshed  @returns {Field} */
export function createSizeField(info, give, range, area) {
  const number = createNumber(info, give);
  const slider = createSlider(info, { max: '1', step: '0.005' }, (place, more) => give(sizeAt(range(), place), more));
  const count = h('span', { className: 'quiet numbers' });
  const { element, changed } = frame(info, give, h('div', { className: 'with-slider' }, slider, number.element), count);
  const show = (/** @type {Value} */ value) => {
    const size = Number(value) || sizeAt(range(), 0.5);
    number.show(value);
    slider.value = String(placeOf(range(), size));
    slider.setAttribute('aria-valuetext', value === 0 ? 'automatic' : inWords(size));
    setText(count, value === 0 ? '' : `about ${counted(Number((area() / size ** 2).toPrecision(2)), 'quad')}`);
    changed(value !== info.default);
  };
  return { element, show };
}
