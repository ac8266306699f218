// The tab "Files" of either page: parts that are kept up to date while it is open.
/** @import { Description } from 'lpquad' */
/** @import { App } from '../app' */
/** @import { Described } from '../run/description.js' */
import { whenDescribed } from '../run/description.js';

/**
 * @typedef {{element: HTMLElement, refresh?: () => void}} Part
 * @typedef {Pick<App, 'actions' | 'tabs'> & {store: import('../state/store.js').Store<any>, runner: Described}} Page
 */

/** @param {Page} page  @param {Part[]} parts
 * @param {(description: Description) => {above: Part[], below: Part[]}} late  what needs the mesher, and comes when it is there
 * @returns {() => void} brings it up to date */
export function installTab({ actions, runner, store, tabs }, parts, late) {
  const elements = (/** @type {Part[]} */ some) => some.map(({ element }) => element);
  const body = tabs.add('files', 'Files', ...elements(parts));
  const all = [...parts];
  const refresh = () => { if (!body.hidden) for (const part of all) part.refresh?.(); };
  store.subscribe(refresh);
  runner.subscribe(refresh);
  tabs.subscribe(refresh);
  whenDescribed(runner, (description) => {
    const { above, below } = late(description);
    all.push(...above, ...below);
    body.prepend(...elements(above));
    body.append(...elements(below));
    actions.refresh();
    refresh();
  });
  return refresh;
}
