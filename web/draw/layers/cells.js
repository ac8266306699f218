/** @import { Pen, Scene, View } from '../../types' */
import { mix } from '../palette.js';

function tracePolygon(/** @type {Pen} */ pen, /** @type {Float64Array} */ points, /** @type {number} */ from, /** @type {number} */ to, /** @type {View} */ { scale, left, top }) {
  for (let i = from; i < to; ++i)
    pen[i === from ? 'moveTo' : 'lineTo']((points[2 * i] - left) * scale, (top - points[2 * i + 1]) * scale);
  pen.closePath();
}

/** Clipped Voronoi cells. @param {Pen} pen  @param {Scene} scene  @param {View} view */
export function drawCells(pen, { frame, palette }, view) {
  const cells = frame?.cells;
  if (!cells) return;
  pen.strokeStyle = palette.faint;
  pen.lineWidth = 1;
  for (let i = 0; i + 1 < cells.offsets.length; i += 8) {
    pen.beginPath();
    for (let k = i; k < Math.min(i + 8, cells.offsets.length - 1); ++k)
      tracePolygon(pen, cells.points, cells.offsets[k], cells.offsets[k + 1], view);
    pen.stroke();
  }
}

/** Energy per area of each cell: paper Fig. 22. @param {Pen} pen  @param {Scene} scene  @param {View} view */
export function drawDensity(pen, { frame, palette }, view) {
  const cells = frame?.cells;
  if (!cells) return;
  const sorted = Float64Array.from(cells.density).sort();
  const high = sorted[Math.floor(0.98 * (sorted.length - 1))] || 1;
  for (let i = 0; i + 1 < cells.offsets.length; ++i) {
    pen.fillStyle = mix(palette.densityLow, palette.densityHigh, Math.min(1, cells.density[cells.sites[i]] / high));
    pen.beginPath();
    tracePolygon(pen, cells.points, cells.offsets[i], cells.offsets[i + 1], view);
    pen.fill();
  }
}
