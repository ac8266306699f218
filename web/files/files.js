// The Files tab: what leaves the page.
/** @import { App } from '../app' */
import { h } from '../panels/dom.js';
import { createCode } from './code/panel.js';
import { createExport } from './export.js';
import { createPictures } from './pictures.js';

/** @param {App} app */
export function installFiles(app) {
  const { actions, runner, store, tabs } = app;
  const pictures = createPictures(app);
  const project = h('section', null, h('h2', null, 'Project'),
    h('p', { className: 'quiet' }, 'Drawing, options and layers, to open again or to pass on.'),
    h('div', { className: 'buttons' }, actions.button('file.open', { labelled: true }), actions.button('file.save', { labelled: true }), actions.button('page.share', { labelled: true })));
  const native = h('section', null, h('h2', null, 'A native run'),
    h('p', { className: 'quiet' }, 'The folder that lpquad mesh … --stages DIR wrote, to step through.'),
    h('div', { className: 'buttons' }, actions.button('file.stages', { labelled: true })));
  const body = tabs.add('files', 'Files', pictures.element, project);
  const parts = [pictures];
  const refresh = () => { if (!body.hidden) for (const part of parts) part.refresh(); };
  store.subscribe(refresh);
  runner.subscribe(refresh);
  tabs.subscribe(refresh);
  void runner.engine().then((engine) => engine.ready()).then((description) => {
    const more = [createExport(app, description), createCode(app, description.options)];
    parts.push(...more);
    body.prepend(more[0].element);
    body.append(more[1].element, native);
    actions.refresh();
    refresh();
  }, () => {});  // without the mesher there is nothing to write; the run says why
}
