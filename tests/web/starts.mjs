// Fifty projects to begin with: the presets, and seeded variations of them, made by the generators of
// the presets with other numbers, turned, in another unit, each outline begun elsewhere, at another size.
import { mapVertices } from '../../web/sketch/model/drawing.js';
import { circle, rectangle } from '../../web/sketch/model/shapes.js';
import { presets } from '../../web/sketch/presets.js';
import { airfoil, gear, star } from '../../web/sketch/presets/outlines.js';
import { jitteredGrid } from '../../web/sketch/presets/paper_squares.js';
import { createDice } from './dice.mjs';

const drawingOf = (...loops) => ({ regions: [{ name: '', loops }], polylines: [], points: [] });

/** Presets whose generators take numbers. */
const generators = {
  plate: (dice) => ({ drawing: drawingOf(rectangle(0, 0, 2, 1), circle(dice.between(0.5, 1.5), 0.5, dice.between(0.12, 0.3), 4 * dice.between(5, 9) | 0)) }),
  disc: (dice) => ({ drawing: drawingOf(circle(0, 0, 0.6, 24 + 2 * dice.below(30))) }),
  annulus: (dice) => ({ drawing: drawingOf(circle(0, 0, 0.7, 72), circle(dice.between(-0.15, 0.15), 0, dice.between(0.2, 0.4), 32)) }),
  gear: (dice) => ({ drawing: drawingOf(gear(8 + dice.below(9)), circle(0, 0, 0.2, 32)) }),
  star: (dice) => ({ drawing: drawingOf(star(4 + dice.below(5))) }),
  airfoil: (dice) => ({ drawing: drawingOf(rectangle(-0.7, -0.7, 1.9, 0.7), airfoil(dice.pick(['0012', '2412', '4415', '0018']), 30 + dice.below(20))) }),
  'paper-b': (dice) => ({ seedPoints: jitteredGrid(11, dice.between(0.1, 0.6), 2 + dice.below(99)) }),
};

/** Loops begun at another vertex, with their tags. */
function begunElsewhere(drawing, dice) {
  const turned = (list, k) => [...list.slice(k), ...list.slice(0, k)];
  return { ...drawing, regions: drawing.regions.map((region) => {
    const places = region.loops.map((loop) => dice.below(loop.length));
    return { ...region, loops: region.loops.map((loop, i) => turned(loop, places[i])),
      ...(region.tags && { tags: region.tags.map((tags, i) => turned(tags, places[i])) }) };
  }) };
}

function variation({ id, title, project }, number, dice) {
  const { drawing, seedPoints, options } = { ...project, ...generators[id]?.(dice) };
  const angle = dice.between(0, 2 * Math.PI), unit = 10 ** dice.between(-2, 2);
  const [c, s] = [unit * Math.cos(angle), unit * Math.sin(angle)];
  const move = ([x, y]) => [c * x - s * y, s * x + c * y];
  const size = options.size * unit * dice.between(0.9, 1.6);
  return { ...project, preset: '', name: `${title} ${number}`, drawing: begunElsewhere(mapVertices(drawing, move), dice), seedPoints: seedPoints.map(move),
    options: { ...options, size, ...(options.simplify && { simplify: options.simplify * unit }) } };
}

/** @param {number} seed */
export function startProjects(seed) {
  const dice = createDice(seed);
  const variations = Array.from({ length: 50 - presets.length }, (_, k) => variation(presets[k % presets.length], k + 1, dice));
  return [...presets.map(({ project }) => project), ...variations];
}
