/** @import { Pen, Scene, View } from '../../types' */
import { edgesOf, strokeEdges } from '../edges.js';
import { mix } from '../palette.js';
import { toScreen } from '../view.js';

/** @param {Pen} pen  @param {Scene} scene  @param {View} view */
export function drawQuads(pen, { frame, palette }, view) {
  if (!frame?.quads) return;
  pen.strokeStyle = palette.ink;
  pen.lineWidth = 1;
  strokeEdges(pen, frame.quads.points, edgesOf(frame.quads.quads, 4), view);
}

/** Quads coloured by η. @param {Pen} pen  @param {Scene} scene  @param {View} view */
export function drawQuality(pen, { frame, palette }, { scale, left, top }) {
  const layer = frame?.quads;
  if (!layer) return;
  const { points, quads, eta } = layer;
  for (let f = 0; 4 * f < quads.length; ++f) {
    pen.fillStyle = mix(palette.quadLow, palette.quadHigh, Math.max(0, 2 * eta[f] - 1));
    pen.beginPath();
    for (let k = 0; k < 4; ++k) {
      const v = 2 * quads[4 * f + k];
      pen[k === 0 ? 'moveTo' : 'lineTo']((points[v] - left) * scale, (top - points[v + 1]) * scale);
    }
    pen.fill();
  }
}

/** Irregular vertices, by how many quads are too few or too many. @param {Pen} pen  @param {Scene} scene  @param {View} view */
export function drawValence(pen, { frame, palette }, view) {
  const layer = frame?.quads;
  if (!layer) return;
  layer.excess.forEach((excess, v) => {
    if (excess === 0) return;
    pen.fillStyle = palette.valence[Math.max(-2, Math.min(2, excess))];
    pen.beginPath();
    pen.arc(...toScreen(view, layer.points[2 * v], layer.points[2 * v + 1]), 4, 0, 2 * Math.PI);
    pen.fill();
  });
}
