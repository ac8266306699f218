// The panel beside the stage: one tab per part, as ARIA describes tabs.
import { h } from './dom.js';

export class Tabs {
  /** @type {{id: string, tab: HTMLButtonElement, body: HTMLElement}[]} */
  #parts = [];
  /** @type {Set<(id: string) => void>} */
  #listeners = new Set();

  /** @param {HTMLElement} panel */
  constructor(panel) {
    this.list = h('div', { role: 'tablist', className: 'tabs', 'aria-label': 'Panels', onkeydown: (/** @type {KeyboardEvent} */ e) => this.#key(e) });
    panel.append(this.list);
    this.panel = panel;
  }

  /** @param {string} id  @param {string} title  @param {...(Node | string)} content */
  add(id, title, ...content) {
    const tab = h('button', {
      type: 'button', role: 'tab', id: `tab-${id}`, 'aria-controls': `panel-${id}`, onclick: () => this.open(id),
    }, title);
    const body = h('section', { role: 'tabpanel', id: `panel-${id}`, 'aria-labelledby': `tab-${id}`, className: 'tab-body', tabIndex: 0 }, ...content);
    this.list.append(tab);
    this.panel.append(body);
    this.#parts.push({ id, tab, body });
    this.open(this.#parts[0].id);
    return body;
  }

  /** @param {string} id */
  open(id) {
    for (const part of this.#parts) {
      const open = part.id === id;
      part.tab.setAttribute('aria-selected', String(open));
      part.tab.tabIndex = open ? 0 : -1;
      part.body.hidden = !open;
    }
    for (const listener of this.#listeners) listener(id);
  }

  /** @param {(id: string) => void} listener  told which tab was opened */
  subscribe(listener) { this.#listeners.add(listener); }

  get current() { return this.#parts.find(({ body }) => !body.hidden)?.id ?? ''; }

  /** Opens the tab so many further and gives it the focus. @param {number} by */
  turn(by) {
    const at = this.#parts.findIndex(({ id }) => id === this.current);
    const part = this.#parts.at((at + by) % this.#parts.length);
    if (part === undefined) return;
    this.open(part.id);
    part.tab.focus();
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    const at = this.#parts.findIndex(({ tab }) => tab === document.activeElement);
    const to = { ArrowRight: at + 1, ArrowLeft: at - 1, Home: 0, End: -1 }[event.key];
    if (at < 0 || to === undefined) return;
    event.preventDefault();
    const part = this.#parts.at(to % this.#parts.length);
    if (part === undefined) return;
    this.open(part.id);
    part.tab.focus();
  }
}
