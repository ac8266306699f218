// Pictures of what is on the screen, and the figures of the run as a file.
/** @import { App } from '../app' */
import { pngPicture, svgPicture } from '../draw/picture.js';
import { h } from '../panels/dom.js';
import { exactJson } from '../state/project_file.js';
import { currentMesh, currentName } from './current.js';
import { download } from './download.js';

/** @param {App} app */
export function createPictures(app) {
  const { actions } = app;
  const has = () => currentMesh(app).mesh !== null;
  const save = async (/** @type {'svg' | 'png'} */ ending) => {
    const name = `${currentName(app)}.picture.${ending}`, scene = app.sides.chosen.scene();
    const content = ending === 'svg' ? svgPicture(scene, app.stage.view) : await pngPicture(scene, app.stage.view);
    download(name, content, ending === 'svg' ? 'image/svg+xml' : 'image/png');
    app.announce(`Saved as ${name}`);
  };
  actions.add(
    { id: 'file.svg', label: 'Picture (.svg)', icon: 'picture', run: () => void save('svg') },
    { id: 'file.png', label: 'Picture (.png)', icon: 'picture', run: () => void save('png') },
    { id: 'file.report', label: 'Report of the run (.json)', icon: 'chart', enabled: has, run: () => saveReport(app) },
  );
  const fingerprint = h('output', { className: 'fingerprint', 'aria-label': 'Fingerprint of the mesh' });
  const element = h('section', null, h('h2', null, 'Pictures and figures'),
    h('div', { className: 'buttons' }, actions.button('file.svg', { labelled: true }), actions.button('file.png', { labelled: true }), actions.button('file.report', { labelled: true })),
    h('p', { className: 'quiet', title: 'Equal meshes have equal fingerprints, on every machine.' }, 'Fingerprint ', fingerprint));
  const refresh = () => { fingerprint.textContent = currentMesh(app).mesh?.report.hash ?? 'of no mesh yet'; };
  return { element, refresh };
}

/** @param {App} app */
function saveReport(app) {
  const { mesh } = currentMesh(app);
  if (mesh === null) return;
  const name = `${currentName(app)}.report.json`;
  download(name, `${exactJson(mesh.report)}\n`, 'application/json');
  app.announce(`Saved as ${name}`);
}
