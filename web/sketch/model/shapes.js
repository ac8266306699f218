// Outlines by formula, and back: the circle or rectangle that a loop is.
/** @import { Point } from '../../types' */
import { boxOf, distance } from './geometry.js';

/** @returns {Point[]} counter-clockwise from the right */
export function circle(/** @type {number} */ x, /** @type {number} */ y, /** @type {number} */ radius, /** @type {number} */ count, start = 0) {
  return Array.from({ length: count }, (_, i) => {
    const angle = start + 2 * Math.PI * i / count;
    return [x + radius * Math.cos(angle), y + radius * Math.sin(angle)];
  });
}

/** @returns {Point[]} */
export const rectangle = (/** @type {number} */ left, /** @type {number} */ bottom, /** @type {number} */ right, /** @type {number} */ top) =>
  [[left, bottom], [right, bottom], [right, top], [left, top]];

/** @typedef {{x: number, y: number, radius: number, count: number, start: number}} Circle */

/** The regular polygon that a loop is, if it is one of eight corners or more. @param {Point[]} loop  @returns {Circle | null} */
export function circleOf(loop) {
  if (loop.length < 8) return null;
  const x = loop.reduce((sum, p) => sum + p[0], 0) / loop.length, y = loop.reduce((sum, p) => sum + p[1], 0) / loop.length;
  const radius = distance([x, y], loop[0]), side = 2 * radius * Math.sin(Math.PI / loop.length);
  const fits = loop.every((p, i) => Math.abs(distance([x, y], p) - radius) < 1e-6 * radius
    && Math.abs(distance(p, loop[(i + 1) % loop.length]) - side) < 1e-6 * radius);
  return fits ? { x, y, radius, count: loop.length, start: Math.atan2(loop[0][1] - y, loop[0][0] - x) } : null;
}

/** The sides of a loop that is an upright rectangle of four corners. @param {Point[]} loop */
export function rectangleOf(loop) {
  if (loop.length !== 4) return null;
  const [left, bottom, right, top] = boxOf(loop);
  const corners = rectangle(left, bottom, right, top);
  const upright = corners.every(([x, y]) => loop.some((p) => p[0] === x && p[1] === y)) && left < right && bottom < top;
  return upright ? { left, bottom, width: right - left, height: top - bottom } : null;
}

/** A closed curve of t in [0, 1), in steps of equal length. @param {(t: number) => Point} curve  @param {number} count  @returns {Point[]} */
export function sampled(curve, count) {
  const fine = 4096;
  const points = Array.from({ length: fine + 1 }, (_, i) => curve(i % fine / fine));
  const along = [0];
  for (let i = 1; i <= fine; ++i) along.push(along[i - 1] + distance(points[i - 1], points[i]));
  let k = 0;
  return Array.from({ length: count }, (_, i) => {
    const s = along[fine] * i / count;
    while (along[k + 1] < s) ++k;
    const t = (s - along[k]) / (along[k + 1] - along[k]);
    return [points[k][0] + t * (points[k + 1][0] - points[k][0]), points[k][1] + t * (points[k + 1][1] - points[k][1])];
  });
}
