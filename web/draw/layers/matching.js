/** @import { Pen, Scene, Snapshot, View } from '../../types' */
import { fillRows, lineWidth, rowsOf, strokeEdges, strokeLines } from '../bulk.js';
import { once } from '../once.js';
import { packedOf, shadeCount, shadesOf } from '../palette.js';
import { edgesOf, typicalLength } from '../topology.js';

/** @typedef {NonNullable<Snapshot['matching']>} Matching */

/** Sides of this many pixels leave room for links between partners. */
const readable = 12;

/**
 * Pairs of triangles by what they cost, linked; pairs that only an extra edge joins stand out.
 * @param {Pen} pen  @param {Scene} scene  @param {View} view
 */
export function* drawMatching(pen, { frame, palette }, view) {
  const layer = frame?.matching;
  if (!layer || layer.triangles.length === 0) return;
  const { low, high } = costRange(layer);
  const special = shadeCount, shades = once(palette, 'pairs', () => {
    const ramp = shadesOf(palette.ramps.costs), colour = palette.valence[-1];
    return { css: [...ramp.css, colour], rgba: Uint32Array.of(...ramp.rgba, packedOf(colour)) };
  });
  const shade = (/** @type {number} */ t) => layer.extra[t] === 1 ? special
    : layer.mates[t] < 0 ? -1
    : Math.round((shadeCount - 1) * Math.max(0, Math.min(1, (layer.costs[t] - low) / (high - low || 1))));
  yield* fillRows(pen, rowsOf(layer.points, layer.triangles, 3), shade, shades, view);
  yield* drawLines(pen, layer, palette, view);
}

/** @param {Pen} pen  @param {Matching} layer  @param {Scene['palette']} palette  @param {View} view */
function* drawLines(pen, layer, palette, view) {
  const some = once(layer, 'kept', () => betweenPairs(layer));
  yield;
  const kept = once(layer, 'kept once', () => edgesOf(some, 2));
  yield;
  const side = once(layer, 'length', () => typicalLength(layer.points, kept)) * view.scale;
  pen.strokeStyle = palette.faint;
  pen.lineWidth = lineWidth(side);
  yield* strokeEdges(pen, layer.points, kept, view);
  if (side < readable) return;
  const links = once(layer, 'links', () => linksOf(layer));
  pen.strokeStyle = palette.ink;
  pen.lineWidth = Math.min(3, side / 12);
  yield* strokeLines(pen, links, view);
}

/** Costs between which 96 of 100 lie. @param {Matching} layer */
export function costRange(layer) {
  return once(layer, 'range', () => {
    const sorted = layer.costs.filter((_, t) => layer.mates[t] >= 0).sort();
    const at = (/** @type {number} */ share) => sorted[Math.floor(share * (sorted.length - 1))] ?? 0;
    return { low: at(0.02), high: at(0.98) };
  });
}

/** Edges that are not between partners, those inside twice. @param {Matching} layer */
function betweenPairs({ triangles, mates }) {
  const all = new Uint32Array(2 * triangles.length);
  let count = 0;
  for (let t = 0; 3 * t < triangles.length; ++t)
    for (let k = 0; k < 3; ++k) {
      const a = triangles[3 * t + k], b = triangles[3 * t + (k + 1) % 3];
      if (mates[t] >= 0 && hasEdge(triangles, mates[t], b, a)) continue;
      all[count++] = a;
      all[count++] = b;
    }
  return all.subarray(0, count);
}

/** @param {Uint32Array} triangles  @param {number} t  @param {number} a  @param {number} b */
function hasEdge(triangles, t, a, b) {
  const u = triangles[3 * t], v = triangles[3 * t + 1], w = triangles[3 * t + 2];
  return u === a && v === b || v === a && w === b || w === a && u === b;
}

/** A line from middle to middle of each pair. @param {Matching} layer */
function linksOf({ points, triangles, mates }) {
  const links = [];
  const middle = (/** @type {number} */ t, /** @type {number} */ axis) => {
    const corner = (/** @type {number} */ k) => points[2 * triangles[3 * t + k] + axis];
    return (corner(0) + corner(1) + corner(2)) / 3;
  };
  for (let t = 0; t < mates.length; ++t)
    if (mates[t] > t) links.push(middle(t, 0), middle(t, 1), middle(mates[t], 0), middle(mates[t], 1));
  return Float64Array.from(links);
}
