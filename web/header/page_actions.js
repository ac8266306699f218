// What concerns the whole page, plane or space: undo and redo, the colours, the help, ways round it.
/** @import { App } from '../app' */
import { setText } from '../panels/dom.js';
import { createHelp } from './help.js';
import { installRegions } from './regions.js';

const themeIcons = /** @type {const} */ ({ system: 'auto', light: 'sun', dark: 'moon' });

/** @typedef {Pick<App, 'actions' | 'announce' | 'tabs' | 'themes'> & {store: import('../state/store.js').Store<any>}} Page */

/** @param {Page} page  @param {string} about  what the page is, for the help */
export function installPageActions(page, about) {
  const { actions, store, themes } = page;
  const help = createHelp(actions, about);
  actions.add(
    { id: 'edit.undo', label: 'Undo', icon: 'undo', keys: ['Ctrl+Z'], enabled: () => store.canUndo, hint: () => store.undoLabel,
      run: () => travel(page, 'Undone', store.undoLabel, () => store.undo()) },
    { id: 'edit.redo', label: 'Redo', icon: 'redo', keys: ['Ctrl+Y', 'Ctrl+Shift+Z'], enabled: () => store.canRedo, hint: () => store.redoLabel,
      run: () => travel(page, 'Redone', store.redoLabel, () => store.redo()) },
    { id: 'page.theme', label: 'Light, dark or as the system', icon: () => themeIcons[themes.theme], hint: () => themes.theme,
      run: () => turnTheme(page) },
    { id: 'page.help', label: 'Help', icon: 'help', keys: ['?', 'F1'], run: () => help.open() },
  );
  installRegions(page);
}

/** @param {Page} page  @param {string} done  @param {string} label  @param {() => void} go */
function travel({ announce }, done, label, go) {
  go();
  announce(`${done}: ${label}`);
}

/** @param {Page} page */
function turnTheme({ actions, announce, themes }) {
  themes.turn();
  actions.refresh();
  announce(`Colours: ${themes.theme}`);
}

/** Puts the buttons of the header there, and keeps the name of what is on the page, above and in the browser's tab.
 * @param {Page} page  @param {string[]} buttons  actions  @param {() => string} name  @param {string} place  what the page is called */
export function installTitle({ actions, store }, buttons, name, place) {
  const element = (/** @type {string} */ id) => /** @type {HTMLElement} */ (document.getElementById(id));
  const show = () => {
    setText(element('project-name'), name());
    document.title = `${name()} – ${place}`;
  };
  store.subscribe(show);
  show();
  element('header-actions').append(...buttons.map((id) => actions.button(id)));
}
