// "Copy as code": what is on the screen as a program that makes the same mesh, bit for bit.
/** @import { App } from '../../app' */
import { h } from '../../panels/dom.js';
import { copy } from '../download.js';

const longest = 20_000;  // characters shown; all are copied

/** @param {Pick<App, 'actions' | 'notify'>} page  @param {Record<string, {title: string, write: () => string}>} languages
 * @param {string} about  what the code does */
export function createCode({ actions, notify }, languages, about) {
  const code = h('code');
  const view = h('pre', { className: 'code', tabIndex: 0, 'aria-label': 'Code', role: 'region' }, code);
  const language = h('select', { 'aria-label': 'Language', onchange: () => refresh() },
    ...Object.entries(languages).map(([id, { title }]) => h('option', { value: id }, title)));
  const text = () => languages[language.value].write();
  const refresh = () => {
    const all = text();
    code.textContent = all.length > longest ? `${all.slice(0, longest)}\n… ${all.length - longest} characters more are copied` : all;
  };
  const copyAll = async () => {
    const done = await copy(text());
    if (!done) getSelection()?.selectAllChildren(view);
    notify(done ? `The ${languages[language.value].title} code is copied.` : 'This browser does not let the page copy. The code is selected: copy it with Ctrl+C.');
  };
  actions.add({ id: 'file.code', label: 'Copy as code', icon: 'copy', run: () => void copyAll() });
  const element = h('section', null, h('h2', null, 'As code'), h('p', { className: 'quiet' }, about),
    h('div', { className: 'buttons' }, language, actions.button('file.code', { labelled: true })), view);
  return { element, refresh };
}
