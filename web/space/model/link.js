// The address of a preset with its options and layers: what can be said in a link. Files cannot. It may be anybody's: it is
// judged before it is opened.
/** @import { SpaceLayer, Work } from '../types' */
import { faultOfOption, knownSurfaceOptions } from '../../state/options.js';
import { presets, surfaceOf } from '../presets/presets.js';
import { inOrder, layerNames, workOf } from './work.js';

/** '' for a surface from a file. @param {Work} work */
export function toFragment({ preset, options, layers }) {
  if (preset === undefined) return '';
  const words = new URLSearchParams({ preset });
  for (const [name, value] of Object.entries(options)) words.set(name, String(value));
  if (layers !== 'auto') words.set('layers', layers.join('.'));
  return `#${words}`;
}

/** What an address says that has no problem; the first preset without. @param {string} fragment  @returns {Work} */
export function fromFragment(fragment) {
  const words = new URLSearchParams(fragment.slice(1));
  const work = presetWork(words.get('preset') ?? '');
  const shown = words.get('layers')?.split('.') ?? null;
  const options = optionsOf(words), { quads } = options;
  return { ...work, options: { ...(!quads && work.options), ...options },  // a number of quads is in place of a size
    layers: shown === null ? 'auto' : inOrder(/** @type {SpaceLayer[]} */ (shown.filter(isLayer))) };
}

/** Why an address opens something else than it says; '': it does not. @param {string} fragment */
export function problemOf(fragment) {
  const words = new URLSearchParams(fragment.slice(1)), id = words.get('preset');
  const has = (/** @type {{title: string}[]} */ all) => `It has ${all.map(({ title }) => title.toLowerCase()).join(', ')}.`;
  const no = (/** @type {string} */ what) => `This link could not be opened: the page has no ${what.slice(0, 50)}”. `;
  if (id !== null && !presets.some((preset) => preset.id === id)) return no(`surface “${id}`) + has(presets);
  const layer = words.get('layers')?.split('.').find((shown) => shown !== '' && !isLayer(shown));
  if (layer !== undefined) return no(`layer “${layer}`) + has(layerNames);
  const fault = faultOf(optionsOf(words));
  return fault && `This link could not be opened: ${fault}.`;
}

/** What is wrong with the options of a work; '': nothing. @param {Record<string, unknown>} options */
export function faultOf(options) {
  const faults = Object.entries(options).map(([name, value]) => faultOfOption(name, value, knownSurfaceOptions));
  return faults.find(Boolean) ?? (options.size && options.quads ? 'it has a size and a number of quads, of which only one can be' : '');
}

/** All that is not of the page's own. @param {URLSearchParams} words  @returns {Record<string, unknown>} */
const optionsOf = (words) => Object.fromEntries([...words].filter(([name]) => name !== 'preset' && name !== 'layers').map(([name, text]) => [name, valueOf(text)]));

const isLayer = (/** @type {string} */ layer) => layerNames.some(({ name }) => name === layer);

/** @param {string} id  @returns {Work} */
export function presetWork(id) {
  const found = presets.find((preset) => preset.id === id) ?? presets[0];
  return { layers: 'auto', ...workOf(found.title, surfaceOf(found.make())), preset: found.id };
}

/** @param {string} text */
function valueOf(text) {
  if (text === 'true' || text === 'false') return text === 'true';
  return text.trim() !== '' && Number.isFinite(Number(text)) ? Number(text) : text;
}
