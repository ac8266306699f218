// What a run of surfaces is doing, and why it failed, in plain words.
/** @import { SurfaceProgress } from 'lpquad' */
/** @import { SurfaceRun } from '../types' */
import { counted } from '../../run/words.js';
import { titleOf as titleInThePlane } from '../../sketch/errors/words.js';

/** @type {Record<SurfaceProgress['stage'], string>} */
const names = {
  features: 'finding sharp edges', field: 'solving the cross field', charts: 'mapping charts to the plane',
  mesh: 'meshing charts', seams: 'remeshing over the seams', shape: 'moving the vertices', done: 'done',
};

/** By what reports call the stages: two of theirs are never on the screen. @type {Record<string, string>} */
export const stageNames = { ...names, repair: 'repairing the surface', summary: 'measuring the mesh' };

/** What differs where there is a surface and no outline. @type {Record<string, string>} */
const titles = {
  EMPTY: 'There is no surface to mesh.',
  ZERO_AREA: 'This surface has no area.',
  BAD_SIZE: 'The mesh size does not fit this surface.',
  NO_VALID_MESH: 'No good mesh was found for this surface.',
};

/** @param {string} code */
export const titleOf = (code) => titles[code] ?? titleInThePlane(code);

/** Where the run is. @param {SurfaceRun} run */
export function stageInWords({ phase, state, error, paused, result }) {
  if (phase === 'failed') return `failed: ${shortTitle(error?.code ?? '')}`;
  if (phase === 'cancelled') return 'cancelled';
  if (phase === 'idle' || state === null) return phase === 'idle' ? 'nothing to mesh yet' : 'preparing the surface';
  if (phase === 'done') return result === null ? 'done' : `done: ${counted(result.report.quads, 'quad')}`;
  const charts = state.stage === 'mesh' ? `: ${state.chart} of ${state.chartCount}` : '';
  const name = state.stage === 'done' ? stageNames.summary : names[state.stage];  // the result is still to come
  return `${name}${charts}${paused ? ' (paused)' : ''}`;
}

/** In the middle of a sentence. @param {string} code */
const shortTitle = (code) => titleOf(code).replace(/\.$/, '').replace(/^./, (first) => first.toLowerCase());

export { messageInWords } from '../../run/words.js';
