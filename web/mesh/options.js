// The mesher's options: their names in plain words, what may be given, and how they are kept.
/** @import { OptionInfo } from 'lpquad' */
/** @import { Drawing, MeshOptions, Project } from '../types' */
import { boundsOf } from '../draw/view.js';

/** @typedef {number | boolean | string} Value */

/** @type {Record<string, string>} */
const names = {
  size: 'Size of the quads', quads: 'Number of quads', norm: 'Exponent p', iterations: 'Iterations', restarts: 'Restarts', seeds: 'First points', seed: 'Random seed',
  smoothing: 'Smoothing', method: 'Method', effort: 'Effort', keepBoundary: 'Keep the boundary', elements: 'Elements',
  growth: 'Growth of sizes', simplify: 'Simplify the outline', allowAddedPoint: 'Allow one added point',
  strict: 'Strict about repeated points', sizeWeight: 'Weight of sizes', maxElements: 'Most elements',
};

/** Shown first, in this order. */
export const mainOptions = [
  'size', 'quads', 'norm', 'iterations', 'seeds', 'seed', 'method', 'effort', 'smoothing', 'keepBoundary', 'elements',
];

/** @param {string} name  also of an option that is newer than this list */
export const nameOfOption = (name) => names[name]
  ?? name.replace(/[A-Z]/g, (letter) => ` ${letter.toLowerCase()}`).replace(/^./, (first) => first.toUpperCase());

/** @param {MeshOptions} options  @param {OptionInfo} info  @returns {Value} */
export const valueOf = (options, info) => /** @type {Record<string, Value>} */ (options)[info.name] ?? info.default;

/** One of these says how fine the mesh is. @type {Record<string, string>} */
const inPlaceOf = { size: 'quads', quads: 'size' };

/** The options with one of them changed; what is as usual is not kept.
 * @param {MeshOptions} options  @param {OptionInfo} info  @param {Value} value  @returns {MeshOptions} */
export function withOption(options, info, value) {
  const changed = /** @type {Record<string, Value>} */ ({ ...options });
  if (value === info.default) delete changed[info.name];
  else changed[info.name] = value;
  if (value !== info.default && Object.hasOwn(inPlaceOf, info.name)) delete changed[inPlaceOf[info.name]];
  return /** @type {MeshOptions} */ (changed);
}

/** With this size, in place of what said so before. @param {MeshOptions} options  @param {number} size  @returns {MeshOptions} */
export const withSize = ({ quads, ...options }, size) => ({ ...options, size });

/** What is wrong with a text as the value of an option, in words; '' is nothing.
 * @param {OptionInfo} info  @param {string} text */
export function problemWith(info, text) {
  const value = numberOf(text, info.type === 'integer');
  if (text.trim() === '' || Number.isNaN(value)) return 'A number is needed.';
  if (info.type === 'integer' && !Number.isInteger(value)) return 'A whole number is needed.';
  if (info.min !== undefined && value < info.min) return `At least ${inWords(leastOf(info))}.`;
  if (info.max !== undefined && value > info.max) return `At most ${inWords(info.max)}.`;
  return '';
}

/** -1 is a word here: automatic. @param {OptionInfo} info */
const leastOf = ({ min = 0, default: usual }) => (usual === -1 ? 0 : min);

const grouped = /^[1-9]\d{0,2}(?:([.,\s’'])\d{3})(?:\1\d{3})*$/;

/** A comma is taken for a point: it is one on many keyboards. In a whole number either parts thousands: 1,000.
 * @param {string} text  @param {boolean} [whole] */
export const numberOf = (text, whole = false) =>
  Number(whole && grouped.test(text.trim()) ? text.replace(/\D/g, '') : text.trim().replace(',', '.'));

/** As short as it can be typed again. @param {number} number */
export const inWords = (number) => (Math.abs(number) >= 1e16 ? number.toExponential() : String(number));

/** The numbers that an option takes, in words. @param {OptionInfo} info */
export function rangeInWords(info) {
  const { type, min, max, unit } = info;
  if (type !== 'number' && type !== 'integer') return '';
  const bounded = max !== undefined && max < 1e15, least = inWords(leastOf(info));
  const range = min === undefined ? '' : bounded ? `${least} to ${max.toLocaleString('en')}` : `${least} or more`;
  const kind = type === 'integer' ? 'whole number' : '';
  return [kind, range, unit === 'length' ? 'in the unit of the coordinates' : unit].filter(Boolean).join(', ');
}

/** Sizes that make sense for a drawing. @param {Drawing} drawing */
export function sizeRange(drawing) {
  const { left, right, bottom, top } = boundsOf(drawing);
  const diagonal = Math.hypot(right - left, top - bottom) || 1;
  return { least: diagonal / 300, most: diagonal / 5 };
}

/** Between the places 0 … 1 of a slider and sizes, evenly by ratio.
 * @param {{least: number, most: number}} range  @param {number} place */
export const sizeAt = ({ least, most }, place) => Number((least * (most / least) ** place).toPrecision(3));

/** @param {{least: number, most: number}} range  @param {number} size */
export const placeOf = ({ least, most }, size) =>
  Math.max(0, Math.min(1, Math.log(size / least) / Math.log(most / least)));
