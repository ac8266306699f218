// Where the charts lie in the picture of the planes: side by side in rows, as large as fits. Pure.
/** @import { Surface, SurfaceSnapshot } from 'lpquad' */
import { areaOf } from '../model/work.js';

/**
 * Where a chart lies: (u, v) is drawn at (shift[0] + scale u, shift[1] - scale v), so that it is seen as from outside.
 * @typedef {{chart: number, triangles: number[], left: number, top: number, scale: number, shift: [number, number]}} Island
 */
/** @typedef {{islands: Island[], width: number, height: number}} Layout  in the unit of the surface */

const gap = 0.04;  // of the root of the whole area

/** @param {NonNullable<SurfaceSnapshot['charts']>} charts  @param {number} aspect  width over height
 * @param {Surface} [surface]  in space: each chart is drawn as large as it is there; without, as large as its map
 * @returns {Layout} */
export function layOut({ charts, uv }, aspect, surface) {
  const boxes = boxesOf(charts, uv, surface).sort((a, b) => b.height - a.height);
  const area = boxes.reduce((sum, { width, height }) => sum + width * height, 0);
  const between = gap * Math.sqrt(area);
  let best = inRows(boxes, between, 1);
  let least = Infinity;
  for (let stretch = 0.8; stretch < 2.5; stretch *= 1.1) {
    const layout = inRows(boxes, between, stretch * Math.sqrt(area * aspect));
    const scale = Math.max(layout.width / aspect, layout.height);
    if (scale < least) [best, least] = [layout, scale];
  }
  return best;
}

/** @param {ArrayLike<number>} charts  @param {ArrayLike<number>} uv  @param {Surface} [surface] */
function boxesOf(charts, uv, surface) {
  /** @type {{chart: number, triangles: number[], low: [number, number], scale: number, width: number, height: number}[]} */
  const boxes = [];
  for (let t = 0; t < charts.length; ++t) {
    const box = boxes[charts[t]] ??= { chart: charts[t], triangles: [], low: [Infinity, Infinity], scale: 1, width: 0, height: 0 };
    box.triangles.push(t);
  }
  const some = boxes.filter(Boolean);
  for (const box of some) {
    const high = [-Infinity, -Infinity];
    for (const t of box.triangles)
      for (let i = 6 * t; i < 6 * t + 6; ++i) {
        box.low[i % 2] = Math.min(box.low[i % 2], uv[i]);
        high[i % 2] = Math.max(high[i % 2], uv[i]);
      }
    if (surface) box.scale = scaleOf(box.triangles, uv, surface);
    box.width = box.scale * (high[0] - box.low[0]);
    box.height = box.scale * (high[1] - box.low[1]);
  }
  return some;
}

/** What makes the area of a chart that in space: a conformal map is right up to a factor, and no chart may dwarf the others.
 * @param {number[]} triangles  @param {ArrayLike<number>} uv  @param {Surface} surface */
function scaleOf(triangles, uv, { points, triangles: corners }) {
  const flat = triangles.reduce((sum, t) => sum + areaInPlane(uv, 6 * t), 0);
  const inSpace = areaOf({ points, triangles: Uint32Array.from(triangles.flatMap((t) => [...corners.subarray(3 * t, 3 * t + 3)])) });
  const scale = Math.sqrt(inSpace / flat);
  return Number.isFinite(scale) && scale > 0 ? scale : 1;
}

/** @param {ArrayLike<number>} uv  @param {number} i  the first of the six numbers of a triangle */
const areaInPlane = (uv, i) =>
  Math.abs((uv[i + 2] - uv[i]) * (uv[i + 5] - uv[i + 1]) - (uv[i + 4] - uv[i]) * (uv[i + 3] - uv[i + 1])) / 2;

/** @param {ReturnType<typeof boxesOf>} boxes  the highest first  @param {number} between  @param {number} most  width
 * @returns {Layout} */
function inRows(boxes, between, most) {
  let [left, top, row, width] = [0, 0, 0, 0];
  const islands = boxes.map((box) => {
    if (left > 0 && left + box.width > most) [left, top, row] = [0, top + row + between, 0];
    const island = { chart: box.chart, triangles: box.triangles, left, top, scale: box.scale,
      shift: /** @type {[number, number]} */ ([left - box.scale * box.low[0], top + box.scale * box.low[1] + box.height]) };
    row = Math.max(row, box.height);
    width = Math.max(width, left + box.width);
    left += box.width + between;
    return island;
  });
  return { islands, width, height: top + row };
}

const onEdge = 1e-6;     // a weight of a corner that a point on the edge opposite has
const acrossCut = 6;     // times the usual length of the chart's quads

/**
 * The quads whose corners all lie in one chart, in its plane; those that reach over a cut are left out.
 * @param {NonNullable<SurfaceSnapshot['charts']>} charts
 * @param {{placeTriangles: ArrayLike<number>, placeWeights: ArrayLike<number>, quads: ArrayLike<number>,
 *   surface: {triangles: ArrayLike<number>}}} mesh
 * @returns {Map<number, number[]>} by chart: u, v of four corners each
 */
export function quadsInPlanes(charts, mesh) {
  const { placeTriangles, quads } = mesh;
  const cornerIn = cornersOf(charts, mesh);
  /** @type {Map<number, number[][]>} */
  const found = new Map();
  for (let q = 0; q < quads.length; q += 4) {
    const corners = [0, 1, 2, 3].map((k) => quads[q + k]);
    for (const chart of new Set(corners.map((v) => charts.charts[placeTriangles[v]]))) {
      const places = corners.map((v) => cornerIn(v, chart));
      if (places.some((place) => place === null)) continue;
      if (!found.has(chart)) found.set(chart, []);
      found.get(chart)?.push(places.flatMap((place) => place ?? []));
      break;
    }
  }
  return new Map([...found].map(([chart, all]) => [chart, withoutWide(all).flat()]));
}

/** @param {number[][]} quads  u, v of four corners each */
function withoutWide(quads) {
  const lengths = quads.map(([a, b, c, d, e, f, g, h]) => Math.max(Math.hypot(a - e, b - f), Math.hypot(c - g, d - h)));
  const usual = [...lengths].sort((a, b) => a - b)[lengths.length >> 1];
  return quads.filter((_, i) => lengths[i] <= acrossCut * usual);
}

/** Where vertices lie in the planes of charts; on the border between two they have a place in either.
 * @param {NonNullable<SurfaceSnapshot['charts']>} charts  @param {Parameters<typeof quadsInPlanes>[1]} mesh */
function cornersOf({ charts, uv }, { placeTriangles, placeWeights, surface: { triangles } }) {
  /** @type {Map<number, number[]>} */
  const around = new Map();  // the triangles at each vertex of the surface
  for (let i = 0; i < triangles.length; ++i) {
    const some = around.get(triangles[i]);
    if (some === undefined) around.set(triangles[i], [Math.floor(i / 3)]);
    else some.push(Math.floor(i / 3));
  }
  const nameIn = (/** @type {number} */ t, /** @type {number} */ vertex) => [0, 1, 2].find((k) => triangles[3 * t + k] === vertex) ?? -1;
  return (/** @type {number} */ v, /** @type {number} */ chart) => {
    const from = placeTriangles[v];
    const parts = [0, 1, 2].map((k) => ({ vertex: triangles[3 * from + k], weight: placeWeights[3 * v + k] }))
      .filter(({ weight }) => charts[from] === chart || weight > onEdge);
    const t = charts[from] === chart ? from : (around.get(parts[0].vertex) ?? []).find((other) =>
      charts[other] === chart && parts.every(({ vertex }) => nameIn(other, vertex) >= 0));
    if (t === undefined) return null;
    const along = (/** @type {number} */ axis) =>
      parts.reduce((sum, { vertex, weight }) => sum + weight * uv[6 * t + 2 * nameIn(t, vertex) + axis], 0);
    return [along(0), along(1)];
  };
}
