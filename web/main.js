// Puts the parts together; what they do is theirs.
/** @import { App } from './app' */
/** @import { Scene } from './types' */
import { installCompare } from './compare/compare.js';
import { Sides } from './compare/sides.js';
import { dark, light } from './draw/palette.js';
import { installFiguresTab } from './figures/figures_tab.js';
import { handedFile } from './files/hand_over.js';
import { createReading } from './files/reading.js';
import { installOpeningProjects } from './files/open_project.js';
import { installOpeningSurfaces } from './files/open_surface.js';
import { installFiles } from './files/files.js';
import { installHeader } from './header/header.js';
import { Themes } from './header/theme.js';
import { installInspector } from './layers/inspector.js';
import { installLayers } from './layers/layers.js';
import { installLearn } from './learn/learn.js';
import { installWelcome } from './learn/welcome.js';
import { installMeshTab } from './mesh/mesh_tab.js';
import { Actions } from './panels/actions.js';
import { setText } from './panels/dom.js';
import { createNotices } from './panels/notice.js';
import { Tabs } from './panels/tabs.js';
import { installOffline } from './offline/offline.js';
import { createEngine } from './run/engine.js';
import { installFollowing, installFreshness, shownOf } from './run/follow.js';
import { Preview } from './run/preview.js';
import { Runner } from './run/runner.js';
import { installTimeline } from './run/timeline.js';
import { installStages } from './stages/open.js';
import { installSketch } from './sketch/install.js';
import { presets } from './sketch/presets.js';
import { Stage } from './stage/stage.js';
import { Keeping, openFirst, openFragment } from './state/keeping.js';
import { Store } from './state/store.js';

const element = (/** @type {string} */ id) => /** @type {HTMLElement} */ (document.getElementById(id));

/** @returns {Scene} */
function scene() {
  const { project } = store;
  const shown = shownOf(project, runner.run, preview.shown);
  return { drawing: project.drawing, ...shown, palette: themes.dark ? dark : light, norm: project.options.norm ?? 6 };
}

const themes = new Themes();
const handed = await handedFile();
const opened = await openFirst();
const store = new Store(opened.first ?? presets[0].project);
const runner = new Runner(createEngine);
const preview = new Preview(createEngine);
const actions = new Actions();
const stage = new Stage(element('stage'), scene);
const tabs = new Tabs(element('panel'));
const notify = createNotices(element('stage'));

/** @type {App} */
const app = {
  store, runner, actions, stage, tabs, themes, scene,
  sides: new Sides({ letter: '', name: '', runner, scene, project: () => store.project }), led: () => app.sides.all.map((side) => side.runner),
  problemsOf: () => [], openFiles: async () => {}, openers: [], recordings: [],
  announce: (text) => setText(element('announcer'), text),
  notify, reading: async () => null,
  keeping: new Keeping({ store, runner, notify }),
};

runner.still = matchMedia('(prefers-reduced-motion: reduce)').matches;
runner.wantedLayers = () => store.project.layers;
installHeader(app);
const refreshTimeline = installTimeline(app);
installSketch(app);
installMeshTab(app);
installInspector(app);
installLayers(app);
installFiguresTab(app);
installCompare(app, createEngine, refreshTimeline);
installOpeningProjects(app);
installOpeningSurfaces(app);
installStages(app);
installFiles(app);
installOffline(app);
app.reading = createReading(app);  // last: its Escape is the first
const openChapter = installLearn(app);

const startRun = installFollowing(app, preview);
installFreshness(app, preview);
store.subscribe(() => {
  stage.invalidate();
  actions.refresh();
});
runner.subscribe(() => {
  stage.invalidate();
  actions.refresh();
});
tabs.subscribe(() => actions.refresh());
themes.subscribe(() => stage.invalidate());
actions.listen(window);
Object.assign(globalThis, { playground: app });  // for the browser's console
addEventListener('hashchange', async ({ newURL }) => {
  const { project, place, notice } = await openFragment(new URL(newURL).hash);  // the address bar may follow the project by now
  if (notice) app.notify(notice);
  const before = store.project;
  if (!project && !location.hash && !place.chapter) app.keeping.leave();  // Back, and the drawing was too much for an address
  if (!notice && !place.chapter) app.keeping.close();
  if (project) store.change('Open a link', project);
  if (store.project.drawing !== before.drawing) stage.fit();
  if (project && place.tick !== undefined) void runner.seek(place.tick);
  openChapter(place.chapter, project === null, before);
});
if (opened.notice) app.notify(opened.notice);
if (opened.first === null && !opened.place.chapter && !handed) installWelcome(app);
const first = store.project;
if (opened.project) store.change('Open a link', opened.project);
startRun(store.project, 'play');
if (opened.place.tick !== undefined) void runner.seek(opened.place.tick);
openChapter(opened.place.chapter, opened.project === null, first);
if (handed) void app.openFiles([handed]);
