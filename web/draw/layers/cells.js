/** @import { Pen, Scene, Snapshot, View } from '../../types' */
import { fillRows, lineWidth, strokeEdges } from '../bulk.js';
import { once } from '../once.js';
import { shadeCount, shadesOf } from '../palette.js';
import { sizesAt } from '../sampler.js';
import { edgesOfRows, typicalLength, welded } from '../topology.js';

/** @typedef {NonNullable<Snapshot['cells']>} Cells */

/** @param {Pick<Cells, 'points' | 'offsets'>} cells */
export const rowsOfCells = ({ points, offsets }) => ({ points, vertices: null, offsets });

/** Clipped Voronoi cells. @param {Pen} pen  @param {Scene} scene  @param {View} view */
export function* drawCells(pen, { frame, palette }, view) {
  const cells = frame?.cells;
  if (!cells) return;
  const same = once(cells, 'same points', () => welded(cells.points));
  yield;
  const edges = once(cells, 'edges', () => edgesOfRows(same, cells.offsets, cells.points.length / 2));
  yield;
  pen.strokeStyle = palette.faint;
  pen.lineWidth = lineWidth(once(cells, 'length', () => typicalLength(cells.points, edges)) * view.scale);
  yield* strokeEdges(pen, cells.points, edges, view);
}

/** A perfect square has the density 1; this much is at the end of the ramp, whatever the picture. */
export const highestDensity = 4;

/** Energy per area of each cell: paper Fig. 22. @param {Pen} pen  @param {Scene} scene  @param {View} view */
export function* drawDensity(pen, { frame, palette, norm }, view) {
  const cells = frame?.cells;
  if (!cells) return;
  const relative = relativeDensity(cells, frame.sizes, norm);
  yield;
  const perOctave = (shadeCount - 1) / Math.log2(highestDensity);
  const shade = (/** @type {number} */ piece) =>
    Math.round(Math.max(0, Math.min(shadeCount - 1, perOctave * Math.log2(Math.max(1, relative[cells.sites[piece]])))));
  yield* fillRows(pen, rowsOfCells(cells), shade, shadesOf(palette.ramps.density), view);
}

/**
 * Energy per area of each cell over that of a square of the target size h, 2 / (2^p (p + 1) h²):
 * without unit, and comparable where sizes differ.
 * @param {Cells} cells  @param {Snapshot['sizes']} sizes  @param {number} p
 */
export const relativeDensity = (cells, sizes, p) => once(cells, `relative ${p}`, () => relativeTo(cells, sizes, p));

/** @param {Cells} cells  @param {Snapshot['sizes']} sizes  @param {number} p */
function relativeTo({ points, density, offsets, sites }, sizes, p) {
  const perfect = 2 / (2 ** p * (p + 1));
  const relative = new Float64Array(density.length);
  const at = sizes?.sizes.length ? sizesAt(sizes) : undefined, usual = at ? 0 : usualArea({ points, offsets });
  for (let i = 0; i < sites.length; ++i) {
    const h = at?.(...middleOf(points, offsets[i], offsets[i + 1]));
    relative[sites[i]] = density[sites[i]] * (h === undefined ? usual : h * h) / perfect;
  }
  return relative;
}

/** @param {ArrayLike<number>} points  @param {number} from  @param {number} to @returns {[number, number]} */
export function middleOf(points, from, to) {
  let x = 0, y = 0;
  for (let i = from; i < to; ++i) {
    x += points[2 * i];
    y += points[2 * i + 1];
  }
  return [x / (to - from), y / (to - from)];
}

/** Median area of the cells. @param {Pick<Cells, 'points' | 'offsets'>} cells */
function usualArea({ points, offsets }) {
  const areas = new Float64Array(offsets.length - 1).map((_, i) => areaOf(points, offsets[i], offsets[i + 1])).sort();
  return areas[areas.length >> 1] ?? 1;
}

/** @param {ArrayLike<number>} points  @param {number} from  @param {number} to */
export function areaOf(points, from, to) {
  let twice = 0;
  for (let i = from; i < to; ++i) {
    const a = 2 * i, b = 2 * (i + 1 < to ? i + 1 : from);
    twice += points[a] * points[b + 1] - points[b] * points[a + 1];
  }
  return twice / 2;
}
