// Colours by role, for light and dark. The two ramps run in lightness too, so that they are read
// without colour.
/** @import { Palette } from '../types' */

/** @type {Palette} */
export const light = {
  background: '#ffffff', ink: '#1d2733', faint: '#8a97a6', boundary: '#0b1622', accent: '#0b62c4',
  error: '#c01b2c',
  quadLow: [214, 94, 64], quadHigh: [226, 240, 248],
  densityLow: [235, 243, 251], densityHigh: [24, 72, 140],
  valence: { [-2]: '#7a1fa2', [-1]: '#c2410c', 1: '#0b62c4', 2: '#00695c' },
};

/** @type {Palette} */
export const dark = {
  background: '#0f151c', ink: '#d6dee8', faint: '#5d6b7a', boundary: '#f2f6fa', accent: '#6cb2ff',
  error: '#ff8089',
  quadLow: [190, 74, 50], quadHigh: [30, 58, 82],
  densityLow: [22, 34, 48], densityHigh: [120, 190, 255],
  valence: { [-2]: '#d9a0f5', [-1]: '#ff9d5c', 1: '#6cb2ff', 2: '#5fd4c0' },
};

/** @param {number[]} low  @param {number[]} high  @param {number} t  0 to 1 */
export function mix(low, high, t) {
  const [r, g, b] = low.map((value, i) => Math.round(value + t * (high[i] - value)));
  return `rgb(${r},${g},${b})`;
}
