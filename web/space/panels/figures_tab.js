// The Figures tab: how good the mesh is, and what it took.
/** @import { SpaceApp } from '../types' */
import { createHistogram } from '../../figures/bars.js';
import { createNumbers, kinds } from '../../figures/numbers.js';
import { createTimes } from '../../figures/times.js';
import { h, setText } from '../../panels/dom.js';
import { stageInWords, stageNames } from '../run/words.js';

/** The layer marks only those off sharp edges; these are all. @param {import('../../figures/numbers.js').Kind} kind */
const inSpace = (kind) => (kind.key !== 'irregular' ? kind : { ...kind, name: 'Irregular, on sharp edges too',
  help: 'Vertices inside where other than four quads meet. Those on sharp edges are among them: a corner has its own number. '
    + 'The layer Irregular vertices marks the others.' });

const shown = ['etaMean', 'etaMin', 'etaP5', 'fourValentPercent', 'quads', 'triangles', 'vertices', 'irregular', 'singularities', 'p10', 'p50', 'p90'];

/** @param {SpaceApp} app */
export function installFiguresTab({ runner, tabs }) {
  const about = h('h2', { className: 'figures-of' });
  const numbers = createNumbers(kinds.filter(({ key }) => shown.includes(key)).map(inSpace));
  const eta = createHistogram({ name: 'Quads by squareness η', heads: ['η', 'Quads'],
    help: 'How many quads there are in each twentieth from 0 to 1.' });
  const valence = createHistogram({ name: 'Vertices by number of quads', heads: ['Quads at a vertex', 'Vertices'],
    help: 'How many quads meet at interior vertices; four is regular.' });
  const times = createTimes(stageNames);
  const charts = h('div', { hidden: true }, eta.element, valence.element, times.element);
  const hash = h('code', { title: 'Equal meshes have equal fingerprints, here and on the command line.' });
  tabs.add('figures', 'Figures', about, numbers.element, charts, h('p', { className: 'quiet hash' }, 'Fingerprint ', hash));
  const refresh = () => {
    const { result } = runner.run;
    setText(about, result ? 'Finished mesh' : `No mesh yet: ${stageInWords(runner.run)}`);
    charts.hidden = result === null;
    setText(hash, result?.report.hash ?? '–');
    numbers.show(result ? figuresOf(result.report) : { final: false });
    if (result === null) return;
    const { quality, cpuSeconds } = result.report;
    eta.show(quality.etaHistogram.map((value, i) => ({ label: (i / 20).toFixed(2), value })), `mean ${quality.etaMean.toFixed(3)}`);
    valence.show(quality.valenceHistogram.slice(2).map((value, i) => ({ label: i + 2 === 9 ? '9+' : String(i + 2), value })),
      `${quality.fourValentPercent.toFixed(1)} % have four`);
    times.show({ seconds: cpuSeconds });
  };
  runner.subscribe(refresh);
  refresh();
}

/** @param {import('lpquad').SurfaceReport} report  @returns {import('../../figures/statistics.js').Figures} */
function figuresOf({ quality, vertices, quads, triangles, singularities, size, hash }) {
  const { etaMean, etaMin, etaP5, fourValentPercent, interiorVertices, valenceHistogram } = quality;
  return { final: true, etaMean, etaMin, etaP5, fourValentPercent, vertices, quads, triangles, hash, size, singularities,
    irregular: interiorVertices - (valenceHistogram[4] ?? 0) };
}
