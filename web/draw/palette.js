// Colours by role, for light and dark. Every ramp runs in lightness too, so that it is read without
// colour; marks and lines keep 3:1 to the background, text 4.5:1.
/** @import { Palette, Ramp } from '../types' */

/** @type {Palette} */
export const light = {
  background: '#ffffff', ink: '#1d2733', faint: '#7b8998', boundary: '#0b1622', accent: '#0b62c4',
  error: '#c01b2c', region: '#f4f7fa',
  ramps: {
    density: [[226, 239, 250], [158, 203, 232], [110, 146, 206], [152, 72, 142], [150, 10, 40]],
    quality: [[150, 24, 28], [226, 104, 60], [248, 190, 120], [250, 240, 214], [234, 246, 250]],
    sizes: [[10, 60, 72], [22, 106, 112], [70, 156, 142], [146, 204, 176], [228, 244, 222]],
    costs: [[238, 240, 250], [196, 190, 228], [150, 124, 196], [106, 58, 148]],
  },
  valence: { [-2]: '#7a1fa2', [-1]: '#c2410c', 1: '#0b62c4', 2: '#00695c' },
};

/** @type {Palette} */
export const dark = {
  background: '#0f151c', ink: '#d6dee8', faint: '#6c7b8b', boundary: '#f2f6fa', accent: '#6cb2ff',
  error: '#ff8089', region: '#131b24',
  ramps: {
    density: [[20, 36, 54], [32, 78, 122], [100, 92, 176], [214, 96, 122], [255, 196, 130]],
    quality: [[255, 214, 150], [238, 140, 84], [168, 76, 62], [72, 58, 72], [26, 46, 62]],
    sizes: [[206, 240, 214], [120, 196, 170], [52, 142, 134], [24, 88, 96], [14, 42, 54]],
    costs: [[28, 32, 48], [66, 58, 108], [122, 98, 172], [196, 178, 236]],
  },
  valence: { [-2]: '#d9a0f5', [-1]: '#ff9d5c', 1: '#6cb2ff', 2: '#5fd4c0' },
};

/** The colour of a ramp at t, 0 to 1. @param {Ramp} ramp  @param {number} t @returns {[number, number, number]} */
function between(ramp, t) {
  const place = Math.max(0, Math.min(1, t)) * (ramp.length - 1);
  const i = Math.min(ramp.length - 2, Math.floor(place));
  const low = ramp[i], high = ramp[i + 1];
  const at = (/** @type {number} */ k) => Math.round(low[k] + (place - i) * (high[k] - low[k]));
  return [at(0), at(1), at(2)];
}

/** The ramp as a CSS image, for legends. @param {Ramp} ramp */
export const gradientOf = (ramp) => `linear-gradient(to right, ${ramp.map((colour) => `rgb(${colour})`)})`;

/** A colour as a word of an ImageData (little-endian). */
export const packed = (/** @type {number} */ r, /** @type {number} */ g, /** @type {number} */ b, alpha = 255) =>
  ((alpha << 24) | (b << 16) | (g << 8) | r) >>> 0;

/** The word of '#rrggbb'. @param {string} colour */
export function packedOf(colour) {
  const rgb = parseInt(colour.slice(1), 16);
  return packed(rgb >> 16, (rgb >> 8) & 255, rgb & 255);
}

export const shadeCount = 256;

/** @type {WeakMap<Ramp, {css: string[], rgba: Uint32Array}>} */
const known = new WeakMap();

/** The ramp in `shadeCount` steps, for paths and for bitmaps. @param {Ramp} ramp */
export function shadesOf(ramp) {
  let shades = known.get(ramp);
  if (shades === undefined) {
    const colours = Array.from({ length: shadeCount }, (_, i) => between(ramp, i / (shadeCount - 1)));
    shades = {
      css: colours.map((colour) => `rgb(${colour})`),
      rgba: Uint32Array.from(colours, (colour) => packed(...colour)),
    };
    known.set(ramp, shades);
  }
  return shades;
}
