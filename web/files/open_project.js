// A saved project is opened like any file.
/** @import { App } from '../app' */
import { NotAProject } from '../state/judge.js';
import { isProjectText, readProject } from '../state/project_file.js';

const mostBytes = 2 ** 26;

/** @param {App} app */
export function installOpeningProjects({ openers, keeping, store, stage, notify, announce }) {
  openers.push(async ([file], signal) => {
    if (file === undefined || !file.name.toLowerCase().endsWith('.json') || file.size > mostBytes) return false;
    if (!isProjectText(await file.slice(0, 200).text())) return false;
    try {
      const text = await file.text();
      if (signal.aborted) return true;
      const project = readProject(text);
      keeping.close();
      store.change(`Open ${file.name}`, project);
      stage.fit();
      announce(`${file.name} opened`);
    } catch (error) {
      notify(`${file.name} could not be opened: ${error instanceof NotAProject ? error.message : 'it is damaged'}.`);
    }
    return true;
  });
}
