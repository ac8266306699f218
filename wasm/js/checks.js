// Judges the form of what crosses into the core, so that a slip is named instead of cast.
import { isList } from './domain.js';
import { LpquadError } from './errors.js';

/** Refuses members of an object of switches that nothing would read. */
export function checkNames(object, known, kind) {
  if (object === null || typeof object !== 'object')
    throw new LpquadError('BAD_OPTION', `Each ${kind} is a member of an object.`);
  for (const name of Object.keys(object))
    if (!known.includes(name))
      throw new LpquadError('BAD_OPTION',
        `There is no ${kind} '${name}'; there is ${known.join(', ')}.`);
}

export function checkWhole(value, what) {
  if (!Number.isInteger(value) || value < 0 || value > 0x7fffffff)
    throw new LpquadError('BAD_OPTION', `${what} must be a whole number from 0 to 2147483647, not ${String(value)}.`);
}

/** The text or bytes of a file. */
export function checkSource(source) {
  if (source instanceof ArrayBuffer) return new Uint8Array(source);
  if (typeof source !== 'string' && !(source instanceof Uint8Array))
    throw new LpquadError('PARSE_ERROR', 'A file is given as a text, a Uint8Array or an ArrayBuffer.');
  return source;
}

const arrays = ['points', 'quads', 'quadRegions', 'triangles', 'triangleRegions', 'edges', 'edgeTags',
  'edgeRegions', 'edgeOrigins', 'taggedPoints', 'pointTags', 'regions', 'tags'];

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

/** Whether all members are there and fit together; the core looks where their indices lead. */
export function checkMesh(mesh) {
  if (mesh === null || typeof mesh !== 'object')
    throw new LpquadError('PARSE_ERROR', 'A mesh is an object, as meshDomain returns it.');
  for (const name of arrays)
    if (!isList(mesh[name]))
      throw new LpquadError('PARSE_ERROR', `mesh.${name} must be an array, as meshDomain returns it.`);
  for (const name of ['regions', 'tags'])
    mesh[name].forEach((text, i) => {
      if (typeof text !== 'string')
        throw new LpquadError('PARSE_ERROR', `mesh.${name}[${i}] must be a text.`);
    });
  if (![undefined, 2, 3].includes(mesh.dimension))
    throw new LpquadError('PARSE_ERROR', 'mesh.dimension must be 3 for a mesh on a surface, or absent.');
  if (typeof mesh.boundaryNodes !== 'number')
    throw new LpquadError('PARSE_ERROR', 'mesh.boundaryNodes must be a number.');
  checkLengths(mesh);
}
