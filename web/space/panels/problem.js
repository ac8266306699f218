// Over the view: why the surface on the screen has no mesh, with ways out. Gone as soon as it is meshed again.
/** @import { SpaceApp } from '../types' */
import { h, setText } from '../../panels/dom.js';
import { icon } from '../../panels/icons.js';
import { haveSameMesh, workOf } from '../model/work.js';
import { messageInWords, titleOf } from '../run/words.js';

/** @param {SpaceApp} app  @param {HTMLElement} view */
export function installProblem(app, view) {
  const { actions, announce, runner, store } = app;
  addAction(app);
  const title = h('strong'), details = h('span', { className: 'details' });
  const bar = h('section', { className: 'error-bar', 'aria-label': 'Problem', hidden: true }, h('div', { className: 'words' }, icon('warning'), title, details),
    h('div', { className: 'buttons' }, actions.button('edit.undo', { labelled: true }), actions.button('mesh.usual', { labelled: true })));
  view.append(bar);
  /** @type {unknown} */
  let said = null;
  const refresh = () => {
    const { error, phase, work } = runner.run;
    bar.hidden = phase !== 'failed' || error === null || work === null || !haveSameMesh(work, store.project);
    if (bar.hidden || error === null) return;
    setText(title, titleOf(error.code));
    setText(details, messageInWords(error.message));
    if (said !== error) announce(`${title.textContent} ${details.textContent}`);
    said = error;
  };
  runner.subscribe(refresh);
  store.subscribe(refresh);
}

/** @param {SpaceApp} app */
function addAction({ actions, announce, store }) {
  const usual = () => workOf(store.project.name, store.project.surface).options;
  actions.add({ id: 'mesh.usual', label: 'Usual options', icon: 'reset',
    enabled: () => !haveSameMesh(store.project, { ...store.project, options: usual() }),
    run: () => {
      store.change('Usual options', { options: usual() });
      announce('All options are as usual');
    } });
}
