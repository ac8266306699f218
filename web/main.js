// Puts the parts together; what they do is theirs.
/** @import { App } from './app' */
/** @import { Scene } from './types' */
import { dark, light } from './draw/palette.js';
import { installHeader } from './header/header.js';
import { Themes } from './header/theme.js';
import { Actions } from './panels/actions.js';
import { setText } from './panels/dom.js';
import { Tabs } from './panels/tabs.js';
import { createEngine } from './run/engine.js';
import { shownLayers } from './run/needed.js';
import { Runner } from './run/runner.js';
import { installTimeline } from './run/timeline.js';
import { presets } from './sketch/presets.js';
import { Stage } from './stage/stage.js';
import { haveSameMesh } from './state/project.js';
import { Store } from './state/store.js';

const element = (/** @type {string} */ id) => /** @type {HTMLElement} */ (document.getElementById(id));

/** @returns {Scene} */
function scene() {
  const { frame, result, state } = runner.run;
  const { drawing, layers } = store.project;
  return {
    drawing, frame, result, layers: shownLayers(layers, state), palette: themes.dark ? dark : light,
  };
}

const themes = new Themes();
const store = new Store(presets[0].project);
const runner = new Runner(createEngine);
const actions = new Actions();
const stage = new Stage(element('stage'), scene);
const tabs = new Tabs(element('panel'));

/** @type {App} */
const app = {
  store, runner, actions, stage, tabs, themes, scene,
  announce: (text) => setText(element('announcer'), text),
};

runner.wantedLayers = () => store.project.layers;
installHeader(app);
installTimeline(app);

store.subscribe((project, before) => {
  if (!haveSameMesh(project, before)) void runner.load(project);
  else if (project.layers !== before.layers) void runner.refresh();
  stage.invalidate();
  actions.refresh();
});
runner.subscribe(() => {
  stage.invalidate();
  actions.refresh();
});
themes.subscribe(() => stage.invalidate());
actions.listen(window);
void runner.load(store.project);
