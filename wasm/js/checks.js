// Judges the form of what crosses into the core, so that a slip is named instead of cast.
import { LpquadError } from './errors.js';
import { checkList, checkLive, checkNumber, fail, isList } from './lists.js';

/** Refuses members of an object of switches that nothing would read. */
export function checkNames(object, known, kind) {
  if (object === null || typeof object !== 'object' || isList(object))
    throw new LpquadError('BAD_OPTION', `Each ${kind} is a member of an object.`);
  for (const name in object)
    if (!known.includes(name))
      throw new LpquadError('BAD_OPTION',
        `There is no ${kind} '${name}'; there is ${known.join(', ')}.`);
}

/** The options as they are now, those too that the object has from another. */
export function checkOptions(options = {}) {
  if (options === null || typeof options !== 'object' || isList(options))
    throw new LpquadError('BAD_OPTION', 'The options must be an object.');
  const all = Object.create(null);
  for (const name in options) all[name] = options[name];
  return { ...all };
}

export function checkFunction(value, name, of = '') {
  if (typeof value !== 'function') throw new LpquadError('BAD_OPTION', `Option ${name} must be a function${of}.`);
}

/** What the caller's function has made. */
export function checkWorker(thread) {
  if (typeof thread?.postMessage !== 'function') throw new LpquadError('BAD_OPTION', 'Option worker must make a Worker.');
  return thread;
}

/** Where the WebAssembly comes from. `more`: what else the object has, for others to judge. */
export function checkWasmSource(source, of, more = []) {
  const addresses = ['wasmUrl', 'readersUrl', 'surfaceUrl'];
  checkNames(source, [...addresses, 'wasmBinary', 'wasmModule', ...more], `source of ${of}`);
  const { wasmModule, wasmBinary } = source;
  for (const name of addresses)
    if (source[name] !== undefined && (typeof source[name] !== 'string' || source[name] === '') && !(source[name] instanceof URL))
      throw new LpquadError('BAD_WASM', `${name} must be an address: a text or a URL.`);
  if (wasmModule !== undefined && !(wasmModule instanceof WebAssembly.Module))
    throw new LpquadError('BAD_WASM', 'wasmModule must be a WebAssembly.Module.');
  if (wasmBinary !== undefined && !(wasmBinary instanceof ArrayBuffer) && !ArrayBuffer.isView(wasmBinary))
    throw new LpquadError('BAD_WASM', 'wasmBinary must be an ArrayBuffer or a Uint8Array.');
}

export function checkWhole(value, what) {
  if (!Number.isInteger(value) || value < 0 || value > 0x7fffffff)
    throw new LpquadError('BAD_OPTION', `${what} must be a whole number from 0 to 2147483647, not ${String(value)}.`);
}

/** The text or bytes of a file. */
export function checkSource(source) {
  if (typeof source === 'string') return source;
  if (!(source instanceof ArrayBuffer) && !(source instanceof Uint8Array))
    throw new LpquadError('PARSE_ERROR', 'A file is given as a text, a Uint8Array or an ArrayBuffer.');
  checkLive(source, 'The file');
  return source instanceof ArrayBuffer ? new Uint8Array(source) : source;
}

const unsigned = ['quads', 'triangles', 'edges', 'taggedPoints'];
const signed = ['quadRegions', 'triangleRegions', 'edgeTags', 'edgeRegions', 'edgeOrigins', 'pointTags'];
const texts = ['regions', 'tags'];

// Arrays that go side by side: so many entries of the one for so many of the other.
const pairs = [
  ['quadRegions', 1, 'quads', 4], ['triangleRegions', 1, 'triangles', 3], ['edgeTags', 1, 'edges', 2],
  ['edgeRegions', 2, 'edges', 2], ['edgeOrigins', 3, 'edges', 2], ['pointTags', 1, 'taggedPoints', 1],
];

function checkLengths(mesh) {
  const dimension = mesh.dimension ?? 2, { length } = mesh.points;
  if (length % dimension !== 0)
    throw new LpquadError('PARSE_ERROR', `mesh.points has ${length} entries, but there must be ${dimension} for each point.`);
  for (const [name, per, other, width] of pairs) {
    const given = mesh[name].length, beside = mesh[other].length;
    if (given * width !== beside * per)
      throw new LpquadError('PARSE_ERROR', `mesh.${name} has ${given} entries and mesh.${other} has ${beside}, ` +
        `but there must be ${per} for ${width === 1 ? 'each' : `every ${width}`}.`);
  }
}

const isCount = (x) => Number.isInteger(x) && x >= 0 && x < 2 ** 32;

/** What crosses would be cast otherwise, and written. */
function checkNumbers(mesh) {
  const { points } = mesh, bad = points.findIndex((x) => !Number.isFinite(x));
  if (bad >= 0) checkNumber(points[bad], `mesh.points[${bad}]`);
  const checkAll = (names, fits, what) => {
    for (const name of names) {
      const at = mesh[name].findIndex((x) => !fits(x));
      if (at >= 0) fail(`mesh.${name}[${at}]`, what, mesh[name][at]);
    }
  };
  checkAll(unsigned, isCount, 'a whole number, 0 or more');
  checkAll(signed, (x) => Number.isInteger(x) && Math.abs(x) < 2 ** 31, 'a whole number');
  checkAll(texts, (x) => typeof x === 'string', 'a text');
}

/** Whether all members are there and fit together; the core looks where their indices lead. */
export function checkMesh(mesh) {
  if (mesh === null || typeof mesh !== 'object')
    throw new LpquadError('PARSE_ERROR', 'A mesh is an object, as meshDomain returns it.');
  for (const name of ['points', ...unsigned, ...signed, ...texts])
    checkList(mesh[name], `mesh.${name}`, 'an array, as meshDomain returns it');
  checkNumbers(mesh);
  if (![undefined, 2, 3].includes(mesh.dimension))
    throw new LpquadError('PARSE_ERROR', 'mesh.dimension must be 3 for a mesh on a surface, or absent.');
  if (!isCount(mesh.boundaryNodes)) fail('mesh.boundaryNodes', 'a whole number, 0 or more', mesh.boundaryNodes);
  checkLengths(mesh);
}
