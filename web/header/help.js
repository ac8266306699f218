// The help: what the page is, and every action with its keys. Each can be run from here, so that
// the keyboard reaches even those without a key.
/** @import { Action, Actions } from '../panels/actions.js' */
import { canRun } from '../panels/actions.js';
import { paperReference } from '../learn/paper.js';
import { h } from '../panels/dom.js';
import { icon } from '../panels/icons.js';

/** Titles by the first part of an action's id; others are shown as they are. @type {Record<string, string>} */
const rooms = {
  edit: 'Editing', tool: 'Tools', draw: 'Drawing', sketch: 'Drawing', snap: 'Drawing', vertex: 'Vertices and outlines', outline: 'Vertices and outlines',
  preset: 'Domains to begin with', run: 'Running', view: 'Looking', layer: 'Layers', mesh: 'Mesh',
  compare: 'Comparing', figures: 'Figures', figure: 'Figures', file: 'Files', learn: 'Learning', panel: 'Panels', page: 'The page',
};

/** @param {Actions} actions  @param {string | Node} about  what the page is */
export function createHelp(actions, about) {
  const list = h('div', { className: 'help-list' });
  const search = h('input', { type: 'search', id: 'help-search', 'aria-label': 'Find an action', placeholder: 'Find an action', oninput: () => filter(list, search.value) });
  const close = h('button', { type: 'button', 'aria-label': 'Close', title: 'Close (Escape)', onclick: () => dialog.close() }, icon('close'));
  const dialog = h('dialog', { className: 'help', 'aria-labelledby': 'help-title', onclick: closeOutside },
    h('div', { className: 'dialog-head' }, h('h2', { id: 'help-title' }, 'Help'), close),
    h('p', null, about), search, list, paperReference());
  document.body.append(dialog);
  return {
    open: () => {
      if (dialog.open) return dialog.close();
      list.replaceChildren(...groups(actions, dialog));
      search.value = '';
      dialog.showModal();
    },
  };
}

/** @param {Actions} actions  @param {HTMLDialogElement} dialog */
function groups(actions, dialog) {
  const byRoom = Map.groupBy(actions.all, ({ id }) => rooms[id.split('.')[0]] ?? id.split('.')[0]);
  return [...byRoom].map(([room, all]) =>
    h('section', null, h('h3', null, room), h('ul', null, ...all.map((action) => row(actions, action, dialog)))));
}

/** @param {Actions} actions  @param {Action} action  @param {HTMLDialogElement} dialog */
function row(actions, action, dialog) {
  const run = () => {
    dialog.close();
    actions.run(action.id);
  };
  return h('li', null,
    h('button', { type: 'button', className: 'plain', onclick: run, 'aria-disabled': String(!canRun(action)) }, action.label),
    h('span', { className: 'keys' }, ...(action.keys ?? []).map((key) => h('kbd', null, key))));
}

/** @param {HTMLElement} list  @param {string} words */
function filter(list, words) {
  const wanted = words.trim().toLowerCase();
  for (const section of list.children) {
    const rows = /** @type {HTMLElement[]} */ ([...section.querySelectorAll('li')]);
    for (const item of rows) item.hidden = !(item.textContent ?? '').toLowerCase().includes(wanted);
    /** @type {HTMLElement} */ (section).hidden = rows.every((item) => item.hidden);
  }
}

/** @param {MouseEvent} event */
export function closeOutside({ target, clientX, clientY }) {
  if (!(target instanceof HTMLDialogElement)) return;
  const { left, right, top, bottom } = target.getBoundingClientRect();
  if (clientX < left || clientX > right || clientY < top || clientY > bottom) target.close();
}
