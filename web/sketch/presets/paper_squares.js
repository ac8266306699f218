// The four starts of the paper's Fig. 12: the inner points of a grid of 11 × 11, each moved by up to
// so many cells. The generator is the core's (SplitMix64), so that the points are those of the tests.
/** @import { Point } from '../../types' */

const whole = (1n << 64n) - 1n, golden = 0x9E3779B97F4A7C15n;

/** Numbers in [0, 1). @param {number} seed */
export function splitMix64(seed) {
  let state = BigInt(seed) * golden & whole;
  return () => {
    state = state + golden & whole;
    let z = (state ^ state >> 30n) * 0xBF58476D1CE4E5B9n & whole;
    z = (z ^ z >> 27n) * 0x94D049BB133111EBn & whole;
    return Number((z ^ z >> 31n) >> 11n) * 2 ** -53;
  };
}

/** @param {number} n  points a side  @param {number} jitter  in cells  @param {number} seed  @returns {Point[]} */
export function jitteredGrid(n, jitter, seed) {
  const unit = splitMix64(seed), step = 1 / (n - 1);
  const near = (/** @type {number} */ i) => step * Math.min(n - 1.3, Math.max(0.3, i + (-jitter + 2 * jitter * unit())));
  /** @type {Point[]} */
  const points = [];
  for (let j = 1; j + 1 < n; ++j)
    for (let i = 1; i + 1 < n; ++i) points.push([near(i), near(j)]);
  return points;
}
