/** @import { Pen, Scene, View } from '../../types' */
import { drawMark, markOf, writeIn } from '../marks.js';
import { toScreen } from '../view.js';
import { quadLength } from './quads.js';

/** Sides of this many pixels leave room for a number. */
const readable = 34;

/** Irregular vertices: shape and colour by how many quads are too few or too many. @param {Pen} pen @param {Scene} scene @param {View} view */
export function drawValence(pen, { frame, palette }, view) {
  const layer = frame?.quads;
  if (!layer) return;
  const side = quadLength(layer) * view.scale;
  const radius = side >= readable ? 10 : Math.max(3, Math.min(6.5, 0.45 * side));
  layer.excess.forEach((excess, v) => {
    if (excess === 0) return;
    const [x, y] = toScreen(view, layer.points[2 * v], layer.points[2 * v + 1]);
    if (x < -radius || y < -radius || x > view.width + radius || y > view.height + radius) return;
    const mark = markOf(palette, excess);
    drawMark(pen, mark.shape, x, y, radius, mark.colour, palette.background);
    if (side >= readable) writeIn(pen, String(layer.valence[v]), x, y, palette.background);
  });
}
