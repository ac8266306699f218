// Which layers are on the screen, and which of the library's snapshot layers they are drawn from.
/** @import { Layers, State } from 'lpquad' */
/** @import { LayerName, Project } from '../types' */

/** With what is told of an element under the pointer. @type {Record<LayerName, (keyof Layers)[]>} */
const sources = {
  boundary: [], triangles: ['triangles', 'matching'], cells: ['cells'], density: ['cells', 'sizes'],
  crosses: ['crosses', 'sizes'], sizes: ['sizes'], matching: ['matching'],
  quads: ['quads', 'sizes'], quality: ['quads', 'sizes'], valence: ['quads', 'sizes'],
};

export const layerNames = /** @type {LayerName[]} */ (Object.keys(sources));

/** What tells most at each stage. @type {Record<State['stage'], LayerName[]>} */
const telling = {
  seeds: ['boundary', 'crosses'],
  optimise: ['boundary', 'cells', 'density'],
  match: ['boundary', 'triangles'],
  clean: ['boundary', 'matching', 'quads'],
  patch: ['boundary', 'quads', 'quality', 'valence'],
  smooth: ['boundary', 'quads', 'quality', 'valence'],
  check: ['boundary', 'quads', 'quality', 'valence'],
  compare: ['boundary', 'quads', 'quality', 'valence'],
  done: ['boundary', 'quads', 'quality', 'valence'],
};

/** Before anything moved. @type {LayerName[]} */
const seeded = ['boundary', 'triangles'];

/** @param {Project['layers']} layers  @param {State | null} state  @returns {ReadonlySet<LayerName>} */
export function shownLayers(layers, state) {
  if (layers !== 'auto') return new Set(layers);
  if (state?.stage === 'optimise' && state.iteration === 0) return new Set(seeded);
  return new Set(telling[state?.stage ?? 'seeds']);
}

/** @param {Project['layers']} layers  @param {State} state  @returns {Layers} */
export function neededFor(layers, state) {
  const needed = /** @type {Layers} */ ({});
  for (const name of shownLayers(layers, state)) for (const source of sources[name]) needed[source] = true;
  return needed;
}
