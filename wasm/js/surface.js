// A surface as the caller writes it to the packed arrays that cross into the core
// (wasm/marshal.h). Judges the form only; the core repairs the geometry.
import { checkObject } from './domain.js';
import { LpquadError } from './errors.js';
import { checkList, fail, isList } from './lists.js';

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

/**
 * A number for each triangle, or none at all, and the names that these count; without names there are as many as they
 * say, but no more than triangles.
 */
function packLabels(labels, labelNames, triangles, path, pathOfNames) {
  checkList(labels, path, 'an array of numbers');
  if (labels.length > 0 && labels.length !== triangles) fail(path, `as long as there are triangles (${triangles})`, labels);
  checkList(labelNames ?? [], pathOfNames, 'an array of texts').forEach((name, i) => {
    if (typeof name !== 'string') fail(`${pathOfNames}[${i}]`, 'a text', name);
  });
  const pathOf = (i) => `${path}[${i}]`, named = labelNames?.length > 0;
  if (named) checkIndices(labels, labelNames.length, pathOf, `names in ${pathOfNames}`);
  else labels.forEach((label, i) => {
    if (!Number.isInteger(label) || label < 0 || label >= triangles)
      fail(pathOf(i), `a whole number from 0 to ${triangles - 1}, as there are ${triangles} triangles`, label);
  });
  const most = labels.reduce((high, label) => Math.max(high, label), labels.length > 0 ? 0 : -1);
  return { labels: Int32Array.from(labels), names: named ? [...labelNames] : Array(most + 1).fill('') };
}

function packGroups({ groups = [], groupNames }, triangles) {
  const { labels, names } = packLabels(groups, groupNames, triangles, 'surface.groups', 'surface.groupNames');
  return { groups: labels, groupNames: names.length > 0 ? names : [''] };
}

function packBodies({ bodies = [], bodyNames }, triangles) {
  const { labels, names } = packLabels(bodies, bodyNames, triangles, 'surface.bodies', 'surface.bodyNames');
  return { bodies: labels, bodyNames: labels.length > 0 ? names : [] };
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
  checkObject(surface, 'surface',
    ['points', 'triangles', 'groups', 'groupNames', 'bodies', 'bodyNames', 'sizes', ...comments]);
  const points = packPoints(surface.points);
  const triangles = packTriangles(surface.triangles, points), count = triangles.length / 3;
  return { points, triangles, sizes: packSizes(surface, points.length / 3),
    ...packGroups(surface, count), ...packBodies(surface, count) };
}
