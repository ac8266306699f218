// The mesh that may leave the page: that of what is on the screen as it is now.
/** @import { App } from '../app' */
/** @import { MeshResult } from '../types' */
import { messageInWords } from '../run/words.js';
import { haveSameMesh } from '../state/project.js';
import { fileNameOf } from './names.js';

/**
 * The mesh, or why there is none.
 * @template M  @param {{phase: string, result: M | null, error: {message: string} | null}} run
 * @param {boolean} own  whether the run is of what is on the screen  @param {boolean} changing  by a gesture under way
 * @returns {{mesh: M, reason: ''} | {mesh: null, reason: string}}
 */
export function meshOf({ phase, result, error }, own, changing) {
  if (changing) return { mesh: null, reason: 'What is to be meshed is still changing.' };
  if (!own) return { mesh: null, reason: 'The mesh on the screen is out of date.' };
  if (result) return { mesh: result, reason: '' };
  if (error) return { mesh: null, reason: `There is no mesh: ${messageInWords(error.message)}` };
  const going = phase === 'playing' || phase === 'running';
  return { mesh: null, reason: going ? 'The mesh is not finished yet.' : 'The mesh is not finished yet: run it to the end first.' };
}

/** Of a comparison, that of the side that is chosen.
 * @param {Pick<App, 'sides' | 'store'>} app  @returns {{mesh: MeshResult, reason: ''} | {mesh: null, reason: string}} */
export function currentMesh({ sides: { chosen: { runner: { run }, project } }, store }) {
  return meshOf(run, run.project !== null && haveSameMesh(run.project, project()), store.gesture !== '');
}

/** What files of that mesh are called, without ending: those of two that are compared lie beside each other.
 * @param {Pick<App, 'sides'>} app */
export const currentName = ({ sides: { chosen: { letter, project } } }) => fileNameOf(project()) + (letter && `-${letter}`);
