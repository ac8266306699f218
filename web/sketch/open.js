// Opens files: by the button, dropped anywhere, or pasted.
/** @import { App } from '../app' */
/** @import { Drawing, Project } from '../types' */
/** @import { ReadDomain } from 'lpquad' */
/** @import { Notice } from './error_bar.js' */
import { h } from '../panels/dom.js';
import { listenForDrops } from '../files/dropped.js';
import { besideThePage } from '../files/reading.js';
import { emptyDrawing, emptyProject } from '../state/project.js';
import { replaceProject } from '../state/replace.js';
import { diagonalOf } from './model/drawing.js';
import { edgeLengths, median } from './model/geometry.js';

/**
 * Takes files that are its own and tells whether it did.
 * @typedef {(files: File[], signal: AbortSignal) => Promise<boolean> | boolean} Opener
 */

const mostBytes = 64 * 2 ** 20, mostPoints = 200000, patience = 20000, longestName = 200;
const endings = ['.json', '.geojson', '.svg', '.poly', '.msh', '.dxf'];
const hasEnding = (/** @type {string} */ name) => endings.some((ending) => name.toLowerCase().endsWith(ending));

/** A mesh size for a domain that brings none: the spacing of its points within reason. @param {Drawing} drawing */
export function sensibleSize(drawing) {
  const diagonal = diagonalOf(drawing);
  const spacing = median(drawing.regions.flatMap(({ loops }) => loops.flatMap((loop) => edgeLengths(loop))));
  return Number(Math.min(diagonal / 40, Math.max(diagonal / 80, spacing)).toPrecision(2));
}

/** @param {ReadDomain} read  @param {string} [name]  of the file  @returns {Project} */
export function fromRead({ regions, polylines, points, h: given, sizes = [], guides = [], seedPoints = [] }, name = '') {
  const drawing = { regions, polylines, points };
  const size = given !== undefined && given > 0 ? given : sensibleSize(drawing);
  return { ...emptyProject, name: name.slice(0, longestName), drawing, options: { size }, sizes, guides, seedPoints };
}

/** The title where a file is of no use: it speaks of the file, not of the drawing that stays. @param {string} code */
function refusalOf(code) {
  if (code === 'PARSE_ERROR') return 'This file cannot be read.';
  if (code === 'IO_ERROR') return 'A file could not be read.';
  return code === 'EMPTY' ? 'There is nothing to mesh in this file.' : 'This file cannot be used.';
}

/** @param {Drawing} drawing */
const pointCount = ({ regions, polylines }) =>
  regions.reduce((sum, { loops }) => sum + loops.reduce((n, loop) => n + loop.length, 0), 0)
  + polylines.reduce((sum, { points }) => sum + points.length, 0);

/** @param {Promise<ReadDomain>} reading  @returns {Promise<ReadDomain>} */
function within(reading) {
  const late = new Promise((_, reject) => setTimeout(() => reject(Object.assign(
    new Error('Reading it takes too long.'), { code: 'TOO_LARGE', where: {} })), patience));
  return /** @type {Promise<ReadDomain>} */ (Promise.race([reading, late]));
}

/** @param {string | Uint8Array} source  @param {string} name  @param {AbortSignal} signal */
const read = (source, name, signal) => besideThePage(signal, (engine) => within(engine.readDomain(source, name ? { name } : {})));

/** Makes files, or pasted text, the drawing. */
class Opening {
  #app;
  #show;

  /** @param {App} app  @param {(notice: Notice) => void} show */
  constructor(app, show) {
    this.#app = app;
    this.#show = show;
  }

  /** @param {ReadDomain} domain  @param {string} name  @param {string} [title]  of the drawing */
  #take(domain, name, title = name) {
    const { announce, store } = this.#app;
    replaceProject(this.#app, `Open ${name}`, { ...fromRead(domain, title), comparison: store.project.comparison });
    announce(`${name} opened: ${pointCount(domain)} points`);
    if (domain.warnings.length > 0)
      this.#show({ title: `${name} was opened, with changes.`, details: domain.warnings.map(({ message }) => message).join(' ') });
  }

  /** @param {unknown} thrown  @param {string} name */
  fail(thrown, name) {
    const { code: given, message, where = {} } = /** @type {any} */ (thrown);
    const code = typeof given === 'string' ? given : 'IO_ERROR';  // errors of the browser have numbers
    const line = where.line === undefined ? '' : ` (line ${where.line})`;
    this.#show({ title: refusalOf(code), details: `${name}: ${message}${line}`, refused: true });
  }

  /** @param {AbortSignal} signal  @param {() => Promise<string | Uint8Array>} source  @param {string} name  @param {string} [title]  of the drawing */
  async #openSource(signal, source, name, title) {
    try {
      this.#app.announce(`Opening ${name}`);
      const domain = await read(await source(), name.includes('.') ? name : '', signal);
      signal.throwIfAborted();
      refuseCount(pointCount(domain));
      this.#take(domain, name, title);
    } catch (thrown) {
      if (!signal.aborted) this.fail(thrown, name);
    }
  }

  /** @param {File} file  @param {File[]} files  it, and what came with it  @param {AbortSignal} signal */
  async #openOne(file, files, signal) {
    try {
      for (const opener of this.#app.openers) if (await opener(files, signal) || signal.aborted) return;
    } catch (thrown) {
      if (!signal.aborted) this.fail(thrown, file.name);
      return;
    }
    if (file.size > mostBytes) return this.fail({ code: 'TOO_LARGE', message: `It has ${Math.round(file.size / 2 ** 20)} MiB; the page takes 64.` }, file.name);
    await this.#openSource(signal, async () => new Uint8Array(await file.arrayBuffer()), file.name);
  }

  /** @param {File[]} files */
  async openFiles(files) {
    const file = files.find(({ name }) => hasEnding(name)) ?? files[0];
    if (file !== undefined) await this.#app.reading(file.name, (signal) => this.#openOne(file, files, signal));
  }

  /** @param {string} text */
  async openPasted(text) {
    await this.#app.reading('what was pasted', (signal) => this.#openSource(signal, async () => text, 'What was pasted', 'Pasted drawing'));
  }
}

/** @param {number} points */
function refuseCount(points) {
  if (points > mostPoints) throw Object.assign(
    new Error(`It has ${points} points; ${mostPoints} can be edited here. The command line meshes it.`), { code: 'TOO_LARGE' });
  if (points === 0) throw Object.assign(new Error('It has no outline.'), { code: 'EMPTY' });
}

/** @param {(files: File[]) => void} open */
function createInput(open) {
  const input = h('input', { type: 'file', multiple: true, hidden: true, 'aria-label': 'Files to open', onchange: () => {
    open([...input.files ?? []]);
    input.value = '';
  } });
  return input;
}

/** @param {Opening} opening */
function listenForPaste(opening) {
  window.addEventListener('paste', (event) => {
    if (event.target instanceof HTMLInputElement || event.target instanceof HTMLTextAreaElement) return;
    const files = [...event.clipboardData?.files ?? []], text = event.clipboardData?.getData('text/plain') ?? '';
    if (files.length > 0) void opening.openFiles(files);
    else if (text.trim() !== '') void opening.openPasted(text);
  });
}

/** @param {App} app  @param {(notice: Notice) => void} show */
export function installOpening(app, show) {
  const opening = new Opening(app, show);
  const openFiles = (/** @type {File[]} */ files) => opening.openFiles(files);
  app.openFiles = openFiles;
  const input = createInput((files) => void openFiles(files));
  document.body.append(input);
  app.actions.add(
    { id: 'file.open', label: 'Open a file', icon: 'open', keys: ['Ctrl+O'], run: () => input.click() },
    { id: 'sketch.empty', label: 'Begin empty', icon: 'file', run: () => {
      replaceProject(app, 'Begin empty', { ...emptyProject, drawing: emptyDrawing });
      app.actions.run('tool.polygon');
    } },
  );
  listenForDrops(app.stage.element, openFiles, (thrown) => opening.fail(thrown, 'What was dropped'));
  listenForPaste(opening);
}
