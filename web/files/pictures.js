// Pictures of what is on the screen, and the figures of the run as a file.
/** @import { App } from '../app' */
import { h } from '../panels/dom.js';
import { exactJson } from '../state/project_file.js';
import { currentMesh } from './current.js';
import { download } from './download.js';
import { fileNameOf } from './names.js';

/** @param {App} app */
export function createPictures(app) {
  const { actions } = app;
  const has = () => currentMesh(app).mesh !== null;
  actions.add(
    { id: 'file.report', label: 'Report of the run (.json)', icon: 'chart', enabled: has, run: () => saveReport(app) },
  );
  const fingerprint = h('output', { className: 'fingerprint', 'aria-label': 'Fingerprint of the mesh' });
  const element = h('section', null, h('h2', null, 'Pictures and figures'),
    h('div', { className: 'buttons' }, actions.button('file.report', { labelled: true })),
    h('p', { className: 'quiet', title: 'Equal meshes have equal fingerprints, on every machine.' }, 'Fingerprint ', fingerprint));
  const refresh = () => { fingerprint.textContent = currentMesh(app).mesh?.report.hash ?? 'of no mesh yet'; };
  return { element, refresh };
}

/** @param {App} app */
function saveReport(app) {
  const { mesh } = currentMesh(app);
  if (mesh === null) return;
  const name = `${fileNameOf(app.store.project)}.report.json`;
  download(name, `${exactJson(mesh.report)}\n`, 'application/json');
  app.announce(`Saved as ${name}`);
}
