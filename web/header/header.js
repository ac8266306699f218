// The bar at the top: what concerns the whole project or the page.
/** @import { App } from '../app' */
/** @import { Themes } from './theme.js' */
import { createHelp } from './help.js';
import { titleOf } from '../files/names.js';
import { setText } from '../panels/dom.js';
import { installRegions } from './regions.js';
import { installShare } from './share.js';

const themeIcons = /** @type {const} */ ({ system: 'auto', light: 'sun', dark: 'moon' });

/** @param {App} app */
export function installHeader(app) {
  const { actions, store, stage, themes } = app;
  const help = createHelp(actions);
  actions.add(
    { id: 'edit.undo', label: 'Undo', icon: 'undo', keys: ['Ctrl+Z'], enabled: () => store.canUndo, hint: () => store.undoLabel,
      run: () => travel(app, 'Undone', store.undoLabel, () => store.undo()) },
    { id: 'edit.redo', label: 'Redo', icon: 'redo', keys: ['Ctrl+Y', 'Ctrl+Shift+Z'], enabled: () => store.canRedo, hint: () => store.redoLabel,
      run: () => travel(app, 'Redone', store.redoLabel, () => store.redo()) },
    { id: 'view.fit', label: 'Show all', icon: 'fit', keys: ['F'], run: () => stage.fit() },
    { id: 'page.theme', label: 'Light, dark or as the system', icon: () => themeIcons[themes.theme], hint: () => themes.theme,
      run: () => turnTheme(app, themes) },
    { id: 'page.help', label: 'Help', icon: 'help', keys: ['?', 'F1'], run: () => help.open() },
  );
  installRegions(app);
  installShare(app);
  const name = /** @type {HTMLElement} */ (document.getElementById('project-name'));
  const showName = () => {
    setText(name, titleOf(store.project));
    document.title = `${titleOf(store.project)} – lpquad playground`;
  };
  store.subscribe(showName);
  showName();
  /** @type {HTMLElement} */ (document.getElementById('header-actions')).append(
    ...['edit.undo', 'edit.redo', 'view.fit', 'page.share', 'page.theme', 'page.help'].map((id) => actions.button(id)));
}

/** @param {App} app  @param {string} done  @param {string} label  @param {() => void} go */
function travel({ announce }, done, label, go) {
  go();
  announce(`${done}: ${label}`);
}

/** @param {App} app  @param {Themes} themes */
function turnTheme({ actions, announce }, themes) {
  themes.turn();
  actions.refresh();
  announce(`Colours: ${themes.theme}`);
}
