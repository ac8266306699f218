// What is meshed when: a change starts a run at once, those of a gesture (a drag, a slider) when it is over.
/** @import { SpaceApp } from '../types' */
import { haveSameMesh } from '../model/work.js';

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
