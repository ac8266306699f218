// The states that a run was seen in.
/** @import { State } from 'lpquad' */

/** @param {State[]} history  @param {State} state  @returns {State[]} by tick, each once */
export function remembered(history, state) {
  const last = history.at(-1);
  if (last === undefined || last.tick < state.tick) return [...history, state];
  const known = history.findIndex(({ tick }) => tick === state.tick);
  if (known < 0) return [...history, state].sort((a, b) => a.tick - b.tick);
  return history[known].tau !== 0 || state.tau === 0 ? history : history.with(known, state);
}
