// Judges what comes from outside (a link, a file, the browser's storage) before it becomes a
// project: every member is copied by name, every number is finite, every count is bounded.
/** @import { Drawing, LayerName, MeshOptions, Point, Project, Region } from '../types' */
import { layerNames } from '../run/needed.js';
import { faultOfOption } from './options.js';
import { emptyProject } from './project.js';

const most = { points: 1e6, parts: 1e5, text: 200 };

/** Says, in words for the person, why something is not a project. */
export class NotAProject extends Error {}

/** @param {string} why  @returns {never} */
function refuse(why) { throw new NotAProject(why); }

/** @param {unknown} value  @param {string} what  @param {number} [limit]  @returns {unknown[]} */
function list(value, what, limit = most.parts) {
  if (!Array.isArray(value)) return refuse(`${what} should be a list`);
  if (value.length > limit) refuse(`${what}: ${value.length} are too many`);
  return value;
}

/** @param {unknown} value  @param {string} what  @returns {Record<string, unknown>} */
function record(value, what) {
  if (typeof value !== 'object' || value === null || Array.isArray(value)) return refuse(`${what} should have named parts`);
  return /** @type {Record<string, unknown>} */ (value);
}

/** @param {unknown} value  @param {string} what */
function text(value, what) {
  if (typeof value !== 'string' || value.length > most.text) return refuse(`${what} should be a short text`);
  return value;
}

/** @param {unknown} value  @param {string} what  @param {number} count  @returns {number[]} */
function numbers(value, what, count) {
  const all = list(value, what, count);
  if (all.length !== count || !all.every(Number.isFinite)) refuse(`${what} should be ${count} finite numbers`);
  return /** @type {number[]} */ (all);
}

/** @param {unknown} value  @param {string} what  @returns {Point[]} */
const points = (value, what) =>
  list(value, what, most.points).map((point) => /** @type {Point} */ (numbers(point, 'a point', 2)));

/** @param {unknown} value  @returns {Region} */
function region(value) {
  const { name = '', loops, tags } = record(value, 'a region');
  const judged = { name: text(name, 'a name'), loops: list(loops, 'loops').map((loop) => points(loop, 'a loop')) };
  if (tags === undefined) return judged;
  return { ...judged, tags: list(tags, 'tags').map((row) => list(row, 'tags', most.points).map((tag) => text(tag ?? '', 'a tag'))) };
}

/** @param {unknown} value  @returns {Drawing} */
export function drawing(value) {
  const { regions, polylines = [], points: single = [] } = record(value, 'a drawing');
  return {
    regions: list(regions, 'regions').map(region),
    polylines: list(polylines, 'lines').map((line) => {
      const { points: along, tag = '' } = record(line, 'a line');
      return { points: points(along, 'a line'), tag: text(tag, 'a tag') };
    }),
    points: list(single, 'points', most.points).map((point) => {
      const { position, tag = '' } = record(point, 'a point');
      return { position: /** @type {Point} */ (numbers(position, 'a point', 2)), tag: text(tag, 'a tag') };
    }),
  };
}

/** @param {unknown} value  @returns {MeshOptions} */
export function options(value) {
  const entries = Object.entries(record(value, 'options'));
  for (const [name, given] of entries) {
    const fault = faultOfOption(name, given);
    if (fault) refuse(fault);
  }
  return Object.fromEntries(entries);
}

/** @param {unknown} value  @returns {Project['layers']} */
export function layers(value) {
  if (value === 'auto') return 'auto';
  const names = list(value, 'layers', layerNames.length).map((name) => text(name, 'a layer'));
  for (const name of names)
    if (!layerNames.includes(/** @type {LayerName} */ (name))) refuse(`there is no layer “${name}”`);
  return /** @type {LayerName[]} */ (names);
}

/** @param {unknown} value  @param {string} what */
export function identifier(value, what) {
  const name = text(value, what);
  return /^[\w.-]*$/.test(name) ? name : refuse(`${what} is no name`);
}

/** What each part of a project must be. @type {{[K in keyof Project]: (value: unknown) => Project[K]}} */
const judges = {
  preset: (value) => identifier(value, 'the preset'),
  name: (value) => text(value, 'the name'),
  drawing,
  options,
  sizes: (value) => list(value, 'sizes', most.points).map((size) => {
    const [x, y, h] = numbers(size, 'a size', 3);
    return h > 0 ? [x, y, h] : refuse('a painted size should be above 0');
  }),
  guides: (value) => list(value, 'guides').map((guide) => points(guide, 'a guide')),
  seedPoints: (value) => points(value, 'seed points'),
  layers,
  comparison: (value) => identifier(value, 'the comparison'),
};

/** The parts of a project that `value` has, judged. @param {unknown} value  @returns {Partial<Project>} */
export function parts(value) {
  const given = record(value, 'a project');
  const names = /** @type {(keyof Project)[]} */ (Object.keys(judges)).filter((name) => Object.hasOwn(given, name));
  return Object.fromEntries(names.map((name) => [name, judges[name](given[name])]));
}

/** @param {unknown} value  @returns {Project} */
export function project(value) {
  const judged = parts(value);
  if (judged.drawing === undefined) refuse('there is no drawing');
  return { ...emptyProject, ...judged };
}
