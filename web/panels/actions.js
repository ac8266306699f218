// Everything a person can do, by name, with its keys. Buttons and shortcuts run the same actions,
// and the help lists them.
import { h } from './dom.js';

/**
 * @typedef {object} Action
 * @property {string} id  'room.verb'
 * @property {string} label  for buttons, menus, screen readers
 * @property {string[]} [keys]  'Space', 'Ctrl+Z', 'Shift+P', '+' …
 * @property {() => void} run
 * @property {() => boolean} [enabled]
 * @property {() => boolean} [pressed]  of a toggle
 */

export class Actions {
  /** @type {Map<string, Action>} */
  #actions = new Map();
  /** @type {Map<string, Action>} */
  #byKey = new Map();
  /** @type {Set<() => void>} */
  #refreshers = new Set();

  /** @param {...Action} actions */
  add(...actions) {
    for (const action of actions) {
      this.#actions.set(action.id, action);
      for (const key of action.keys ?? []) this.#byKey.set(key, action);
    }
  }

  get all() { return [...this.#actions.values()]; }

  /** @param {string} id */
  run(id) {
    const action = this.#actions.get(id);
    if (action && (action.enabled?.() ?? true)) action.run();
  }

  /** Buttons show whether their action is possible, or on. Call after any change. */
  refresh() {
    for (const refresh of this.#refreshers) refresh();
  }

  /** @param {string} id  @param {{text?: string, title?: string, className?: string}} [look] */
  button(id, { text, title, className = '' } = {}) {
    const action = /** @type {Action} */ (this.#actions.get(id));
    const keys = action.keys?.length ? ` (${action.keys.join(', ')})` : '';
    const button = h('button', {
      type: 'button', className, title: `${title ?? action.label}${keys}`, 'data-action': id,
      'aria-label': text === undefined || text === action.label ? undefined : action.label,
      onclick: () => this.run(id),
    }, text ?? action.label);
    const refresh = () => {
      const enabled = action.enabled?.() ?? true;
      button.setAttribute('aria-disabled', String(!enabled));
      if (action.pressed) button.setAttribute('aria-pressed', String(action.pressed()));
    };
    this.#refreshers.add(refresh);
    refresh();
    return button;
  }

  /** Shortcuts act unless the key belongs to what has the focus. @param {Window | HTMLElement} target */
  listen(target) {
    target.addEventListener('keydown', (raised) => {
      const event = /** @type {KeyboardEvent} */ (raised);
      const action = this.#byKey.get(nameOf(event));
      if (!action || event.defaultPrevented || keepsKey(event)) return;
      event.preventDefault();
      this.run(action.id);
    });
  }
}

/** @param {KeyboardEvent} event */
export function nameOf(event) {
  const key = event.key === ' ' ? 'Space' : event.key.length === 1 ? event.key.toUpperCase() : event.key;
  const letter = /^[A-Z]$/.test(key);
  return `${event.ctrlKey || event.metaKey ? 'Ctrl+' : ''}${event.shiftKey && (letter || key.length > 1) ? 'Shift+' : ''}${key}`;
}

/** @param {KeyboardEvent} event */
function keepsKey({ target, key, ctrlKey, metaKey }) {
  if (!(target instanceof HTMLElement)) return false;
  if (target.closest('dialog')) return key !== 'Escape';
  const typing = target instanceof HTMLInputElement && !['checkbox', 'radio', 'range', 'button'].includes(target.type)
    || target instanceof HTMLTextAreaElement || target instanceof HTMLSelectElement;
  if (typing) return true;
  if (ctrlKey || metaKey) return false;
  const pressing = target.closest('button, a, summary, [role=tab], input');
  return pressing !== null && (key === ' ' || key === 'Enter' || key.startsWith('Arrow') || key === 'Home' || key === 'End');
}
