// Domains to begin with. Each says what it is good for; numbers are in no particular unit.
/** @import { Drawing, MeshOptions, Point, Project, Region } from '../types' */
import { emptyProject } from '../state/project.js';
import { circle, rectangle } from './model/shapes.js';
import { denmark } from './presets/denmark.js';
import { airfoil, gear, hood, letter, star } from './presets/outlines.js';
import { jitteredGrid } from './presets/paper_squares.js';

/** @typedef {{id: string, title: string, why: string, project: Project}} Preset */

/** @param {Point[][]} loops  @returns {Drawing} */
const plain = (...loops) => ({ regions: [{ name: '', loops }], polylines: [], points: [] });

/** @param {string} id  @param {string} title  @param {string} why  @param {Drawing} drawing  @param {MeshOptions} options
 *  @param {Partial<Project>} [more]  @returns {Preset} */
const preset = (id, title, why, drawing, options, more) =>
  ({ id, title, why, project: { ...emptyProject, preset: id, drawing, options, ...more } });

/** @param {string} name  @param {number} jitter */
const paperSquare = (name, jitter) => preset(`paper-${name.toLowerCase()}`, `Paper’s square ${name}`,
  `Fig. 12 of the paper: a grid of 11 × 11 whose inner points start up to ${jitter} cells away, and find back.`,
  plain(rectangle(0, 0, 1, 1)), { size: 0.1, method: 'paper', iterations: 100 }, { seedPoints: jitteredGrid(11, jitter, 1) });

/** @type {Region[]} */
const materials = [
  { name: 'steel', loops: [[[0, 0], [1, 0], [1.25, 0.5], [1, 1], [0, 1]]], tags: [['base', '', '', 'top', 'clamped']] },
  { name: 'copper', loops: [[[1, 0], [2.2, 0], [2.2, 1], [1, 1], [1.25, 0.5]], circle(1.75, 0.5, 0.18, 24)],
    tags: [['base', 'pulled', 'top', '', ''], Array(24).fill('bore')] },
];

/** @type {Drawing} */
const lines = {
  ...plain([[0, 0], [1.6, 0], [1.6, 1], [0, 1], [0, 0.3]]),
  polylines: [
    { points: [[0, 0.3], [0.5, 0.42], [0.95, 0.4], [1.3, 0.5]], tag: 'fault' },
    { points: [[0.35, 0.72], [0.8, 0.84]], tag: 'crack' },
  ],
  points: [{ position: [0.45, 0.15], tag: 'well' }, { position: [1.25, 0.25], tag: 'well' }],
};

const glyph = letter();

/** @type {Preset[]} */
export const presets = [
  preset('plate', 'Plate with a hole', 'Voronoi cells become square round a hole, as in the paper’s Figs. 2 and 3.',
    plain(rectangle(0, 0, 2, 1), circle(1, 0.5, 0.22, 32)), { size: 0.055, seeds: 'isotropic', iterations: 80 }),
  preset('square', 'Square', 'The simplest domain; every vertex can be regular.',
    plain(rectangle(0, 0, 1, 1)), { size: 0.05 }),
  paperSquare('A', 0.15), paperSquare('B', 0.35), paperSquare('C', 0.4), paperSquare('D', 0.6),
  preset('l', 'L shape', 'A corner that points inwards; the grid goes on around it.',
    plain([[0, 0], [1, 0], [1, 0.5], [0.5, 0.5], [0.5, 1], [0, 1]]), { size: 0.04 }),
  preset('disc', 'Disc', 'No corner at all: four irregular vertices must be somewhere inside.',
    plain(circle(0, 0, 0.6, 64)), { size: 0.05 }),
  preset('annulus', 'Ring', 'Rows follow both circles without one irregular vertex.',
    plain(circle(0, 0, 0.7, 72), circle(0, 0, 0.3, 32)), { size: 0.05 }),
  preset('two-holes', 'Two holes', 'A round and an oblong hole: the rows part and join again.',
    plain(rectangle(0, 0, 2, 1), circle(0.55, 0.5, 0.22, 32), circle(0, 0, 1, 32).map(([x, y]) => [1.45 + 0.26 * x, 0.52 + 0.18 * y])), { size: 0.05 }),
  preset('gear', 'Gear', 'Twelve teeth and a bore: many corners close together.',
    plain(gear(12), circle(0, 0, 0.2, 32)), { size: 0.035 }),
  preset('star', 'Star', 'Sharp tips, where no square fits.',
    plain(star(5)), { size: 0.04 }),
  preset('hood', 'Car hood', 'Bulging sides, as the body part of the paper’s Figs. 19 to 23.',
    plain(hood()), { size: 0.045 }),
  preset('airfoil', 'Airfoil', 'NACA 2412 in a box: fine about the section, coarse far away.',
    plain(rectangle(-0.7, -0.7, 1.9, 0.7), airfoil('2412', 40)), { size: 0.07, growth: 0.3 }),
  preset('denmark', 'Country', 'The coast of Jutland (Natural Earth): edges of all lengths.',
    plain(denmark), { size: 70, simplify: 12 }),
  preset('letter', 'Letter', 'The letter a: bends and thin parts.',
    plain(glyph.outline, glyph.counter), { size: 0.035 }),
  preset('materials', 'Two materials', 'Two regions that share an edge, and its mesh edges; the names go into the files.',
    { regions: materials, polylines: [], points: [] }, { size: 0.06 }),
  preset('lines', 'Lines inside', 'A fault, a crack and two wells become edges and vertices of the mesh.',
    lines, { size: 0.05 }),
];
