// The page for surfaces in space: puts its parts together; what they do is theirs.
/** @import { SpaceApp } from './types' */
import { installPageActions, installTitle } from '../header/page_actions.js';
import { Themes } from '../header/theme.js';
import { handedFile } from '../files/hand_over.js';
import { installOffline } from '../offline/offline.js';
import { Actions } from '../panels/actions.js';
import { h, setText } from '../panels/dom.js';
import { createNotices } from '../panels/notice.js';
import { Tabs } from '../panels/tabs.js';
import { createEngine } from '../run/engine.js';
import { createSpeed } from '../run/speed.js';
import { Store } from '../state/store.js';
import { installKeeping, openFirst } from './model/keeping.js';
import { fromFragment, problemOf } from './model/link.js';
import { installOpening } from './model/open.js';
import { layersFor } from './model/work.js';
import { installFiguresTab } from './panels/figures_tab.js';
import { installFilesTab } from './panels/files_tab.js';
import { installLayersTab } from './panels/layers_tab.js';
import { installLearnTab } from './panels/learn_tab.js';
import { installMeshTab } from './panels/mesh_tab.js';
import { installProblem } from './panels/problem.js';
import { installSurfaceTab } from './panels/surface_tab.js';
import { installFollowing } from './run/follow.js';
import { SurfaceRunner, shareOf } from './run/runner.js';
import { stageInWords } from './run/words.js';
import { Planes } from './view/planes.js';
import { installScene } from './view/scene.js';
import { Viewer } from './view/viewer.js';

const element = (/** @type {string} */ id) => /** @type {HTMLElement} */ (document.getElementById(id));

const handed = await handedFile();
const opened = await openFirst();
const store = new Store(opened.work);
const runner = new SurfaceRunner(createEngine, () => !matchMedia('(prefers-reduced-motion: reduce)').matches);

/** @type {SpaceApp} */
const app = {
  store, runner, actions: new Actions(), tabs: new Tabs(element('panel')), themes: new Themes(), viewer: new Viewer(element('space-view')),
  announce: (text) => setText(element('announcer'), text),
  notify: createNotices(element('space-view')),
  layers: () => new Set(store.project.layers === 'auto' ? layersFor(runner.run) : store.project.layers),
  pointed: { chart: -1 },
  point: (chart) => {
    if (app.pointed.chart === chart) return;
    app.pointed.chart = chart;
    refreshScene();
    planes.refresh();
  },
};

const { actions, viewer, themes } = app;
installPageActions(app, 'Open a surface, or choose one under Surface: it is meshed at once. Drag to turn it, turn the wheel or '
  + 'pinch to zoom. Every action is listed here with its keys, and can be started here too.');
actions.add(
  { id: 'view.fit', label: 'Show all', icon: 'fit', keys: ['F'], run: () => viewer.fit() },
  { id: 'view.in', label: 'Nearer', icon: 'zoomIn', keys: ['+'], run: () => viewer.zoom(1 / 1.2) },
  { id: 'view.out', label: 'Farther', icon: 'zoomOut', keys: ['-'], run: () => viewer.zoom(1.2) },
  { id: 'run.pause', label: 'Pause', icon: () => (runner.run.paused ? 'play' : 'pause'), keys: ['Space'], enabled: () => runner.run.phase === 'running',
    pressed: () => runner.run.paused, run: () => runner.pause(!runner.run.paused) },
  { id: 'run.step', label: 'One step', icon: 'step', keys: ['.'], enabled: () => runner.run.phase === 'running', run: () => runner.step() },
  { id: 'run.end', label: 'To the end', icon: 'end', keys: ['E'], enabled: () => runner.run.phase === 'running' && !runner.hurried,
    hint: () => 'without pictures on the way', run: () => runner.end() },
  { id: 'run.cancel', label: 'Cancel', icon: 'cancel', keys: ['Escape'], enabled: () => runner.run.phase === 'running', run: () => runner.cancel() },
  { id: 'run.again', label: 'Run again', icon: 'again', keys: ['R'], run: () => void runner.start(store.project) },
);
const openFiles = installOpening(app, element('stage'));
installSurfaceTab(app);
installMeshTab(app);
installLayersTab(app);
installFiguresTab(app);
installFilesTab(app);
installLearnTab(app);
installProblem(app, element('space-view'));
installKeeping(app);
installOffline(app);
installTitle(app, ['edit.undo', 'edit.redo', 'view.fit', 'page.theme', 'page.help'], () => store.project.name, 'lpquad in space');

const progress = h('progress', { max: 1, 'aria-label': 'Progress' }), stageName = h('span', { className: 'stage-name' });
element('timeline').append(actions.button('run.again'), actions.button('run.pause'), actions.button('run.step'),
  actions.button('run.end'), actions.button('run.cancel'), progress, stageName, createSpeed(app, runner));

const planes = new Planes(app, element('plane-view'));
const refreshScene = installScene(app);
viewer.pointed = (triangle) => {
  const { charts } = runner.run.frame;
  app.point(triangle >= 0 && charts ? charts.charts[triangle] : -1);
};

const refresh = () => {
  progress.value = shareOf(runner.run);
  setText(stageName, stageInWords(runner.run));
  stageName.title = stageName.textContent ?? '';  // it may be cut off
  actions.refresh();
  planes.refresh();
};
let phase = runner.run.phase;
runner.subscribe((run) => {
  refresh();
  if (run.phase === phase) return;
  phase = run.phase;
  if (phase === 'running') app.point(-1);  // its charts are others
  if (phase === 'done') app.announce(stageInWords(run));
});
store.subscribe(refresh);
themes.subscribe(() => planes.refresh());
actions.listen(window);
addEventListener('hashchange', ({ newURL }) => {
  const { hash } = new URL(newURL), problem = problemOf(hash);
  app.notify(problem);
  if (problem === '') store.change('Open a link', fromFragment(hash));
});
Object.assign(globalThis, { playground: app });  // for the browser's console
refresh();
refreshScene();
if (opened.notice) app.notify(opened.notice);
installFollowing(app);
if (handed) void openFiles([handed]);
