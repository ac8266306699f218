/** @import { Pen, Scene, View } from '../../types' */
import { lineWidth, strokeEdges } from '../bulk.js';
import { once } from '../once.js';
import { edgesOf, typicalLength } from '../topology.js';

/** The triangulation before the matching. @param {Pen} pen  @param {Scene} scene  @param {View} view */
export function* drawTriangles(pen, { frame, palette }, view) {
  const layer = frame?.triangles;
  if (!layer) return;
  const edges = once(layer, 'edges', () => edgesOf(layer.triangles, 3));
  yield;
  pen.strokeStyle = palette.faint;
  pen.lineWidth = lineWidth(once(layer, 'length', () => typicalLength(layer.points, edges)) * view.scale);
  yield* strokeEdges(pen, layer.points, edges, view);
}
