// The one place where the project lives, with everything it was before. Changes make new objects;
// undo is going back to an old one.

const remembered = 500;  // states; they share what did not change

/** @template {object} P  of plain values */
export class Store {
  /** @type {{label: string, project: P}[]} */
  #past = [];
  /** @type {{label: string, project: P}[]} */
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
    if (gesture === '' || gesture !== this.#merging) {
      this.#past.push({ label, project: before });
      if (this.#past.length > remembered) this.#past.shift();
    }
    this.#merging = gesture;
    this.#future.length = 0;
    this.#become({ ...before, ...part });
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

  /** @param {{label: string, project: P}[]} from  @param {{label: string, project: P}[]} to */
  #travel(from, to) {
    const step = from.pop();
    if (step === undefined) return;
    to.push({ label: step.label, project: this.#project });
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
