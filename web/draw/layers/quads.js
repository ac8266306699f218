/** @import { Pen, Scene, Snapshot, View } from '../../types' */
import { fillRows, lineWidth, rowsOf, strokeEdges } from '../bulk.js';
import { once } from '../once.js';
import { shadeCount, shadesOf } from '../palette.js';
import { edgesOf, typicalLength } from '../topology.js';

/** @typedef {NonNullable<Snapshot['quads']>} Quads */

/**
 * Lines of the quads, and of triangles that are left over.
 * @param {Pen} pen  @param {Scene} scene  @param {View} view
 */
export function* drawQuads(pen, { frame, palette }, view) {
  const layer = frame?.quads;
  if (!layer) return;
  const edges = quadEdges(layer);
  yield;
  pen.strokeStyle = palette.ink;
  pen.lineWidth = lineWidth(quadLength(layer) * view.scale);
  yield* strokeEdges(pen, layer.points, edges, view);
  const leftOver = once(layer, 'left over', () => edgesOf(layer.triangles, 3));
  yield* strokeEdges(pen, layer.points, leftOver, view);
}

/** @param {Quads} layer */
const quadEdges = (layer) => once(layer, 'edges', () => edgesOf(layer.quads, 4));
/** Typical side. @param {Quads} layer */
export const quadLength = (layer) => once(layer, 'length', () => typicalLength(layer.points, quadEdges(layer)));

/** The η at the low end of the ramp. */
export const lowestQuality = 0.5;

/** Quads coloured by η; left-over triangles have none. @param {Pen} pen  @param {Scene} scene  @param {View} view */
export function* drawQuality(pen, { frame, palette }, view) {
  const layer = frame?.quads;
  if (!layer) return;
  const { points, quads, triangles, eta } = layer;
  const shade = (/** @type {number} */ f) =>
    Math.round((shadeCount - 1) * Math.max(0, Math.min(1, (eta[f] - lowestQuality) / (1 - lowestQuality))));
  const shades = shadesOf(palette.ramps.quality);
  yield* fillRows(pen, rowsOf(points, quads, 4), shade, shades, view);
  yield* fillRows(pen, rowsOf(points, triangles, 3), () => 0, shades, view);
}
