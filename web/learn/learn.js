// The Learn tab: one chapter at a time, with its live figure on the stage and its formula.
/** @import { App } from '../app' */
/** @import { Chapter } from './chapters.js' */
/** @import { Project } from '../types' */
import { h } from '../panels/dom.js';
import { chapters } from './chapters.js';
import { showFigure, watch } from './figure.js';
import { paperReference } from './paper.js';

/** @param {App} app */
export function installLearn(app) {
  const { actions, keeping, stage, store, tabs } = app;
  let at = -1;
  const list = h('ol', { className: 'chapters' }, ...chapters.map(({ id, title }, k) =>
    h('li', null, h('a', { href: `#chapter=${id}`, onclick: (/** @type {MouseEvent} */ event) => follow(event, k) }, title))));
  const page = h('article', { 'aria-live': 'off' });
  const body = tabs.add('learn', 'Learn', page, h('nav', { 'aria-label': 'Chapters' }, list), paperReference());

  /** @param {MouseEvent} event  @param {number} k */
  function follow(event, k) {
    if (event.ctrlKey || event.metaKey || event.shiftKey) return;  // a tab of its own
    event.preventDefault();
    open(k);
  }

  /** @param {number} k  @param {{figure?: boolean, before?: Project}} [how]  without its figure: the link brought another */
  function open(k, { figure = true, before = store.project } = {}) {
    at = k;
    const chapter = chapters[k];
    const focused = document.activeElement?.closest('[role=tabpanel]');
    tabs.open('learn');
    page.replaceChildren(...pageOf(chapter, k, app));
    if (focused) page.querySelector('h2')?.focus({ preventScroll: true });  // what had the focus is gone
    [...list.children].forEach((item, i) => item.firstElementChild?.toggleAttribute('aria-current', i === k));
    if (figure) showFigure(app, chapter);
    keeping.open(chapter.id, before, figure);
    app.announce(`Chapter ${k + 1} of ${chapters.length}: ${chapter.title}`);
    actions.refresh();
    body.scrollTop = 0;
  }

  function leave() {
    keeping.leave();
    stage.fit();
    tabs.open('domain');
    app.announce('Back to your drawing');
  }

  const reading = () => at >= 0 && tabs.current === 'learn';  // elsewhere a key must not take the drawing away
  actions.add(
    { id: 'learn.start', label: 'Start the tour', icon: 'next', run: () => open(0) },
    { id: 'learn.next', label: 'Next chapter', icon: 'next', keys: ['N'], enabled: () => reading() && at < chapters.length - 1, run: () => open(at + 1) },
    { id: 'learn.previous', label: 'Previous chapter', icon: 'previous', keys: ['Shift+N'], enabled: () => reading() && at > 0, run: () => open(at - 1) },
    { id: 'learn.watch', label: 'Watch it happen', icon: 'play', enabled: () => keeping.inTour, run: () => watch(app, chapters[at]) },
    { id: 'learn.leave', label: 'Back to my drawing', icon: 'undo', enabled: () => keeping.inTour, run: leave },
    { id: 'learn.figure', label: 'Show its figure', icon: 'again', enabled: () => at >= 0 && store.project !== keeping.chapter.figure, run: () => open(at) },
  );
  page.append(
    h('h2', null, 'From an outline to quads, in seven steps'),
    h('p', null, 'A short tour for those who have never meshed anything. Every step has a figure that you can play, change and undo; your drawing comes back with Undo.'),
    h('div', { className: 'buttons' }, actions.button('learn.start', { text: 'Start the tour', className: 'primary' })));

  /** Opens a chapter by its name in a link. @param {string | undefined} id  @param {boolean} figure  @param {Project} [before] */
  return (id, figure, before) => {
    const k = chapters.findIndex((chapter) => chapter.id === id);
    if (k >= 0) open(k, { figure, before });
  };
}

/** @param {Chapter} chapter  @param {number} k  @param {App} app */
function pageOf({ title, text, formula, spoken, source }, k, { actions }) {
  const last = k === chapters.length - 1;
  const onwards = actions.button(last ? 'learn.leave' : 'learn.next', { labelled: true, className: 'primary' });
  const math = h('div', { className: 'formula' });
  const calm = formula.replace(/<mo>([()‖])<\/mo>/g, '<mo stretchy="false">$1</mo>');
  math.innerHTML = `<math display="block" aria-label="${spoken}">${calm}</math>`;  // ours, from chapters.js
  return [
    h('p', { className: 'quiet' }, `${k + 1} of ${chapters.length}`),
    h('h2', { tabIndex: -1 }, title),
    ...text.split('\n\n').map((part) => h('p', null, part.trim().replace(/\s+/g, ' '))),
    h('figure', null, math, h('figcaption', null, source)),
    h('div', { className: 'buttons' }, actions.button('learn.watch', { labelled: true }), actions.button('learn.figure', { labelled: true }),
      last ? null : actions.button('learn.leave', { labelled: true })),
    // Comes last and stays in sight: no phone shows the end of a chapter at once.
    h('div', { className: 'buttons onwards' }, actions.button('learn.previous'), onwards),
  ];
}
