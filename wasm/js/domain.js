// A domain as the caller writes it to the packed arrays that cross into the core (wasm/marshal.h).
// Judges the form only, and names the path of what does not fit; the core judges the geometry.
import { LpquadError } from './errors.js';
import { checkList, checkNumber, fail, isList } from './lists.js';

const listed = (names) => `${names.slice(0, -1).join(', ')} and ${names.at(-1)}`;

// What domain files say about themselves; accepted and not read.
const comments = ['name', 'description', 'source', 'licence', 'license', 'warnings'];

/** Refuses members that nothing would read: a misspelt one would be missed in silence. */
export function checkObject(value, path, known) {
  if (value === null || typeof value !== 'object' || isList(value))
    fail(path, `an object { ${known.filter((name) => !comments.includes(name)).join(', ')} }`, value);
  for (const key of Object.keys(value))
    if (!known.includes(key))
      throw new LpquadError('PARSE_ERROR',
        `${path}.${key} is not known; ${path} has ${listed(known)}.`);
}

function appendPoint(out, value, path, where) {
  if (!isList(value) || value.length !== 2) fail(path, 'a point [x, y]', value);
  out.push(checkNumber(value[0], `${path}[0]`, where), checkNumber(value[1], `${path}[1]`, where));
}

/**
 * Appends the points of [[x, y], ..] or of a flat [x0, y0, x1, ..]; returns their number. The first
 * entry tells which of the two it is.
 */
function appendPoints(out, value, path, where = {}) {
  checkList(value, path, 'an array of points');
  const nested = value.length > 0 && isList(value[0]);
  if (!nested && value.length % 2 !== 0) fail(path, 'an even count of numbers x, y, x, y, …', value);
  const count = nested ? value.length : value.length / 2;
  for (let i = 0; i < value.length; ++i)
    if (nested) appendPoint(out, value[i], `${path}[${i}]`, { ...where, edge: i });
    else out.push(checkNumber(value[i], `${path}[${i}]`, { ...where, edge: i >> 1 }));
  return count;
}

/** Numbers names as they come; '' and undefined are -1, no name. */
class Names {
  list = [];
  #numbers = new Map();
  number(value, path) {
    if (value === undefined || value === null || value === '') return -1;
    if (typeof value !== 'string') fail(path, 'a text', value);
    if (!this.#numbers.has(value)) this.#numbers.set(value, this.list.push(value) - 1);
    return this.#numbers.get(value);
  }
}

/** Of the loop that comes last, of `size` points: its first may be repeated at its end. */
function edgesOf({ points }, size) {
  const first = points.length - 2 * size, last = points.length - 2;
  const repeated = size > 1 && points[first] === points[last] && points[first + 1] === points[last + 1];
  return repeated ? size - 1 : size;
}

function packTags(packed, tags, size, path, names) {
  checkList(tags, path, 'an array of texts, one per edge');
  const edges = edgesOf(packed, size);
  if (![0, edges, size].includes(tags.length)) fail(path, `as long as its loop has edges (${edges})`, tags);
  for (let e = 0; e < size; ++e) packed.edgeTags.push(names.number(tags[e], `${path}[${e}]`));
}

function packLoops(packed, { loops, tags }, path, region, names) {
  checkList(loops, `${path}.loops`, 'an array of loops');
  if (loops.length > 2 && loops.every((one) => isList(one) && one.length === 2 && !isList(one[0])))
    fail(`${path}.loops`, 'an array of loops, [[[x, y], …], …], so put a single loop into brackets', loops);
  checkList(tags ?? [], `${path}.tags`, 'an array with the tags of each loop');
  if ((tags?.length ?? 0) > loops.length)
    fail(`${path}.tags`, `a list of texts for each loop (${loops.length}), [['a', 'b', …], …]`, tags);
  packed.loopsPerRegion.push(loops.length);
  loops.forEach((points, loop) => {
    const size = appendPoints(packed.points, points, `${path}.loops[${loop}]`, { region, loop });
    packed.sizes.push(size);
    packTags(packed, tags?.[loop] ?? [], size, `${path}.tags[${loop}]`, names);
  });
}

function packRegions(packed, domain, names) {
  checkObject(domain, 'domain', ['loops', 'tags', 'regions', 'polylines', 'points', 'h', 'sizes', 'guides', 'seedPoints', ...comments]);
  if (domain.regions === undefined) {
    packed.regions.push('');
    return packLoops(packed, domain, 'domain', 0, names);
  }
  if (domain.loops !== undefined || domain.tags !== undefined)
    throw new LpquadError('PARSE_ERROR',
      'domain has regions, so its loops and tags belong into them, not beside them.');
  checkList(domain.regions, 'domain.regions', 'an array of regions').forEach((region, r) => {
    const path = `domain.regions[${r}]`;
    checkObject(region, path, ['loops', 'tags', 'name']);
    if (typeof (region.name ?? '') !== 'string') fail(`${path}.name`, 'a text', region.name);
    packed.regions.push(region.name ?? '');
    packLoops(packed, region, path, r, names);
  });
}

function packPolylines(packed, lines, names) {
  checkList(lines, 'domain.polylines', 'an array of polylines').forEach((line, i) => {
    const path = `domain.polylines[${i}]`;
    checkObject(line, path, ['points', 'tag']);
    packed.sizes.push(appendPoints(packed.points, line.points, `${path}.points`));
    packed.polylineTags.push(names.number(line.tag, `${path}.tag`));
  });
}

function packPoints(packed, points, names) {
  checkList(points, 'domain.points', 'an array of points').forEach((point, i) => {
    const path = `domain.points[${i}]`;
    if (isList(point)) appendPoint(packed.points, point, path);
    else {
      checkObject(point, path, ['position', 'tag']);
      appendPoint(packed.points, point.position, `${path}.position`);
    }
    packed.pointTags.push(names.number(point.tag, `${path}.tag`));
  });
}

/** Guides as two arrays: of all points, and of their number in each. */
export function packGuides(guides, path) {
  const points = [];
  const sizes = Array.from(checkList(guides, path, 'an array of lines'), (line, i) =>
    appendPoints(points, line, `${path}[${i}]`, { guide: i }));
  return { points: Float64Array.from(points), sizes: Int32Array.from(sizes) };
}

/** [[x, y, h], ..] or [x0, y0, h0, ..] as a flat array, likewise for other widths. */
export function packTuples(list, width, path, form) {
  checkList(list, path, form);
  const nested = isList(list[0]);
  if (nested ? !list.every((one) => isList(one) && one.length === width) : list.length % width !== 0) fail(path, form, list);
  const flat = nested ? list.flatMap((one) => [...one]) : [...list];
  return flat.every(Number.isFinite) ? Float64Array.from(flat) : fail(path, form, list);
}
export const sizesForm = 'points with a target size each: [[x, y, h], …], all finite numbers';

/** @param {import('./index.js').Domain} domain */
export function packDomain(domain) {
  const packed = { regions: [], loopsPerRegion: [], sizes: [], points: [], edgeTags: [],
    polylineTags: [], pointTags: [], seeds: [] };
  const names = new Names();
  packRegions(packed, domain, names);
  packPolylines(packed, domain.polylines ?? [], names);
  packPoints(packed, domain.points ?? [], names);
  appendPoints(packed.seeds, domain.seedPoints ?? [], 'domain.seedPoints');
  const h = domain.h === undefined ? 0 : checkNumber(domain.h, 'domain.h');
  const sizesAt = packTuples(domain.sizes ?? [], 3, 'domain.sizes', sizesForm);
  return { regions: packed.regions, tags: names.list, h, sizesAt,
    guides: packGuides(domain.guides ?? [], 'domain.guides'), seeds: Float64Array.from(packed.seeds),
    points: Float64Array.from(packed.points),
    loopsPerRegion: Int32Array.from(packed.loopsPerRegion), sizes: Int32Array.from(packed.sizes),
    edgeTags: Int32Array.from(packed.edgeTags),
    polylineTags: Int32Array.from(packed.polylineTags),
    pointTags: Int32Array.from(packed.pointTags) };
}
