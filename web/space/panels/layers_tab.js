// The Layers tab: every layer with its key, its button and what its colours mean just now.
/** @import { LegendItem } from '../../draw/legend.js' */
/** @import { SpaceApp, SpaceLayer, SurfaceRun } from '../types' */
/** @import { Palette } from '../../types' */
import { highestDensity } from '../../draw/layers/cells.js';
import { directions, short, singularities } from '../../draw/legend.js';
import { markOf } from '../../draw/marks.js';
import { once } from '../../draw/once.js';
import { dark, light } from '../../draw/palette.js';
import { createKey } from '../../layers/key.js';
import { showLegend } from '../../layers/legend.js';
import { h } from '../../panels/dom.js';
import { counted } from '../../run/words.js';
import { inOrder, layerNames } from '../model/work.js';
import { irregularOnFeatures, irregularVertices } from '../view/geometry.js';

/** @param {SpaceApp} app */
export function installLayersTab(app) {
  const { actions, announce, runner, store, tabs, themes } = app;
  actions.add(
    { id: 'layer.auto', label: 'Layers follow the run', keys: ['A'], icon: 'auto', pressed: () => store.project.layers === 'auto',
      run: () => store.change('Layers follow the run', { layers: store.project.layers === 'auto' ? inOrder(app.layers()) : 'auto' }) },
    ...layerNames.map(({ name, key, title }) => ({ id: `layer.${name}`, label: title, keys: [key], pressed: () => app.layers().has(name),
      run: () => {
        const on = new Set(app.layers());
        if (!on.delete(name)) on.add(name);
        store.change(`${on.has(name) ? 'Show' : 'Hide'} ${title.toLowerCase()}`, { layers: inOrder(on) });
        announce(`${title} ${on.has(name) ? 'shown' : 'hidden'}`);
      } })));
  const rows = layerNames.map((layer) => ({ ...layer, legend: h('div', { className: 'legend' }) }));
  tabs.add('layers', 'Layers',
    h('div', { className: 'layers-head buttons' }, actions.button('layer.auto', { labelled: true })),
    h('ul', { className: 'layers' }, ...rows.map(({ name, legend, key, what }) => h('li', null,
      h('div', { className: 'layer' }, actions.button(`layer.${name}`, { title: what }), h('kbd', { 'aria-hidden': 'true' }, key)), legend))));
  const showKey = createKey(app.viewer.canvas);
  const refresh = () => {
    const palette = themes.dark ? dark : light;
    showKey(rows.map(({ name, title, legend }) => {
      const shown = app.layers().has(name), gone = name === 'cells' && runner.run.phase === 'done';
      const items = shown || gone ? legends[name](runner.run, palette) : [];
      showLegend(legend, items);
      legend.parentElement?.classList.toggle('quiet', gone);
      return { title, items };
    }));
  };
  store.subscribe(refresh);
  runner.subscribe(refresh);
  themes.subscribe(refresh);
  refresh();
}

/** @type {LegendItem[]} */
const notYet = [{ kind: 'text', text: 'Nothing yet at this stage.' }];

/** @type {Record<SpaceLayer, (run: SurfaceRun, palette: Palette) => LegendItem[]>} */
const legends = {
  surface: ({ frame }) => (frame.surface ? [{ kind: 'text', text: counted(frame.surface.triangles.length / 3, 'triangle') }] : notYet),
  features: ({ frame }, palette) => (frame.features
    ? [{ kind: 'line', colour: palette.boundary, width: 2.5, text: counted(frame.features.edges.length / 2, 'edge') }] : notYet),
  charts: ({ frame }, palette) => (frame.charts
    ? [{ kind: 'line', colour: palette.faint, width: 1.5, text: `${counted(new Set(frame.charts.charts).size, 'chart')}; cuts between them` }]
    : notYet),
  crosses: ({ frame }, palette) => (frame.crosses
    ? [directions(palette), ...singularities(frame.crosses.indices, palette)]
    : notYet),
  cells: ({ frame }, palette) => (frame.cells
    ? [{ kind: 'ramp', ramp: palette.ramps.density, low: '1', high: `≥ ${highestDensity}`, of: 'energy per area; a square has 1' }]
    : [{ kind: 'text', text: `Only while a chart is meshed${frame.quads ? ': run again, and pause there' : ''}.` }]),
  quads: ({ frame }, palette) => (frame.quads
    ? [{ kind: 'line', colour: palette.ink, width: 1, text: counted(frame.quads.quads.length / 4, 'quad') }] : notYet),
  quality: ({ frame }, palette) => {
    if (!frame.quads) return notYet;
    const eta = frame.quads.eta.subarray(0, frame.quads.quads.length / 4);
    const of = `mean ${short(eta.reduce((sum, one) => sum + one, 0) / eta.length)}, least ${short(eta.reduce((a, b) => Math.min(a, b), 1))}`;
    return [{ kind: 'ramp', ramp: palette.ramps.quality, low: '≤ 0.4', high: '1', of }];
  },
  valence: ({ frame }, palette) => (frame.quads ? [...marksOf(frame.quads, palette), ...onFeatures(frame.quads)] : notYet),
};

/** @param {NonNullable<SurfaceRun['frame']['quads']>} quads  @param {Palette} palette  @returns {LegendItem[]} */
const marksOf = (quads, palette) => [...irregularVertices(quads)].sort(([a], [b]) => a - b).map(([excess, vertices]) => {
  const { shape, colour, text, key } = markOf(palette, excess);
  return { kind: 'mark', shape, colour, hollow: false, text: `${vertices.length} with ${text}`, key };
});

/** The figures count these too. @param {NonNullable<SurfaceRun['frame']['quads']>} quads  @returns {LegendItem[]} */
function onFeatures(quads) {
  const count = once(quads, 'irregular on features', () => irregularOnFeatures(quads));
  return count === 0 ? [] : [{ kind: 'text', text: `${count} more on sharp edges, not marked: corners have numbers of their own.` }];
}
