// The Files tab: what leaves the page.
/** @import { App } from '../app' */
/** @import { OptionInfo } from 'lpquad' */
import { createSideChoice } from '../compare/sides.js';
import { h } from '../panels/dom.js';
import { toCommand } from './code/command.js';
import { toCpp } from './code/cpp.js';
import { toJavaScript } from './code/javascript.js';
import { createCode } from './code/panel.js';
import { currentMesh, currentName } from './current.js';
import { createExport } from './export.js';
import { createPictures } from './pictures.js';
import { installTab } from './tab.js';

/** @param {App} app */
export function installFiles(app) {
  const { actions } = app;
  const pictures = createPictures(app);
  const project = h('section', null, h('h2', null, 'Project'),
    h('p', { className: 'quiet' }, 'Drawing, options and layers, to open again or to pass on.'),
    h('div', { className: 'buttons' }, actions.button('file.open', { labelled: true }), actions.button('file.save', { labelled: true }), actions.button('page.share', { labelled: true })));
  const native = h('section', null, h('h2', null, 'A native run'),
    h('p', { className: 'quiet' }, 'The folder that lpquad mesh … --stages DIR wrote, to step through.'),
    h('div', { className: 'buttons' }, actions.button('file.stages', { labelled: true })));
  const exporting = { ...app, current: () => currentMesh(app), name: () => currentName(app) };
  const refresh = installTab(app, [pictures, { element: project }], ({ meshFormats, options, writeOptions }) => ({
    above: [{ element: createSideChoice(app) }, createExport(exporting, meshFormats, writeOptions)],
    below: [createCode(app, languagesOf(app, options), 'Makes the same mesh, bit for bit.'), { element: native }],
  }));
  app.sides.subscribe(refresh);
}

/** @param {App} app  @param {OptionInfo[]} known */
function languagesOf(app, known) {
  const by = (/** @type {typeof toCpp} */ write) => () => write(app.sides.chosen.project(), known, currentName(app));
  return {
    javascript: { title: 'JavaScript', write: by(toJavaScript) },
    cpp: { title: 'C++', write: by(toCpp) },
    command: { title: 'Command line', write: by(toCommand) },
  };
}
