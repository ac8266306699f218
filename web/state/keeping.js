// The project outlives the page: the address bar follows it, the browser's storage keeps it for the
// next visit, and a link or a chapter's address opens it.
/** @import { App } from '../app' */
/** @import { Project } from '../types' */
/** @import { Place } from './link.js' */
import { NotAProject } from './judge.js';
import { fromFragment, longestLink, toFragment } from './link.js';
import { projectText, readProject } from './project_file.js';
import { haveSameMesh } from './project.js';
import { whenRested } from './rest.js';
import { keep, kept } from './storage.js';

const stored = 'project';

/** @typedef {{project: Project | null, place: Place, notice: string}} Opened */

/** What the page shows first: what its address says, else what was there last. @returns {Promise<Opened>} */
export async function openFirst() {
  if (location.hash.length > 1) {
    const opened = await openFragment(location.hash);
    if (opened.project !== null || opened.place.chapter) return opened;
    return { ...opened, project: lastProject() };
  }
  return { project: lastProject(), place: {}, notice: '' };
}

/** @param {string} fragment  @returns {Promise<Opened>} */
export async function openFragment(fragment) {
  try {
    return { ...await fromFragment(fragment), notice: '' };
  } catch (error) {
    const why = error instanceof NotAProject ? error.message : 'it is damaged';
    return { project: null, place: {}, notice: `This link could not be opened: ${why}.` };
  }
}

/** @returns {Project | null} */
function lastProject() {
  const text = kept(stored);
  if (text === null) return null;
  try {
    return readProject(text);
  } catch {
    return null;  // of an older page, or damaged: as on the first visit
  }
}

export class Keeping {
  #app;
  #soon = whenRested(() => void this.#follow());
  #turn = 0;
  #full = false;
  /** Which chapter of the tour is open, and the project as it set it. @type {{id: string, project: Project | null}} */
  chapter = { id: '', project: null };

  /** @param {Pick<App, 'store' | 'runner' | 'notify'>} app */
  constructor(app) {
    this.#app = app;
    app.store.subscribe(() => this.#soon());
    app.runner.subscribe(() => this.#soon());
    addEventListener('pagehide', () => this.save());
    document.addEventListener('visibilitychange', () => { if (document.hidden) this.save(); });
  }

  /** @param {string} id  @param {Project | null} project  the chapter's own figure, if that is shown */
  open(id, project) {
    this.chapter = { id, project };
    this.#soon();
  }

  /** Where the run stands, if that is not its end. @returns {Place} */
  get place() {
    const { phase, state, project } = this.#app.runner.run;
    const stands = phase === 'paused' && project !== null && haveSameMesh(project, this.#app.store.project) && state !== null && state.tick > 0;
    return { ...(stands && { tick: state.tick }), ...(this.chapter.id && { chapter: this.chapter.id }) };
  }

  /** The fragment of an address that opens what is on the screen. */
  fragment() {
    const { project } = this.#app.store;
    if (this.chapter.id && project === this.chapter.project) return Promise.resolve(`#chapter=${this.chapter.id}`);
    return toFragment(project, this.place);
  }

  async #follow() {
    this.save();
    const turn = ++this.#turn;
    const fragment = await this.fragment();
    if (turn !== this.#turn) return;  // a later one was faster
    history.replaceState(null, '', fragment.length <= longestLink ? fragment : location.pathname + location.search);
  }

  /** Keeps the project for the next visit. */
  save() {
    const full = !keep(stored, projectText(this.#app.store.project));
    if (full && !this.#full) this.#app.notify('This browser keeps nothing for the next visit: its storage is full or switched off. Save the project as a file.');
    this.#full = full;
  }
}
