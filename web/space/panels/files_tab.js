// The Files tab: the mesh in every format that has room for a third coordinate, and a picture.
/** @import { SpaceApp } from '../types' */
/** @import { SurfaceMeshFormat } from 'lpquad' */
import { download } from '../../files/download.js';
import { formats } from '../../files/formats.js';
import { h } from '../../panels/dom.js';
import { icon } from '../../panels/icons.js';

/** @param {SpaceApp} app */
export function installFilesTab(app) {
  const { actions, runner, viewer } = app;
  actions.add({ id: 'file.picture', label: 'Picture as PNG', icon: 'picture', enabled: () => viewer.renderer !== null,
    run: () => viewer.canvas.toBlob((blob) => { if (blob) download(`${fileName(app)}.png`, blob, 'image/png'); }) });
  const list = h('ul', { className: 'formats' });
  const reason = h('p', { className: 'reason', id: 'export-reason' });
  app.tabs.add('files', 'Files', h('section', null, h('h2', null, 'Mesh'), reason, list),
    h('section', null, h('h2', null, 'Picture'), h('div', { className: 'buttons' }, actions.button('file.picture', { labelled: true }))));
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

/** @param {SpaceApp} app */
const fileName = ({ store }) => store.project.name.toLowerCase().replace(/\.[a-z0-9]+$/, '').replace(/[^a-z0-9]+/g, '-') || 'surface';

/** @param {SpaceApp} app  @param {SurfaceMeshFormat} format */
async function save(app, format) {
  const { result } = app.runner.run;
  if (result === null) return app.notify('There is a mesh to save once the run is done.');
  const name = `${fileName(app)}.${format}`;
  try {
    const { report: _, surface: __, ...mesh } = result;
    download(name, await (await app.runner.engine()).writeMesh(mesh, format), formats[format]?.type);
    app.announce(`Saved as ${name}`);
  } catch (error) {
    app.notify(`${name} could not be written: ${/** @type {Error} */ (error).message}`);
  }
}
