// A project, and where its run stands, as the fragment of an address:
//   #preset=plate&options=size:0.05,norm:2&layers=cells,density&tick=12&data=…
// Everything that is as the preset has it is left out; without a preset and data it is the first
// preset. What was drawn, painted or stroked is packed in `data`. A fragment may be anybody's: it is
// judged before anything of it is used.
/** @import { Project } from '../types' */
import { comparisons } from '../compare/comparisons.js';
import { chapters } from '../learn/chapters.js';
import { presets } from '../sketch/presets.js';
import * as judge from './judge.js';
import { pack, unpack } from './pack.js';
import { exactJson } from './project_file.js';
import { emptyProject } from './project.js';

/** @typedef {{tick?: number, chapter?: string}} Place  where a run stands, which chapter is open */

/** Longer links are cut by mail programs and chats; a file is better. */
export const longestLink = 8000;

/** @type {(keyof Project)[]} */
const drawn = ['drawing', 'sizes', 'guides', 'seedPoints'];

/** What changes a project and names none. */
const changing = ['name', 'options', 'layers', 'comparison'];

/** @param {string} id  @returns {Project} */
const base = (id) => presets.find((preset) => preset.id === id)?.project ?? emptyProject;

/** @param {unknown} a  @param {unknown} b */
const same = (a, b) => a === b || exactJson(a) === exactJson(b);

/** @param {Project} project  @param {Place} [place] */
export async function toFragment(project, { tick, chapter } = {}) {
  const from = base(project.preset);
  const data = Object.fromEntries(drawn.filter((name) => !same(project[name], from[name])).map((name) => [name, project[name]]));
  /** @type {Record<string, string | undefined>} */
  const parts = {
    preset: project.preset || undefined,
    name: project.name === from.name ? undefined : encodeURIComponent(project.name),
    chapter: chapter || undefined,
    options: same(project.options, from.options) ? undefined : written(project.options),
    layers: same(project.layers, from.layers) ? undefined : String(project.layers),
    comparison: project.comparison === from.comparison ? undefined : project.comparison,
    tick: tick === undefined ? undefined : String(tick),
  };
  // An empty drawing is told, too, where the rest would be taken for the first preset's.
  if (project.preset === '' && changing.some((name) => parts[name] !== undefined)) data.drawing = project.drawing;
  if (Object.keys(data).length > 0) parts.data = await pack(exactJson(data));
  return '#' + Object.entries(parts).filter(([, value]) => value !== undefined).map(([name, value]) => `${name}=${value}`).join('&');
}

/** @param {Project['options']} options */
const written = (options) => Object.entries(options).map(([name, value]) => `${name}:${value}`).join(',');

/** @param {string} text  @returns {Record<string, unknown>} */
function readOptions(text) {
  const pairs = text.split(',').filter(Boolean).map((pair) => pair.split(/:(.*)/s));
  return Object.fromEntries(pairs.map(([name, value = '']) => [name, readValue(value)]));
}

/** @param {string} text */
function readValue(text) {
  if (text === 'true' || text === 'false') return text === 'true';
  return /^-?[\d.]/.test(text) ? Number(text) : text;
}

/**
 * @param {string} fragment  with or without '#'
 * @returns {Promise<{project: Project | null, place: Place}>}  null: the fragment names no project
 */
export async function fromFragment(fragment) {
  try {
    return await read(new Map([...new URLSearchParams(fragment.replace(/^#/, '').replaceAll('+', '%2B'))]));
  } catch (error) {
    throw error instanceof judge.NotAProject ? error : new judge.NotAProject('it is cut off or damaged');
  }
}

/** The preset that is meant; '': the data is all, null: no project, or that of the chapter.
 * @param {Map<string, string>} parts  @param {Place} place */
function presetOf(parts, { chapter }) {
  const id = parts.get('preset') ?? '';
  if (id !== '' || parts.has('data')) return id;
  return chapter === undefined && changing.some((name) => parts.has(name)) ? presets[0].id : null;
}

const names = ['preset', 'name', 'chapter', 'options', 'layers', 'comparison', 'tick', 'data'];

/** @param {Map<string, string>} parts */
async function read(parts) {
  for (const name of parts.keys())
    if (!names.includes(name)) throw new judge.NotAProject(`it has an unknown part “${name.slice(0, 40)}”`);
  const place = readPlace(parts);
  const id = presetOf(parts, place);
  known('preset', judge.identifier(id ?? '', 'the preset'), presets);
  known('chapter', place.chapter ?? '', chapters);
  known('comparison', parts.get('comparison') ?? '', comparisons);
  if (id === null) return { project: null, place };
  const packed = parts.get('data');
  const [name, options, layers, comparison] = ['name', 'options', 'layers', 'comparison'].map((part) => parts.get(part));
  const project = judge.project({
    ...base(id),
    ...(packed !== undefined && judge.parts(JSON.parse(await unpack(packed)))),
    ...(name !== undefined && { name }),
    ...(options !== undefined && { options: readOptions(options) }),
    ...(layers !== undefined && { layers: layers === 'auto' ? layers : layers.split(',').filter(Boolean) }),
    ...(comparison !== undefined && { comparison }),
    preset: id,
  });
  return { project: shared(project, base(id)), place };
}

/** @param {string} what  @param {string} id  @param {{id: string}[]} all */
function known(what, id, all) {
  if (id !== '' && !all.some((one) => one.id === id)) throw new judge.NotAProject(`there is no ${what} “${id.slice(0, 40)}”`);
}

/** @param {Map<string, string>} parts  @returns {Place} */
function readPlace(parts) {
  const chapter = judge.identifier(parts.get('chapter') ?? '', 'the chapter');
  const tick = parts.get('tick') ?? '';
  if (!/^\d{0,9}$/.test(tick)) throw new judge.NotAProject(`“${tick.slice(0, 40)}” is no tick of a run`);
  return { ...(chapter && { chapter }), ...(tick && { tick: Number(tick) }) };
}

/** Parts equal to the preset's become the preset's own, so that comparisons stay cheap.
 * @param {Project} project  @param {Project} from */
function shared(project, from) {
  const equal = /** @type {(keyof Project)[]} */ (Object.keys(from)).filter((name) => same(project[name], from[name]));
  return { ...project, ...Object.fromEntries(equal.map((name) => [name, from[name]])) };
}
