// Over the stage: what is wrong, in plain words, with buttons that mend it, and a way to the place.
/** @import { App } from '../app' */
/** @import { Point } from '../types' */
/** @import { Fix, Problem } from './errors/fixes.js' */
/** @import { Sketch } from './sketch.js' */
import { toScreen } from '../draw/view.js';
import { h, setText } from '../panels/dom.js';
import { icon } from '../panels/icons.js';
import { atNextPicture } from '../panels/next_picture.js';
import { messageInWords } from '../run/words.js';
import { fixesFor, placeOf } from './errors/fixes.js';
import { titleOf } from './errors/words.js';
import { drawPlace } from './marks.js';
import { diagonalOf } from './model/drawing.js';

/** A message of the page's own: a file that was not read, what was left out of one.
 * @typedef {{title: string, details: string, problem?: Problem, refused?: boolean}} Notice  refused: another file may do */

/** Where nobody did wrong: what the bar is instead of a problem. @type {Record<string, string>} */
const neutral = { EMPTY: 'What to do', CANCELLED: 'What to do', OPENED: 'What is not as in the file' };

export class ErrorBar {
  #app;
  #sketch;
  /** @type {Notice | null} */
  #notice = null;
  /** Where what is wrong is. @type {Point | null} */
  #place = null;
  /** What the buttons were made for. @type {unknown[]} */
  #builtFor = [];
  #title = h('strong');
  #details = h('span', { className: 'details' });
  #buttons = h('div', { className: 'buttons' });
  #bar = h('section', { className: 'error-bar', 'aria-label': 'Problem', hidden: true },
    h('div', { className: 'words' }, icon('warning'), this.#title, this.#details), this.#buttons);

  /** @param {App} app  @param {Sketch} sketch */
  constructor(app, sketch) {
    this.#app = app;
    this.#sketch = sketch;
    const { store, runner, stage } = app;
    stage.element.append(this.#bar);
    const soon = atNextPicture(() => this.#refresh());
    store.subscribe((project, before) => {
      if (project !== before && store.gesture === '') this.#notice = null;
      soon();
    });
    runner.subscribe(soon);
    stage.overlays.push((context, view) => {
      if (this.#place && sketch.meetings.length === 0) drawPlace(context, view, sketch, this.#place);
    });
  }

  /** @param {Notice} message */
  show(message) {
    this.#notice = message;
    this.#app.announce(`${message.title} ${message.details}`);
    this.#refresh();
  }

  /** What there is to show now. @returns {Notice | null} */
  #current() {
    const { store, runner: { run: { phase, error, project } } } = this.#app;
    if (this.#notice) return this.#notice;
    if (phase === 'failed' && error && project === store.project) return { title: titleOf(error.code), details: messageInWords(error.message), problem: error };
    const [problem, ...more] = this.#sketch.problemsOf(store.project.drawing);
    if (problem) return { title: titleOf(problem.code), details: problem.message + (more.length > 0 ? ` And ${more.length} more.` : ''), problem };
    if (phase !== 'cancelled') return null;
    return { title: titleOf('CANCELLED'), details: '', problem: { code: 'CANCELLED', message: '', where: {} } };
  }

  #refresh() {
    const { store } = this.#app;
    const shown = this.#current();
    this.#bar.hidden = shown === null;
    if (shown === null) {
      this.#builtFor = [];
      this.#mark(null);
      return;
    }
    setText(this.#title, shown.title);
    setText(this.#details, shown.problem?.code === 'EMPTY' ? 'Click the corners of an outline here, or open a file.' : shown.details);
    const code = shown.problem?.code ?? (shown.refused ? '' : 'OPENED');
    this.#bar.dataset.code = code;
    this.#bar.ariaLabel = neutral[code] ?? 'Problem';
    const key = [shown.problem ?? this.#notice, store.project, store.gesture];
    if (key.every((value, i) => value === this.#builtFor[i])) return;
    this.#builtFor = key;
    this.#mark(shown.problem ? placeOf(shown.problem, store.project) : null);
    if (store.gesture === '') this.#stepAside();
    this.#buttons.replaceChildren(...(store.gesture === '' ? this.#buttonsFor(shown) : []));  // a drag goes on
  }

  /** @param {Point | null} place */
  #mark(place) {
    if (place || this.#place) this.#app.stage.invalidate('overlay');
    this.#place = place;
  }

  /** To the other end of the stage where the place is that it would hide. */
  #stepAside() {
    const { view } = this.#app.stage;
    this.#bar.classList.toggle('below', this.#place !== null && toScreen(view, ...this.#place)[1] < view.height / 2);
  }

  /** @param {Notice} shown  @returns {HTMLElement[]} */
  #buttonsFor({ problem, refused = false }) {
    const made = [], place = this.#place;
    if (refused) made.push(h('button', { type: 'button', className: 'primary', onclick: () => this.#app.actions.run('file.open') }, 'Open another file'));
    if (place) made.push(h('button', { type: 'button', onclick: () => this.#look(place) }, 'Show me'));
    const fixes = problem ? fixesFor(problem, this.#app.store.project) : [];
    made.push(...fixes.map((fix, i) => h('button', { type: 'button', className: i === 0 ? 'primary fix' : 'fix', onclick: () => this.#apply(fix) }, fix.label)));
    if (this.#notice) made.push(h('button', { type: 'button', 'aria-label': 'Close this message', onclick: () => {
      this.#notice = null;
      this.#refresh();
    } }, icon('close')));
    return made;
  }

  /** @param {Fix} fix */
  #apply(fix) {
    const { actions, announce, stage, store } = this.#app;
    this.#notice = null;
    if ('action' in fix) actions.run(fix.action);
    else {
      store.change(fix.label, fix.change(store.project));
      announce(`${fix.label}: done`);
    }
    this.#refresh();
    stage.overlay.focus({ preventScroll: true });
  }

  /** @param {Point} at */
  #look(at) {
    const { stage, store } = this.#app, { width, height } = stage.view;
    const scale = Math.max(stage.view.scale, 0.25 * Math.min(width, height) / (0.1 * diagonalOf(store.project.drawing)));
    stage.look({ ...stage.view, scale, left: at[0] - width / scale / 2, top: at[1] + height / scale / 2 });
  }
}
