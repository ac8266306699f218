// Opens surfaces: by the button, dropped anywhere, or handed over by the page for the plane.
/** @import { SpaceApp } from '../types' */
/** @import { Surface } from 'lpquad' */
import { listenForDrops } from '../../files/dropped.js';
import { handOver } from '../../files/hand_over.js';
import { besideThePage, createReading } from '../../files/reading.js';
import { h } from '../../panels/dom.js';
import { keepCadReader, readCadFile } from '../cad/read.js';
import { isCadName, workOf } from './work.js';

const ofThePlane = /\.(json|geojson|svg|poly|dxf)$/i, ofSpace = /\.(stl|obj|ply|off|msh)$/i;
const mostBytes = 256 * 2 ** 20, mostTriangles = 400_000;

/** Nothing: it belongs on the other page. @param {File} file  @param {AbortSignal} signal  @param {(words: string) => void} progress
 * @returns {Promise<Surface | void>} */
async function read(file, signal, progress) {
  if (ofThePlane.test(file.name)) return handOver(file, './', signal);
  if (!isCadName(file.name))
    return besideThePage(signal, async (engine) => engine.readSurface(new Uint8Array(await file.arrayBuffer()), { name: file.name }));
  const surface = await readCadFile(file, { progress, signal });
  keepCadReader().catch(() => {});
  return surface;
}

const isSurface = (/** @type {string} */ name) => isCadName(name) || ofSpace.test(name);
const isKnown = (/** @type {string} */ name) => isSurface(name) || ofThePlane.test(name);

/** What is wrong with a file in words that name all that the page reads. @param {string} name  @param {unknown} error */
const problemWith = (name, error) => `${name} could not be opened: ${isKnown(name) ? /** @type {Error} */ (error).message
  : 'the page knows files by their endings, and takes .stl, .obj, .ply, .off, .msh, .step, .iges and .brep; drawings go to the page Plane.'}`;

/** @param {SpaceApp} app  @param {HTMLElement} stage  @returns {(files: File[]) => Promise<void>} opens files */
export function installOpening(app, stage) {
  const { store, actions, announce, notify } = app;
  const reading = createReading(app);
  /** @param {File[]} files */
  async function open(files) {
    const file = files.find(({ name }) => isSurface(name)) ?? files.find(({ name }) => isKnown(name)) ?? files[0];
    if (file === undefined) return;
    announce(`Opening ${file.name}`);
    notify('');
    try {
      if (file.size > mostBytes) throw new Error(`It has ${Math.round(file.size / 2 ** 20)} MiB; the page takes 256.`);
      const surface = await reading(file.name, (signal, progress) => read(file, signal, progress));
      if (!surface) return;  // it was given up, or is on the other page
      const count = surface.triangles.length / 3;
      if (count > mostTriangles) throw new Error(`It has ${count.toLocaleString('en')} triangles; the page takes 400,000, the command line more.`);
      store.change(`Open ${file.name}`, workOf(file.name, surface));
      announce(`${file.name} opened: ${count.toLocaleString('en')} triangles`);
    } catch (error) {
      notify(problemWith(file.name, error));
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
