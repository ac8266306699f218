/** @import { Pen, Scene, View } from '../../types' */
import { toScreen } from '../view.js';

/** The outlines as given. @param {Pen} pen  @param {Scene} scene  @param {View} view */
export function drawBoundary(pen, { drawing, palette }, view) {
  pen.strokeStyle = palette.boundary;
  pen.lineWidth = 1.5;
  pen.lineJoin = 'round';
  for (const { loops } of drawing.regions)
    for (const loop of loops) {
      pen.beginPath();
      loop.forEach(([x, y], i) => pen[i === 0 ? 'moveTo' : 'lineTo'](...toScreen(view, x, y)));
      pen.closePath();
      pen.stroke();
    }
}
