// The borders of one chart, in space and in its plane: where it ends, and where it is cut open. Pure.
/** @import { SurfaceSnapshot } from 'lpquad' */
import { once } from '../../draw/once.js';

/** @typedef {NonNullable<SurfaceSnapshot['charts']>} Charts */

/** The sides of triangles that have no other triangle of the chart beside them in its plane.
 * @param {Charts} charts  @param {ArrayLike<number>} triangles  of the surface  @param {number} chart
 * @returns {number[]} 3 t + k for the side from corner k of triangle t on */
export const bordersOf = (charts, triangles, chart) =>
  once(charts, `borders ${chart}`, () => findBorders(charts, triangles, chart));

/** @param {Charts} charts  @param {ArrayLike<number>} triangles  @param {number} chart */
function findBorders({ charts, uv }, triangles, chart) {
  /** @type {Map<number, number[]>} */
  const open = new Map();  // by the ends of the edge
  for (let t = 0; t < charts.length; ++t) {
    if (charts[t] !== chart) continue;
    for (let i = 3 * t; i < 3 * t + 3; ++i) {
      const [a, b] = [triangles[i], triangles[nextCorner(i)]], edge = Math.min(a, b) * 2 ** 26 + Math.max(a, b);
      const others = open.get(edge) ?? [];
      const beside = others.findIndex((j) => samePlace(uv, i, nextCorner(j)) && samePlace(uv, nextCorner(i), j));
      if (beside < 0) open.set(edge, [...others, i]);
      else others.splice(beside, 1);
    }
  }
  return [...open.values()].flat();
}

/** The corner after the i-th of all, in the same triangle. @param {number} i */
export const nextCorner = (i) => (i % 3 === 2 ? i - 2 : i + 1);

/** @param {ArrayLike<number>} uv  @param {number} i  @param {number} j */
const samePlace = (uv, i, j) => uv[2 * i] === uv[2 * j] && uv[2 * i + 1] === uv[2 * j + 1];
