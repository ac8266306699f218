// Lines and polygons by the thousand, in portions: one stroke of everything takes seconds.
/** @import { Pen, View } from '../types' */
import { once } from './once.js';
import { packedOf } from './palette.js';
import { strides } from './topology.js';

/** @typedef {import('./grid.js').Rows} Rows */
/** @typedef {(x0: number, y0: number, x1: number, y1: number) => void} Line */

const linesPerStroke = 50;    // measured best
const linesPerRest = 4000;    // a few milliseconds
const polygonsPerRest = 2000;

/** Lines stay apart where the mesh is fine. @param {number} pixels  length of an edge */
export const lineWidth = (pixels) => Math.max(0.3, Math.min(1, pixels / 9));

/**
 * @param {Pen} pen  with strokeStyle '#rrggbb' and lineWidth  @param {ArrayLike<number>} points
 * @param {ArrayLike<number>} edges  @param {View} view
 */
export function* strokeEdges(pen, points, edges, { scale, left, top, width, height }) {
  const stroke = pen.strokeLine ? inBulk(pen) : inPaths(pen);
  for (let i = 0; i < edges.length; i += 2) {
    const a = 2 * edges[i], b = 2 * edges[i + 1];
    const x0 = (points[a] - left) * scale, y0 = (top - points[a + 1]) * scale;
    const x1 = (points[b] - left) * scale, y1 = (top - points[b + 1]) * scale;
    const outside = x0 < 0 && x1 < 0 || y0 < 0 && y1 < 0 || x0 > width && x1 > width || y0 > height && y1 > height;
    if (!outside) stroke.line(x0, y0, x1, y1);
    if (i % (2 * linesPerRest) === 0) yield;
  }
  stroke.end();
}

/** Points in pairs: x0, y0, x1, y1, … @param {Pen} pen  @param {ArrayLike<number>} ends  @param {View} view */
export function strokeLines(pen, ends, view) {
  return strokeEdges(pen, ends, counting(ends.length / 2), view);
}

/** 0, 1, 2, … @param {number} count */
function counting(count) {
  if (count > numbers.length) numbers = strides(2 * count, 1);
  return numbers.subarray(0, count);
}
let numbers = strides(1000, 1);

/** @param {Pen} pen */
function inBulk(pen) {
  const rgba = packedOf(String(pen.strokeStyle)), width = pen.lineWidth;
  return {
    line: /** @type {Line} */ ((x0, y0, x1, y1) => pen.strokeLine?.(x0, y0, x1, y1, width, rgba)),
    end: () => {},
  };
}

/** @param {Pen} pen */
function inPaths(pen) {
  let open = 0;
  const end = () => { if (open > 0) pen.stroke(); open = 0; };
  return {
    line: /** @type {Line} */ ((x0, y0, x1, y1) => {
      if (open++ === 0) pen.beginPath();
      pen.moveTo(x0, y0);
      pen.lineTo(x1, y1);
      if (open === linesPerStroke) end();
    }),
    end,
  };
}

/** Where the corners of one polygon are put, in pixels. */
let corners = new Float64Array(64);

/**
 * Polygons, each in one of the shades; what is out of sight is left out.
 * @param {Pen} pen  @param {Rows} rows
 * @param {(polygon: number) => number} shade  number of a shade; below 0: none
 * @param {{css: ArrayLike<string>, rgba: ArrayLike<number>}} shades  @param {View} view
 */
export function* fillRows(pen, { points, vertices, offsets }, shade, shades, { scale, left, top, width, height }) {
  for (let f = 0; f + 1 < offsets.length; ++f) {
    if (f % polygonsPerRest === 0) yield;
    const from = offsets[f], count = offsets[f + 1] - from;
    if (2 * count > corners.length) corners = new Float64Array(4 * count);
    let low = Infinity, high = -Infinity, bottom = Infinity, above = -Infinity;
    for (let k = 0; k < count; ++k) {
      const v = 2 * (vertices ? vertices[from + k] : from + k);
      const x = (points[v] - left) * scale, y = (top - points[v + 1]) * scale;
      corners[2 * k] = x;
      corners[2 * k + 1] = y;
      if (x < low) low = x;
      if (x > high) high = x;
      if (y < bottom) bottom = y;
      if (y > above) above = y;
    }
    if (high < 0 || above < 0 || low > width || bottom > height) continue;
    const at = shade(f);
    if (at >= 0) fillCorners(pen, count, shades.css[at], shades.rgba[at]);
  }
}

/** @param {Pen} pen  @param {number} count  @param {string} css  @param {number} rgba */
function fillCorners(pen, count, css, rgba) {
  if (pen.fillPolygon) return pen.fillPolygon(corners, count, rgba);
  pen.fillStyle = css;
  pen.beginPath();
  for (let k = 0; k < count; ++k) pen[k === 0 ? 'moveTo' : 'lineTo'](corners[2 * k], corners[2 * k + 1]);
  pen.closePath();
  pen.fill();
}

/**
 * Rows of faces with so many corners each.
 * @param {ArrayLike<number>} points  @param {Uint32Array} faces  @param {number} corners
 */
export function rowsOf(points, faces, corners) {
  const offsets = once(faces, `offsets ${corners}`, () => strides(faces.length / corners, corners));
  return { points, vertices: faces, offsets };
}
