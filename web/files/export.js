// Meshes to take along: one button per format that the library writes. For the plane and for space.
/** @import { OptionInfo, WriteOptions } from 'lpquad' */
import { h } from '../panels/dom.js';
import { icon } from '../panels/icons.js';
import { download } from './download.js';
import { formats } from './formats.js';

/**
 * The mesh that may leave the page: that of what is on the screen as it is now; or why there is none.
 * @typedef {() => {mesh: {[member: string]: any, report: object}, reason: ''} | {mesh: null, reason: string}} Current
 * What exporting needs of a page; `name`: the files', without ending.
 * @typedef {{announce: (text: string) => void, notify: (text: string) => void, current: Current, name: () => string,
 *   runner: {engine: () => Promise<import('lpquad/worker').LpquadWorker>}}} Exporting
 */

/** An option 'mshVersion' is one of format 'msh'. @param {OptionInfo} option  @param {string} format */
const belongs = ({ name }, format) => new RegExp(`^${format}[A-Z]`).test(name);

/** @param {Exporting} page  @param {string[]} known  formats  @param {OptionInfo[]} writeOptions */
export function createExport(page, known, writeOptions) {
  const order = Object.keys(formats);
  const rows = [...known].sort((a, b) => order.indexOf(a) - order.indexOf(b))
    .map((format) => createRow(page, format, writeOptions.filter((option) => belongs(option, format))));
  const reason = h('p', { className: 'reason', id: 'export-reason' });
  const refresh = () => {
    const { mesh, reason: why } = page.current();
    reason.textContent = why;
    reason.hidden = why === '';
    for (const { button } of rows) button.setAttribute('aria-disabled', String(mesh === null));
  };
  return { element: h('section', null, h('h2', null, 'Mesh'), reason, h('ul', { className: 'formats' }, ...rows.map(({ row }) => row))), refresh };
}

/** @param {Exporting} page  @param {string} format  @param {OptionInfo[]} options */
function createRow(page, format, options) {
  const { title, use } = textOf(format);
  const selects = options.map(createSelect);
  const chosen = () => Object.fromEntries(selects.map(({ name, select }) => [name, select.value]));
  const button = h('button', { type: 'button', 'data-format': format, 'aria-label': `Download .${format}`, 'aria-describedby': 'export-reason',
    title: `${title}: ${use}`, onclick: () => void save(page, format, chosen()) }, icon('download'), `.${format}`);
  const row = h('li', null, button, h('span', null, h('strong', null, title), ` – ${use}`, ...selects.map(({ label }) => label)));
  return { row, button };
}

/** Also of a format that is newer than the page. @param {string} format  @returns {{title: string, use: string, type?: string}} */
const textOf = (format) => formats[/** @type {keyof typeof formats} */ (format)] ?? { title: format.toUpperCase(), use: '' };

/** @param {OptionInfo} option */
function createSelect({ name, choices = [], default: usual, help }) {
  const select = h('select', { title: help, 'aria-label': help.replace(/\.$/, '') }, ...choices.map((choice) => h('option', { value: choice, selected: choice === usual }, choice)));
  return { name, select, label: h('label', null, select) };
}

/** @param {Exporting} page  @param {string} format  @param {WriteOptions} options */
async function save({ announce, current, name, notify, runner }, format, options) {
  const { mesh, reason } = current();
  if (mesh === null) return notify(reason);
  const file = `${name()}.${format}`;
  try {
    const { report: _, surface: __, ...bare } = mesh;  // written from its points and quads alone
    download(file, await (await runner.engine()).writeMesh(/** @type {any} */ (bare), /** @type {any} */ (format), options), textOf(format).type);
    announce(`Saved as ${file}`);
  } catch (error) {
    notify(`${file} could not be written: ${/** @type {Error} */ (error).message}`);
  }
}
