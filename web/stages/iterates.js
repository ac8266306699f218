// The iterations of L_p in a --stages folder (core/io/iterates.h): an index, and numbers in binary.
/** @import { Snapshot } from 'lpquad' */
import { BadStages, Fields } from './parse.js';

/** @typedef {{iteration: number, triangles: NonNullable<Snapshot['triangles']>, cells: Omit<NonNullable<Snapshot['cells']>, 'energy'>}} Iterate */

const binary = 'iterates.bin';

/** Views into the bytes, one array after the other. */
class Cursor {
  #bytes;
  #at = 0;

  /** @param {ArrayBuffer} bytes */
  constructor(bytes) { this.#bytes = bytes; }

  get ended() { return this.#at === this.#bytes.byteLength; }
  /** To the next place where a double may begin. */
  align() { this.#at = Math.min(this.#bytes.byteLength, Math.ceil(this.#at / 8) * 8); }

  /** @template T  @param {{new (buffer: ArrayBuffer, at: number, count: number): T, BYTES_PER_ELEMENT: number}} Type  @param {number} count  @returns {T} */
  take(Type, count) {
    const begin = this.#at, end = begin + count * Type.BYTES_PER_ELEMENT;
    if (end > this.#bytes.byteLength) throw new BadStages(`${binary} is shorter than iterates.json says.`);
    this.#at = end;
    return new Type(this.#bytes, begin, count);
  }

  /** @param {number} count */
  doubles(count) {
    const values = this.take(Float64Array, count);
    if (!values.every(Number.isFinite)) throw new BadStages(`${binary} holds something that is no finite number.`);
    return values;
  }

  /** @template {Uint32Array | Int32Array} T  @param {{new (buffer: ArrayBuffer, at: number, count: number): T, BYTES_PER_ELEMENT: number}} Type  @param {number} count  @param {number} limit */
  indices(Type, count, limit) {
    const values = this.take(Type, count);
    if (!values.every((/** @type {number} */ value) => value >= 0 && value < limit)) throw new BadStages(`${binary} names something that is not there.`);
    return values;
  }
}

/** @param {Cursor} cursor  @param {number} boundaryNodes  @param {Record<string, unknown>} entry  @returns {Iterate} */
function readIterate(cursor, boundaryNodes, entry) {
  const size = (/** @type {string} */ name) => {
    const value = entry?.[name];
    return Number.isSafeInteger(value) && Number(value) >= 0 ? Number(value) : refuse(name);
  };
  const iteration = size('iteration'), points = size('points'), pieces = size('pieces'), corners = size('corners');
  const positions = cursor.doubles(2 * points), density = cursor.doubles(points), outlines = cursor.doubles(2 * corners);
  const triangles = { points: positions, triangles: cursor.indices(Uint32Array, 3 * size('triangles'), points), boundaryNodes };
  const sites = cursor.indices(Int32Array, pieces, points), offsets = cursor.indices(Int32Array, pieces + 1, corners + 1);
  cursor.align();
  return { iteration, triangles, cells: { points: outlines, offsets, sites, density } };
}

/** @param {string} name  @returns {never} */
const refuse = (name) => { throw new BadStages(`iterates.json has an entry without “${name}”.`); };

/** @param {string | undefined} index  text of iterates.json  @param {ArrayBuffer | undefined} bytes  of iterates.bin  @returns {Iterate[]} none where L_p did not run */
export function readIterates(index, bytes) {
  if (index === undefined || bytes === undefined) return [];
  const fields = new Fields('iterates.json', index), cursor = new Cursor(bytes);
  const boundaryNodes = fields.number('boundaryNodes');
  const iterates = fields.list('iterates').map((entry) => readIterate(cursor, boundaryNodes, entry));
  if (!cursor.ended) throw new BadStages(`${binary} is longer than iterates.json says.`);
  return iterates;
}
