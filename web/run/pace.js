// How fast a run is shown: so that cells are seen to settle, in some seconds, whatever the number
// of iterations and the speed of the machine.
/** @import { State } from 'lpquad' */

const settling = 2200;  // milliseconds for all iterations together
const longest = 300;    // of a gap between two pictures that is made up for
const most = 64;        // ticks between two pictures

/** Milliseconds before the next tick, at speed 1. @param {State} state */
export function dwellOf({ stage, iteration, maxIterations }) {
  if (stage === 'seeds') return 250;
  if (stage === 'optimise') return iteration === 0 ? 400 : Math.max(4, Math.min(130, settling / maxIterations));
  return stage === 'match' || stage === 'clean' ? 350 : 140;
}

/** The time of the next picture. A page in the background gets none, but time goes on. */
export function nextPicture() {
  return new Promise((resolve) => {
    const seen = typeof requestAnimationFrame === 'function' && document.visibilityState === 'visible';
    if (seen) requestAnimationFrame(resolve);
    else setTimeout(resolve, 16);
  });
}

export class Pace {
  #owed = 0;  // ticks, or part of one
  #last = 0;

  /** @param {() => number} [now]  in milliseconds */
  constructor(now = () => performance.now()) {
    this.now = now;
  }

  begin() {
    this.#owed = 0;
    this.#last = this.now();
  }

  /** Ticks that are due by now. @param {State} state  @param {number} speed */
  take(state, speed) {
    const now = this.now();
    this.#owed += Math.min(longest, now - this.#last) * speed / dwellOf(state);
    this.#last = now;
    const steady = state.stage === 'optimise' && state.iteration > 0;
    const due = Math.min(steady ? most : 1, Math.floor(this.#owed));
    if (due > 0) this.#owed = steady ? Math.min(1, this.#owed - due) : 0;
    return due;
  }
}
