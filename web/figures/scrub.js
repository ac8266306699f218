// Looking into the past of a run from a curve: hovering shows an iteration as long as the pointer is
// there, a click stays.
/** @import { Runner } from '../run/runner.js' */
import { iterationOf, iteratesOf } from './statistics.js';

/** @param {() => Runner} runnerNow */
export function createScrub(runnerNow) {
  let back = /** @type {number | null} */ (null);  // the tick to return to
  const go = (/** @type {number} */ iteration) => {
    const runner = runnerNow(), { first, iterates } = iteratesOf(runner.run);
    const last = iterates.at(-1)?.iteration ?? 0;
    void runner.seek(first + Math.max(0, Math.min(last, iteration)));
  };
  return {
    hover(/** @type {number} */ iteration) {
      const runner = runnerNow();
      if (runner.going || runner.run.state === null) return;
      back ??= runner.run.state.tick;
      go(iteration);
    },
    leave() {
      if (back !== null) void runnerNow().seek(back);
      back = null;
    },
    pin(/** @type {number} */ iteration) {
      back = null;
      go(iteration);
    },
    turn(/** @type {string} */ key) {
      back = null;
      const { run } = runnerNow(), { iterates } = iteratesOf(run);
      const at = iterationOf(run.state, iterates);
      const last = iterates.at(-1)?.iteration ?? 0;
      go({ ArrowLeft: at - 1, ArrowDown: at - 1, ArrowRight: at + 1, ArrowUp: at + 1, Home: 0, End: last }[key] ?? at);
    },
  };
}
