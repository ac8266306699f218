// The bar below the stage: play, pause, step, end, reset, and the slider over the iterations.
/** @import { App } from '../app' */
import { h, setText } from '../panels/dom.js';

/** @param {App} app */
export function installTimeline({ actions, runner, store, announce }) {
  const can = () => runner.run.state !== null && runner.run.phase !== 'failed';
  actions.add(
    { id: 'run.play', label: 'Play or pause', icon: () => (runner.run.phase === 'playing' ? 'pause' : 'play'), keys: ['Space'], enabled: can,
      pressed: () => runner.run.phase === 'playing',
      run: () => void (runner.run.phase === 'playing' ? runner.pause() : runner.play()) },
    { id: 'run.back', label: 'One step back', icon: 'back', keys: [','], enabled: () => can() && (runner.run.state?.tick ?? 0) > 0,
      run: () => void runner.seek((runner.run.state?.tick ?? 1) - 1) },
    { id: 'run.step', label: 'One step', icon: 'step', keys: ['.'], enabled: () => can() && runner.run.phase !== 'done', run: () => void runner.step() },
    { id: 'run.end', label: 'To the end', icon: 'end', keys: ['E'], enabled: () => can() && runner.run.phase !== 'done', run: () => void runner.end() },
    { id: 'run.reset', label: 'Back to the start', icon: 'reset', keys: ['Shift+E'], enabled: can, run: () => void runner.seek(0) },
    { id: 'run.cancel', label: 'Cancel', icon: 'cancel', keys: ['Escape'], enabled: () => ['playing', 'starting'].includes(runner.run.phase), run: () => void runner.cancel() },
    { id: 'run.again', label: 'Run again', icon: 'again', keys: ['R'], run: () => void runner.load(store.project) },
  );
  const slider = h('input', { type: 'range', min: '0', max: '0', value: '0', id: 'tick', 'aria-label': 'Iteration',
    oninput: () => void runner.seek(Number(slider.value)) });
  const stage = h('output', { className: 'stage-name', for: 'tick' });
  const footer = /** @type {HTMLElement} */ (document.getElementById('timeline'));
  footer.append(
    h('div', { className: 'buttons', role: 'group', 'aria-label': 'Run' },
      actions.button('run.reset'), actions.button('run.back'),
      actions.button('run.play', { className: 'primary' }), actions.button('run.step'),
      actions.button('run.end'), actions.button('run.cancel')),
    slider, stage);

  let spoken = '';
  runner.subscribe(({ phase, state, history, error, result }) => {
    slider.max = String(history.at(-1)?.tick ?? 0);
    slider.value = String(state?.tick ?? 0);
    const text = describe(phase, state, error, result);
    setText(stage, text);
    slider.setAttribute('aria-valuetext', text);
    const heard = error ? error.message : `${phase} ${state?.stage ?? ''}`;
    if (heard !== spoken) announce(error ? error.message : text);
    spoken = heard;
  });
}

/** @type {Record<string, string>} */
export const stageNames = {
  seeds: 'fields', optimise: 'L_p optimisation', match: 'triangles to merge', clean: 'merged to quads',
  patch: 'cleaned up', smooth: 'patches remeshed', check: 'smoothed', done: 'done',
};

/** @param {import('../types').Phase} phase  @param {import('lpquad').State | null} state */
function describe(phase, state, /** @type {import('../types').Run['error']} */ error, /** @type {import('lpquad').MeshResult | null} */ result) {
  if (error) return error.code;
  if (phase === 'loading') return 'loading the mesher …';
  if (phase === 'cancelled') return 'cancelled';
  if (state === null) return 'starting …';
  if (state.stage === 'optimise') return `iteration ${state.iteration} of ${state.maxIterations}`;
  if (state.stage === 'done' && result) return `done: ${result.quads.length / 4} quads`;
  return stageNames[state.stage];
}
