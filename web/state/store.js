// The one place where the project lives, with everything it was before. Changes make new objects;
// undo is going back to an old one.
import { weightBeside } from './weight.js';

const remembered = 500;  // states; they share what did not change
const mostBytes = 1e8;   // of what they do not share: a phone has some hundred megabytes for a page

/** What undo or redo comes back to. `bytes`: what would be free without it.
 * @template P  @typedef {{label: string, project: P, bytes: number}} Step */

/** @template {object} P  of plain values */
export class Store {
  /** @type {Step<P>[]} */
  #past = [];
  /** @type {Step<P>[]} */
  #future = [];
  /** @type {P} */
  #project;
  /** @type {Set<(project: P, before: P) => void>} */
  #listeners = new Set();
  #merging = '';

  /** @param {P} project */
  constructor(project) {
    this.#project = project;
  }

  get project() { return this.#project; }
  get canUndo() { return this.#past.length > 0; }
  get canRedo() { return this.#future.length > 0; }
  /** What undo would take back, in words. */
  get undoLabel() { return this.#past.at(-1)?.label ?? ''; }
  get redoLabel() { return this.#future.at(-1)?.label ?? ''; }

  /** @param {(project: P, before: P) => void} listener  @returns {() => void} ends it */
  subscribe(listener) {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }

  /**
   * @param {string} label  what was done, in words
   * @param {Partial<P> | ((project: P) => Partial<P>)} change
   * @param {string} [gesture]  changes of one gesture (a drag, a slider) are undone together
   */
  change(label, change, gesture = '') {
    const before = this.#project;
    const part = typeof change === 'function' ? change(before) : change;
    if (Object.keys(part).every((key) => part[/** @type {keyof P} */ (key)] === before[/** @type {keyof P} */ (key)])) return;
    if (gesture === '' || gesture !== this.#merging) this.#remember(label, before);
    this.#merging = gesture;
    this.#future.length = 0;
    this.#become({ ...before, ...part });
  }

  /** The newest step stays, however large. @param {string} label  @param {P} project */
  #remember(label, project) {
    const last = this.#past.at(-1);
    if (last) last.bytes = weightBeside(last.project, project);  // not before: a gesture may have gone on
    this.#past.push({ label, project, bytes: 0 });
    let bytes = this.#past.reduce((sum, step) => sum + step.bytes, 0);
    while (this.#past.length > remembered || (bytes > mostBytes && this.#past.length > 1)) bytes -= this.#past.shift()?.bytes ?? 0;
  }

  /** The gesture under way, '' between gestures: what changes meanwhile will change again. */
  get gesture() { return this.#merging; }

  /** The gesture is over: the next change is undone by itself. Listeners are told. */
  settle() {
    if (this.#merging === '') return;
    this.#merging = '';
    this.#tell(this.#project);
  }

  undo() { this.#travel(this.#past, this.#future); }
  redo() { this.#travel(this.#future, this.#past); }

  /** @param {Step<P>[]} from  @param {Step<P>[]} to */
  #travel(from, to) {
    const step = from.pop();
    if (step === undefined) return;
    to.push({ label: step.label, project: this.#project, bytes: weightBeside(this.#project, step.project) });
    this.#merging = '';
    this.#become(step.project);
  }

  /** @param {P} project */
  #become(project) {
    const before = this.#project;
    this.#project = project;
    this.#tell(before);
  }

  /** @param {P} before */
  #tell(before) {
    for (const listener of this.#listeners) listener(this.#project, before);
  }
}
