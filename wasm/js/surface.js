// A surface as the caller writes it to the packed arrays that cross into the core
// (wasm/marshal.h). Judges the form only; the core repairs the geometry.
import { checkList, checkObject, fail, isList } from './domain.js';
import { LpquadError } from './errors.js';

// What readSurface says beside; accepted and not read.
const comments = ['warnings', 'name', 'description'];

/** [[a, b, c], …] or [a0, b0, c0, …] as one flat list, and the path of its i-th number. */
function flatTriples(value, path, what) {
  checkList(value, path, `an array of ${what}`);
  if (!isList(value[0])) {
    if (value.length % 3 !== 0) fail(path, `three numbers for each of its ${what}`, value);
    return { flat: value, pathOf: (i) => `${path}[${i}]` };
  }
  const flat = [];
  for (let i = 0; i < value.length; ++i) {
    if (!isList(value[i]) || value[i].length !== 3) fail(`${path}[${i}]`, 'three numbers', value[i]);
    flat.push(value[i][0], value[i][1], value[i][2]);
  }
  return { flat, pathOf: (i) => `${path}[${Math.floor(i / 3)}][${i % 3}]` };
}

function packPoints(value) {
  const { flat, pathOf } = flatTriples(value, 'surface.points', 'points');
  for (let i = 0; i < flat.length; ++i) {
    if (typeof flat[i] !== 'number') fail(pathOf(i), 'a number', flat[i]);
    if (!Number.isFinite(flat[i]))
      throw new LpquadError('NON_FINITE', `${pathOf(i)} is ${flat[i]}; it must be finite.`);
  }
  return Float64Array.from(flat);
}

function checkIndices(list, count, pathOf, what) {
  for (let i = 0; i < list.length; ++i)
    if (!Number.isInteger(list[i]) || list[i] < 0 || list[i] >= count)
      fail(pathOf(i), `the index of one of the ${count} ${what}`, list[i]);
}

function packTriangles(value, points) {
  const { flat, pathOf } = flatTriples(value, 'surface.triangles', 'triangles');
  checkIndices(flat, points.length / 3, pathOf, 'points');
  return Uint32Array.from(flat);
}

function packGroups({ groups = [], groupNames }, triangles) {
  checkList(groups, 'surface.groups', 'an array of numbers');
  if (groups.length > 0 && groups.length !== triangles)
    fail('surface.groups', `as long as there are triangles (${triangles})`, groups);
  const most = groups.reduce((high, group) => Math.max(high, group), 0);
  const names = groupNames ?? Array(Number.isInteger(most) ? Math.min(most, triangles) + 1 : 1).fill('');
  checkList(names, 'surface.groupNames', 'an array of texts').forEach((name, i) => {
    if (typeof name !== 'string') fail(`surface.groupNames[${i}]`, 'a text', name);
  });
  checkIndices(groups, names.length, (i) => `surface.groups[${i}]`, 'names');
  return { groups: Int32Array.from(groups), groupNames: names.length > 0 ? [...names] : [''] };
}

function packSizes({ sizes = [] }, points) {
  checkList(sizes, 'surface.sizes', 'an array of lengths');
  if (sizes.length > 0 && sizes.length !== points)
    fail('surface.sizes', `as long as there are points (${points})`, sizes);
  for (let i = 0; i < sizes.length; ++i)
    if (typeof sizes[i] !== 'number') fail(`surface.sizes[${i}]`, 'a number', sizes[i]);
  return Float64Array.from(sizes);
}

/** @param {import('./surface.js').SurfaceInput} surface */
export function packSurface(surface) {
  checkObject(surface, 'surface', ['points', 'triangles', 'groups', 'groupNames', 'sizes', ...comments]);
  const points = packPoints(surface.points);
  const triangles = packTriangles(surface.triangles, points);
  return { points, triangles, sizes: packSizes(surface, points.length / 3), ...packGroups(surface, triangles.length / 3) };
}
