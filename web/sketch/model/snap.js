// Where a pointer is meant to be: on a vertex that is there, on a direction, on the grid.
/** @import { Drawing, Point } from '../../types' */
import { pathsOf } from './drawing.js';
import { distance } from './geometry.js';

/**
 * @typedef {object} Snapping
 * @property {boolean} vertices
 * @property {boolean} grid
 * @property {number} gridSize  0: what fits the view
 * @property {boolean} angles
 * @property {number} angleStep  degrees
 */

/**
 * @typedef {object} Snapped
 * @property {Point} at
 * @property {'' | 'vertex' | 'grid' | 'angle'} to
 * @property {{from: Point, degrees: number}[]} rays  the directions it lies on
 */

const reach = 9;  // pixels

/** A round step of at least twelve pixels: 1, 2 or 5 times a power of ten. @param {number} pixel */
export function fittingGrid(pixel) {
  const least = 12 * pixel, power = 10 ** Math.floor(Math.log10(least));
  return [1, 2, 5, 10].map((step) => step * power).find((step) => step >= least) ?? 10 * power;
}

/** @param {Snapping} snapping  @param {number} pixel */
export const gridSizeOf = ({ gridSize }, pixel) => gridSize > 0 ? gridSize : fittingGrid(pixel);

/** Rounded so that 3 steps of 0.1 are 0.3. @param {number} value  @param {number} step */
export function toGrid(value, step) {
  const digits = Math.max(0, Math.min(15, 2 - Math.floor(Math.log10(step))));
  return Number((Math.round(value / step) * step).toFixed(digits));
}

/** @param {Drawing} drawing  @param {Point} at  @param {number} within  @param {(place: {region: number, loop: number, vertex: number}) => boolean} [allowed] */
export function nearestVertex(drawing, at, within, allowed = () => true) {
  let best = null, least = within;
  for (const { region, loop, points } of pathsOf(drawing))
    for (let vertex = 0; vertex < points.length; ++vertex) {
      const away = distance(at, points[vertex]);
      if (away < least && allowed({ region, loop, vertex })) {
        least = away;
        best = { region, loop, vertex };
      }
    }
  return best;
}

/** @param {Point} at  @param {Point[]} anchors  @param {number} step  @param {number} within  @returns {Snapped | null} */
function onRays(at, anchors, step, within) {
  const rays = anchors.filter((from) => distance(from, at) > 0).map((from) => {
    const degrees = step * Math.round(Math.atan2(at[1] - from[1], at[0] - from[0]) * 180 / Math.PI / step);
    // Right angles exactly: the drawing is to be straight where it looks so.
    const [c, s] = degrees % 90 === 0 ? [[1, 0], [0, 1], [-1, 0], [0, -1]][(degrees / 90 + 4) % 4]
      : [Math.cos(degrees * Math.PI / 180), Math.sin(degrees * Math.PI / 180)];
    return { from, degrees, c, s };
  });
  /** @param {typeof rays[0]} ray  @returns {Point} */
  const onto = ({ from, c, s }) => {
    const t = (at[0] - from[0]) * c + (at[1] - from[1]) * s;
    return [from[0] + t * c, from[1] + t * s];
  };
  const nearest = rays.toSorted((p, q) => distance(at, onto(p)) - distance(at, onto(q)));
  if (nearest.length === 0) return null;
  const [one, two] = nearest;
  const turn = two ? one.c * two.s - one.s * two.c : 0;
  if (two && Math.abs(turn) > 1e-9) {
    const t = ((two.from[0] - one.from[0]) * two.s - (two.from[1] - one.from[1]) * two.c) / turn;
    /** @type {Point} */
    const both = [one.from[0] + t * one.c, one.from[1] + t * one.s];
    if (distance(both, at) < within) return { at: both, to: 'angle', rays: [one, two] };
  }
  return { at: onto(one), to: 'angle', rays: [one] };
}

/**
 * @param {Point} at  @param {number} pixel  its size in the world
 * @param {{drawing: Drawing, snapping: Snapping, anchors?: Point[], shift?: boolean,
 *   allowed?: (place: {region: number, loop: number, vertex: number}) => boolean, more?: Point[]}} how
 *   `anchors`: where directions start; `more`: further places to snap to
 * @returns {Snapped}
 */
export function snap(at, pixel, { drawing, snapping, anchors = [], shift = false, allowed, more = [] }) {
  if (snapping.vertices) {
    const own = more.find((p) => distance(p, at) < reach * pixel);
    const place = own ? null : nearestVertex(drawing, at, reach * pixel, allowed);
    const vertex = own ?? (place && pathsOf(drawing).find(({ region, loop }) => region === place.region && loop === place.loop)?.points[place.vertex]);
    if (vertex) return { at: vertex, to: 'vertex', rays: [] };
  }
  const turned = snapping.angles !== shift ? onRays(at, anchors, snapping.angleStep, 2 * reach * pixel) : null;
  if (turned) return turned;
  if (!snapping.grid) return { at, to: '', rays: [] };
  const step = gridSizeOf(snapping, pixel);
  return { at: [toGrid(at[0], step), toGrid(at[1], step)], to: 'grid', rays: [] };
}
