// "Copy as code": the project as a program that makes the same mesh, bit for bit.
/** @import { App } from '../../app' */
/** @import { OptionInfo } from 'lpquad' */
import { h } from '../../panels/dom.js';
import { icon } from '../../panels/icons.js';
import { copy } from '../download.js';
import { fileNameOf } from '../names.js';
import { toCommand } from './command.js';
import { toCpp } from './cpp.js';
import { toJavaScript } from './javascript.js';

/** @type {Record<string, {title: string, write: (project: import('../../types').Project, known: OptionInfo[], file: string) => string}>} */
export const languages = {
  javascript: { title: 'JavaScript', write: toJavaScript },
  cpp: { title: 'C++', write: toCpp },
  command: { title: 'Command line', write: toCommand },
};
const longest = 20_000;  // characters shown; all are copied

/** @param {App} app  @param {OptionInfo[]} known */
export function createCode(app, known) {
  const code = h('code');
  const view = h('pre', { className: 'code', tabIndex: 0, 'aria-label': 'Code', role: 'region' }, code);
  const language = h('select', { 'aria-label': 'Language', onchange: () => refresh() },
    ...Object.entries(languages).map(([id, { title }]) => h('option', { value: id }, title)));
  const text = () => languages[language.value].write(app.store.project, known, fileNameOf(app.store.project));
  const refresh = () => {
    const all = text();
    code.textContent = all.length > longest ? `${all.slice(0, longest)}\n… ${all.length - longest} characters more are copied` : all;
  };
  const copyAll = async () => {
    const done = await copy(text());
    if (!done) getSelection()?.selectAllChildren(view);
    app.notify(done ? `The ${languages[language.value].title} code is copied.` : 'This browser does not let the page copy. The code is selected: copy it with Ctrl+C.');
  };
  app.actions.add({ id: 'file.code', label: 'Copy as code', icon: 'copy', run: () => void copyAll() });
  const element = h('section', null, h('h2', null, 'As code'),
    h('p', { className: 'quiet' }, 'Makes the same mesh, bit for bit.'),
    h('div', { className: 'buttons' }, language, app.actions.button('file.code', { labelled: true })), view);
  return { element, refresh };
}
