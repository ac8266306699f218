// Numbers for the graphics card, from the layers of a run: positions and colours, nothing of any
// drawing library. Pure.
/** @import { Palette, Ramp } from '../../types' */
/** @import { SurfaceSnapshot } from 'lpquad' */
import { highestDensity, relativeDensity } from '../../draw/layers/cells.js';
import { shadesOf, shadeCount } from '../../draw/palette.js';

const norm = 6;  // the p of the energy in charts

/** Three numbers of each of the vertices, one after the other.
 * @param {ArrayLike<number>} points  @param {ArrayLike<number>} vertices */
export function gather(points, vertices) {
  const out = new Float32Array(3 * vertices.length);
  for (let i = 0; i < vertices.length; ++i)
    for (let k = 0; k < 3; ++k) out[3 * i + k] = points[3 * vertices[i] + k];
  return out;
}

/** Two triangles for each quad, cut along the shorter diagonal.
 * @param {ArrayLike<number>} points  @param {ArrayLike<number>} quads */
export function trianglesOfQuads(points, quads) {
  const out = new Uint32Array(quads.length / 4 * 6);
  const apart = (/** @type {number} */ a, /** @type {number} */ b) =>
    Math.hypot(points[3 * a] - points[3 * b], points[3 * a + 1] - points[3 * b + 1], points[3 * a + 2] - points[3 * b + 2]);
  for (let q = 0, at = 0; q < quads.length; q += 4, at += 6) {
    const [a, b, c, d] = [quads[q], quads[q + 1], quads[q + 2], quads[q + 3]];
    out.set(apart(a, c) <= apart(b, d) ? [a, b, c, a, c, d] : [b, c, d, b, d, a], at);
  }
  return out;
}

/** Every edge of the quads once, as pairs of vertices. @param {ArrayLike<number>} quads */
export function edgesOfQuads(quads) {
  const seen = new Set(), out = [];
  for (let q = 0; q < quads.length; q += 4)
    for (let k = 0; k < 4; ++k) {
      const a = quads[q + k], b = quads[q + (k + 1) % 4];
      const key = Math.min(a, b) * 2 ** 26 + Math.max(a, b);
      if (seen.has(key)) continue;
      seen.add(key);
      out.push(a, b);
    }
  return Uint32Array.from(out);
}

/** '#rrggbb' or a ramp's 'rgb(…)' as three numbers from 0 to 1. @param {string} colour */
export function parts(colour) {
  if (colour.startsWith('#')) return [1, 3, 5].map((k) => parseInt(colour.slice(k, k + 2), 16) / 255);
  return (colour.match(/\d+/g) ?? []).slice(0, 3).map((x) => Number(x) / 255);
}

/** The same colour for all corners of one face. @param {number[][]} colours  by face  @param {number} corners */
export function perCorner(colours, corners) {
  const out = new Float32Array(3 * corners * colours.length);
  colours.forEach((colour, f) => {
    for (let k = 0; k < corners; ++k) out.set(colour, 3 * (corners * f + k));
  });
  return out;
}

/** Soft colours that tell neighbours apart: hues by the golden ratio. @param {number} i  @param {boolean} dark */
export function chartColour(i, dark) {
  const hue = (i * 0.618033988749895 + 0.58) % 1;
  const [s, l] = dark ? [0.38, 0.36] : [0.5, 0.8];
  const channel = (/** @type {number} */ n) => {
    const k = (n + hue * 12) % 12;
    return l - s * Math.min(l, 1 - l) * Math.max(-1, Math.min(k - 3, 9 - k, 1));
  };
  return [channel(0), channel(8), channel(4)];
}

/** @param {ArrayLike<number>} eta  @param {Ramp} ramp  @param {number} lowest  all below looks alike */
export function qualityColours(eta, ramp, lowest = 0.4) {
  const shades = shadesOf(ramp).css.map(parts);
  return Array.from(eta, (value) => {
    const t = Math.max(0, Math.min(1, (value - lowest) / (1 - lowest)));
    return shades[Math.round(t * (shadeCount - 1))];
  });
}

/** @typedef {NonNullable<SurfaceSnapshot['cells']>} Cells */

/** The colour of each piece of a cell, by its energy. @param {Cells} cells  @param {Ramp} ramp  @returns {string[]} CSS */
export function cellColours(cells, ramp) {
  const shades = shadesOf(ramp).css;
  const relative = relativeDensity(/** @type {any} */ ({ ...cells, points: cells.uv }), undefined, norm);
  return Array.from(cells.sites, (site) => {
    const t = Math.log(Math.max(1, relative[site])) / Math.log(highestDensity);
    return shades[Math.round(Math.min(1, t) * (shadeCount - 1))];
  });
}

/** Triangles of the pieces, from the first corner of each, and their borders. @param {Cells} cells */
export function meshOfCells({ offsets }) {
  /** @type {number[]} */
  const triangles = [], pieces = [], edges = [];
  for (let i = 0; i + 1 < offsets.length; ++i)
    for (let k = offsets[i]; k < offsets[i + 1]; ++k) {
      edges.push(k, k + 1 < offsets[i + 1] ? k + 1 : offsets[i]);
      if (k < offsets[i] + 2) continue;
      triangles.push(offsets[i], k - 1, k);
      pieces.push(i);
    }
  return { triangles, pieces, edges };
}

/** Little crosses at the middles of triangles, both arms tangent; thinned out evenly to `most`.
 * @param {import('lpquad').Surface} surface  @param {ArrayLike<number>} axes  @param {number} reach
 * @param {number} [most] */
export function crossLines({ points, triangles }, axes, reach, most = 6000) {
  const count = triangles.length / 3, step = Math.max(1, Math.ceil(count / most));
  const out = [];
  for (let t = 0; t < count; t += step) {
    const corner = [0, 1, 2].map((k) => triangles[3 * t + k]);
    const at = (/** @type {number} */ i) => [0, 1, 2].map((k) => points[3 * corner[i] + k]);
    const [a, b, c] = [at(0), at(1), at(2)];
    const normal = unit(cross(minus(b, a), minus(c, a)));
    const middle = [0, 1, 2].map((k) => (a[k] + b[k] + c[k]) / 3 + 0.02 * reach * normal[k]);
    const axis = [axes[3 * t], axes[3 * t + 1], axes[3 * t + 2]];
    for (const arm of [axis, cross(normal, axis)])
      for (const sign of [-1, 1]) for (let k = 0; k < 3; ++k) out.push(middle[k] + sign * reach * arm[k]);
  }
  return Float32Array.from(out);
}

const minus = (/** @type {number[]} */ a, /** @type {number[]} */ b) => a.map((x, k) => x - b[k]);
const cross = (/** @type {number[]} */ [a, b, c], /** @type {number[]} */ [x, y, z]) => [b * z - c * y, c * x - a * z, a * y - b * x];
const unit = (/** @type {number[]} */ v) => { const l = Math.hypot(...v) || 1; return v.map((x) => x / l); };

/** Vertices that have fewer or more quads than four, by how many. Those on features and borders are left out.
 * @param {NonNullable<SurfaceSnapshot['quads']>} quads  @returns {Map<number, number[]>} by excess, -2 to 2 */
export function irregularVertices({ valence, edges }) {
  const onLine = new Set(edges);
  /** @type {Map<number, number[]>} */
  const found = new Map();
  for (let v = 0; v < valence.length; ++v) {
    if (valence[v] === 4 || valence[v] === 0 || onLine.has(v)) continue;
    const excess = Math.max(-2, Math.min(2, valence[v] - 4));
    found.set(excess, [...found.get(excess) ?? [], v]);
  }
  return found;
}

/** How many vertices on features, not on borders, have other than four quads: corners belong there, and are not marked.
 * @param {NonNullable<SurfaceSnapshot['quads']>} quads */
export function irregularOnFeatures({ quads, triangles, valence, edges }) {
  const onBorder = new Set(borderEdges([[quads, 4], [triangles, 3]]).flat());
  let count = 0;
  for (const v of new Set(edges)) if (valence[v] !== 4 && valence[v] !== 0 && !onBorder.has(v)) ++count;
  return count;
}

/** The edges of one face only. @param {[ArrayLike<number>, number][]} faces  with so many corners each */
function borderEdges(faces) {
  /** @type {Map<number, [number, number]>} */
  const once = new Map();
  for (const [corners, count] of faces)
    for (let i = 0; i < corners.length; ++i) {
      const [a, b] = [corners[i], corners[i % count === count - 1 ? i + 1 - count : i + 1]];
      const edge = Math.min(a, b) * 2 ** 26 + Math.max(a, b);
      if (!once.delete(edge)) once.set(edge, [a, b]);
    }
  return [...once.values()];
}
