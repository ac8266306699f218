// The Layers tab: every layer with its key, its button and what its colours mean just now.
/** @import { App } from '../app' */
/** @import { LayerName } from '../types' */
import { createSideChoice } from '../compare/sides.js';
import { legendOf } from '../draw/legend.js';
import { h } from '../panels/dom.js';
import { atNextPicture } from '../panels/next_picture.js';
import { createKey } from './key.js';
import { showLegend } from './legend.js';
import { inOrder, layerNames } from './names.js';

/** @param {App} app */
export function installLayers(app) {
  const { actions, announce, sides, store, runner, tabs, themes } = app;
  const shown = () => sides.chosen.scene().layers;

  /** @param {LayerName} name  @param {string} title */
  function toggle(name, title) {
    const on = new Set(shown());
    if (!on.delete(name)) on.add(name);
    store.change(`${on.has(name) ? 'Show' : 'Hide'} ${title.toLowerCase()}`, { layers: inOrder(on) });
    announce(`${title} ${on.has(name) ? 'shown' : 'hidden'}`);
  }
  function follow() {
    const auto = store.project.layers === 'auto';
    store.change(auto ? 'Keep these layers' : 'Layers follow the run', { layers: auto ? inOrder(shown()) : 'auto' });
    announce(auto ? 'Layers stay as they are' : 'Layers follow the run');
  }

  actions.add(
    { id: 'layer.auto', label: 'Layers follow the run', keys: ['A'], icon: 'auto',
      pressed: () => store.project.layers === 'auto', run: follow },
    ...layerNames.map(({ name, key, title }) => ({
      id: `layer.${name}`, label: title, keys: [key], pressed: () => shown().has(name), run: () => toggle(name, title),
    })));

  const rows = layerNames.map((layer) => ({ ...layer, legend: h('div', { className: 'legend' }) }));
  tabs.add('layers', 'Layers', createSideChoice(app),
    h('div', { className: 'layers-head buttons' }, 
      actions.button('layer.auto', { labelled: true, title: 'Show what tells most at each stage of the run' }),
      actions.button('view.inspect', {
        text: 'Inspect', title: 'Tells of one element; arrow keys go to its neighbours',
      })),
    h('ul', { className: 'layers' }, ...rows.map(({ name, legend, key, what }) =>
      h('li', null,
        h('div', { className: 'layer' },
          actions.button(`layer.${name}`, { title: what }), h('kbd', { 'aria-hidden': 'true' }, key)),
        legend))));

  const showKey = createKey(app.stage.overlay);
  const refresh = atNextPicture(() => {
    const now = sides.chosen.scene();
    const shown = rows.map((row) => ({ ...row, items: now.layers.has(row.name) ? legendOf(row.name, now) : [] }));
    for (const { legend, items } of shown) showLegend(legend, items);
    showKey(shown);
  });
  store.subscribe(refresh);
  runner.subscribe(refresh);
  sides.subscribe(refresh);
  themes.subscribe(refresh);
  refresh();
}
