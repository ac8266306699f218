// What a person works on, and what it looks like without being asked.
/** @import { SpaceLayer, SurfaceRun, Work } from '../types' */
/** @import { Surface } from 'lpquad' */
import { once } from '../../draw/once.js';

/** @type {{name: SpaceLayer, key: string, title: string, what: string}[]} */
export const layerNames = [
  { name: 'surface', key: '1', title: 'Surface', what: 'The triangles that were given, as repaired.' },
  { name: 'features', key: '2', title: 'Sharp edges',
    what: 'Sharp edges, borders and the borders of groups: the mesh follows them. Corners are points of the mesh.' },
  { name: 'crosses', key: '3', title: 'Cross field',
    what: 'The directions that the sides of the quads should have, and where that cannot be everywhere.' },
  { name: 'charts', key: '4', title: 'Charts',
    what: 'The parts that are mapped to the plane, each by itself; there the quads are made.' },
  { name: 'cells', key: '5', title: 'Cells',
    what: 'In the chart that is meshed now: the cell of every vertex, coloured by its energy. Squares have the least.' },
  { name: 'quads', key: '6', title: 'Quads', what: 'The mesh.' },
  { name: 'quality', key: '7', title: 'Quality η',
    what: 'How near the corners of a quad are to right angles: 1 is a rectangle.' },
  { name: 'valence', key: '8', title: 'Irregular vertices',
    what: 'Vertices where fewer or more than four quads meet.' },
];

/** In the order of the keys. @param {Iterable<SpaceLayer>} some */
export function inOrder(some) {
  const chosen = new Set(some);
  return layerNames.map(({ name }) => name).filter((name) => chosen.has(name));
}

/** What tells most at this stage. @param {SurfaceRun} run  @returns {SpaceLayer[]} */
export function layersFor({ frame }) {
  if (frame.quads && !frame.cells) return ['features', 'quads', 'valence'];
  if (frame.cells) return ['features', 'cells', 'quads'];
  if (frame.charts) return ['features', 'charts'];
  if (frame.crosses) return ['surface', 'features', 'crosses'];
  return ['surface', 'features'];
}

/** Files that lpquad/cad reads. @param {string} name */
export const isCadName = (name) => /\.(step|stp|iges|igs|brep|brp)$/i.test(name);

/** Asked at every tick, of hundreds of thousands of triangles perhaps. @param {Surface} surface */
export const areaOf = (surface) => once(surface, 'area', () => {
  const { points: p, triangles } = surface;
  let twice = 0;
  for (let t = 0; t < triangles.length; t += 3) {
    const a = 3 * triangles[t], b = 3 * triangles[t + 1], c = 3 * triangles[t + 2];
    const u = p[b] - p[a], v = p[b + 1] - p[a + 1], w = p[b + 2] - p[a + 2];
    const x = p[c] - p[a], y = p[c + 1] - p[a + 1], z = p[c + 2] - p[a + 2];
    twice += Math.hypot(v * z - w * y, w * x - u * z, u * y - v * x);
  }
  return twice / 2;
});

/** @param {Float64Array} points  three numbers each */
export function boxOf(points) {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < points.length; ++i) {
    low[i % 3] = Math.min(low[i % 3], points[i]);
    high[i % 3] = Math.max(high[i % 3], points[i]);
  }
  const middle = low.map((x, k) => (x + high[k]) / 2);
  return { middle, radius: Math.hypot(...low.map((x, k) => high[k] - x)) / 2 || 1 };
}

/** A size that gives about so many quads, in three digits. @param {Surface} surface  @param {number} quads */
export const sizeFor = (surface, quads) => Number(Math.sqrt(areaOf(surface) / quads).toPrecision(3));

/** The size of the quads, also of a number of them. @param {Pick<Work, 'surface' | 'options'>} work */
export const askedSize = ({ surface, options: { size, quads } }) => size || sizeFor(surface, quads || 3000);

/** @param {string} name  @param {Surface} surface  @param {number} [quads]  @returns {Pick<Work, 'name' | 'surface' | 'options' | 'preset'>} */
export const workOf = (name, surface, quads = 3000) => ({ name, surface, options: { size: sizeFor(surface, quads) }, preset: undefined });

/** Whether two works have the same mesh. @param {Work} a  @param {Work} b */
export const haveSameMesh = (a, b) => a.surface === b.surface && sameOptions(a.options, b.options);

/** A slider that comes back to where it was has made new options with the old values.
 * @param {Record<string, any>} a  @param {Record<string, any>} b */
function sameOptions(a, b) {
  const names = new Set([...Object.keys(a), ...Object.keys(b)]);
  return a === b || [...names].every((name) => a[name] === b[name]);
}
