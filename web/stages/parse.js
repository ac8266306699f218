// The files of a --stages folder (core/io/stages.h) as arrays. Every field that is used is judged:
// its kind, its length, its indices.

/** Says in words what is wrong with a folder. */
export class BadStages extends Error {}

/** @param {string} name  @param {string} why  @returns {never} */
const refuse = (name, why) => { throw new BadStages(`${name} ${why}`); };

/** @typedef {import('lpquad').Float64s} Float64s  @typedef {import('lpquad').Uint32s} Uint32s */
/** @typedef {{points: Float64s, triangles: Uint32s, quads: Uint32s}} Faces */

/** @param {string} name  @param {string} text  @returns {Faces} */
export function readObj(name, text) {
  /** @type {number[]} */ const points = [];
  /** @type {number[]} */ const triangles = [];
  /** @type {number[]} */ const quads = [];
  for (const line of text.split('\n')) {
    const [kind, ...values] = line.trim().split(/\s+/);
    if (kind === 'v') points.push(Number(values[0]), Number(values[1]));
    else if (kind === 'f') (values.length === 4 ? quads : values.length === 3 ? triangles : refuse(name, 'has a face that is no triangle or quad')).push(...values.map((value) => Number(value) - 1));
  }
  return { points: floats(name, points), triangles: indices(name, triangles, points.length / 2), quads: indices(name, quads, points.length / 2) };
}

/** @param {string} name  @param {number[]} values */
function floats(name, values) {
  return values.every(Number.isFinite) ? Float64Array.from(values) : refuse(name, 'holds something that is no finite number');
}

/** @param {string} name  @param {number[]} values  @param {number} count */
function indices(name, values, count) {
  return values.every((value) => Number.isInteger(value) && value >= 0 && value < count) ? Uint32Array.from(values) : refuse(name, 'names a point that is not there');
}

/** One JSON file and its fields. */
export class Fields {
  /** @param {string} name  @param {string} text */
  constructor(name, text) {
    this.name = name;
    try {
      this.value = JSON.parse(text);
    } catch {
      refuse(name, 'is cut off or is not JSON');
    }
    if (typeof this.value !== 'object' || this.value === null) refuse(name, 'has no fields');
  }

  /** @param {string} field  @returns {any[]} */
  list(field) {
    const list = this.value[field];
    return Array.isArray(list) ? list : refuse(this.name, `lacks the list “${field}”`);
  }

  /** @param {string} field */
  number(field) {
    const value = this.value[field];
    return Number.isFinite(value) ? /** @type {number} */ (value) : refuse(this.name, `lacks the number “${field}”`);
  }

  /** @param {string} field  @param {number} [count] */
  numbers(field, count) {
    const list = this.list(field);
    if (count !== undefined && list.length !== count) refuse(this.name, `has ${list.length} values in “${field}” instead of ${count}`);
    return floats(this.name, list);
  }

  /** Tuples, flat. @param {string} field  @param {number} width  @param {number} [count] */
  tuples(field, width, count) {
    const list = this.list(field);
    if (count !== undefined && list.length !== count) refuse(this.name, `has ${list.length} entries in “${field}” instead of ${count}`);
    if (!list.every((entry) => Array.isArray(entry) && entry.length === width)) refuse(this.name, `has an entry in “${field}” that is not ${width} numbers`);
    return floats(this.name, list.flat());
  }

  /** @param {string} field  @param {number} width  @param {number} limit */
  indices(field, width, limit) { return indices(this.name, [...this.tuples(field, width)], limit); }
}
