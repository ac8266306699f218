// The bar at the top of the page for the plane.
/** @import { App } from '../app' */
import { titleOf } from '../files/names.js';
import { installPageActions, installTitle } from './page_actions.js';
import { installShare } from './share.js';

const about = 'Draw an outline, or choose one under Domain: the mesh follows. Drag to pan, turn the wheel or pinch to zoom; '
  + 'on the stage arrow keys pan where nothing is chosen. Every action is listed here with its keys, and can be started here too.';

/** @param {App} app */
export function installHeader(app) {
  const { actions, store, stage } = app;
  installPageActions(app, about);
  actions.add(
    { id: 'view.fit', label: 'Show all', icon: 'fit', keys: ['F'], run: () => stage.fit() },
    { id: 'view.in', label: 'Nearer', icon: 'zoomIn', keys: ['+'], run: () => stage.zoom(1.2) },
    { id: 'view.out', label: 'Farther', icon: 'zoomOut', keys: ['-'], run: () => stage.zoom(1 / 1.2) },
  );
  installShare(app);
  installTitle(app, ['edit.undo', 'edit.redo', 'view.fit', 'page.share', 'page.theme', 'page.help'], () => titleOf(store.project), 'lpquad playground');
}
