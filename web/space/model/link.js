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
  const known = new Set(layerNames.map(({ name }) => /** @type {string} */ (name)));
  return { ...work, options: { ...work.options, ...options },
    layers: shown === null ? 'auto' : inOrder(/** @type {SpaceLayer[]} */ (shown.filter((name) => known.has(name)))) };
}

/** Why an address opens something else than it says; '': it does not. @param {string} fragment */
export function problemOf(fragment) {
  const id = new URLSearchParams(fragment.slice(1)).get('preset');
  if (id === null || presets.some((preset) => preset.id === id)) return '';
  return `This link could not be opened: the page has no surface “${id.slice(0, 40)}”. It has ${presets.map(({ title }) => title.toLowerCase()).join(', ')}.`;
}

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
