// The bar below the stage: play, pause, step, end, reset, and the slider over the iterations. It
// leads the run, or both runs of a comparison.
/** @import { App } from '../app' */
/** @import { Run } from '../types' */
/** @import { Runner } from './runner.js' */
import { h, setText } from '../panels/dom.js';
import { titleOf } from '../sketch/errors/words.js';
import { haveSameMesh } from '../state/project.js';
import { createSpeed } from './speed.js';
import { describe, expectedTicks } from './words.js';

/** The run that the bar shows: the longest. @param {App} app */
function leadOf(app) {
  return app.led().reduce((lead, runner) => (expectedTicks(runner.run) > expectedTicks(lead.run) ? runner : lead));
}

/** @param {App} app */
function addActions(app) {
  const { actions, runner: own, store } = app;
  const each = (/** @type {(runner: Runner) => unknown} */ act) => app.led().forEach((runner) => void act(runner));
  const lead = () => leadOf(app).run;
  const can = () => lead().project !== null && lead().phase !== 'failed';
  const going = () => app.led().some((runner) => runner.going);
  const atEnd = () => app.led().every(({ run }) => run.phase === 'done');
  const tick = () => lead().state?.tick ?? 0;
  const playOrPause = () => {
    const [stop, again] = [going(), atEnd()];
    each((runner) => (stop ? runner.pause() : (again || runner.run.phase !== 'done') && runner.play()));
  };
  const again = (/** @type {Runner} */ runner) => {
    const project = runner === own ? store.project : runner.run.project;
    return project && runner.load(project);
  };
  actions.add(
    { id: 'run.play', label: 'Play or pause', icon: () => (going() ? 'pause' : 'play'), keys: ['Space'],
      enabled: can, pressed: going, run: playOrPause },
    { id: 'run.back', label: 'One step back', icon: 'back', keys: [','],
      enabled: () => can() && tick() > 0, run: () => each((runner) => runner.back()) },
    { id: 'run.step', label: 'One step', icon: 'step', keys: ['.'],
      enabled: () => can() && !atEnd(), run: () => each((runner) => runner.step()) },
    { id: 'run.end', label: 'To the end', icon: 'end', keys: ['E'],
      enabled: () => can() && !atEnd(), run: () => each((runner) => runner.end()) },
    { id: 'run.reset', label: 'Back to the start', icon: 'reset', keys: ['Shift+E'],
      enabled: can, run: () => each((runner) => runner.reset()) },
    { id: 'run.cancel', label: 'Cancel', icon: 'cancel', keys: ['Escape'],
      enabled: () => app.led().some(({ busy }) => busy), run: () => each((runner) => runner.cancel()) },
    { id: 'run.again', label: 'Run again', icon: 'again', keys: ['R'],
      enabled: () => app.problemsOf(store.project.drawing).length === 0, run: () => each(again) },
  );
}

/** The slider follows the run, except under a hand. @param {App} app */
function createSlider(app) {
  let held = false;
  const slider = h('input', { type: 'range', min: '0', max: '0', value: '0', id: 'tick', 'aria-label': 'Iteration',
    oninput: () => app.led().forEach((runner) => void runner.seek(Number(slider.value))),
    onpointerdown: () => { held = true; },
    onpointerup: () => { held = false; }, onpointercancel: () => { held = false; }, onblur: () => { held = false; } });
  const follow = (/** @type {Run} */ run, /** @type {string} */ text) => {
    if (!held) {
      slider.max = String(expectedTicks(run));
      slider.value = String(run.state?.tick ?? 0);
    }
    slider.setAttribute('aria-valuetext', text);
  };
  return { slider, follow };
}

/** @param {App} app  @returns {() => void} shows how things are now */
export function installTimeline(app) {
  const { actions, runner, store, announce } = app;
  addActions(app);
  const { slider, follow } = createSlider(app);
  const stage = h('output', { className: 'stage-name', for: 'tick' });
  const footer = /** @type {HTMLElement} */ (document.getElementById('timeline'));
  footer.append(
    h('div', { className: 'buttons', role: 'group', 'aria-label': 'Run' },
      actions.button('run.reset'), actions.button('run.back'),
      actions.button('run.play', { className: 'primary' }), actions.button('run.step'),
      actions.button('run.end'), actions.button('run.cancel')),
    slider, stage, createSpeed(app, runner, app.led));

  let spoken = '';
  const refresh = () => {
    const { run } = leadOf(app);
    const { project } = runner.run;
    const resting = project === null || haveSameMesh(project, store.project);
    const text = resting ? describe(run) : 'out of date: waiting for the drawing to rest';
    follow(run, text);
    setText(stage, resting && run.error ? `no mesh: ${titleOf(run.error.code)}` : text);  // the rest is above the stage
    stage.title = text;
    if (!resting) return;
    const heard = `${run.phase} ${run.state?.stage ?? ''} ${run.error?.message ?? ''}`;  // not every iteration
    if (heard !== spoken) announce(text);
    spoken = heard;
  };
  runner.subscribe(refresh);
  store.subscribe(refresh);
  return refresh;
}
