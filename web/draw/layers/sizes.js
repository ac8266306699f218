/** @import { Pen, Scene, Snapshot, View } from '../../types' */
import { fillRows, strokeLines } from '../bulk.js';
import { contours } from '../contours.js';
import { once } from '../once.js';
import { shadeCount, shadesOf } from '../palette.js';
import { rangeOf } from '../sampler.js';

/** @typedef {NonNullable<Snapshot['sizes']>} Sizes */
/** @typedef {{points: Float64Array, offsets: Uint32Array, band: Uint8Array}} Bands */
/** @typedef {{bands: Bands, lines: Float64Array, bandCount: number}} Made */

/**
 * The target size, small to large in equal ratios, with lines of equal size.
 * @param {Pen} pen  @param {Scene} scene  @param {View} view
 */
export function* drawSizes(pen, { frame, palette }, view) {
  const layer = frame?.sizes;
  if (!layer || layer.sizes.length === 0) return;
  const known = once(layer, 'contours', () => /** @type {{made?: Made}} */ ({}));
  known.made ??= yield* contoursOf(layer);
  const { bands, lines, bandCount } = known.made;
  const { low, high } = rangeOf(layer.sizes), used = Math.log(high / low) / Math.log(high / lowestSize(layer.sizes));
  const share = (/** @type {number} */ i) => 1 - used * (1 - (bands.band[i] + 0.5) / bandCount);
  const shade = (/** @type {number} */ i) => Math.round((shadeCount - 1) * share(i));
  const rows = { points: bands.points, vertices: null, offsets: bands.offsets };
  yield* fillRows(pen, rows, shade, shadesOf(palette.ramps.sizes), view);
  pen.strokeStyle = palette.ink;
  pen.lineWidth = 0.6;
  yield* strokeLines(pen, lines, view);
}

/**
 * Where the ramp begins: sizes that differ by less than a factor of two look alike.
 * @param {ArrayLike<number>} sizes
 */
export function lowestSize(sizes) {
  const { low, high } = rangeOf(sizes);
  return Math.min(low, high / 2);
}

/** Bands of the logarithm; about 12 percent from one to the next, 16 at most. @param {Sizes} layer */
function* contoursOf(layer) {
  const { low, high } = rangeOf(layer.sizes);
  const span = Math.log(high / low), bandCount = span < 0.02 ? 1 : Math.max(2, Math.min(16, Math.ceil(span / 0.12)));
  const heights = layer.sizes.map((h) => bandCount * Math.log(h / low) / (span || 1));
  return { ...yield* contours(layer.points, layer.triangles, heights, bandCount), bandCount };
}
