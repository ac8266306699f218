// One sentence above the stage about something that happened and is not an error of the drawing; '' takes
// it away.
import { h } from './dom.js';
import { icon } from './icons.js';

/** @param {HTMLElement} stage  @returns {(text: string) => void} */
export function createNotices(stage) {
  const words = h('span');
  const close = h('button', { type: 'button', 'aria-label': 'Close the notice', title: 'Close', onclick: () => { bar.hidden = true; } }, icon('close'));
  const bar = h('div', { className: 'notice', hidden: true }, words, close);
  const spoken = h('div', { role: 'status' }, bar);
  stage.append(spoken);
  return (text) => {
    words.textContent = text;
    bar.hidden = text === '';
  };
}
