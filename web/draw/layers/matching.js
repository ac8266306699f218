/** @import { Pen, Scene, Snapshot, View } from '../../types' */
import { fillRows, lineWidth, rowsOf, strokeEdges } from '../bulk.js';
import { once } from '../once.js';
import { packedOf, shadeCount, shadesOf } from '../palette.js';
import { edgesOf, typicalLength } from '../topology.js';

/** @typedef {NonNullable<Snapshot['matching']>} Matching */

/** Sides of this many pixels leave room for links between partners. */
const readable = 12;

/** Pairs of triangles by what they cost, linked; pairs that only an extra edge joins stand out. @param {Pen} pen @param {Scene} scene @param {View} view */
export function* drawMatching(pen, { frame, palette }, view) {
  const layer = frame?.matching;
  if (!layer || layer.triangles.length === 0) return;
  const { low, high } = costRange(layer);
  const ramp = shadesOf(palette.ramps.costs), special = shadeCount;
  const shades = { css: [...ramp.css, palette.valence[-1]], rgba: [...ramp.rgba, packedOf(palette.valence[-1])] };
  const shade = (/** @type {number} */ t) => layer.extra[t] === 1 ? special
    : layer.mates[t] < 0 ? -1
    : Math.round((shadeCount - 1) * Math.max(0, Math.min(1, (layer.costs[t] - low) / (high - low || 1))));
  yield* fillRows(pen, rowsOf(layer.points, layer.triangles, 3), shade, shades, view);
  yield* drawLines(pen, layer, palette, view);
}

/** @param {Pen} pen  @param {Matching} layer  @param {Scene['palette']} palette  @param {View} view */
function* drawLines(pen, layer, palette, view) {
  const edges = once(layer, 'edges', () => edgesOf(layer.triangles, 3));
  const side = once(layer, 'length', () => typicalLength(layer.points, edges)) * view.scale;
  const { kept, links } = once(layer, 'links', () => linksOf(layer));
  pen.strokeStyle = palette.faint;
  pen.lineWidth = lineWidth(side);
  yield* strokeEdges(pen, layer.points, kept, view);
  if (side < readable) return;
  pen.strokeStyle = palette.ink;
  pen.lineWidth = Math.min(3, side / 12);
  yield* strokeEdges(pen, links, Array.from({ length: links.length / 2 }, (_, i) => i), view);
}

/** Costs between which 96 of 100 lie. @param {Matching} layer */
export function costRange(layer) {
  return once(layer, 'range', () => {
    const sorted = layer.costs.filter((_, t) => layer.mates[t] >= 0).sort();
    const at = (/** @type {number} */ share) => sorted[Math.floor(share * (sorted.length - 1))] ?? 0;
    return { low: at(0.02), high: at(0.98) };
  });
}

/** Edges that are not between partners, and a line from middle to middle of each pair. @param {Matching} layer */
function linksOf({ points, triangles, mates }) {
  /** @type {number[]} */
  const kept = [];
  /** @type {number[]} */
  const links = [];
  const middle = (/** @type {number} */ t, /** @type {number} */ axis) =>
    (points[2 * triangles[3 * t] + axis] + points[2 * triangles[3 * t + 1] + axis] + points[2 * triangles[3 * t + 2] + axis]) / 3;
  for (let t = 0; 3 * t < triangles.length; ++t) {
    const mate = mates[t];
    if (mate > t) links.push(middle(t, 0), middle(t, 1), middle(mate, 0), middle(mate, 1));
    for (let k = 0; k < 3; ++k) {
      const a = triangles[3 * t + k], b = triangles[3 * t + (k + 1) % 3];
      if (mate < 0 || !hasEdge(triangles, mate, b, a)) kept.push(a, b);
    }
  }
  return { kept: edgesOf(Uint32Array.from(kept), 2), links: Float64Array.from(links) };
}

/** @param {Uint32Array} triangles  @param {number} t  @param {number} a  @param {number} b */
const hasEdge = (triangles, t, a, b) =>
  [0, 1, 2].some((k) => triangles[3 * t + k] === a && triangles[3 * t + (k + 1) % 3] === b);
