// Sizes and directions of the caller: samples and strokes cross as arrays, functions as functions.
import { packGuides, packTuples, sizesForm } from './domain.js';
import { checkFunction, checkOptions } from './checks.js';
import { LpquadError } from './errors.js';

/** As of a domain; only that an option is wrong then, not a text. */
function asOption(pack) {
  try {
    return pack();
  } catch (error) {
    if (!(error instanceof LpquadError) || error.code !== 'PARSE_ERROR') throw error;
    throw new LpquadError('BAD_OPTION', `Option ${error.message}`, error.where);
  }
}

/** A caller's function that throws must not unwind the core: the error is kept until it is back. */
function guarded(name, f, kept) {
  if (f === undefined) return undefined;
  checkFunction(f, name, ' of x and y');
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
export function splitOptions(options) {
  const { sizes = [], guides = [], seedPoints = [], sizeAt, angleAt, onProgress, ...table } = checkOptions(options);
  const thrown = [];
  const fields = {
    sizes: asOption(() => packTuples(sizes, 3, 'sizes', sizesForm)),
    guides: asOption(() => packGuides(guides, 'guides')),
    seeds: asOption(() => packTuples(seedPoints, 2, 'seedPoints', 'points: [[x, y], …], all finite numbers')),
    size: guarded('sizeAt', sizeAt, thrown),
    angle: guarded('angleAt', angleAt, thrown),
  };
  if (onProgress !== undefined) checkFunction(onProgress, 'onProgress');
  return { table, fields, onProgress, thrown };
}
