// Everything a person can do, by name, with its keys. Buttons and shortcuts run the same actions,
// and the help lists them.
/** @import { IconName } from './icons.js' */
import { h } from './dom.js';
import { icon } from './icons.js';

/**
 * @typedef {object} Action
 * @property {string} id  'room.verb'
 * @property {string} label  for buttons, menus, screen readers
 * @property {string[]} [keys]  'Space', 'Ctrl+Z', 'Shift+P', '+' …
 * @property {() => void} run
 * @property {() => boolean} [enabled]
 * @property {() => boolean} [pressed]  of a toggle
 * @property {IconName | (() => IconName)} [icon]
 * @property {() => string} [hint]  what it would do just now, for the tooltip
 */

/**
 * How a button shows its action: by its icon, if it has one, else by its label.
 * @typedef {object} Look
 * @property {string} [text]  these words instead of the icon
 * @property {boolean} [labelled]  the label beside the icon
 * @property {string} [title]
 * @property {string} [className]
 */

export class Actions {
  /** @type {Map<string, Action>} */
  #actions = new Map();
  /** Of several with the same key the last that is possible acts. @type {Map<string, Action[]>} */
  #byKey = new Map();
  /** @type {Set<() => void>} */
  #refreshers = new Set();

  /** @param {...Action} actions */
  add(...actions) {
    for (const action of actions) {
      this.#actions.set(action.id, action);
      for (const key of action.keys ?? []) this.#byKey.set(key, [...this.#byKey.get(key) ?? [], action]);
    }
  }

  get all() { return [...this.#actions.values()]; }

  /** @param {string} id */
  run(id) {
    const action = this.#actions.get(id);
    if (action && canRun(action)) action.run();
  }

  /** Buttons show whether their action is possible, or on. Call after any change. */
  refresh() {
    for (const refresh of this.#refreshers) refresh();
  }

  /** @param {string} id  @param {Look} [look] */
  button(id, { text, labelled = false, title, className = '' } = {}) {
    const action = /** @type {Action} */ (this.#actions.get(id));
    const named = labelled || text !== undefined || !action.icon;
    const button = h('button', {
      type: 'button', className, 'data-action': id, 'aria-keyshortcuts': action.keys?.map(ariaKey).join(' ') || undefined,
      'aria-label': named ? undefined : action.label, onclick: () => this.run(id),
    }, text ?? (labelled || !action.icon ? action.label : null));
    const refresh = () => {
      button.setAttribute('aria-disabled', String(!canRun(action)));
      if (action.pressed) button.setAttribute('aria-pressed', String(action.pressed()));
      button.title = titleOf(action, title);
      if (text === undefined && action.icon) showIcon(button, typeof action.icon === 'function' ? action.icon() : action.icon);
    };
    this.#refreshers.add(refresh);
    refresh();
    return button;
  }

  /** Shortcuts act unless the key belongs to what has the focus. @param {Window | HTMLElement} target */
  listen(target) {
    target.addEventListener('keydown', (raised) => {
      const event = /** @type {KeyboardEvent} */ (raised);
      const all = this.#byKey.get(nameOf(event)), action = all?.findLast(canRun) ?? all?.[0];
      if (!action || event.defaultPrevented || keepsKey(event)) return;
      event.preventDefault();
      this.run(action.id);
    });
  }
}

/** @param {Action} action */
export const canRun = (action) => action.enabled?.() ?? true;

/** @param {Action} action  @param {string} [title] */
function titleOf(action, title = action.label) {
  const hint = action.hint?.();
  const keys = action.keys?.length ? ` (${action.keys.join(', ')})` : '';
  return `${title}${hint ? `: ${hint}` : ''}${keys}`;
}

/** @param {HTMLButtonElement} button  @param {IconName} name */
function showIcon(button, name) {
  const shown = button.querySelector('svg');
  if (shown?.getAttribute('data-icon') === name) return;
  shown?.remove();
  button.prepend(icon(name));
}

/** @param {string} key  as ARIA names it */
const ariaKey = (key) => key.replace('Ctrl', 'Control');

/** @param {KeyboardEvent} event */
export function nameOf(event) {
  const key = event.key === ' ' ? 'Space' : event.key.length === 1 ? event.key.toUpperCase() : event.key;
  const letter = /^[A-Z]$/.test(key);
  const control = (event.ctrlKey || event.metaKey) && !event.getModifierState('AltGraph');
  return `${control ? 'Ctrl+' : ''}${event.shiftKey && (letter || key.length > 1) ? 'Shift+' : ''}${key}`;
}

/** @param {KeyboardEvent} event */
function keepsKey({ target, key, ctrlKey, metaKey }) {
  if (document.querySelector('dialog[open]')) return true;  // its own keys, though a click on its words took the focus off it
  if (!(target instanceof HTMLElement)) return false;
  const typing = target instanceof HTMLInputElement && !['checkbox', 'radio', 'range', 'button'].includes(target.type)
    || target instanceof HTMLTextAreaElement || target instanceof HTMLSelectElement;
  if (typing) return true;
  if (ctrlKey || metaKey) return false;
  const pressing = target.closest('button, a, summary, [role=tab], input');
  return pressing !== null && (key === ' ' || key === 'Enter' || key.startsWith('Arrow') || key === 'Home' || key === 'End');
}
