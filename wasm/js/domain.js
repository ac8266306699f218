// A domain as the caller writes it to the packed arrays that cross into the core (wasm/marshal.h).
// Judges the form only, and names the path of what does not fit; the core judges the geometry.
import { LpquadError } from './errors.js';

const fail = (path, expected, value) => {
  throw new LpquadError('PARSE_ERROR', `${path} must be ${expected}, not ${describe(value)}.`);
};

function describe(value) {
  if (value === null) return 'null';
  if (Array.isArray(value)) return `an array of ${value.length}`;
  if (typeof value === 'string') return `the text ${JSON.stringify(value.slice(0, 40))}`;
  if (typeof value === 'object') return 'an object';
  return String(value);
}

const isList = (value) =>
  Array.isArray(value) || (ArrayBuffer.isView(value) && !(value instanceof DataView));

/** Appends the points of [[x, y], ..] or of a flat [x0, y0, x1, ..]; returns their number. */
function appendPoints(out, value, path) {
  if (!isList(value)) fail(path, 'an array of points', value);
  const nested = value.length > 0 && typeof value[0] !== 'number';
  if (!nested && value.length % 2 !== 0) fail(path, 'an even count of numbers x, y, x, y, …', value);
  if (nested) value.forEach((point, i) => appendPoint(out, point, `${path}[${i}]`));
  else for (let i = 0; i < value.length; ++i) appendNumber(out, value[i], `${path}[${i}]`);
  return nested ? value.length : value.length / 2;
}

function appendPoint(out, value, path) {
  if (!isList(value) || value.length !== 2) fail(path, 'a point [x, y]', value);
  appendNumber(out, value[0], `${path}[0]`);
  appendNumber(out, value[1], `${path}[1]`);
}

function appendNumber(out, value, path) {
  if (typeof value !== 'number') fail(path, 'a number', value);
  if (!Number.isFinite(value))
    throw new LpquadError('NON_FINITE', `${path} is ${value}; coordinates must be finite.`);
  out.push(value);
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

function packLoops(packed, region, path, names) {
  const loops = region.loops;
  if (!Array.isArray(loops)) fail(`${path}.loops`, 'an array of loops', loops);
  packed.loopsPerRegion.push(loops.length);
  loops.forEach((loop, l) => {
    const size = appendPoints(packed.points, loop, `${path}.loops[${l}]`);
    packed.sizes.push(size);
    const tags = region.tags?.[l] ?? [];
    if (!Array.isArray(tags)) fail(`${path}.tags[${l}]`, 'an array of texts, one per edge', tags);
    if (tags.length > 0 && tags.length !== size)
      fail(`${path}.tags[${l}]`, `as long as its loop (${size} edges)`, tags);
    for (let e = 0; e < size; ++e)
      packed.edgeTags.push(names.number(tags[e], `${path}.tags[${l}][${e}]`));
  });
}

function checkKeys(domain) {
  const known = ['loops', 'regions', 'tags', 'polylines', 'points', 'h'];
  const described = ['name', 'description', 'source', 'licence', 'license', 'warnings'];
  for (const key of Object.keys(domain))
    if (!known.includes(key) && !described.includes(key))
      throw new LpquadError('PARSE_ERROR',
        `domain.${key} is not a part of a domain; its parts are ${known.join(', ')}.`);
}

/**
 * @param {import('./index.js').Domain} domain
 */
export function packDomain(domain) {
  if (domain === null || typeof domain !== 'object') fail('domain', 'an object', domain);
  checkKeys(domain);
  const packed = { regions: [], loopsPerRegion: [], sizes: [], points: [], tags: [], edgeTags: [],
    polylineTags: [], pointTags: [], h: 0 };
  const names = new Names();
  if (domain.loops !== undefined && domain.regions !== undefined)
    fail('domain', 'given by loops or by regions', 'both');
  const regions = domain.regions ?? [domain];
  if (!Array.isArray(regions)) fail('domain.regions', 'an array of regions', regions);
  regions.forEach((region, r) => {
    const path = domain.regions === undefined ? 'domain' : `domain.regions[${r}]`;
    if (region === null || typeof region !== 'object') fail(path, 'an object', region);
    const name = domain.regions === undefined ? '' : region.name ?? '';
    if (typeof name !== 'string') fail(`${path}.name`, 'a text', name);
    packed.regions.push(name);
    packLoops(packed, region, path, names);
  });
  (domain.polylines ?? []).forEach((line, i) => {
    packed.sizes.push(appendPoints(packed.points, line.points, `domain.polylines[${i}].points`));
    packed.polylineTags.push(names.number(line.tag, `domain.polylines[${i}].tag`));
  });
  (domain.points ?? []).forEach((point, i) => {
    const path = `domain.points[${i}]`;
    appendPoint(packed.points, isList(point) ? point : point?.position, path);
    packed.pointTags.push(names.number(point.tag, `${path}.tag`));
  });
  if (domain.h !== undefined) {
    const h = [];
    appendNumber(h, domain.h, 'domain.h');
    packed.h = h[0];
  }
  packed.tags = names.list;
  return typed(packed);
}

function typed(packed) {
  return { ...packed, points: Float64Array.from(packed.points),
    loopsPerRegion: Int32Array.from(packed.loopsPerRegion), sizes: Int32Array.from(packed.sizes),
    edgeTags: Int32Array.from(packed.edgeTags),
    polylineTags: Int32Array.from(packed.polylineTags),
    pointTags: Int32Array.from(packed.pointTags) };
}
