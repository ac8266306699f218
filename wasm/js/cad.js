// STEP, IGES and BREP files as triangles, by occt-import-js (LGPL-2.1): a package of its own that the
// user installs and that is loaded only here.
import { withoutRepeats } from './cad-repeats.js';
import { LpquadError } from './errors.js';

const kinds = {
  step: { read: 'ReadStepFile', endings: ['step', 'stp'], begin: /^\s*ISO-10303-21/ },
  iges: { read: 'ReadIgesFile', endings: ['iges', 'igs'], begin: /^.{72}S/ },
  brep: { read: 'ReadBrepFile', endings: ['brep', 'brp'],
    begin: /^\s*(?:DBRep_DrawableShape|(?:Open )?CASCADE Topology)/ },
};

export const cadFormats = Object.freeze(Object.keys(kinds));

const formatOf = (name) => {
  const ending = /\.([a-z]+)$/i.exec(name)?.[1].toLowerCase();
  return cadFormats.find((format) => kinds[format].endings.includes(ending));
};

export const isCadFile = (name) => formatOf(name) !== undefined;

export const occtMissing = 'Reading CAD files needs the package occt-import-js, which is not installed: ' +
  'npm install occt-import-js.';

const silent = { print: () => {}, printErr: () => {} };  // copied: an instance writes itself into what it is given

/** An instance, from one, a promise of one, the package's function, or the installed package. */
async function instanceOf(occt) {
  const given = await (occt ?? import('occt-import-js').catch((cause) => {
    throw new LpquadError('IO_ERROR', occtMissing, {}, { cause });
  }));
  const factory = given.default ?? given;
  return typeof factory === 'function' ? factory({ ...silent }) : factory;
}

// Chords may leave the shape by a two-hundredth of a quad's side, where a size is known, and turn by 0.2 rad
// (31 to a circle): the triangles then bend less than the quads will.
const chordsPerSize = 200;
const ratioWithoutSize = 0.0002;  // of the mean of the box's sides, of which a quad has some hundredths
const quadsWithoutSize = 3000;    // that it is for, at least
const angle = 0.2;

const deflection = ({ size, quads = 0, linearDeflection, angularDeflection }) => {
  const absolute = linearDeflection ?? (size > 0 ? size / chordsPerSize : undefined);
  return {
    linearDeflectionType: absolute === undefined ? 'bounding_box_ratio' : 'absolute_value',
    linearDeflection: absolute ?? ratioWithoutSize * Math.min(1, Math.sqrt(quadsWithoutSize / quads)),
    angularDeflection: angularDeflection ?? angle,
  };
};

function imported(occt, bytes, format, options) {
  const params = { linearUnit: options.unit ?? 'millimeter', ...deflection(options) };
  let result;
  try {
    result = occt[kinds[format].read](bytes, params);
  } catch (cause) {
    result = { success: false, cause };
  }
  const meshes = result?.success ? result.meshes.filter((mesh) => mesh.index.array.length > 0) : [];
  if (format === 'step' && meshes.length === 0) refuseReferences(bytes);
  if (!result?.success) throw unreadable(bytes, format, result?.cause);
  return withoutRepeats(meshes);
}

/** What is wrong with a file that the package refuses without a word. */
function unreadable(bytes, format, cause) {
  if (bytes.length === 0) return new LpquadError('EMPTY', 'The file is empty.');
  const name = format.toUpperCase();
  const start = new TextDecoder('latin1').decode(bytes.subarray(0, 200)).replace(/^\xef\xbb\xbf/, '');
  const reason = kinds[format].begin.test(start) ? ''
    : `: it does not begin as ${name} files do. Is it a page of the web, or a reference in place of the file?`;
  return new LpquadError('PARSE_ERROR', `The file cannot be read as ${name}${reason || '.'}`, {}, { cause });
}

/** An assembly whose parts are in files of their own. */
function refuseReferences(bytes) {
  const text = new TextDecoder('latin1').decode(bytes), references =
    /(?:DOCUMENT_FILE|EXTERNAL_IDENTIFICATION_ASSIGNMENT)\s*\(\s*'([^']*\.[^'.]+)'/g;
  const names = [...new Set(Array.from(text.matchAll(references), ([, name]) => name.split(/[\\/]/).at(-1)))];
  if (names.length === 0) return;
  const some = names.slice(0, 3).join(', ') + (names.length > 3 ? ` and ${names.length - 3} more` : '');
  throw new LpquadError('EMPTY', 'There is no shape in this file, an assembly whose parts are in other files: ' +
    `${some}. Give these one by one, or save the assembly with its parts in one file.`);
}

/** Each name once: "bolt", "bolt 2", … */
function eachOnce(names) {
  const used = new Set(), next = new Map();
  return names.map((name) => {
    let unique = name, count = next.get(name) ?? 2;
    for (; used.has(unique); ++count) unique = `${name} ${count}`;
    next.set(name, count);
    used.add(unique);
    return unique;
  });
}

/** Names of bodies; a number where a file of several has no name. */
const bodyNames = (meshes) =>
  eachOnce(meshes.map(({ name }, number) => name?.trim() || (meshes.length > 1 ? `body ${number + 1}` : '')));

/** Faces of the B-rep as groups of triangles; what no face has is one more. */
function addBody(surface, body, mesh, at) {
  const { array } = mesh.index;
  for (let i = 0; i < array.length; ++i) surface.triangles[3 * at.triangle + i] = array[i] + at.point;
  surface.points.set(mesh.attributes.position.array, 3 * at.point);
  const group = (name) => surface.groupNames.push([body, name].filter(Boolean).join(' ')) - 1;
  let next = 0;
  const until = (end, name) => {
    if (end > next) surface.groups.fill(group(name), at.triangle + next, at.triangle + end);
    next = Math.max(next, end);
  };
  mesh.brep_faces.forEach(({ first, last }, number) => {
    until(first, 'rest');
    until(last + 1, `face ${number + 1}`);
  });
  until(array.length / 3, 'rest');
  at.point += mesh.attributes.position.array.length / 3;
  at.triangle += array.length / 3;
}

/** Bodies that touch stay apart; loose sheets are one body, so that those that belong together are joined. */
function numberBodies(surface, meshes, names) {
  let next = 0, sheets = -1;
  meshes.forEach((mesh, number) => {
    const { closed } = mesh, count = mesh.index.array.length / 3;
    const body = !closed && sheets >= 0 ? sheets : surface.bodyNames.push(names[number]) - 1;
    if (!closed) sheets = body;
    surface.bodies.fill(body, next, next += count);
  });
}

/** What readCad does, with an instance at hand. */
export function readCadWith(occt, bytes, options = {}) {
  const format = options.format ?? formatOf(options.name ?? '');
  if (!cadFormats.includes(format))
    throw new LpquadError('BAD_OPTION', `The format must be one of ${cadFormats.join(', ')}; ` +
      'give it, or a name that ends in .step, .stp, .iges, .igs, .brep or .brp.');
  const meshes = imported(occt, bytes, format, options);
  if (meshes.length === 0) throw new LpquadError('EMPTY', 'The file has no face with an area.');
  const sum = (count) => meshes.reduce((total, mesh) => total + count(mesh), 0);
  const triangles = sum((mesh) => mesh.index.array.length / 3);
  const surface = {
    points: new Float64Array(sum((mesh) => mesh.attributes.position.array.length)),
    triangles: new Uint32Array(3 * triangles), groups: new Int32Array(triangles), groupNames: [],
    bodies: new Int32Array(triangles), bodyNames: [], warnings: [],
  };
  const at = { point: 0, triangle: 0 };
  const names = bodyNames(meshes);
  meshes.forEach((mesh, number) => addBody(surface, names[number], mesh, at));
  numberBodies(surface, meshes, names);
  return surface;
}

/** @type {import('./cad.js').readCad} */
export async function readCad(source, options = {}) {
  const bytes = source instanceof ArrayBuffer ? new Uint8Array(source)
    : typeof source === 'string' ? new TextEncoder().encode(source) : source;
  return readCadWith(await instanceOf(options.occt), bytes, options);
}

/** Names as a line of an OBJ file can hold them: one line, no comment, no line that goes on; still each once. */
const plainNames = (names, kind) =>
  eachOnce(names.map((name, i) => name.replace(/[\s\\#]+/g, ' ').trim() || `${kind} ${i + 1}`));

/** A text that is read as the same number. */
const exact = (value) => (Object.is(value, -0) ? '-0' : String(value));

/** @type {import('./cad.js').surfaceAsObj} */
export function surfaceAsObj({ points, triangles, groups = [], groupNames = [], bodies = [], bodyNames: given = [] }) {
  const bodyTitles = given.length > 1 ? plainNames(given, 'body') : [];
  const groupTitles = groupNames.some(Boolean) ? plainNames(groupNames, 'group') : [];
  const lines = ['# lpquad'];
  for (let i = 0; i < points.length; i += 3)
    lines.push(`v ${exact(points[i])} ${exact(points[i + 1])} ${exact(points[i + 2])}`);
  for (let t = 0; t < triangles.length / 3; ++t) {
    const begins = (numbers) => t === 0 || numbers[t] !== numbers[t - 1];
    if (bodyTitles[bodies[t]] && begins(bodies)) lines.push(`o ${bodyTitles[bodies[t]]}`);
    if (groupTitles[groups[t]] && begins(groups)) lines.push(`g ${groupTitles[groups[t]]}`);
    lines.push(`f ${triangles[3 * t] + 1} ${triangles[3 * t + 1] + 1} ${triangles[3 * t + 2] + 1}`);
  }
  return `${lines.join('\n')}\n`;
}
