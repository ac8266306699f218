// The Files tab: the mesh in every format that has room for a third coordinate, and a picture.
/** @import { SpaceApp } from '../types' */
/** @import { SurfaceMeshFormat } from 'lpquad' */
import { surfaceAsObj } from 'lpquad/cad';
import { copy, download } from '../../files/download.js';
import { formats } from '../../files/formats.js';
import { h } from '../../panels/dom.js';
import { icon } from '../../panels/icons.js';
import { fileNameOf, toCommand, toJavaScript } from '../model/code.js';
import { toFragment } from '../model/link.js';

/** @param {SpaceApp} app */
export function installFilesTab(app) {
  const { actions, runner, viewer } = app;
  actions.add({ id: 'file.picture', label: 'Picture as PNG', icon: 'picture', enabled: () => viewer.renderer !== null,
    run: () => viewer.canvas.toBlob((blob) => { if (blob) download(`${fileNameOf(app.store.project)}.png`, blob, 'image/png'); }) });
  actions.add(
    { id: 'file.surface', label: 'Surface as OBJ', icon: 'download',
      run: () => download(`${fileNameOf(app.store.project)}.obj`, surfaceAsObj(app.store.project.surface)) },
    { id: 'page.share', label: 'Copy the link', icon: 'share', keys: ['Shift+S'], enabled: () => app.store.project.preset !== undefined,
      run: () => void tryToCopy(app, location.href.replace(/#.*$/, '') + toFragment(app.store.project), 'The link is copied.') });
  const code = createCode(app);
  const list = h('ul', { className: 'formats' });
  const reason = h('p', { className: 'reason', id: 'export-reason' });
  app.tabs.add('files', 'Files', h('section', null, h('h2', null, 'Mesh'), reason, list),
    h('section', null, h('h2', null, 'Surface'), h('div', { className: 'buttons' },
      actions.button('file.surface', { labelled: true }), actions.button('page.share', { labelled: true }))),
    code.element, h('section', null, h('h2', null, 'Picture'), h('div', { className: 'buttons' }, actions.button('file.picture', { labelled: true }))));
  const refresh = async () => {
    const ready = runner.run.result !== null;
    reason.hidden = ready;
    reason.textContent = ready ? '' : 'There is a mesh to save once the run is done.';
    for (const button of list.querySelectorAll('button')) button.setAttribute('aria-disabled', String(!ready));
    if (list.childElementCount > 0 || !ready) return;
    const { surfaceMeshFormats } = await (await runner.engine()).ready();
    if (list.childElementCount === 0) list.append(...surfaceMeshFormats.map((format) => row(app, format)));
  };
  runner.subscribe(() => void refresh());
  void refresh();
}

/** @param {SpaceApp} app  @param {SurfaceMeshFormat} format */
function row(app, format) {
  const { title, use } = formats[format] ?? { title: format.toUpperCase(), use: '' };
  return h('li', null, h('button', { type: 'button', 'data-format': format, 'aria-label': `Download .${format}`,
    'aria-describedby': 'export-reason', onclick: () => void save(app, format) }, icon('download'), `.${format}`),
  h('span', null, h('strong', null, title), ` – ${use}`));
}

/** @param {SpaceApp} app  @param {string} text  @param {string} said */
async function tryToCopy({ notify }, text, said) {
  notify(await copy(text) ? said : 'This browser does not let the page copy.');
}

/** "Copy as code". @param {SpaceApp} app */
function createCode(app) {
  const text = h('code'), view = h('pre', { className: 'code', tabIndex: 0, 'aria-label': 'Code', role: 'region' }, text);
  const language = h('select', { 'aria-label': 'Language', onchange: () => void refresh() },
    h('option', { value: 'javascript' }, 'JavaScript'), h('option', { value: 'command' }, 'Command line'));
  const refresh = async () => {
    const { surfaceOptions } = await (await app.runner.engine()).ready();
    text.textContent = (language.value === 'command' ? toCommand : toJavaScript)(app.store.project, surfaceOptions);
  };
  app.actions.add({ id: 'file.code', label: 'Copy as code', icon: 'copy',
    run: () => void refresh().then(() => tryToCopy(app, text.textContent ?? '', 'The code is copied.')) });
  const quietly = () => void refresh().catch(() => {});  // the run says what is wrong with the mesher
  app.store.subscribe(quietly);
  quietly();
  return { element: h('section', null, h('h2', null, 'As code'),
    h('p', { className: 'quiet' }, 'Makes the same mesh, bit for bit, from the file of the surface.'),
    h('div', { className: 'buttons' }, language, app.actions.button('file.code', { labelled: true })), view) };
}

/** @param {SpaceApp} app  @param {SurfaceMeshFormat} format */
async function save(app, format) {
  const { result } = app.runner.run;
  if (result === null) return app.notify('There is a mesh to save once the run is done.');
  const name = `${fileNameOf(app.store.project)}.${format}`;
  try {
    const { report: _, surface: __, ...mesh } = result;
    download(name, await (await app.runner.engine()).writeMesh(mesh, format), formats[format]?.type);
    app.announce(`Saved as ${name}`);
  } catch (error) {
    app.notify(`${name} could not be written: ${/** @type {Error} */ (error).message}`);
  }
}
