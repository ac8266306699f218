// The Surface tab: where a surface comes from, and what was found in it.
/** @import { SpaceApp, SurfaceRun } from '../types' */
import { once } from '../../draw/once.js';
import { h } from '../../panels/dom.js';
import { firstWhereSmall } from '../../panels/small.js';
import { licences, source } from '../cad/files.js';
import { presetWork } from '../model/link.js';
import { presets } from '../presets/presets.js';

/** @param {SpaceApp} app */
export function installSurfaceTab(app) {
  const { actions, store, runner } = app;
  for (const { id, title } of presets)
    actions.add({ id: `preset.${id}`, label: title, pressed: () => store.project.preset === id, run: () => {
      store.change(`Open ${title.toLowerCase()}`, { ...presetWork(id), layers: store.project.layers });
      app.announce(`${title} opened`);
    } });
  const facts = h('dl', { className: 'numbers-list' });
  const repairs = h('ul', { className: 'warnings' });
  const begin = h('section', { 'aria-label': 'Surfaces to begin with' }, h('h2', null, 'To begin with'),
    h('ul', { className: 'space-presets' }, ...presets.map(({ id, title, about }) => {
      const button = actions.button(`preset.${id}`);
      button.replaceChildren(h('img', { src: `surfaces/${id}.png`, alt: '' }), h('strong', null, title), h('span', { className: 'quiet' }, about));
      return h('li', null, button);
    })));
  app.tabs.add('surface', 'Surface',
    h('p', { className: 'quiet' }, 'Drop a file here: STL, OBJ, PLY, OFF, Gmsh triangles, STEP, IGES or BREP.'),
    h('div', { className: 'buttons' }, actions.button('file.open', { labelled: true })), aboutCad(),
    begin,
    h('h2', null, 'This surface'), facts, repairs);
  firstWhereSmall(begin);
  const refresh = () => {
    facts.replaceChildren(...factsOf(app, runner.run).map(([name, value]) =>
      h('div', null, h('dt', null, name), h('dd', { className: 'numbers' }, value))));
    repairs.replaceChildren(...warningsOf(runner.run).map((text) => h('li', null, text)));
  };
  store.subscribe(refresh);
  runner.subscribe(refresh);
  refresh();
}

/** Whose work reads CAD files: it is no part of lpquad. */
const aboutCad = () => h('details', { className: 'quiet' }, h('summary', null, 'What reads STEP, IGES and BREP'),
  h('p', null, 'The package ', h('a', { href: source }, 'occt-import-js'), ' (7.6 MB), with Open CASCADE Technology inside. It is fetched with the first '
    + 'such file, runs on your machine, and has a licence of its own, LGPL-2.1: ',
  ...Object.entries(licences).flatMap(([name, url], k) => [k ? ', ' : '', h('a', { href: url }, name)]), '.'));

const count = (/** @type {number} */ value) => value.toLocaleString('en');
const different = (/** @type {ArrayLike<number> & Iterable<number>} */ values) => once(values, 'different', () => count(new Set(values).size));

/** @param {SpaceApp} app  @param {SurfaceRun} run  @returns {[string, string][]} */
function factsOf({ store }, { frame }) {
  const { surface } = store.project;
  /** @type {[string, string][]} */
  const facts = [['Triangles', count(surface.triangles.length / 3)], ['Points', count(surface.points.length / 3)]];
  if (surface.bodyNames?.length) facts.push(['Bodies', count(surface.bodyNames.length)]);
  if (surface.groupNames?.length) facts.push(['Groups', count(surface.groupNames.length)]);
  const { features, charts } = frame;
  if (features) {
    facts.push(['Faces between sharp edges', different(features.faces)]);
    facts.push(['Sharp and border edges', count(features.edges.length / 2)]);
    facts.push(['Corners', count(features.corners.length)]);
  }
  if (charts) facts.push(['Charts', different(charts.charts)]);
  return facts;
}

/** @param {SurfaceRun} run */
const warningsOf = ({ work, result }) =>
  [...work?.surface.warnings ?? [], ...result?.report.warnings ?? []].map(({ message }) => message);
