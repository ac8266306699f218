// What is worth comparing: the same drawing meshed twice, with one thing changed.
/** @import { MeshOptions, Project } from '../types' */
/** @import { Figures } from '../figures/statistics.js' */
import { haveSameMesh } from '../state/project.js';

/**
 * @typedef {{name: string, options: MeshOptions}} Side
 * @typedef {{id: string, title: string, why: string, sides: [Side, Side]}} Comparison
 */

/** The method of the paper, in which the iterations are all there is. @type {MeshOptions} */
const plain = { method: 'paper', seeds: 'isotropic', iterations: 80 };

/** What the method chooses by itself. @type {MeshOptions} */
const automatic = { seeds: 'automatic', iterations: -1 };

/** @type {Comparison[]} */
export const comparisons = [
  {
    id: 'lp', title: 'Without and with L_p',
    why: 'The same first points, merged at once, or after 80 iterations that make the cells square.',
    sides: [
      { name: 'without L_p', options: { ...plain, iterations: 0 } },
      { name: '80 iterations of L_p', options: plain }],
  },
  {
    id: 'seeds', title: 'Isotropic and aligned first points',
    why: 'Points spread evenly and settled by L_p, or laid in rows along the cross field from the start.',
    sides: [
      { name: 'isotropic', options: { seeds: 'isotropic', iterations: -1 } },
      { name: 'aligned', options: { seeds: 'aligned', iterations: -1 } }],
  },
  {
    id: 'norm', title: 'p = 2 and p = 6',
    why: 'Euclidean cells become hexagons; with a larger p they become squares, whose triangles merge better.',
    sides: [
      { name: 'p = 2', options: { ...plain, norm: 2 } },
      { name: 'p = 6', options: { ...plain, norm: 6 } }],
  },
  {
    id: 'method', title: "The paper's method and the best",
    why: 'What remeshing patches and smoothing corners add to the method of the paper.',
    sides: [
      { name: 'paper', options: { ...automatic, method: 'paper' } },
      { name: 'best', options: { ...automatic, method: 'best' } }],
  },
  {
    id: 'effort', title: 'Normal and high effort',
    why: 'What moving irregular vertices about for much longer brings, and costs.',
    sides: [
      { name: 'normal', options: { method: 'best', effort: 'normal' } },
      { name: 'high', options: { method: 'best', effort: 'high' } }],
  },
];

/** @param {string} id */
export const comparisonOf = (id) => comparisons.find((one) => one.id === id);

/** The project with a side's options; the very same options as before while its mesh is the same.
 * @param {Project} project  @param {Side} side  @param {{project: Project, side: Side, made: Project} | null} before */
export function projectOf(project, side, before) {
  const same = before !== null && before.side === side && haveSameMesh(before.project, project);
  return { ...project, options: same ? before.made.options : { ...project.options, ...side.options } };
}

/**
 * One line of the table of differences; `better` is the sign of a difference for the better.
 * @typedef {object} Line
 * @property {string} name
 * @property {-1 | 0 | 1} better
 * @property {(figures: Figures) => number | undefined} of
 * @property {(value: number) => string} write
 */

const three = (/** @type {number} */ value) => value.toFixed(3);
const count = (/** @type {number} */ value) => value.toLocaleString('en');

/** @param {Figures} figures  in milliseconds */
const timeOf = ({ seconds }) => seconds && 1000 * Object.values(seconds).reduce((sum, one) => sum + one, 0);

/** @type {Line[]} */
export const lines = [
  { name: 'Right angles before merging τ', better: 1, of: (f) => f.tau, write: three },
  { name: 'Squareness, mean η', better: 1, of: (f) => f.etaMean, write: three },
  { name: 'Squareness, least η', better: 1, of: (f) => f.etaMin, write: three },
  { name: 'Regular vertices inside, %', better: 1, of: (f) => f.fourValentPercent, write: (v) => v.toFixed(1) },
  { name: 'Irregular vertices inside', better: -1, of: (f) => f.irregular, write: count },
  { name: 'Quads', better: 0, of: (f) => f.quads, write: count },
  { name: 'Triangles', better: -1, of: (f) => f.triangles, write: count },
  { name: 'Time, ms', better: -1, of: timeOf, write: (v) => Math.round(v).toLocaleString('en') },
];

/** @param {Line} line  @param {Figures} a  @param {Figures} b */
export function difference({ of, write, better }, a, b) {
  const [from, to] = [of(a), of(b)];
  if (from === undefined || to === undefined) return { text: '–', good: 0 };
  const by = to - from;
  const shown = write(Math.abs(by));
  const none = Number(shown.replaceAll(',', '')) === 0;
  return { text: none ? '0' : `${by > 0 ? '+' : '−'}${shown}`, good: none ? 0 : Math.sign(by) * better || 0 };
}
