// Over the stage: what is wrong, in plain words, with buttons that mend it, and a way to the place.
/** @import { App } from '../app' */
/** @import { Point } from '../types' */
/** @import { Fix, Problem } from './errors/fixes.js' */
/** @import { Sketch } from './sketch.js' */
import { h, setText } from '../panels/dom.js';
import { icon } from '../panels/icons.js';
import { fixesFor, placeOf } from './errors/fixes.js';
import { titleOf } from './errors/words.js';
import { drawPlace } from './marks.js';
import { diagonalOf } from './model/drawing.js';

/** A message of the page's own: a file that was not read, what was left out of one.
 * @typedef {{title: string, details: string, problem?: Problem}} Notice */

/** @param {App} app  @param {Sketch} sketch */
export function installErrorBar(app, sketch) {
  const { store, runner, stage, actions, announce } = app;
  /** @type {Notice | null} */
  let notice = null;
  /** @type {Point | null} */
  let place = null;
  const title = h('strong'), details = h('span', { className: 'details' }), buttons = h('div', { className: 'buttons' });
  const bar = h('section', { className: 'error-bar', 'aria-label': 'Problem', hidden: true },
    h('div', { className: 'words' }, icon('warning'), title, details), buttons);
  stage.element.append(bar);

  /** What there is to show now. @returns {Notice | null} */
  function current() {
    const { phase, error, project } = runner.run;
    if (notice) return notice;
    if (phase === 'failed' && error && project === store.project) return { title: titleOf(error.code), details: error.message, problem: error };
    const [problem, ...more] = sketch.problemsOf(store.project.drawing);
    if (problem) return { title: titleOf(problem.code), details: problem.message + (more.length > 0 ? ` And ${more.length} more.` : ''), problem };
    if (phase !== 'cancelled') return null;
    return { title: titleOf('CANCELLED'), details: '', problem: { code: 'CANCELLED', message: '', where: {} } };
  }

  function apply(/** @type {Fix} */ fix) {
    notice = null;
    if ('action' in fix) actions.run(fix.action);
    else {
      store.change(fix.label, fix.change(store.project));
      announce(`${fix.label}: done`);
    }
    refresh();
    stage.overlay.focus({ preventScroll: true });
  }

  function showPlace(/** @type {Point} */ at) {
    const scale = Math.max(stage.view.scale, 0.25 * Math.min(stage.view.width, stage.view.height) / (0.1 * diagonalOf(store.project.drawing)));
    const { width, height } = stage.view;
    stage.look({ ...stage.view, scale, left: at[0] - width / scale / 2, top: at[1] + height / scale / 2 });
  }

  /** @param {Notice} shown  @returns {HTMLElement[]} */
  function buttonsFor({ problem }) {
    const made = [];
    if (place) made.push(h('button', { type: 'button', onclick: () => place && showPlace(place) }, 'Show me'));
    const fixes = problem ? fixesFor(problem, store.project) : [];
    made.push(...fixes.map((fix, i) => h('button', { type: 'button', className: i === 0 ? 'primary fix' : 'fix', onclick: () => apply(fix) }, fix.label)));
    if (notice) made.push(h('button', { type: 'button', 'aria-label': 'Close this message', onclick: () => {
      notice = null;
      refresh();
    } }, icon('close')));
    return made;
  }

  let builtFor = /** @type {unknown[]} */ ([]);
  function refresh() {
    const shown = current();
    bar.hidden = shown === null;
    if (shown === null) {
      builtFor = [];
      if (place) stage.invalidate('overlay');
      place = null;
      return;
    }
    setText(title, shown.title);
    setText(details, shown.details);
    bar.dataset.code = shown.problem?.code ?? '';
    const key = [shown.problem ?? notice, store.project, store.gesture];
    if (key.every((value, i) => value === builtFor[i])) return;
    builtFor = key;
    place = shown.problem ? placeOf(shown.problem, store.project) : null;
    stage.invalidate('overlay');
    buttons.replaceChildren(...(store.gesture === '' ? buttonsFor(shown) : []));  // a drag goes on
  }

  let waiting = false;
  const soon = () => {
    if (waiting) return;
    waiting = true;
    requestAnimationFrame(() => {
      waiting = false;
      refresh();
    });
  };
  store.subscribe((project, before) => {
    if (project !== before && store.gesture === '') notice = null;
    soon();
  });
  runner.subscribe(soon);
  stage.overlays.push((context, view) => {
    if (place && sketch.meetings.length === 0) drawPlace(context, view, sketch, place);
  });
  return {
    /** @param {Notice} message */
    show(message) {
      notice = message;
      announce(`${message.title} ${message.details}`);
      refresh();
    },
  };
}
