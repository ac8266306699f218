// The mesh that may leave the page: that of the drawing as it is now.
/** @import { App } from '../app' */
/** @import { MeshResult } from '../types' */
import { haveSameMesh } from '../state/project.js';

/** @param {Pick<App, 'runner' | 'store'>} app  @returns {{mesh: MeshResult, reason: ''} | {mesh: null, reason: string}} */
export function currentMesh({ runner: { run }, store }) {
  const own = run.project !== null && haveSameMesh(run.project, store.project);
  if (store.gesture !== '') return { mesh: null, reason: 'The drawing is still changing.' };
  if (!own) return { mesh: null, reason: 'The mesh on the screen is of an older drawing.' };
  if (run.result) return { mesh: run.result, reason: '' };
  if (run.error) return { mesh: null, reason: `There is no mesh: ${run.error.message}` };
  return { mesh: null, reason: run.phase === 'playing' ? 'The mesh is not finished yet.' : 'The mesh is not finished yet: run it to the end first.' };
}
