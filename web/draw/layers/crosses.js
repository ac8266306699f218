/** @import { Pen, Scene, Snapshot, View } from '../../types' */
import { strokeLines } from '../bulk.js';
import { drawMark, markOf, traceMark } from '../marks.js';
import { axisAt, weightsAt } from '../sampler.js';
import { toScreen } from '../view.js';

/** @typedef {NonNullable<Snapshot['crosses']>} Crosses */
/** @typedef {NonNullable<Snapshot['sizes']>} Sizes */

/** Pixels between glyphs, and of an arm. */
const spacing = 26, arm = 8;

/**
 * Crosses at equal distances on the screen, and the singularities of the field.
 * @param {Pen} pen  @param {Scene} scene  @param {View} view
 */
export function* drawCrosses(pen, { frame, palette }, view) {
  const layer = frame?.crosses;
  if (!layer || layer.points.length === 0) return;
  const { sizes } = frame;  // on the same background triangles
  const together = sizes?.triangles.length && sizes.points.length === layer.points.length;
  const ends = together ? evenly(layer, sizes, view) : thinned(layer, view);
  pen.strokeStyle = palette.accent;
  pen.lineWidth = 1.25;
  yield* strokeLines(pen, ends, view);
  drawSingularities(pen, layer, palette, view);
}

/** Ends of the arms in the world. @param {number} x  @param {number} y  @param {number} c  @param {number} s */
const armsOf = (x, y, c, s) => [x - c, y - s, x + c, y + s, x + s, y - c, x - s, y + c];

/**
 * One glyph in each square of the screen, the squares standing still in the world.
 * @param {Crosses} crosses  @param {Sizes} background  @param {View} view
 */
function evenly({ axes }, background, view) {
  const weights = weightsAt(background), step = spacing / view.scale, reach = arm / view.scale;
  const right = view.left + view.width / view.scale, bottom = view.top - view.height / view.scale;
  /** @type {number[]} */
  const ends = [];
  for (let y = Math.ceil(bottom / step) * step; y <= view.top; y += step)
    for (let x = Math.ceil(view.left / step) * step; x <= right; x += step) {
      const at = weights(x, y), axis = at && axisAt(axes, at);
      if (axis) ends.push(...armsOf(x, y, reach * axis[0], reach * axis[1]));
    }
  return ends;
}

/**
 * Of the points of the field, the nearest to the middle of each square of the screen.
 * @param {Crosses} crosses  @param {View} view
 */
function thinned({ points, axes }, view) {
  const across = Math.ceil(view.width / spacing), reach = arm / view.scale;
  /** @type {Map<number, {gap: number, i: number}>} */
  const chosen = new Map();
  for (let i = 0; 2 * i < points.length; ++i) {
    const [x, y] = toScreen(view, points[2 * i], points[2 * i + 1]);
    if (x < 0 || y < 0 || x > view.width || y > view.height) continue;
    const column = Math.floor(x / spacing), row = Math.floor(y / spacing), square = row * across + column;
    const gap = Math.hypot(x - (column + 0.5) * spacing, y - (row + 0.5) * spacing);
    if (gap < (chosen.get(square)?.gap ?? Infinity)) chosen.set(square, { gap, i });
  }
  return [...chosen.values()].flatMap(({ i }) =>
    armsOf(points[2 * i], points[2 * i + 1], reach * axes[2 * i], reach * axes[2 * i + 1]));
}

/**
 * Hollow where a vertex of the mesh would be solid: +1 (three quads meet) and -1 (five).
 * @param {Pen} pen  @param {Crosses} crosses  @param {Scene['palette']} palette  @param {View} view
 */
function drawSingularities(pen, { singularities, indices }, palette, view) {
  indices.forEach((index, i) => {
    const [x, y] = toScreen(view, singularities[2 * i], singularities[2 * i + 1]);
    const { shape, colour } = markOf(palette, -index);
    drawMark(pen, shape, x, y, 8, palette.background, palette.background);
    pen.strokeStyle = colour;
    pen.lineWidth = 2.5;
    traceMark(pen, shape, x, y, 7);
    pen.stroke();
  });
}
