/** @import { Pen, Scene, View } from '../../types' */
import { edgesOf, strokeEdges } from '../edges.js';

/** @param {Pen} pen  @param {Scene} scene  @param {View} view */
export function drawTriangles(pen, { frame, palette }, view) {
  if (!frame?.triangles) return;
  pen.strokeStyle = palette.faint;
  pen.lineWidth = 1;
  strokeEdges(pen, frame.triangles.points, edgesOf(frame.triangles.triangles, 3), view);
}
