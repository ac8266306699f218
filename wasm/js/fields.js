// Sizes and directions of the caller: samples cross as an array, functions as functions.
import { LpquadError } from './errors.js';

const wrong = (name, expected) =>
  new LpquadError('BAD_OPTION', `Option ${name} must be ${expected}.`);

const isList = (value) => Array.isArray(value) || ArrayBuffer.isView(value);

/** Tuples of `width` numbers, nested or flat: [[x, y, h], …] or [x0, y0, h0, …]. */
function flatTuples(name, list, width, expected) {
  const nested = isList(list) && isList(list[0]);
  const form = !isList(list) ? false
    : nested ? list.every((tuple) => isList(tuple) && tuple.length === width)
    : list.length % width === 0;
  const flat = !form ? [] : nested ? list.flatMap((tuple) => [...tuple]) : [...list];
  if (!form || !flat.every(Number.isFinite)) throw wrong(name, `${expected}, all finite numbers`);
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
  const { sizes = [], seedPoints = [], sizeAt, angleAt, onProgress, ...table } = options;
  const thrown = [];
  const fields = {
    sizes: flatTuples('sizes', sizes, 3, 'points with a target size each: [[x, y, h], …]'),
    seeds: flatTuples('seedPoints', seedPoints, 2, 'points [[x, y], …]'),
    size: guarded('sizeAt', sizeAt, thrown),
    angle: guarded('angleAt', angleAt, thrown),
  };
  if (onProgress !== undefined && typeof onProgress !== 'function')
    throw wrong('onProgress', 'a function');
  return { table, fields, onProgress, thrown };
}
