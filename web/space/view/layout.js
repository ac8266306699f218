// Where the charts lie in the picture of the planes: side by side in rows, as large as fits. Pure.
/** @import { SurfaceSnapshot } from 'lpquad' */

/** @typedef {{chart: number, triangles: number[], left: number, top: number, shift: [number, number]}} Island */
/** @typedef {{islands: Island[], width: number, height: number}} Layout  in the unit of the charts */

const gap = 0.04;  // of the root of the whole area

/** @param {NonNullable<SurfaceSnapshot['charts']>} charts  @param {number} aspect  width over height  @returns {Layout} */
export function layOut({ charts, uv }, aspect) {
  const boxes = boxesOf(charts, uv).sort((a, b) => b.height - a.height);
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

/** @param {ArrayLike<number>} charts  @param {ArrayLike<number>} uv */
function boxesOf(charts, uv) {
  /** @type {{chart: number, triangles: number[], low: [number, number], width: number, height: number}[]} */
  const boxes = [];
  for (let t = 0; t < charts.length; ++t) {
    const box = boxes[charts[t]] ??= { chart: charts[t], triangles: [], low: [Infinity, Infinity], width: 0, height: 0 };
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
    box.width = high[0] - box.low[0];
    box.height = high[1] - box.low[1];
  }
  return some;
}

/** @param {ReturnType<typeof boxesOf>} boxes  the highest first  @param {number} between  @param {number} most  width
 * @returns {Layout} */
function inRows(boxes, between, most) {
  let [left, top, row, width] = [0, 0, 0, 0];
  const islands = boxes.map((box) => {
    if (left > 0 && left + box.width > most) [left, top, row] = [0, top + row + between, 0];
    const island = { chart: box.chart, triangles: box.triangles, left, top,
      shift: /** @type {[number, number]} */ ([left - box.low[0], top - box.low[1]]) };
    row = Math.max(row, box.height);
    width = Math.max(width, left + box.width);
    left += box.width + between;
    return island;
  });
  return { islands, width, height: top + row };
}

/** Points of the mesh in the plane of a chart: where they lie on its triangles. The quads whose corners all do.
 * @param {NonNullable<SurfaceSnapshot['charts']>} charts
 * @param {{placeTriangles: ArrayLike<number>, placeWeights: ArrayLike<number>, quads: ArrayLike<number>}} mesh
 * @returns {Map<number, number[]>} by chart: u, v of four corners each */
export function quadsInPlanes({ charts, uv }, { placeTriangles, placeWeights, quads }) {
  /** @type {Map<number, number[]>} */
  const found = new Map();
  for (let q = 0; q < quads.length; q += 4) {
    const chart = charts[placeTriangles[quads[q]]];
    const corners = [0, 1, 2, 3].map((k) => quads[q + k]);
    if (!corners.every((v) => charts[placeTriangles[v]] === chart)) continue;
    const into = found.get(chart) ?? [];
    for (const v of corners)
      for (const axis of [0, 1]) {
        let x = 0;
        for (let k = 0; k < 3; ++k) x += placeWeights[3 * v + k] * uv[6 * placeTriangles[v] + 2 * k + axis];
        into.push(x);
      }
    found.set(chart, into);
  }
  return found;
}
