// What a run is doing, in plain words.
/** @import { State } from 'lpquad' */
/** @import { Run } from '../types' */

/** What is on the screen when this stage comes next. @type {Record<State['stage'], string>} */
const shown = {
  seeds: 'cross field', optimise: 'triangles', match: 'triangles to merge', clean: 'triangles merged to quads',
  patch: 'quads tidied', smooth: 'patches remeshed', check: 'corners smoothed', done: 'last check',
};

/** @param {State} state */
export function stageName({ stage, iteration, maxIterations }) {
  if (stage === 'optimise' && iteration > 0) return `cells settle: iteration ${iteration} of ${maxIterations}`;
  return shown[stage];
}

/** @param {Run} run */
export function describe({ phase, state, error, result }) {
  if (error) return `no mesh: ${error.message}`;
  if (phase === 'loading') return 'loading the mesher …';
  if (phase === 'cancelled') return state === null ? 'cancelled' : `cancelled at: ${stageName(state)}`;
  if (state === null) return 'starting …';
  if (state.stage === 'done' && result) return `done: ${counted(result.quads.length / 4, 'quad')}`;
  return stageName(state);
}

/** @param {number} count  @param {string} thing */
export const counted = (count, thing) => `${count.toLocaleString('en')} ${thing}${count === 1 ? '' : 's'}`;

/** Ticks that the whole run may take, as far as can be told. @param {Run} run */
export function expectedTicks({ history, result }) {
  const last = history.at(-1);
  if (last === undefined) return 0;
  if (result || last.stage === 'done') return last.tick;
  const left = last.maxIterations - last.iteration + 5;
  const after = { seeds: left, optimise: left, match: 4, clean: 3, patch: 3, smooth: 2, check: 1 };
  return last.tick + Math.max(1, after[last.stage]);
}
