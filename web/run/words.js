// What a run is doing, in plain words.
/** @import { State } from 'lpquad' */
/** @import { Run } from '../types' */
import { nameOfOption } from '../mesh/options.js';

/** What is on the screen when this stage comes next. @type {Record<State['stage'], string>} */
const shown = {
  seeds: 'cross field', optimise: 'triangles', match: 'triangles to merge', clean: 'triangles merged to quads',
  patch: 'quads tidied', smooth: 'patches remeshed', check: 'corners smoothed', compare: 'checked, to compare with others', done: 'last check',
};

/** @param {State} state */
export function stageName({ stage, iteration, maxIterations }) {
  if (stage === 'optimise' && iteration > 0) return `cells settle: iteration ${iteration} of ${maxIterations}`;
  return shown[stage];
}

/** @param {Run} run */
export function describe({ phase, state, error, result }) {
  if (error) return `no mesh: ${messageInWords(error.message)}`;
  if (phase === 'loading') return 'loading the mesher …';
  if (phase === 'cancelled') return state === null ? 'cancelled' : `cancelled at: ${stageName(state)}`;
  if (state === null) return 'starting …';
  if (state.stage === 'done' && result) return `done: ${counted(result.quads.length / 4, 'quad')}`;
  return stageName(state);
}

/** @param {number} count  @param {string} thing */
export const counted = (count, thing) => `${count.toLocaleString('en')} ${thing}${count === 1 ? '' : 's'}`;

/** Ticks that the whole run may take, as far as can be told. @param {Run} run */
export function expectedTicks({ history, result }) {
  const last = history.at(-1);
  if (last === undefined) return 0;
  if (result || last.stage === 'done') return last.tick;
  const left = last.maxIterations - last.iteration + 5;
  const after = { seeds: left, optimise: left, match: 6, clean: 5, patch: 5, smooth: 4, check: 3, compare: 2 };
  return last.tick + Math.max(1, after[last.stage]);
}

const manyDigits = 5;

/** @param {string} message */
const partInWords = (message) => message
  .replace(/(?<![\w.])\d+(?:\.\d+)?e\+\d+(?![\w.]*\w)/g, (number) => written(Number(number)))
  .replace(new RegExp(`(?<![\\w.,-])\\d{${manyDigits},}(?![\\w,-]|\\.\\w)`, 'g'), (number) => written(Number(number)))
  .replace(/\bAbout far\b/g, 'Far')
  .replace(/\b[a-z]+(?:[A-Z][a-z]+)+\b/g, (name) => `“${nameOfOption(name)}”`);

/** @param {number} number */
function written(number) {
  if (number < 1e9) return number.toLocaleString('en');
  return number < 1e15 ? number.toLocaleString('en', { notation: 'compact', compactDisplay: 'long', maximumSignificantDigits: 2 }) : 'far too many';
}

/** A message of the mesher as people write: options by their names on the page, numbers with all their digits. What is in
 * brackets, places and names that people gave, stays as it is. @param {string} message */
export const messageInWords = (message) => message.split(/(\([^()]*\))/).map((part, i) => (i % 2 === 1 ? part : partInWords(part))).join('');
