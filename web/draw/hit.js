// Which element of what is drawn lies at a point, and which is its neighbour. Pure; what it needs
// to be fast is built when first asked for, once per frame.
/** @import { LayerName, Point, Scene, Snapshot } from '../types' */
import { rowsOf } from './bulk.js';
import { Grid } from './grid.js';
import { areaOf, middleOf, rowsOfCells } from './layers/cells.js';
import { quadLength } from './layers/quads.js';
import { once } from './once.js';

/** @typedef {import('./grid.js').Rows} Rows */
/** @typedef {'quad' | 'left-over' | 'pair' | 'cell' | 'triangle'} FaceKind */
/**
 * `index` counts within the arrays of the frame; of an edge it is the edge in its loop.
 * @typedef {{kind: FaceKind | 'vertex' | 'singularity' | 'place', index: number, at: Point}
 *   | {kind: 'edge', index: number, at: Point, region: number, loop: number}} Element
 */

/** Pixels. */
const near = { mark: 9, vertex: 7, edge: 5, roomForVertices: 22 };

/**
 * What is at a point of the world: marks first, then lines, then faces; only of layers that are shown.
 * @param {Scene} scene  @param {Point} at  @param {number} pixel  @returns {Element | null}
 */
export function elementAt(scene, at, pixel) {
  return singularityAt(scene, at, near.mark * pixel)
    ?? irregularAt(scene, at, near.mark * pixel)
    ?? vertexAt(scene, at, pixel)
    ?? edgeAt(scene, at, near.edge * pixel)
    ?? faceAt(scene, at)
    ?? placeAt(scene, at);
}

/**
 * Faces of the layers that are shown, those drawn last first.
 * @param {Scene} scene  @returns {{kind: FaceKind, rows: Rows}[]}
 */
function facesOf({ frame, layers }) {
  /** @type {{kind: FaceKind, rows: Rows}[]} */
  const faces = [];
  const shows = (/** @type {LayerName[]} */ ...names) => names.some((name) => layers.has(name));
  const { quads, matching, cells, triangles } = frame ?? {};
  if (quads && shows('quads', 'quality', 'valence')) {
    faces.push({ kind: 'quad', rows: rowsOf(quads.points, quads.quads, 4) });
    faces.push({ kind: 'left-over', rows: rowsOf(quads.points, quads.triangles, 3) });
  }
  if (matching && shows('matching')) faces.push({ kind: 'pair', rows: rowsOf(matching.points, matching.triangles, 3) });
  if (cells && shows('cells', 'density')) faces.push({ kind: 'cell', rows: rowsOfCells(cells) });
  if (triangles && shows('triangles'))
    faces.push({ kind: 'triangle', rows: rowsOf(triangles.points, triangles.triangles, 3) });
  return faces;
}

/**
 * Those of a kind of faces; undefined for what is no face, or not shown.
 * @param {Scene} scene  @param {Element['kind']} kind
 */
export const rowsOfKind = (scene, kind) => facesOf(scene).find((faces) => faces.kind === kind)?.rows;

/** @param {Rows} rows */
const gridOf = (rows) => once(rows.vertices ?? rows.offsets, 'grid', () => new Grid(rows));

/** @param {Scene} scene  @param {Point} at  @returns {Element | null} */
export function faceAt(scene, at) {
  for (const { kind, rows } of facesOf(scene)) {
    const index = gridOf(rows).at(...at);
    if (index >= 0) return { kind, index, at };
  }
  return null;
}

/** The mean of the corners. @param {Rows} rows  @param {number} face  @returns {Point} */
export function middleOfFace({ points, vertices, offsets }, face) {
  if (!vertices) return middleOf(points, offsets[face], offsets[face + 1]);
  return middleOf(cornersOfFace({ points, vertices, offsets }, face).flat(), 0, offsets[face + 1] - offsets[face]);
}

/** @param {Rows} rows  @param {number} face  @returns {Point[]} */
export function cornersOfFace({ points, vertices, offsets }, face) {
  return Array.from({ length: offsets[face + 1] - offsets[face] }, (_, k) => {
    const v = 2 * (vertices ? vertices[offsets[face] + k] : offsets[face] + k);
    return [points[v], points[v + 1]];
  });
}

/** @param {Rows} rows  @param {number} face */
export function areaOfFace(rows, face) {
  const corners = cornersOfFace(rows, face);
  return areaOf(corners.flat(), 0, corners.length);
}

/**
 * The nearest of some points within reach.
 * @param {ArrayLike<number>} points  @param {Iterable<number>} some  @param {Point} at  @param {number} reach
 */
function nearest(points, some, [x, y], reach) {
  let best = -1, least = reach;
  for (const v of some) {
    const away = Math.hypot(points[2 * v] - x, points[2 * v + 1] - y);
    if (away > least) continue;
    least = away;
    best = v;
  }
  return best;
}

/** @param {ArrayLike<number>} points  @param {number} v  @returns {Point} */
const pointOf = (points, v) => [points[2 * v], points[2 * v + 1]];

/** @param {Scene} scene  @param {Point} at  @param {number} reach  @returns {Element | null} */
function singularityAt({ frame, layers }, at, reach) {
  if (!frame?.crosses || !layers.has('crosses')) return null;
  const index = nearest(frame.crosses.singularities, frame.crosses.indices.keys(), at, reach);
  return index < 0 ? null : { kind: 'singularity', index, at: pointOf(frame.crosses.singularities, index) };
}

/** @param {Scene} scene  @param {Point} at  @param {number} reach  @returns {Element | null} */
function irregularAt({ frame, layers }, at, reach) {
  const quads = frame?.quads;
  if (!quads || !layers.has('valence')) return null;
  const irregular = once(quads, 'irregular', () => [...quads.excess.keys()].filter((v) => quads.excess[v] !== 0));
  const index = nearest(quads.points, irregular, at, Math.min(reach, 0.45 * quadLength(quads)));
  return index < 0 ? null : { kind: 'vertex', index, at: pointOf(quads.points, index) };
}

/**
 * A corner of the quad at the point.
 * @param {Scene} scene  @param {Point} at  @param {number} pixel  @returns {Element | null}
 */
function vertexAt(scene, at, pixel) {
  const quads = scene.frame?.quads;
  if (!quads || quadLength(quads) < near.roomForVertices * pixel) return null;
  const face = faceAt(scene, at);
  if (face?.kind !== 'quad') return null;
  const corners = quads.quads.subarray(4 * face.index, 4 * face.index + 4);
  const index = nearest(quads.points, corners, at, near.vertex * pixel);
  return index < 0 ? null : { kind: 'vertex', index, at: pointOf(quads.points, index) };
}

/**
 * The nearest edge of the drawing.
 * @param {Scene} scene  @param {Point} at  @param {number} reach  @returns {Element | null}
 */
function edgeAt({ drawing, layers }, [x, y], reach) {
  if (!layers.has('boundary')) return null;
  /** @type {Element | null} */
  let best = null;
  let least = reach;
  drawing.regions.forEach(({ loops }, region) => loops.forEach((points, loop) => points.forEach(([ax, ay], index) => {
    const [bx, by] = points[(index + 1) % points.length];
    const along = ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / ((bx - ax) ** 2 + (by - ay) ** 2 || 1);
    const t = Math.max(0, Math.min(1, along)), away = Math.hypot(ax + t * (bx - ax) - x, ay + t * (by - ay) - y);
    if (away > least) return;
    least = away;
    best = { kind: 'edge', index, region, loop, at: [ax + t * (bx - ax), ay + t * (by - ay)] };
  })));
  return best;
}

/** Fields have values anywhere. @param {Scene} scene  @param {Point} at  @returns {Element | null} */
function placeAt({ frame, layers }, at) {
  const { sizes } = frame ?? {};
  if (!sizes?.triangles.length || !(layers.has('sizes') || layers.has('crosses'))) return null;
  return gridOf(rowsOf(sizes.points, sizes.triangles, 3)).at(...at) < 0 ? null : { kind: 'place', index: 0, at };
}

/**
 * From an element to the next one in a direction.
 * @param {Scene} scene  @param {Element} from  @param {number} dx  @param {number} dy  one of them 0
 * @returns {Element | null}
 */
export function neighbourOf(scene, from, dx, dy) {
  const quads = scene.frame?.quads;
  if (from.kind === 'vertex' && quads) return vertexBeside(quads, from, dx, dy);
  const rows = rowsOfKind(scene, from.kind);
  const step = rows ? 0.2 * Math.sqrt(Math.abs(areaOfFace(rows, from.index))) : 0;
  const [x, y] = rows ? middleOfFace(rows, from.index) : from.at;
  for (let k = 1; rows && k <= 400; ++k) {  // as far as across a hole
    const next = faceAt(scene, [x + k * step * dx, y + k * step * dy]);
    if (next && (next.kind !== from.kind || next.index !== from.index)) return centred(scene, next);
  }
  return null;
}

/** The same face, looked at in its middle. @param {Scene} scene  @param {Element} face  @returns {Element} */
export function centred(scene, face) {
  const rows = rowsOfKind(scene, face.kind);
  if (!rows) return face;
  const at = middleOfFace(rows, face.index);
  const there = faceAt(scene, at);
  return there?.kind === face.kind && there.index === face.index ? { ...face, at } : face;
}

/**
 * Among the vertices that share a face.
 * @param {NonNullable<Snapshot['quads']>} quads  @param {Element} from  @param {number} dx  @param {number} dy
 * @returns {Element | null}
 */
function vertexBeside({ points, quads }, { index, at }, dx, dy) {
  let best = -1, most = 0.5;  // cosine: within 60° of the direction
  for (let i = 0; i < quads.length; ++i) {
    if (quads[i] !== index) continue;
    const face = i - i % 4;
    for (const v of [quads[face + (i + 1) % 4], quads[face + (i + 3) % 4]]) {
      const x = points[2 * v] - at[0], y = points[2 * v + 1] - at[1];
      const along = (x * dx + y * dy) / (Math.hypot(x, y) || 1);
      if (along > most) [best, most] = [v, along];
    }
  }
  return best < 0 ? null : { kind: 'vertex', index: best, at: pointOf(points, best) };
}
