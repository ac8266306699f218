// What the colours and marks of a layer mean in a scene, with its numbers. Pure, like drawing.
/** @import { LayerName, Palette, Ramp, Scene } from '../types' */
/** @import { Shape } from './marks.js' */
import { highestDensity, relativeDensity } from './layers/cells.js';
import { costRange } from './layers/matching.js';
import { lowestQuality } from './layers/quads.js';
import { markOf } from './marks.js';
import { rangeOf } from './sampler.js';

/**
 * @typedef {{kind: 'ramp', ramp: Ramp, low: string, high: string, of: string}
 *   | {kind: 'line', colour: string, width: number, text: string}
 *   | {kind: 'area', colour: string, text: string}
 *   | {kind: 'mark', shape: Shape, colour: string, hollow: boolean, text: string}
 *   | {kind: 'text', text: string}} LegendItem
 */

/** Three digits. @param {number} x */
export const short = (x) => String(Number(x.toPrecision(3)));

/** @param {number} n  @param {string} one  @param {string} [many] */
export const counted = (n, one, many = `${one}s`) => `${n} ${n === 1 ? one : many}`;

/** @param {LayerName} name  @param {Scene} scene  @returns {LegendItem[]} */
export function legendOf(name, scene) {
  const items = legends[name](scene);
  return items ?? [{ kind: 'text', text: 'Nothing yet at this stage.' }];
}

/** @type {Record<LayerName, (scene: Scene) => LegendItem[] | null>} */
const legends = {
  boundary: ({ drawing, palette }) => {
    const points = drawing.regions.reduce((sum, { loops }) => sum + loops.reduce((all, loop) => all + loop.length, 0), 0);
    const loops = drawing.regions.reduce((sum, region) => sum + region.loops.length, 0);
    const tags = new Set(drawing.regions.flatMap(({ tags: of = [] }) => of.flat()).filter(Boolean));
    return [
      { kind: 'line', colour: palette.boundary, width: 1.5, text: `${counted(loops, 'outline')}, ${counted(points, 'point')}` },
      ...tags.size > 0 ? [/** @type {LegendItem} */ ({ kind: 'line', colour: palette.boundary, width: 3, text: `tagged: ${[...tags].join(', ')}` })] : [],
    ];
  },
  triangles: ({ frame, palette }) => frame?.triangles?.triangles.length
    ? [{ kind: 'line', colour: palette.faint, width: 1, text: counted(frame.triangles.triangles.length / 3, 'triangle') }] : null,
  cells: ({ frame, palette }) => frame?.cells?.sites.length
    ? [{ kind: 'line', colour: palette.faint, width: 1, text: `${counted(frame.cells.density.length, 'cell')}, energy ${short(frame.cells.energy)}` }] : null,
  density: ({ frame, palette, norm }) => {
    if (!frame?.cells?.sites.length) return null;
    const { cells, sizes } = frame;
    const relative = relativeDensity(cells, sizes, norm);
    const mean = relative.reduce((sum, value) => sum + value, 0) / relative.length;
    return [{ kind: 'ramp', ramp: palette.ramps.density, low: '1', high: `≥ ${highestDensity}`, of: `of a perfect square; mean ${short(mean)}` }];
  },
  crosses: ({ frame, palette }) => frame?.crosses?.points.length
    ? [{ kind: 'line', colour: palette.accent, width: 1.25, text: 'directions of the sides' }, ...singularities(frame.crosses.indices, palette)] : null,
  sizes: ({ frame, palette }) => {
    if (!frame?.sizes?.sizes.length) return null;
    const { low, high } = rangeOf(frame.sizes.sizes);
    if (high < 1.02 * low) return [{ kind: 'text', text: `${short(low)} everywhere` }];
    return [{ kind: 'ramp', ramp: palette.ramps.sizes, low: short(low), high: short(high), of: 'in equal ratios' }];
  },
  matching: ({ frame, palette }) => {
    if (!frame?.matching?.triangles.length) return null;
    const { low, high } = costRange(frame.matching);
    const extra = frame.matching.extra.reduce((sum, one) => sum + one, 0) / 2;
    const alone = frame.matching.mates.filter((mate) => mate < 0).length;
    return [
      { kind: 'ramp', ramp: palette.ramps.costs, low: short(low / 1e4), high: short(high / 1e4), of: 'cost of a pair' },
      { kind: 'area', colour: palette.valence[-1], text: `${counted(extra, 'pair')} joined by an extra edge` },
      ...alone > 0 ? [/** @type {LegendItem} */ ({ kind: 'text', text: `${counted(alone, 'triangle')} left over` })] : [],
    ];
  },
  quads: ({ frame, palette }) => {
    if (!frame?.quads?.quads.length) return null;
    const alone = frame.quads.triangles.length / 3;
    return [{ kind: 'line', colour: palette.ink, width: 1, text: counted(frame.quads.quads.length / 4, 'quad') + (alone > 0 ? `, ${counted(alone, 'triangle')}` : '') }];
  },
  quality: ({ frame, palette }) => {
    if (!frame?.quads?.quads.length) return null;
    const eta = frame.quads.eta.subarray(0, frame.quads.quads.length / 4);
    const mean = eta.reduce((sum, value) => sum + value, 0) / eta.length;
    return [{ kind: 'ramp', ramp: palette.ramps.quality, low: `≤ ${lowestQuality}`, high: '1', of: `mean ${short(mean)}, least ${short(rangeOf(eta).low)}` }];
  },
  valence: ({ frame, palette }) => {
    if (!frame?.quads?.quads.length) return null;
    const { excess, valence } = frame.quads;
    const used = valence.filter((count) => count > 0).length, regular = excess.filter((e, v) => e === 0 && valence[v] > 0).length;
    return [
      { kind: 'text', text: `${short(100 * regular / used)} % of ${used} are regular` },
      ...[-2, -1, 1, 2].flatMap((kind) => {
        const count = excess.filter((e) => Math.max(-2, Math.min(2, e)) === kind).length;
        const { shape, colour, text } = markOf(palette, kind);
        return count > 0 ? [/** @type {LegendItem} */ ({ kind: 'mark', shape, colour, hollow: false, text: `${count} with ${text}` })] : [];
      }),
    ];
  },
};

/** @param {Int32Array} indices  @param {Palette} palette  @returns {LegendItem[]} */
function singularities(indices, palette) {
  return [1, -1].flatMap((sign) => {
    const count = indices.filter((index) => Math.sign(index) === sign).length;
    const { shape, colour } = markOf(palette, -sign);
    const text = sign > 0 ? `${counted(count, 'singularity', 'singularities')} +1: three quads meet` : `${counted(count, 'singularity', 'singularities')} −1: five quads meet`;
    return count > 0 ? [{ kind: /** @type {const} */ ('mark'), shape, colour, hollow: true, text }] : [];
  });
}
