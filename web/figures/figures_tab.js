// The Figures tab: how good the mesh on the screen is, how the cells got there, and what it took.
/** @import { App } from '../app' */
/** @import { Run } from '../types' */
/** @import { Figures } from './statistics.js' */
import { createSideChoice } from '../compare/sides.js';
import { h, setText, withSubscripts } from '../panels/dom.js';
import { stageName } from '../run/words.js';
import { createHistogram } from './bars.js';
import { createCurve } from './curve.js';
import { createNumbers } from './numbers.js';
import { createScrub } from './scrub.js';
import { figuresOf, iterationOf, iteratesOf } from './statistics.js';
import { createTimes } from './times.js';

/** @param {App} app */
export function installFiguresTab(app) {
  const about = h('h2', { className: 'figures-of' });
  const hash = h('code', { title: 'Equal meshes have equal fingerprints, here and on the command line.' });
  const parts = [createCurves(app), createNumbers(), createQuality(), createTimes()];
  const body = app.tabs.add('figures', 'Figures', createSideChoice(app), about, ...parts.map(({ element }) => element),
    h('p', { className: 'quiet hash' }, 'Fingerprint ', hash));
  const refresh = () => {
    if (body.hidden) return;
    const { runner: { run }, scene } = app.sides.chosen;
    const { freshness } = scene();
    const figures = figuresOf(run);
    setText(about, titleOf(run, figures, freshness !== 'current'));
    body.classList.toggle('out-of-date', freshness !== 'current');
    setText(hash, figures.hash ?? '–');
    for (const { show } of parts) show(figures, run);
  };
  app.runner.subscribe(refresh);
  app.store.subscribe(refresh);
  app.sides.subscribe(refresh);
  new MutationObserver(refresh).observe(body, { attributeFilter: ['hidden'] });
  refresh();
}

/** @param {Run} run  @param {Figures} figures  @param {boolean} old */
function titleOf({ frame }, { final }, old) {
  if (frame === null) return 'No mesh yet';
  const what = final ? 'Finished mesh' : stageName(frame).replace(/^./, (letter) => letter.toUpperCase());
  return old ? `Out of date: ${what}` : what;
}

/** @param {App} app */
function createCurves({ sides }) {
  const scrub = createScrub(() => sides.chosen.runner);
  const energy = createCurve({ name: 'Energy F',
    help: 'The Lp energy of the cells, without unit. Point at the curve to see the cells at that iteration.' }, scrub);
  const slope = createCurve({ name: 'Slope ‖g‖, logarithmic', log: true,
    help: 'How steeply the energy still falls at each iteration, without unit.' }, scrub);
  const none = h('p', { className: 'quiet' }, ...withSubscripts('This run has no L_p iterations: its first points are aligned already. '
    + 'Choose isotropic first points in the Mesh tab to see cells settle.'));
  const curves = h('div', null, energy.element, slope.element);
  /** @param {Figures} _  @param {Run} run */
  function show(_, run) {
    const { iterates, planned } = iteratesOf(run);
    const early = run.state === null || run.state.stage === 'seeds' || run.state.stage === 'optimise';
    none.hidden = iterates.length > 0 || early;
    curves.hidden = iterates.length === 0;
    const at = iterationOf(run.frame, iterates);
    energy.show(iterates.map((one) => ({ x: one.iteration, y: one.energy })), planned, at);
    slope.show(iterates.map((one) => ({ x: one.iteration, y: one.gradientNorm })), planned, at);
  }
  return { element: h('div', null, none, curves), show };
}

function createQuality() {
  const eta = createHistogram({ name: 'Quads by squareness η', heads: ['η', 'Quads'],
    help: 'How many quads there are in each twentieth from 0 to 1.' });
  const valence = createHistogram({ name: 'Vertices by number of quads', heads: ['Quads at a vertex', 'Vertices'],
    help: 'How many quads meet at interior vertices; four is regular.' });
  const element = h('div', { hidden: true }, eta.element, valence.element);
  /** @param {Figures} figures */
  function show({ etaHistogram, valenceHistogram, etaMean, fourValentPercent }) {
    element.hidden = etaHistogram === undefined || valenceHistogram === undefined;
    if (etaHistogram === undefined || valenceHistogram === undefined) return;
    eta.show(etaHistogram.map((value, i) => ({ label: (i / 20).toFixed(2), value })), `mean ${etaMean?.toFixed(3)}`);
    valence.show(valenceHistogram.slice(2).map((value, i) => ({ label: i + 2 === 9 ? '9+' : String(i + 2), value })),
      fourValentPercent === undefined ? '' : `${fourValentPercent.toFixed(1)} % have four`);
  }
  return { element, show };
}
