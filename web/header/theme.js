// Light, dark, or as the system has it. The choice is the reader's, not the project's: it is kept
// beside it and no link carries it.
import { keep, kept } from '../state/storage.js';

/** @typedef {'system' | 'light' | 'dark'} Theme */

const name = 'theme';
const next = /** @type {const} */ ({ system: 'light', light: 'dark', dark: 'system' });
const system = matchMedia('(prefers-color-scheme: dark)');

export class Themes {
  /** @type {Theme} */
  theme = 'system';
  /** @type {Set<() => void>} */
  #listeners = new Set();

  constructor() {
    const chosen = kept(name);
    if (chosen === 'light' || chosen === 'dark') this.theme = chosen;
    this.#show();
    system.addEventListener('change', () => this.#tell());
  }

  get dark() { return this.theme === 'system' ? system.matches : this.theme === 'dark'; }

  /** @param {() => void} listener */
  subscribe(listener) { this.#listeners.add(listener); }

  turn() {
    this.theme = next[this.theme];
    keep(name, this.theme);
    this.#show();
    this.#tell();
  }

  #show() {
    document.documentElement.dataset.scheme = this.theme;
  }

  #tell() {
    for (const listener of this.#listeners) listener();
  }
}
