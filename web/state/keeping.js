// The project outlives the page: the address bar follows it, the browser's storage keeps it for the
// next visit, and a link or a chapter's address opens it.
/** @import { App } from '../app' */
/** @import { Project } from '../types' */
/** @import { Place } from './link.js' */
import { NotAProject } from './judge.js';
import { fromFragment, longestLink, toFragment } from './link.js';
import { projectText, readProject } from './project_file.js';
import { emptyProject, haveSameMesh } from './project.js';
import { whenRested } from './rest.js';
import { keep, kept } from './storage.js';

const stored = 'project';

/** @typedef {{project: Project | null, place: Place, notice: string}} Opened */

/** What the page shows `first`: what its address says, else what was there last. The tour takes the place of that.
 * @returns {Promise<Opened & {first: Project | null}>} */
export async function openFirst() {
  const opened = location.hash.length > 1 ? await openFragment(location.hash) : { project: null, place: {}, notice: '' };
  return { ...opened, first: opened.place.chapter ? lastProject() : opened.project ?? lastProject() };
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
  /**
   * The chapter of the tour that was opened last; `shown`: the project that it was opened with, `figure`: the same if it is the chapter's own;
   * `before`: that which the tour took the place of.
   * @type {{id: string, open: boolean, shown: Project | null, figure: Project | null, before: Project}}
   */
  chapter = { id: '', open: false, shown: null, figure: null, before: emptyProject };

  /** @param {Pick<App, 'store' | 'runner' | 'notify'>} app */
  constructor(app) {
    this.#app = app;
    app.store.subscribe((project) => this.#follows(project));
    app.runner.subscribe(() => this.#soon());
    addEventListener('pagehide', () => this.save());
    document.addEventListener('visibilitychange', () => { if (document.hidden) this.save(); });
  }

  /** @param {Project} project  whether it is the open chapter's figure, changed perhaps */
  #ofTour({ drawing }) { return this.chapter.open && drawing === this.chapter.shown?.drawing; }

  /** Whether the tour's figure is on the screen. */
  get inTour() { return this.#ofTour(this.#app.store.project); }

  /** What the person had the layers set to: those of the tour go with its figure. */
  get layers() { return this.inTour ? this.chapter.before.layers : this.#app.store.project.layers; }

  /** @param {string} id  @param {Project} before  what is no longer shown  @param {boolean} own  the chapter's own figure is shown */
  open(id, before, own) {
    const { project } = this.#app.store;
    const first = this.#ofTour(before) ? this.chapter.before : before;
    this.chapter = { id, open: true, shown: project, figure: own ? project : null, before: first };
    const address = `#chapter=${id}`;
    if (own && location.hash !== address) {
      ++this.#turn;
      history.pushState(null, '', address);  // so that Back leads to the chapter before
    }
    this.#soon();
  }

  /** Undo and redo lead out of the tour and into it again. @param {Project} project */
  #follows(project) {
    if (project === this.chapter.before) this.chapter.open = false;
    if (project === this.chapter.shown) this.chapter.open = true;
    this.#soon();
  }

  /** Another project takes the place of the tour's figure. */
  close() {
    this.chapter = { ...this.chapter, open: false };
    this.#soon();
  }

  /** Out of the tour: what it took the place of is there again. */
  leave() {
    if (!this.inTour) return;
    this.close();
    this.#app.store.change('Leave the tour', this.chapter.before);
  }

  /** Where the run stands, if that is not its end. @returns {Place} */
  get place() {
    const { phase, state, project } = this.#app.runner.run;
    const stands = phase === 'paused' && project !== null && haveSameMesh(project, this.#app.store.project) && state !== null && state.tick > 0;
    return { ...(stands && { tick: state.tick }), ...(this.inTour && { chapter: this.chapter.id }) };
  }

  /** The fragment of an address that opens what is on the screen. */
  fragment() {
    const { project } = this.#app.store;
    if (project === this.chapter.figure) return Promise.resolve(`#chapter=${this.chapter.id}`);
    return toFragment(project, this.place);
  }

  async #follow() {
    this.save();
    const turn = ++this.#turn;
    const fragment = await this.fragment();
    if (turn !== this.#turn) return;  // a later one was faster
    history.replaceState(null, '', fragment.length <= longestLink ? fragment : location.pathname + location.search);
  }

  /** Keeps the project for the next visit: the person's, not the tour's. */
  save() {
    const full = !keep(stored, projectText(this.inTour ? this.chapter.before : this.#app.store.project));
    if (full && !this.#full) this.#app.notify('This browser keeps nothing for the next visit: its storage is full or switched off. Save the project as a file.');
    this.#full = full;
  }
}
