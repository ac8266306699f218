// Surfaces made by formula: grids that are bent, and profiles that are swept. Pure.

/** @typedef {{points: number[], triangles: number[]}} Shape */

/** A grid over [0, 1]², bent by a map; closed where a direction wraps.
 * @param {number} columns  @param {number} rows  @param {(u: number, v: number) => number[]} place
 * @param {{wrapU?: boolean, wrapV?: boolean, hole?: (u: number, v: number) => boolean}} [how]  cells with their middle in
 *   a hole are left out  @returns {Shape} */
export function bentGrid(columns, rows, place, { wrapU = false, wrapV = false, hole = () => false } = {}) {
  const across = wrapU ? columns : columns + 1, along = wrapV ? rows : rows + 1;
  const points = [], triangles = [];
  for (let j = 0; j < along; ++j) for (let i = 0; i < across; ++i) points.push(...place(i / columns, j / rows));
  const at = (/** @type {number} */ i, /** @type {number} */ j) => (j % along) * across + i % across;
  for (let j = 0; j < rows; ++j)
    for (let i = 0; i < columns; ++i) {
      if (hole((i + 0.5) / columns, (j + 0.5) / rows)) continue;
      const [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
      triangles.push(a, b, c, a, c, d);
    }
  return { points, triangles };
}

/** A ring between an outer and an inner outline of as many points, `height` thick: with sharp edges.
 * @param {number[][]} outer  @param {number[][]} inner  @param {number} height  @param {number} layers  @returns {Shape} */
export function thickRing(outer, inner, height, layers) {
  const count = outer.length;
  const wall = (/** @type {number[][]} */ loop, /** @type {boolean} */ inwards) =>
    bentGrid(count, layers, (u, v) => {
      const [x, y] = loop[Math.round(u * count) % count];
      return [x, y, (inwards ? 1 - v : v) * height];
    }, { wrapU: true });
  const lid = (/** @type {number} */ z) => bentGrid(count, layers, (u, v) => {
    const i = Math.round(u * count) % count, t = z > 0 ? v : 1 - v;
    return [outer[i][0] + t * (inner[i][0] - outer[i][0]), outer[i][1] + t * (inner[i][1] - outer[i][1]), z];
  }, { wrapU: true });
  return joined(wall(outer, false), wall(inner, true), lid(0), lid(height));
}

/** All in one; equal points become one when it is read. @param {...Shape} shapes  @returns {Shape} */
export function joined(...shapes) {
  const points = [], triangles = [];
  for (const shape of shapes) {
    const first = points.length / 3;
    points.push(...shape.points);
    triangles.push(...shape.triangles.map((v) => v + first));
  }
  return { points, triangles };
}

/** A tube about a closed or open curve; the frame is carried along without twist.
 * @param {(t: number) => number[]} curve  @param {number} radius  @param {number} around  @param {number} along
 * @param {boolean} closed  @returns {Shape} */
export function tube(curve, radius, around, along, closed) {
  const frames = framesAlong(curve, along, closed);
  return bentGrid(around, along, (u, v) => {
    const { at, normal, binormal } = frames[Math.round(v * along) % frames.length];
    const [c, s] = [radius * Math.cos(2 * Math.PI * u), radius * Math.sin(2 * Math.PI * u)];
    return at.map((x, k) => x + c * normal[k] + s * binormal[k]);
  }, { wrapU: true, wrapV: closed });
}

/** @param {(t: number) => number[]} curve  @param {number} along  @param {boolean} closed */
function framesAlong(curve, along, closed) {
  const count = closed ? along : along + 1;
  /** @type {{at: number[], normal: number[], binormal: number[]}[]} */
  const frames = [];
  let normal = [0, 0, 1];
  for (let i = 0; i < count; ++i) {
    const t = i / along;
    const tangent = unit(curve(t + 1e-4).map((x, k) => x - curve(t - 1e-4)[k]));
    const lean = dot(normal, tangent);
    normal = unit(normal.map((x, k) => x - lean * tangent[k]));
    frames.push({ at: curve(t), normal, binormal: cross(tangent, normal) });
  }
  return closed ? untwisted(frames, curve) : frames;
}

/** What the frame has turned by after one round is spread over the round.
 * @param {{at: number[], normal: number[], binormal: number[]}[]} frames  @param {(t: number) => number[]} curve */
function untwisted(frames, curve) {
  const tangent = unit(curve(1e-4).map((x, k) => x - curve(-1e-4)[k]));
  const last = frames[frames.length - 1].normal;
  const lean = dot(last, tangent);
  const arrived = unit(last.map((x, k) => x - lean * tangent[k]));
  const angle = Math.atan2(dot(arrived, frames[0].binormal), dot(arrived, frames[0].normal));
  return frames.map(({ at, normal, binormal }, i) => {
    const back = -angle * i / frames.length;
    const [c, s] = [Math.cos(back), Math.sin(back)];
    return { at, normal: normal.map((x, k) => c * x + s * binormal[k]), binormal: normal.map((x, k) => c * binormal[k] - s * x) };
  });
}

const dot = (/** @type {number[]} */ a, /** @type {number[]} */ b) => a.reduce((sum, x, k) => sum + x * b[k], 0);
const unit = (/** @type {number[]} */ v) => v.map((x) => x / (Math.hypot(...v) || 1));
const cross = (/** @type {number[]} */ [a, b, c], /** @type {number[]} */ [x, y, z]) => [b * z - c * y, c * x - a * z, a * y - b * x];
