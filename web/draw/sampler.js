// Values at any point, from those at the corners of the background triangles.
/** @import { Snapshot } from '../types' */
import { rowsOf } from './bulk.js';
import { Grid } from './grid.js';
import { once } from './once.js';

/** @typedef {NonNullable<Snapshot['sizes']>} Sizes */

/**
 * The corners of the triangle at a point and their weights; null outside.
 * @param {Sizes} layer  @returns {(x: number, y: number) => {corners: number[], weights: number[]} | null}
 */
export function weightsAt({ points, triangles }) {
  const grid = once(triangles, 'grid', () => new Grid(rowsOf(points, triangles, 3)));
  return (x, y) => {
    const t = grid.at(x, y);
    if (t < 0) return null;
    const [a, b, c] = [triangles[3 * t], triangles[3 * t + 1], triangles[3 * t + 2]];
    const ux = points[2 * b] - points[2 * a], uy = points[2 * b + 1] - points[2 * a + 1];
    const vx = points[2 * c] - points[2 * a], vy = points[2 * c + 1] - points[2 * a + 1];
    const wx = x - points[2 * a], wy = y - points[2 * a + 1];
    const area = ux * vy - uy * vx, s = (wx * vy - wy * vx) / area, r = (ux * wy - uy * wx) / area;
    return { corners: [a, b, c], weights: [1 - s - r, s, r] };
  };
}

/** The target size; undefined outside. @param {Sizes} layer  @returns {(x: number, y: number) => number | undefined} */
export function sizesAt(layer) {
  const { sizes } = layer, { low, high } = once(layer, 'range', () => rangeOf(sizes));
  if (high <= low * (1 + 1e-9)) return () => low;
  const weights = weightsAt(layer);
  return (x, y) => {
    const at = weights(x, y);
    return at?.corners.reduce((sum, v, k) => sum + at.weights[k] * sizes[v], 0);
  };
}

/** @param {ArrayLike<number>} values */
export function rangeOf(values) {
  let low = Infinity, high = -Infinity;
  for (let i = 0; i < values.length; ++i) {
    if (values[i] < low) low = values[i];
    if (values[i] > high) high = values[i];
  }
  return { low, high };
}

/**
 * The direction of a cross (one arm, unit length): crosses turn by quarters, so four times the angle
 * is what has a mean. null outside and where the field has no direction.
 * @param {ArrayLike<number>} axes  @param {{corners: number[], weights: number[]}} at
 * @returns {[number, number] | null}
 */
export function axisAt(axes, { corners, weights }) {
  let re = 0, im = 0;
  corners.forEach((v, k) => {
    const angle = 4 * Math.atan2(axes[2 * v + 1], axes[2 * v]);
    re += weights[k] * Math.cos(angle);
    im += weights[k] * Math.sin(angle);
  });
  if (Math.hypot(re, im) < 0.05) return null;
  const angle = Math.atan2(im, re) / 4;
  return [Math.cos(angle), Math.sin(angle)];
}
