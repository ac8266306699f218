// Target sizes under a brush: samples on a lattice, close enough that the mesh keeps to them.
/** @import { Point, Project } from '../../types' */

/** @typedef {Project['sizes']} Sizes */

/** Between samples sizes may grow by 0.3 of the distance, so these are near enough. */
const stepOf = (/** @type {number} */ radius, /** @type {number} */ size) => Math.max(radius / 4, Math.min(radius, 1.5 * size));

/** @param {Sizes} sizes  @param {Point} at  @param {number} radius  @returns {Sizes} */
export function erased(sizes, [x, y], radius) {
  const left = sizes.filter(([sx, sy]) => Math.hypot(sx - x, sy - y) > radius);
  return left.length === sizes.length ? sizes : left;
}

/** @param {Sizes} sizes  @param {Point} at  @param {number} radius  @param {number} size  @returns {Sizes} */
export function painted(sizes, at, radius, size) {
  const [x, y] = at, step = stepOf(radius, size);
  /** @type {Sizes} */
  const added = [];
  for (let j = Math.ceil((y - radius) / step); j * step <= y + radius; ++j)
    for (let i = Math.ceil((x - radius) / step); i * step <= x + radius; ++i)
      if (Math.hypot(i * step - x, j * step - y) <= radius) added.push([i * step, j * step, size]);
  if (added.length === 0) added.push([x, y, size]);
  const keyOf = (/** @type {Sizes[0]} */ [a, b, c]) => `${a} ${b} ${c}`;
  const known = new Set(sizes.map(keyOf));
  const fresh = added.filter((sample) => !known.has(keyOf(sample)));
  const kept = sizes.filter(([sx, sy, h]) => h === size || Math.hypot(sx - x, sy - y) > radius);
  return fresh.length === 0 && kept.length === sizes.length ? sizes : [...kept, ...fresh];
}
