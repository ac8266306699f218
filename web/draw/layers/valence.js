/** @import { Pen, Scene, View } from '../../types' */
import { drawMark, drawMarkInBulk, markOf, writeIn } from '../marks.js';
import { toScreen } from '../view.js';
import { quadLength } from './quads.js';

/** @typedef {import('./quads.js').Quads} Quads */

/** Sides of this many pixels leave room for a number. */
const readable = 34;

/** So many marks are drawn in bulk. */
const many = 600;

/**
 * Irregular vertices: shape and colour by how many quads are too few or too many.
 * @param {Pen} pen  @param {Scene} scene  @param {View} view
 */
export function* drawValence(pen, { frame, palette }, view) {
  const layer = frame?.quads;
  if (!layer) return;
  const side = quadLength(layer) * view.scale;
  const radius = side >= readable ? 10 : Math.max(3, Math.min(6.5, 0.45 * side));
  const shown = irregularIn(layer, view, radius);
  const drawOne = shown.length > many ? drawMarkInBulk : drawMark;
  for (const [i, { v, x, y }] of shown.entries()) {
    const mark = markOf(palette, layer.excess[v]);
    drawOne(pen, mark.shape, x, y, radius, mark.colour, palette.background);
    if (side >= readable) writeIn(pen, String(layer.valence[v]), x, y, palette.background);
    if (i % 100 === 0) yield;
  }
}

/** Those in sight. @param {Quads} layer  @param {View} view  @param {number} radius */
function irregularIn({ excess, points }, view, radius) {
  const shown = [];
  for (let v = 0; v < excess.length; ++v) {
    if (excess[v] === 0) continue;
    const [x, y] = toScreen(view, points[2 * v], points[2 * v + 1]);
    if (x > -radius && y > -radius && x < view.width + radius && y < view.height + radius) shown.push({ v, x, y });
  }
  return shown;
}
