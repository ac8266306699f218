// The bar below the stage: play, pause, step, end, reset, and the slider over the iterations.
/** @import { App } from '../app' */
/** @import { Run } from '../types' */
import { h, setText } from '../panels/dom.js';
import { createSpeed } from './speed.js';
import { describe, expectedTicks } from './words.js';

/** @param {App} app */
function addActions(app) {
  const { actions, runner, store } = app;
  const can = () => runner.run.project !== null && runner.run.phase !== 'failed';
  const atEnd = () => runner.run.phase === 'done';
  const atStart = () => (runner.run.state?.tick ?? 0) === 0;
  actions.add(
    { id: 'run.play', label: 'Play or pause', icon: () => (runner.going ? 'pause' : 'play'), keys: ['Space'], enabled: can,
      pressed: () => runner.going, run: () => void (runner.going ? runner.pause() : runner.play()) },
    { id: 'run.back', label: 'One step back', icon: 'back', keys: [','], enabled: () => can() && !atStart(), run: () => void runner.back() },
    { id: 'run.step', label: 'One step', icon: 'step', keys: ['.'], enabled: () => can() && !atEnd(), run: () => void runner.step() },
    { id: 'run.end', label: 'To the end', icon: 'end', keys: ['E'], enabled: () => can() && !atEnd(), run: () => void runner.end() },
    { id: 'run.reset', label: 'Back to the start', icon: 'reset', keys: ['Shift+E'], enabled: can, run: () => void runner.reset() },
    { id: 'run.cancel', label: 'Cancel', icon: 'cancel', keys: ['Escape'], enabled: () => runner.busy, run: () => runner.cancel() },
    { id: 'run.again', label: 'Run again', icon: 'again', keys: ['R'], enabled: () => app.problemsOf(store.project.drawing).length === 0,
      run: () => void runner.load(store.project) },
  );
}

/** The slider follows the run, except under a hand. @param {App} app */
function createSlider({ runner }) {
  let held = false;
  const slider = h('input', { type: 'range', min: '0', max: '0', value: '0', id: 'tick', 'aria-label': 'Iteration',
    oninput: () => void runner.seek(Number(slider.value)),
    onpointerdown: () => { held = true; },
    onpointerup: () => { held = false; }, onpointercancel: () => { held = false; }, onblur: () => { held = false; } });
  const follow = (/** @type {Run} */ run, /** @type {string} */ text) => {
    const end = expectedTicks(run);
    if (!held) {
      slider.max = String(end);
      slider.value = String(run.state?.tick ?? 0);
    }
    slider.style.setProperty('--part', String(end > 0 ? (run.state?.tick ?? 0) / end : 0));
    slider.setAttribute('aria-valuetext', text);
  };
  return { slider, follow };
}

/** @param {App} app */
export function installTimeline(app) {
  const { actions, runner, announce } = app;
  addActions(app);
  const { slider, follow } = createSlider(app);
  const stage = h('output', { className: 'stage-name', for: 'tick' });
  const footer = /** @type {HTMLElement} */ (document.getElementById('timeline'));
  footer.append(
    h('div', { className: 'buttons', role: 'group', 'aria-label': 'Run' },
      actions.button('run.reset'), actions.button('run.back'),
      actions.button('run.play', { className: 'primary' }), actions.button('run.step'),
      actions.button('run.end'), actions.button('run.cancel')),
    slider, stage, createSpeed(app));

  let spoken = '';
  runner.subscribe((run) => {
    const text = describe(run);
    follow(run, text);
    setText(stage, text);
    stage.title = text;
    const heard = `${run.phase} ${run.state?.stage ?? ''} ${run.error?.message ?? ''}`;  // not every iteration
    if (heard !== spoken) announce(text);
    spoken = heard;
  });
}
