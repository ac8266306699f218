// The address of a preset with its options and layers: what can be said in a link. Files cannot.
/** @import { SpaceLayer, Work } from '../types' */
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

/** What the address says; the first preset without. Options that cannot be are for the mesher to refuse.
 * @param {string} fragment  @returns {Work} */
export function fromFragment(fragment) {
  const words = new URLSearchParams(fragment.slice(1));
  const work = presetWork(words.get('preset') ?? '');
  const shown = words.get('layers')?.split('.') ?? null;
  words.delete('preset');
  words.delete('layers');
  const options = Object.fromEntries([...words].map(([name, text]) => [name, valueOf(text)]));
  return { ...work, options: { ...work.options, ...options },
    layers: shown === null ? 'auto' : inOrder(/** @type {SpaceLayer[]} */ (shown.filter(isLayer))) };
}

/** Why an address opens something else than it says; '': it does not. @param {string} fragment */
export function problemOf(fragment) {
  const words = new URLSearchParams(fragment.slice(1)), id = words.get('preset');
  const has = (/** @type {{title: string}[]} */ all) => `It has ${all.map(({ title }) => title.toLowerCase()).join(', ')}.`;
  const no = (/** @type {string} */ what) => `This link could not be opened: the page has no ${what.slice(0, 50)}”. `;
  if (id !== null && !presets.some((preset) => preset.id === id)) return no(`surface “${id}`) + has(presets);
  const layer = words.get('layers')?.split('.').find((shown) => shown !== '' && !isLayer(shown));
  return layer === undefined ? '' : no(`layer “${layer}`) + has(layerNames);
}

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
