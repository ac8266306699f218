// Sizes and directions of the caller: samples and strokes cross as arrays, functions as functions.
import { flatTuples, packGuides, sizesForm } from './domain.js';
import { LpquadError } from './errors.js';

const wrong = (name, expected) =>
  new LpquadError('BAD_OPTION', `Option ${name} must be ${expected}.`);

function packTuples(name, list, width, form) {
  const flat = flatTuples(list, width);
  if (flat === null) throw wrong(name, form);
  return flat;
}

/** As of a domain; only that an option is wrong then, not a text. */
function packGuideOption(guides = []) {
  try {
    return packGuides(guides, 'guides');
  } catch (error) {
    if (!(error instanceof LpquadError) || error.code !== 'PARSE_ERROR') throw error;
    throw new LpquadError('BAD_OPTION', `Option ${error.message}`, error.where);
  }
}

/** A caller's function that throws must not unwind the core: the error is kept until it is back. */
function guarded(name, f, kept) {
  if (f === undefined) return undefined;
  if (typeof f !== 'function') throw wrong(name, 'a function of x and y');
  return (x, y) => {
    try {
      return Number(f(x, y));
    } catch (error) {
      kept.push(error);
      return NaN;
    }
  };
}

/**
 * Splits what the caller wrote into the options of the option table, the fields and the rest.
 * `thrown` collects what the caller's functions threw.
 */
export function splitOptions(options = {}) {
  if (options === null || typeof options !== 'object')
    throw new LpquadError('BAD_OPTION', 'The options must be an object.');
  const { sizes = [], guides, seedPoints = [], sizeAt, angleAt, onProgress, ...table } = options;
  const thrown = [];
  const fields = {
    sizes: packTuples('sizes', sizes, 3, sizesForm),
    guides: packGuideOption(guides),
    seeds: packTuples('seedPoints', seedPoints, 2, 'points: [[x, y], …], all finite numbers'),
    size: guarded('sizeAt', sizeAt, thrown),
    angle: guarded('angleAt', angleAt, thrown),
  };
  if (onProgress !== undefined && typeof onProgress !== 'function')
    throw wrong('onProgress', 'a function');
  return { table, fields, onProgress, thrown };
}
