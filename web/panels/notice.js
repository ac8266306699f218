// One sentence above the stage about something that happened and is not an error of the drawing; '' takes
// it away.
import { h } from './dom.js';
import { icon } from './icons.js';

/**
 * Shows a sentence; with `stop` it is about something under way, which a button gives up.
 * @typedef {(text: string, stop?: () => void) => () => void} Notify  returns: takes it away, if nothing else was said since
 */

/** @param {HTMLElement} stage  @returns {Notify} */
export function createNotices(stage) {
  let said = 0, stop = () => {};
  const words = h('span');
  const close = h('button', { type: 'button', 'aria-label': 'Close the notice', title: 'Close', onclick: () => { bar.hidden = true; } }, icon('close'));
  const cancel = h('button', { type: 'button', 'aria-label': 'Cancel reading', title: 'Cancel (Escape)', onclick: () => stop() }, 'Cancel');
  const bar = h('div', { className: 'notice', hidden: true }, words, close, cancel);
  const spoken = h('div', { role: 'status' }, bar);
  stage.append(spoken);
  return (text, stopping) => {
    const mine = ++said;
    stop = stopping ?? stop;
    words.textContent = text;
    bar.hidden = text === '';
    close.hidden = stopping !== undefined;
    cancel.hidden = stopping === undefined;
    return () => { bar.hidden ||= mine === said; };
  };
}
