// From the many shaky points of a hand to the few of a drawing.
/** @import { Point } from '../../types' */
import { distance, nearestOnSegment } from './geometry.js';

/** Points in steps of about `step` along a path. @param {Point[]} path  @param {number} step  @returns {Point[]} */
function evenly(path, step) {
  const result = [path[0]];
  let left = step;
  for (let i = 1; i < path.length; ++i) {
    let from = path[i - 1], length = distance(from, path[i]);
    while (length >= left && left > 0) {
      const t = left / length;
      from = [from[0] + t * (path[i][0] - from[0]), from[1] + t * (path[i][1] - from[1])];
      result.push(from);
      length -= left;
      left = step;
    }
    left -= length;
  }
  return result;
}

/** Weighted means of neighbours; the ends of an open path stay. @param {Point[]} path  @param {boolean} closed  @param {number} times  @returns {Point[]} */
function blurred(path, closed, times) {
  let result = path;
  for (let round = 0; round < times; ++round) {
    const old = result, n = old.length;
    result = old.map((p, i) => {
      if (!closed && (i === 0 || i === n - 1)) return p;
      const a = old[(i + n - 1) % n], b = old[(i + 1) % n];
      return [(a[0] + 2 * p[0] + b[0]) / 4, (a[1] + 2 * p[1] + b[1]) / 4];
    });
  }
  return result;
}

/** Keeps as few points as needed to stay within `tolerance` [Ramer 1972; Douglas & Peucker 1973]. @param {Point[]} path  @param {number} tolerance  @returns {Point[]} */
export function simplified(path, tolerance) {
  if (path.length < 3) return path;
  const keep = new Uint8Array(path.length);
  keep[0] = keep[path.length - 1] = 1;
  const open = [[0, path.length - 1]];
  for (let span = open.pop(); span; span = open.pop()) {
    const [from, to] = span;
    let worst = tolerance, at = -1;
    for (let i = from + 1; i < to; ++i) {
      const away = distance(path[i], nearestOnSegment(path[i], path[from], path[to]));
      if (away > worst) [worst, at] = [away, i];
    }
    if (at < 0) continue;
    keep[at] = 1;
    open.push([from, at], [at, to]);
  }
  return path.filter((_, i) => keep[i]);
}

/** A loop from its first point to the farthest and back. @param {Point[]} loop  @param {number} tolerance  @returns {Point[]} */
export function simplifiedLoop(loop, tolerance) {
  const away = loop.map((p) => distance(loop[0], p));
  const far = away.indexOf(Math.max(...away));
  return [...simplified(loop.slice(0, far + 1), tolerance).slice(0, -1), ...simplified([...loop.slice(far), loop[0]], tolerance).slice(0, -1)];
}

/**
 * A stroke of the hand, smoothed and with a sensible number of points.
 * @param {Point[]} stroke  @param {boolean} closed  @param {number} pixel  its size in the world  @returns {Point[]}
 */
export function tidied(stroke, closed, pixel) {
  if (stroke.length < 2) return stroke;
  const even = blurred(evenly(closed ? [...stroke, stroke[0]] : stroke, 3 * pixel), closed, 4);
  if (!closed) return simplified([...even, stroke[stroke.length - 1]], pixel);
  if (even.length > 3 && distance(even[0], even[even.length - 1]) < pixel) even.pop();
  return even.length < 3 ? even : simplifiedLoop(even, pixel);
}
