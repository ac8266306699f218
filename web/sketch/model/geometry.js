// Plane geometry of points [x, y] that tools and fixes share.
/** @import { Point } from '../../types' */

/** @param {Point} p  @param {Point} q */
export const distance = (p, q) => Math.hypot(q[0] - p[0], q[1] - p[1]);

/** @param {Point} p  @param {Point} q  @returns {Point} */
export const midpoint = (p, q) => [(p[0] + q[0]) / 2, (p[1] + q[1]) / 2];

/** @param {Point} p  @param {Point} q */
export const samePlace = (p, q) => p[0] === q[0] && p[1] === q[1];

/** The place of a segment nearest to p. @param {Point} p  @param {Point} a  @param {Point} b  @returns {Point} */
export function nearestOnSegment(p, a, b) {
  const dx = b[0] - a[0], dy = b[1] - a[1];
  const t = ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / (dx * dx + dy * dy || 1);
  return t <= 0 ? a : t >= 1 ? b : [a[0] + t * dx, a[1] + t * dy];
}

/** Positive if counter-clockwise. @param {Point[]} loop */
export function signedArea(loop) {
  let twice = 0;
  const [ox, oy] = loop[0] ?? [0, 0];
  for (let i = 1; i + 1 < loop.length; ++i)
    twice += (loop[i][0] - ox) * (loop[i + 1][1] - oy) - (loop[i][1] - oy) * (loop[i + 1][0] - ox);
  return twice / 2;
}

/** Whether the loop winds about p: even-odd count along a ray. @param {Point[]} loop  @param {Point} p */
export function encloses(loop, [x, y]) {
  let inside = false;
  for (let i = 0, k = loop.length - 1; i < loop.length; k = i++) {
    const [ax, ay] = loop[k], [bx, by] = loop[i];
    if ((ay > y) !== (by > y) && x < ax + (y - ay) / (by - ay) * (bx - ax)) inside = !inside;
  }
  return inside;
}

/** How many vertices of `inner` the loop encloses, as a share. @param {Point[]} loop  @param {Point[]} inner */
export const shareInside = (loop, inner) => inner.filter((p) => encloses(loop, p)).length / Math.max(1, inner.length);

/** @param {Point[]} points  @param {boolean} [closed] */
export function edgeLengths(points, closed = true) {
  const count = points.length - (closed ? 0 : 1);
  return Array.from({ length: Math.max(0, count) }, (_, i) => distance(points[i], points[(i + 1) % points.length]));
}

/** @param {number[]} values */
export function median(values) {
  const sorted = values.toSorted((a, b) => a - b);
  return sorted[sorted.length >> 1] ?? 0;
}

/** Of the vertices; 0 for none. @param {Point[]} points  @returns {Point} */
export function centreOf(points) {
  const [left, bottom, right, top] = boxOf(points);
  return points.length === 0 ? [0, 0] : [(left + right) / 2, (bottom + top) / 2];
}

/** @param {Iterable<Point>} points  @returns {[left: number, bottom: number, right: number, top: number]} */
export function boxOf(points) {
  /** @type {[number, number, number, number]} */
  const box = [Infinity, Infinity, -Infinity, -Infinity];
  for (const [x, y] of points) {
    box[0] = Math.min(box[0], x);
    box[1] = Math.min(box[1], y);
    box[2] = Math.max(box[2], x);
    box[3] = Math.max(box[3], y);
  }
  return box;
}
