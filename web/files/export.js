// Meshes to take along: one button per format that the library writes.
/** @import { App } from '../app' */
/** @import { Description, MeshFormat, OptionInfo, WriteOptions } from 'lpquad' */
import { h } from '../panels/dom.js';
import { icon } from '../panels/icons.js';
import { currentMesh } from './current.js';
import { download } from './download.js';
import { formats } from './formats.js';
import { fileNameOf } from './names.js';

/** An option 'mshVersion' is one of format 'msh'. @param {OptionInfo} option  @param {string} format */
const belongs = ({ name }, format) => new RegExp(`^${format}[A-Z]`).test(name);

/** @param {App} app  @param {Description} description */
export function createExport(app, { meshFormats, writeOptions }) {
  const order = Object.keys(formats);
  const rows = [...meshFormats].sort((a, b) => order.indexOf(a) - order.indexOf(b)).map((format) => createRow(app, format, writeOptions.filter((option) => belongs(option, format))));
  const reason = h('p', { className: 'reason', id: 'export-reason' });
  const refresh = () => {
    const { mesh, reason: why } = currentMesh(app);
    reason.textContent = why;
    reason.hidden = why === '';
    for (const { button } of rows) button.setAttribute('aria-disabled', String(mesh === null));
  };
  return { element: h('section', null, h('h2', null, 'Mesh'), reason, h('ul', { className: 'formats' }, ...rows.map(({ row }) => row))), refresh };
}

/** @param {App} app  @param {MeshFormat} format  @param {OptionInfo[]} options */
function createRow(app, format, options) {
  const { title, use } = formats[format] ?? { title: format.toUpperCase(), use: '' };
  const selects = options.map(createSelect);
  const chosen = () => Object.fromEntries(selects.map(({ name, select }) => [name, select.value]));
  const button = h('button', { type: 'button', 'data-format': format, 'aria-label': `Download .${format}`, 'aria-describedby': 'export-reason',
    title: `${title}: ${use}`, onclick: () => void save(app, format, chosen()) }, icon('download'), `.${format}`);
  const row = h('li', null, button, h('span', null, h('strong', null, title), ` – ${use}`, ...selects.map(({ label }) => label)));
  return { row, button };
}

/** @param {OptionInfo} option */
function createSelect({ name, choices = [], default: usual, help }) {
  const select = h('select', { title: help, 'aria-label': help.replace(/\.$/, '') }, ...choices.map((choice) => h('option', { value: choice, selected: choice === usual }, choice)));
  return { name, select, label: h('label', null, select) };
}

/** @param {App} app  @param {MeshFormat} format  @param {WriteOptions} options */
async function save(app, format, options) {
  const { mesh, reason } = currentMesh(app);
  if (mesh === null) return app.notify(reason);
  const name = `${fileNameOf(app.store.project)}.${format}`;
  try {
    const { report: _, ...bare } = mesh;
    const text = await (await app.runner.engine()).writeMesh(bare, format, options);
    download(name, text, formats[format]?.type);
    app.announce(`Saved as ${name}`);
  } catch (error) {
    app.notify(`${name} could not be written: ${/** @type {Error} */ (error).message}`);
  }
}
