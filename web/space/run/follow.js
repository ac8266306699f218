// What is meshed when: a change starts a run at once, those of a gesture (a drag, a slider) when it is over.
/** @import { SpaceApp, Work } from '../types' */

/** Whether two works have the same mesh. @param {Work} a  @param {Work} b */
export const haveSameMesh = (a, b) => a.surface === b.surface && sameOptions(a.options, b.options);

/** A slider that comes back to where it was has made new options with the old values.
 * @param {Record<string, any>} a  @param {Record<string, any>} b */
function sameOptions(a, b) {
  const names = new Set([...Object.keys(a), ...Object.keys(b)]);
  return a === b || [...names].every((name) => a[name] === b[name]);
}

/** @param {Pick<SpaceApp, 'store' | 'runner'>} app */
export function installFollowing({ store, runner }) {
  const follow = () => {
    // The run's own work, not the one before the change: the end of a gesture changes nothing any more.
    const { work } = runner.run;
    if (store.gesture === '' && (work === null || !haveSameMesh(work, store.project))) void runner.start(store.project);
  };
  store.subscribe(follow);
  follow();
}
