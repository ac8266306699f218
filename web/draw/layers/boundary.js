/** @import { Pen, Point, Region, Scene, View } from '../../types' */
import { packedOf } from '../palette.js';
import { toScreen } from '../view.js';

/** @param {Pen} pen  @param {View} view  @param {Point[]} points */
export function tracePoints(pen, view, points) {
  points.forEach(([x, y], i) => pen[i === 0 ? 'moveTo' : 'lineTo'](...toScreen(view, x, y)));
}

/** The inside, below everything. @param {Pen} pen  @param {Scene} scene  @param {View} view */
export function drawRegions(pen, { drawing, palette }, view) {
  pen.fillStyle = palette.region;
  for (const { loops } of drawing.regions)
    if (pen.fillPolygon) {
      // Back to the first point after each loop: the way there and the way back cancel.
      const corners = loops.flatMap((loop) => [...loop, loop[0], loops[0][0]]);
      const flat = Float64Array.from(corners.flatMap(([x, y]) => toScreen(view, x, y)));
      pen.fillPolygon(flat, corners.length, packedOf(palette.region));
    } else {
      pen.beginPath();
      for (const loop of loops) {
        tracePoints(pen, view, loop);
        pen.closePath();
      }
      pen.fill('evenodd');
    }
}

/**
 * The outlines, lines and points as given; tagged edges stronger.
 * @param {Pen} pen  @param {Scene} scene  @param {View} view
 */
export function drawBoundary(pen, { drawing, palette }, view) {
  pen.strokeStyle = palette.boundary;
  pen.lineJoin = 'round';
  pen.lineCap = 'round';
  pen.lineWidth = 1.5;
  for (const { loops } of drawing.regions) for (const loop of loops) strokePoints(pen, view, loop, true);
  for (const { points } of drawing.polylines) strokePoints(pen, view, points, false);
  pen.lineWidth = 3;
  for (const { loops, tags } of drawing.regions)
    loops.forEach((loop, l) => loop.forEach((point, i) => {
      if (tags?.[l]?.[i]) strokePoints(pen, view, [point, loop[(i + 1) % loop.length]], false);
    }));
  pen.fillStyle = palette.boundary;
  for (const { position } of drawing.points) {
    pen.beginPath();
    pen.arc(...toScreen(view, ...position), 3, 0, 2 * Math.PI);
    pen.fill();
  }
}

/** @param {Pen} pen  @param {View} view  @param {Point[]} points  @param {boolean} closed */
function strokePoints(pen, view, points, closed) {
  pen.beginPath();
  tracePoints(pen, view, points);
  if (closed) pen.closePath();
  pen.stroke();
}
