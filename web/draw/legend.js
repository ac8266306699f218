// What the colours and marks of a layer mean in a scene, with its numbers. Pure, like drawing.
/** @import { LayerName, Palette, Ramp, Scene } from '../types' */
/** @import { Shape } from './marks.js' */
import { highestDensity, relativeDensity } from './layers/cells.js';
import { costRange } from './layers/matching.js';
import { lowestQuality } from './layers/quads.js';
import { lowestSize } from './layers/sizes.js';
import { markOf } from './marks.js';
import { rangeOf } from './sampler.js';

/**
 * `key`: what it means in few words, where a look at the picture does not tell.
 * @typedef {{key?: string} & ({kind: 'ramp', ramp: Ramp, low: string, high: string, of: string}
 *   | {kind: 'line', colour: string, width: number, text: string}
 *   | {kind: 'area', colour: string, text: string}
 *   | {kind: 'mark', shape: Shape, colour: string, hollow: boolean, text: string}
 *   | {kind: 'text', text: string})} LegendItem
 */

/** Three digits. @param {number} x */
export const short = (x) => String(Number(x.toPrecision(3)));

/** @param {number} n  @param {string} one  @param {string} [many] */
export const counted = (n, one, many = `${one}s`) => `${n.toLocaleString('en')} ${n === 1 ? one : many}`;

/** @param {ArrayLike<number>} values */
function meanOf(values) {
  let sum = 0;
  for (let i = 0; i < values.length; ++i) sum += values[i];
  return sum / values.length;
}

/** @param {string} colour  @param {number} width  @param {string} text  @returns {LegendItem} */
const line = (colour, width, text) => ({ kind: 'line', colour, width, text });
/** @param {string} text  @returns {LegendItem} */
const words = (text) => ({ kind: 'text', text });
/** @param {Ramp} ramp  @param {string} low  @param {string} high  @param {string} of  @returns {LegendItem} */
const ramped = (ramp, low, high, of) => ({ kind: 'ramp', ramp, low, high, of });

/** @param {LayerName} name  @param {Scene} scene  @returns {LegendItem[]} */
export const legendOf = (name, scene) => legends[name](scene) ?? [words('Nothing yet at this stage.')];

/** null: the layer has nothing to show. @type {Record<LayerName, (scene: Scene) => LegendItem[] | null>} */
const legends = {
  boundary: boundaryLegend,
  triangles({ frame, palette }) {
    const { triangles } = frame?.triangles ?? {};
    return triangles?.length ? [line(palette.faint, 1, counted(triangles.length / 3, 'triangle'))] : null;
  },
  cells({ frame, palette }) {
    const cells = frame?.cells;
    if (!cells?.sites.length) return null;
    return [line(palette.faint, 1, `${counted(cells.density.length, 'cell')}, energy ${short(cells.energy)}`)];
  },
  density({ frame, palette, norm }) {
    if (!frame?.cells?.sites.length) return null;
    const mean = meanOf(relativeDensity(frame.cells, frame.sizes, norm));
    return [ramped(palette.ramps.density, '1', `≥ ${highestDensity}`, `of a perfect square; mean ${short(mean)}`)];
  },
  crosses({ frame, palette }) {
    const crosses = frame?.crosses;
    if (!crosses?.points.length) return null;
    return [directions(palette), ...singularities(crosses.indices, palette)];
  },
  sizes({ frame, palette }) {
    if (!frame?.sizes?.sizes.length) return null;
    const { low, high } = rangeOf(frame.sizes.sizes);
    if (high < 1.02 * low) return [words(`${short(low)} everywhere`)];
    return [ramped(palette.ramps.sizes, short(lowestSize(frame.sizes.sizes)), short(high), `least ${short(low)}`)];
  },
  matching: matchingLegend,
  quads({ frame, palette }) {
    if (!frame?.quads?.quads.length) return null;
    const { quads, triangles } = frame.quads;
    const leftOver = triangles.length > 0 ? `, ${counted(triangles.length / 3, 'triangle')}` : '';
    return [line(palette.ink, 1, counted(quads.length / 4, 'quad') + leftOver)];
  },
  quality({ frame, palette }) {
    if (!frame?.quads?.quads.length) return null;
    const eta = frame.quads.eta.subarray(0, frame.quads.quads.length / 4);
    const of = `mean ${short(meanOf(eta))}, least ${short(rangeOf(eta).low)}`;
    return [ramped(palette.ramps.quality, `≤ ${lowestQuality}`, '1', of)];
  },
  valence: valenceLegend,
};

/** @param {Scene} scene */
function boundaryLegend({ drawing: { regions }, palette }) {
  const loops = regions.flatMap((region) => region.loops);
  const points = loops.reduce((sum, loop) => sum + loop.length, 0);
  const tags = new Set(regions.flatMap((region) => region.tags ?? []).flat().filter(Boolean));
  const items = [line(palette.boundary, 1.5, `${counted(loops.length, 'outline')}, ${counted(points, 'point')}`)];
  if (tags.size > 0) items.push(line(palette.boundary, 3, `tagged: ${[...tags].join(', ')}`));
  return items;
}

/** @param {Scene} scene */
function matchingLegend({ frame, palette }) {
  const matching = frame?.matching;
  if (!matching?.triangles.length) return null;
  const { low, high } = costRange(matching);
  const extra = matching.extra.reduce((sum, one) => sum + one, 0) / 2;
  const alone = matching.mates.filter((mate) => mate < 0).length;
  /** @type {LegendItem[]} */
  const items = [
    { ...ramped(palette.ramps.costs, short(low / 1e4), short(high / 1e4), 'cost of a pair'), key: 'Cost of a pair' },
    { kind: 'area', colour: palette.valence[-1], text: `${counted(extra, 'pair')} joined by an extra edge`, key: extra > 0 ? 'joined by an extra edge' : undefined },
  ];
  if (alone > 0) items.push(words(`${counted(alone, 'triangle')} left over`));
  return items;
}

/** @param {Scene} scene */
function valenceLegend({ frame, palette }) {
  if (!frame?.quads?.quads.length) return null;
  const { excess, valence, boundaryNodes } = frame.quads;
  const inside = valence.subarray(boundaryNodes), regular = inside.filter((count) => count === 4).length;
  const items = inside.length > 0 ? [words(`${(100 * regular / inside.length).toFixed(1)} % of ${inside.length.toLocaleString('en')} inside are regular`)] : [];
  for (const kind of [-2, -1, 1, 2]) {
    const ofKind = (/** @type {Int32Array | Int8Array} */ some) => some.filter((e) => Math.max(-2, Math.min(2, e)) === kind).length;
    const count = ofKind(excess), along = ofKind(excess.subarray(0, boundaryNodes));
    const { shape, colour, text, key } = markOf(palette, kind);
    const where = along === 0 ? '' : `, ${along === count ? 'all' : along.toLocaleString('en')} on the boundary`;
    if (count > 0) items.push({ kind: 'mark', shape, colour, hollow: false, text: `${count.toLocaleString('en')} with ${text}${where}`, key });
  }
  return items;
}

/** @param {Palette} palette  @returns {LegendItem} */
export const directions = ({ accent }) => ({ ...line(accent, 1.25, 'directions of the sides'), key: 'directions of the sides' });

/** @param {Int32Array} indices  @param {Palette} palette  @returns {LegendItem[]} */
export function singularities(indices, palette) {
  return [1, -1].flatMap((sign) => {
    const count = indices.filter((index) => Math.sign(index) === sign).length;
    const { shape, colour } = markOf(palette, -sign);
    const many = counted(count, 'singularity', 'singularities');
    const key = `${sign > 0 ? 'three' : 'five'} quads will meet`;
    const text = `${many} ${sign > 0 ? '+1: three' : '−1: five'} quads meet`;
    return count > 0 ? [{ kind: /** @type {const} */ ('mark'), shape, colour, hollow: true, text, key }] : [];
  });
}
