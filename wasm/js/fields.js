// Sizes and directions of the caller: samples cross as an array, functions as functions.
import { LpquadError } from './errors.js';

const wrong = (name, expected) =>
  new LpquadError('BAD_OPTION', `Option ${name} must be ${expected}.`);

const isList = (value) => Array.isArray(value) || ArrayBuffer.isView(value);

/** [[x, y, h], ..] or a flat [x0, y0, h0, ..] */
function flatSamples(sizes = []) {
  const nested = isList(sizes) && isList(sizes[0]);
  const form = !isList(sizes) ? false
    : nested ? sizes.every((sample) => isList(sample) && sample.length === 3)
    : sizes.length % 3 === 0;
  const flat = !form ? [] : nested ? sizes.flatMap((sample) => [...sample]) : [...sizes];
  if (!form || !flat.every(Number.isFinite))
    throw wrong('sizes', 'points with a target size each: [[x, y, h], …], all finite numbers');
  return Float64Array.from(flat);
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
  const { sizes, sizeAt, angleAt, onProgress, ...table } = options;
  const thrown = [];
  const fields = { sizes: flatSamples(sizes), size: guarded('sizeAt', sizeAt, thrown),
    angle: guarded('angleAt', angleAt, thrown) };
  if (onProgress !== undefined && typeof onProgress !== 'function')
    throw wrong('onProgress', 'a function');
  return { table, fields, onProgress, thrown };
}
