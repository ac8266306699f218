// Domains to begin with. Each says what it is good for; numbers are in no particular unit.
/** @import { Drawing, MeshOptions, Point, Project } from '../types' */
import { emptyProject } from '../state/project.js';

/** @typedef {{id: string, title: string, why: string, project: Project}} Preset */

/** @param {Point[][]} loops  @returns {Drawing} */
const plain = (...loops) => ({ regions: [{ name: '', loops }], polylines: [], points: [] });

/** @returns {Point[]} */
export function circle(/** @type {number} */ x, /** @type {number} */ y, /** @type {number} */ radius, /** @type {number} */ count) {
  return Array.from({ length: count }, (_, i) => {
    const angle = 2 * Math.PI * i / count;
    return [x + radius * Math.cos(angle), y + radius * Math.sin(angle)];
  });
}

/** @returns {Point[]} */
export const rectangle = (/** @type {number} */ left, /** @type {number} */ bottom, /** @type {number} */ right, /** @type {number} */ top) =>
  [[left, bottom], [right, bottom], [right, top], [left, top]];

/** @param {string} id  @param {string} title  @param {string} why  @param {Drawing} drawing  @param {MeshOptions} options @returns {Preset} */
const preset = (id, title, why, drawing, options) =>
  ({ id, title, why, project: { ...emptyProject, preset: id, drawing, options } });

/** @type {Preset[]} */
export const presets = [
  preset('plate', 'Plate with a hole', 'Voronoi cells become square round a hole: the method at work.',
    plain(rectangle(0, 0, 2, 1), circle(1, 0.5, 0.22, 32)), { size: 0.06, seeds: 'isotropic' }),
  preset('square', 'Square', 'The simplest domain; every vertex can be regular.',
    plain(rectangle(0, 0, 1, 1)), { size: 0.05 }),
];
