// The one door for lists and their numbers, named by their paths: arrays and typed arrays. A view of a transferred
// buffer looks empty.
import { LpquadError } from './errors.js';

export const fail = (path, expected, value) => {
  throw new LpquadError('PARSE_ERROR', `${path} must be ${expected}, not ${describe(value)}.`);
};

function describe(value) {
  if (value === null) return 'null';
  if (isList(value)) return `an array of ${value.length}`;
  if (typeof value === 'string') return `the text ${JSON.stringify(value.slice(0, 40))}`;
  if (typeof value === 'object') return 'an object';
  if (typeof value === 'function') return 'a function';
  return String(value);
}

export const isList = (value) =>
  Array.isArray(value) || (ArrayBuffer.isView(value) && !(value instanceof DataView));

/** @param {object} [where]  the place in the input */
export function checkNumber(value, path, where = undefined) {
  if (typeof value !== 'number') fail(path, 'a number', value);
  if (!Number.isFinite(value))
    throw new LpquadError('NON_FINITE', `${path} is ${value}; it must be finite.`, where);
  return value;
}

/** Of no view of a transferred buffer can another be made. */
function isDetached({ buffer, byteLength }) {
  if (byteLength !== 0) return false;
  try {
    return new Uint8Array(buffer).length < 0;
  } catch {
    return true;
  }
}

/** @param {ArrayBufferView | ArrayBuffer} bytes */
export function checkLive(bytes, path) {
  if (isDetached(bytes instanceof ArrayBuffer ? { buffer: bytes, byteLength: bytes.byteLength } : bytes))
    throw new LpquadError('PARSE_ERROR',
      `${path} holds nothing any more: its buffer was transferred, to a worker for example. Pass a copy.`);
}

export function checkList(value, path, expected) {
  if (!isList(value)) fail(path, expected, value);
  if (ArrayBuffer.isView(value)) checkLive(value, path);
  return value;
}

/** All buffers in what is to be sent; whatever else there is may cross or not. */
export function checkAllLive(value, path, seen = new Set()) {
  if (value === null || typeof value !== 'object' || seen.has(value)) return;
  seen.add(value);
  if (ArrayBuffer.isView(value) || value instanceof ArrayBuffer) return checkLive(value, path);
  for (const [name, member] of Object.entries(value))
    checkAllLive(member, Array.isArray(value) ? `${path}[${name}]` : `${path}.${name}`, seen);
}
