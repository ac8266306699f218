// Lines of a mesh, each once, in strokes of a size that software rasterisers like.
/** @import { Pen, View } from '../types' */

const linesPerStroke = 50;  // one stroke of everything takes seconds; measured best

/** Unique edges [a, b, …] of faces with `corners` corners each. @param {Uint32Array} faces */
export function edgesOf(faces, /** @type {number} */ corners) {
  const edges = [];
  const seen = new Set();
  for (let f = 0; f < faces.length; f += corners)
    for (let k = 0; k < corners; ++k) {
      const a = /** @type {number} */ (faces[f + k]);
      const b = /** @type {number} */ (faces[f + (k + 1) % corners]);
      const key = a < b ? a * 4194304 + b : b * 4194304 + a;
      if (seen.has(key)) continue;
      seen.add(key);
      edges.push(a, b);
    }
  return Uint32Array.from(edges);
}

/** @param {Pen} pen  @param {ArrayLike<number>} points  @param {ArrayLike<number>} edges  @param {View} view */
export function strokeEdges(pen, points, edges, { scale, left, top }) {
  for (let from = 0; from < edges.length; from += 2 * linesPerStroke) {
    const to = Math.min(edges.length, from + 2 * linesPerStroke);
    pen.beginPath();
    for (let i = from; i < to; i += 2) {
      const a = 2 * /** @type {number} */ (edges[i]), b = 2 * /** @type {number} */ (edges[i + 1]);
      pen.moveTo((/** @type {number} */ (points[a]) - left) * scale, (top - /** @type {number} */ (points[a + 1])) * scale);
      pen.lineTo((/** @type {number} */ (points[b]) - left) * scale, (top - /** @type {number} */ (points[b + 1])) * scale);
    }
    pen.stroke();
  }
}
