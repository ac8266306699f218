// The Files tab: the mesh in every format that has room for a third coordinate, the surface, code, and a picture.
/** @import { SpaceApp, Work } from '../types' */
/** @import { OptionInfo } from 'lpquad' */
import { surfaceAsObj } from 'lpquad/cad';
import { createCode } from '../../files/code/panel.js';
import { meshOf } from '../../files/current.js';
import { copy, download } from '../../files/download.js';
import { createExport } from '../../files/export.js';
import { installTab } from '../../files/tab.js';
import { h, setText } from '../../panels/dom.js';
import { fileNameOf, surfaceFileOf, toCommand, toJavaScript } from '../model/code.js';
import { toFragment } from '../model/link.js';
import { haveSameMesh } from '../model/work.js';

/** @param {SpaceApp} app */
export function installFilesTab(app) {
  const { store } = app;
  addActions(app);
  const exporting = { ...app, current: () => currentMesh(app), name: () => fileNameOf(store.project) };
  installTab(app, [surfaceSection(app), section(app, 'Picture', 'file.picture')],
    ({ surfaceMeshFormats, surfaceOptions, writeOptions }) => ({
      // The elements of a surface are shells: there is nothing to choose.
      above: [createExport(exporting, surfaceMeshFormats, writeOptions.filter(({ name }) => name !== 'inpElement'))],
      below: [createCode(app, languagesOf(app, surfaceOptions), 'Makes the same mesh, bit for bit, from the file of the surface.')],
    }));
}

/** @param {Pick<SpaceApp, 'runner' | 'store'>} app */
const currentMesh = ({ runner: { run }, store }) =>
  meshOf(run, run.work !== null && haveSameMesh(run.work, store.project), store.gesture !== '');

/** @param {SpaceApp} app  @param {string} title  @param {...string} ids  actions */
const section = ({ actions }, title, ...ids) => ({ element: h('section', null, h('h2', null, title),
  h('div', { className: 'buttons' }, ...ids.map((id) => actions.button(id, { labelled: true })))) });

/** @param {SpaceApp} app */
function surfaceSection(app) {
  const { element } = section(app, 'Surface', 'file.surface', 'page.share');
  const reason = h('p', { className: 'reason' });
  element.append(reason);
  const refresh = () => {
    setText(reason, noLink(app.store.project));
    reason.hidden = reason.textContent === '';
  };
  refresh();
  return { element, refresh };
}

/** Why there is no link; '': there is one. @param {Work} work */
const noLink = ({ name, preset }) => (preset === undefined ? `No link holds a file: pass ${name} on with the code below.` : '');

/** @param {SpaceApp} app */
function addActions({ actions, announce, notify, store, viewer }) {
  const save = (/** @type {string} */ name, /** @type {BlobPart} */ content, /** @type {string} */ type) => {
    download(name, content, type);
    announce(`Saved as ${name}`);
  };
  const copyLink = async () => {
    const copied = await copy(location.href.replace(/#.*$/, '') + toFragment(store.project));
    notify(copied ? 'The link is copied.' : 'This browser does not let the page copy. The link is in the address bar.');
  };
  actions.add(
    { id: 'file.surface', label: 'Surface as OBJ', icon: 'download', run: () => save(surfaceFileOf(store.project), surfaceAsObj(store.project.surface), 'text/plain') },
    { id: 'page.share', label: 'Copy the link', icon: 'share', keys: ['Shift+S'], enabled: () => noLink(store.project) === '',
      hint: () => noLink(store.project), run: () => void copyLink() },
    { id: 'file.picture', label: 'Picture as PNG', icon: 'picture', enabled: () => viewer.renderer !== null,
      run: () => viewer.canvas.toBlob((blob) => { if (blob) save(`${fileNameOf(store.project)}.png`, blob, 'image/png'); }) },
  );
}

/** @param {SpaceApp} app  @param {OptionInfo[]} known */
const languagesOf = ({ store }, known) => ({
  javascript: { title: 'JavaScript', write: () => toJavaScript(store.project, known) },
  command: { title: 'Command line', write: () => toCommand(store.project, known) },
});
