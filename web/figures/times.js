// What a run took: the computing time of each of its stages, in the words of the page.
/** @import { Figures } from './statistics.js' */
import { h } from '../panels/dom.js';
import { createBars } from './bars.js';

/** In the plane. @type {Record<string, string>} */
const stages = {
  prepare: 'outline and field', seeds: 'first points', optimise: 'settling cells', match: 'choosing pairs',
  clean: 'merging, tidying', patch: 'remeshing patches', smooth: 'smoothing', check: 'last check',
};

/** @param {Record<string, string>} [words]  by what the reports call the stages */
export function createTimes(words = stages) {
  const bars = createBars({ name: 'Time by stage',
    help: 'Computing time of the mesher in this browser, without drawing.' });
  const element = h('div', { hidden: true }, bars.element);
  /** @param {Pick<Figures, 'seconds'>} figures */
  function show({ seconds }) {
    element.hidden = seconds === undefined;
    if (seconds === undefined) return;
    const total = Object.values(seconds).reduce((sum, one) => sum + one, 0);
    const rows = Object.entries(seconds).map(([name, value]) =>
      ({ label: words[name] ?? name, value, text: inMilliseconds(value) }));
    bars.show(rows, inMilliseconds(total));
  }
  return { element, show };
}

/** @param {number} seconds */
const inMilliseconds = (seconds) =>
  (seconds < 10 ? `${Math.round(1000 * seconds).toLocaleString('en')} ms` : `${seconds.toFixed(1)} s`);
