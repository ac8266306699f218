// Whose numbers the panels show: those of the run, or of one of the two that are compared.
/** @import { App } from '../app' */
/** @import { Project, Scene } from '../types' */
/** @import { Runner } from '../run/runner.js' */
import { h, withSubscripts } from '../panels/dom.js';

/** `project`: the one on the screen with the options of this mesh. `letter`: '' of a run that is not compared.
 * @typedef {{letter: string, name: string, runner: Runner, scene: () => Scene, project: () => Project}} Shown */

export class Sides {
  /** @type {Shown[]} */
  #all;
  #at = 1;  // of two: B is what A is to be compared with
  /** @type {Set<() => void>} */
  #listeners = new Set();

  /** @param {Shown} alone */
  constructor(alone) {
    this.#all = [alone];
  }

  get all() { return this.#all; }
  get chosen() { return this.#all[Math.min(this.#at, this.#all.length - 1)]; }

  /** @param {Shown[]} all */
  show(all) {
    this.#all = all;
    this.tell();
  }

  /** @param {number} at */
  choose(at) {
    this.#at = at;
    this.tell();
  }

  /** What is shown has changed. */
  tell() {
    for (const listener of this.#listeners) listener();
  }

  /** @param {() => void} listener */
  subscribe(listener) { this.#listeners.add(listener); }
}

/** Buttons to choose between the two. @param {App} app */
export function createSideChoice({ actions, sides }) {
  const choose = (/** @type {number} */ at) => {
    sides.choose(at);
    actions.refresh();  // what is possible, or on, may be of the side
  };
  const buttons = [0, 1].map((at) => h('button', { type: 'button', onclick: () => choose(at) }, 'AB'[at]));
  const element = h('div', { className: 'buttons side-choice', role: 'group', 'aria-label': 'Which of the two meshes', hidden: true }, ...buttons);
  const refresh = () => {
    element.hidden = sides.all.length < 2;
    if (element.hidden) return;
    buttons.forEach((button, at) => {
      const { name } = sides.all[at];
      if (button.dataset.of !== name) button.replaceChildren(...withSubscripts(name));
      button.dataset.of = name;
      button.setAttribute('aria-pressed', String(sides.all[at] === sides.chosen));
    });
  };
  sides.subscribe(refresh);
  return element;
}
