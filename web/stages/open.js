// Opens the folder that `lpquad mesh … --stages DIR` wrote, chosen or dropped, as a run of its own:
// the same timeline, layers and figures step through what the native program did.
/** @import { App } from '../app' */
/** @import { WorkerSession } from 'lpquad/worker' */
import { h } from '../panels/dom.js';
import { emptyProject } from '../state/project.js';
import { BadStages } from './parse.js';
import { isStagesFolder, readStages, RecordedSession } from './recording.js';

const mostBytes = 2 ** 29;

/** @param {App} app */
export function installStages(app) {
  const { actions, openers, notify } = app;
  const take = async (/** @type {File[]} */ files, /** @type {AbortSignal} */ signal) => {
    if (!isStagesFolder(files.map(({ name }) => name))) return false;
    await open(app, files, signal);
    return true;
  };
  openers.unshift(take);
  const input = h('input', { type: 'file', hidden: true, 'aria-label': 'Folder of stages', webkitdirectory: true, onchange: async () => {
    const files = [...input.files ?? []];
    input.value = '';
    if (files.length > 0 && await app.reading('the folder', (signal) => take(files, signal)) === false) notify('This is not a folder that lpquad mesh --stages wrote: hardly any of its files are there.');
  } });
  document.body.append(input);
  actions.add({ id: 'file.stages', label: 'Open the stages of a native run', icon: 'open', run: () => input.click() });
}

/** @param {App} app  @param {File[]} files  @param {AbortSignal} signal */
async function open({ keeping, store, stage, recordings, notify, announce }, files, signal) {
  try {
    if (files.reduce((sum, { size }) => sum + size, 0) > mostBytes) throw new BadStages('It is larger than 512 MiB.');
    const texts = new Map(await Promise.all(files.filter(({ name }) => /\.(json|obj)$/.test(name)).map(async (file) => /** @type {const} */ ([file.name, await file.text()]))));
    const iterates = await files.find(({ name }) => name === 'iterates.bin')?.arrayBuffer();
    if (signal.aborted) return;
    const recording = readStages(texts, iterates);
    const name = files[0].webkitRelativePath.split('/')[0] || 'native run';
    const project = { ...emptyProject, name, drawing: recording.drawing, options: { norm: recording.norm } };
    recordings.push({ project, open: async () => /** @type {WorkerSession} */ (/** @type {unknown} */ (new RecordedSession(recording))) });
    keeping.close();
    store.change(`Open the stages in ${name}`, project);
    stage.fit();
    announce(`${name} opened: ${recording.steps.length} steps of a native run`);
  } catch (error) {
    notify(`The stages could not be opened. ${error instanceof BadStages ? error.message : 'A file is damaged.'}`);
  }
}
