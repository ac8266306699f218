// The outlines of the presets.
/** @import { Point } from '../../types' */
import { sampled } from '../model/shapes.js';

/** @returns {Point} */
const polar = (/** @type {number} */ radius, /** @type {number} */ angle) => [radius * Math.cos(angle), radius * Math.sin(angle)];

/** Four corners a tooth. @param {number} teeth  @returns {Point[]} */
export function gear(teeth) {
  const turn = 2 * Math.PI / teeth;
  return Array.from({ length: teeth }, (_, i) =>
    [[0.56, 0], [0.56, 0.42], [0.7, 0.5], [0.7, 0.92]].map(([radius, at]) => polar(radius, turn * (i + at)))).flat();
}

/** @param {number} tips  @returns {Point[]} */
export const star = (tips) =>
  Array.from({ length: 2 * tips }, (_, i) => polar(i % 2 === 0 ? 0.75 : 0.36, Math.PI * (i / tips + 0.5)));

/** A car's hood from above: wider at the windscreen, all sides bulging. @returns {Point[]} */
export function hood() {
  /** @type {Point[]} */
  const corners = [[-0.8, -0.55], [0.8, -0.55], [0.62, 0.45], [-0.62, 0.45]];
  /** @type {Point[]} */
  const bulges = [[0, 0.1], [0.06, 0], [0, 0.16], [-0.06, 0]];
  return corners.flatMap(([ax, ay], side) => {
    const [bx, by] = corners[(side + 1) % 4], [cx, cy] = bulges[side];
    const count = side % 2 === 0 ? 24 : 14;
    return Array.from({ length: count }, (_, i) => {
      const u = i / count, out = 4 * u * (1 - u);
      return /** @type {Point} */ ([ax + u * (bx - ax) + out * cx, ay + u * (by - ay) + out * cy]);
    });
  });
}

/** Half thickness at x of a NACA four-digit section whose trailing edge is closed [Jacobs et al. 1933]. */
const halfThickness = (/** @type {number} */ x, /** @type {number} */ thickness) =>
  5 * thickness * (0.2969 * Math.sqrt(x) - 0.126 * x - 0.3516 * x * x + 0.2843 * x ** 3 - 0.1036 * x ** 4);

/** From the trailing edge over the top. @param {string} digits  '2412'  @param {number} count  points a side  @returns {Point[]} */
export function airfoil(digits, count) {
  const camber = Number(digits[0]) / 100, place = Number(digits[1]) / 10, thickness = Number(digits.slice(2)) / 100;
  /** @returns {Point} */
  const at = (/** @type {number} */ x, /** @type {number} */ side) => {
    const front = x < place;
    const share = camber / (front ? place * place : (1 - place) ** 2);
    const y = camber === 0 ? 0 : share * ((front ? 0 : 1 - 2 * place) + 2 * place * x - x * x);
    const slope = Math.atan(camber === 0 ? 0 : 2 * share * (place - x));
    const t = side * halfThickness(x, thickness);
    return [x - t * Math.sin(slope), y + t * Math.cos(slope)];
  };
  const steps = Array.from({ length: count + 1 }, (_, i) => (1 - Math.cos(Math.PI * i / count)) / 2);
  return [...steps.toReversed().slice(0, -1).map((x) => at(x, 1)), ...steps.slice(0, -1).map((x) => at(x, -1))];
}

/** The letter a: a bowl and a stem. @returns {{outline: Point[], counter: Point[]}} */
export function letter() {
  const bowl = Array.from({ length: 24 }, (_, i) => polarOval(0.42, 0.5, 0.42, 0.5, 2 * Math.PI * (0.16 + 0.68 * i / 23)));
  return {
    outline: [...bowl, [0.66, 0.08], [0.66, 0], [0.9, 0], [0.9, 1], [0.66, 1], [0.66, 0.9]],
    counter: sampled((t) => polarOval(0.43, 0.5, 0.2, 0.29, 2 * Math.PI * t), 24),
  };
}

/** @returns {Point} */
const polarOval = (/** @type {number} */ x, /** @type {number} */ y, /** @type {number} */ width, /** @type {number} */ height, /** @type {number} */ angle) =>
  [x + width * Math.cos(angle), y + height * Math.sin(angle)];
