// Numbers to type: a labelled field that takes what is a number and shows what is so.
import { numberOf } from '../mesh/options.js';
import { h } from '../panels/dom.js';
import { short } from './sketch.js';

/** @typedef {{element: HTMLLabelElement, refresh: () => void, value: () => number | null}} Field */

/**
 * @param {object} how
 * @param {string} how.label
 * @param {() => number | null} [how.get]  null: nothing to show
 * @param {(value: number) => void} [how.set]  on Enter or when the field is left
 * @param {number} [how.min]  @param {boolean} [how.whole]  @param {string} [how.hint]  shown while empty
 * @param {string} [how.title]
 * @returns {Field}
 */
export function numberField({ label, get, set, min = -Infinity, whole = false, hint = '', title = '' }) {
  const parsed = () => {
    const value = input.value.trim() === '' ? NaN : numberOf(input.value, whole);
    return Number.isFinite(value) && value >= min ? (whole ? Math.round(value) : value) : null;
  };
  const refresh = () => {
    if (!get || document.activeElement === input) return;
    show();
  };
  const show = () => {
    const value = get?.() ?? null;
    const text = value === null ? '' : short(value);
    if (input.value !== text) input.value = text;
    input.removeAttribute('aria-invalid');
  };
  const change = () => {
    const value = parsed();
    if (value === null && input.value.trim() !== '') return input.setAttribute('aria-invalid', 'true');
    input.removeAttribute('aria-invalid');
    const before = get?.() ?? null;
    if (value !== null && (before === null || short(before) !== input.value.trim())) set?.(value);
    if (get) show();
  };
  const input = h('input', { type: 'text', inputMode: 'decimal', autocomplete: 'off', placeholder: hint, title, onchange: change });
  refresh();
  return { element: h('label', { className: 'field' }, h('span', null, label), input), refresh, value: parsed };
}

/** Fields side by side. @param {...(Field | Node)} fields */
export const row = (...fields) => h('div', { className: 'fields' }, ...fields.map((field) => field instanceof Node ? field : field.element));
