// The options of the mesher as the pages must know them before the mesher is there: to judge a link.
// A test compares these tables with the library's own.

/** Choices, a yes or no, or the range of a number. @typedef {Record<string, string[] | 'boolean' | [number, number] | ['integer', number, number]>} Known */

/** @type {Known} */
export const knownOptions = {
  size: [0, 1e300], quads: ['integer', 0, 100000000], keepBoundary: 'boolean', elements: ['quad', 'one-triangle', 'quad-dominant'], method: ['best', 'paper'],
  effort: ['normal', 'high'], seeds: ['automatic', 'aligned', 'isotropic'], norm: [2, 20],
  iterations: ['integer', -1, 100000], restarts: ['integer', -1, 1000], seed: ['integer', 0, 9007199254740991], growth: [0, 10], simplify: [0, 1e300],
  allowAddedPoint: 'boolean', strict: 'boolean', sizeWeight: [0, 10], smoothing: ['integer', -1, 10000],
  maxElements: ['integer', 1, 100000000],
};

/** Of surfaces. @type {Known} */
export const knownSurfaceOptions = {
  size: [0, 1e300], quads: ['integer', 0, 100000000], featureAngle: [0, 180], keepGroups: 'boolean', turn: [0, 90], growth: [0, 10], weld: [0, 0.01],
  method: knownOptions.method, effort: knownOptions.effort, seeds: knownOptions.seeds, norm: [2, 20],
  iterations: ['integer', -1, 100000], restarts: ['integer', -1, 1000], seed: ['integer', 0, 9007199254740991],
  sizeWeight: [0, 10], smoothing: ['integer', -1, 10000], maxElements: ['integer', 1, 100000000],
};

/** What is wrong with an option's value; '' if nothing is. @param {string} name  @param {unknown} value  @param {Known} [of] */
export function faultOfOption(name, value, of = knownOptions) {
  const kind = Object.hasOwn(of, name) ? of[name] : undefined;
  if (kind === undefined) return `there is no option “${name.slice(0, 40)}”`;
  if (kind === 'boolean') return typeof value === 'boolean' ? '' : `${name} is yes or no`;
  const numbers = /** @type {number[]} */ (kind.filter((part) => typeof part === 'number'));
  if (numbers.length === 0) return typeof value === 'string' && kind.some((choice) => choice === value) ? '' : `${name} is one of ${kind.join(', ')}`;
  const whole = kind[0] === 'integer';
  if (typeof value !== 'number' || !Number.isFinite(value) || (whole && !Number.isSafeInteger(value))) return `${name} is a ${whole ? 'whole ' : ''}number`;
  return value >= numbers[0] && value <= numbers[1] ? '' : `${name} lies between ${numbers[0]} and ${numbers[1]}`;
}
