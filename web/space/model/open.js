// Opens surfaces: by the button, dropped anywhere, or handed over by the page for the plane.
/** @import { SpaceApp } from '../types' */
/** @import { Surface } from 'lpquad' */
import { droppedFiles } from '../../files/dropped.js';
import { handOver } from '../../files/hand_over.js';
import { h } from '../../panels/dom.js';
import { keepCadReader, readCadFile } from '../cad/read.js';
import { isCadName, workOf } from './work.js';

const ofThePlane = /\.(json|geojson|svg|poly|dxf)$/i, ofSpace = /\.(stl|obj|ply|off|msh)$/i;
const mostBytes = 256 * 2 ** 20, mostTriangles = 400_000;

/** @param {SpaceApp} app  @param {File} file  @param {AbortSignal} signal  @returns {Promise<Surface>} */
async function read({ runner, notify }, file, signal) {
  if (isCadName(file.name)) {
    const surface = await readCadFile(file, { progress: notify, signal });
    keepCadReader().catch(() => {});
    notify('');
    return surface;
  }
  const engine = await runner.createEngine();  // of its own: a run under way is not held up
  try {
    return await engine.readSurface(new Uint8Array(await file.arrayBuffer()), { name: file.name });
  } finally {
    engine.terminate();
  }
}

const isSurface = (/** @type {string} */ name) => isCadName(name) || ofSpace.test(name);
const isKnown = (/** @type {string} */ name) => isSurface(name) || ofThePlane.test(name);

/** What is wrong with a file in words that name all that the page reads. @param {string} name  @param {unknown} error */
const problemWith = (name, error) => `${name} could not be opened: ${isKnown(name) ? /** @type {Error} */ (error).message
  : 'the page knows files by their endings, and takes .stl, .obj, .ply, .off, .msh, .step, .iges and .brep; drawings go to the page Plane.'}`;

/** Shows that files may be dropped, and takes them. @param {HTMLElement} mark  @param {(files: File[]) => Promise<void>} open
 * @param {() => void} fail  where they cannot be read */
function listenForDrops(mark, open, fail) {
  const hasFiles = (/** @type {DragEvent} */ { dataTransfer }) => dataTransfer?.types.includes('Files') ?? false;
  window.addEventListener('dragover', (event) => {
    event.preventDefault();  // whatever it is: the page is not left
    mark.classList.toggle('dropping', hasFiles(event));
  });
  for (const name of /** @type {const} */ (['dragleave', 'dragend', 'drop'])) window.addEventListener(name, () => mark.classList.remove('dropping'));
  window.addEventListener('drop', (event) => {
    event.preventDefault();
    if (hasFiles(event)) void droppedFiles(event.dataTransfer).then(open, fail);
  });
}

/** @param {SpaceApp} app  @param {HTMLElement} stage  @returns {(files: File[]) => Promise<void>} opens files */
export function installOpening(app, stage) {
  const { store, actions, announce, notify } = app;
  let latest = new AbortController();
  /** @param {File[]} files */
  async function open(files) {
    const file = files.find(({ name }) => isSurface(name)) ?? files.find(({ name }) => isKnown(name)) ?? files[0];
    if (file === undefined) return;
    if (file.size > mostBytes) return notify(`${file.name} has ${Math.round(file.size / 2 ** 20)} MiB; the page takes 256.`);
    announce(`Opening ${file.name}`);
    latest.abort();  // of two files that are opened the second is wanted
    notify('');
    const { signal } = latest = new AbortController();
    try {
      if (ofThePlane.test(file.name)) return await handOver(file, './');
      const surface = await read(app, file, signal);
      if (signal.aborted) return;
      const count = surface.triangles.length / 3;
      if (count > mostTriangles) return notify(`${file.name} has ${count.toLocaleString('en')} triangles; the command line meshes it.`);
      store.change(`Open ${file.name}`, workOf(file.name, surface));
      announce(`${file.name} opened: ${count.toLocaleString('en')} triangles`);
    } catch (error) {
      if (!signal.aborted) notify(problemWith(file.name, error));
    }
  }
  const input = h('input', { type: 'file', hidden: true, 'aria-label': 'Surface to open', onchange: () => {
    void open([...input.files ?? []]);
    input.value = '';
  } });
  document.body.append(input);
  actions.add({ id: 'file.open', label: 'Open a surface', icon: 'open', keys: ['Ctrl+O'], run: () => input.click() });
  listenForDrops(stage, open, () => notify('What was dropped could not be read.'));
  return open;
}
