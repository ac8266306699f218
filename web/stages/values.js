// What the files of a native run leave to be computed: the quality of quads, valences, right angles,
// and the outline.
/** @import { Point } from '../types' */

/** @param {Float64Array} points  @param {number} a  @param {number} at  @param {number} b  angle from b to a at `at` */
function angleAt(points, a, at, b) {
  const [ux, uy] = [points[2 * a] - points[2 * at], points[2 * a + 1] - points[2 * at + 1]];
  const [vx, vy] = [points[2 * b] - points[2 * at], points[2 * b + 1] - points[2 * at + 1]];
  const angle = Math.atan2(vx * uy - vy * ux, ux * vx + uy * vy);
  return angle < 0 ? angle + 2 * Math.PI : angle;
}

/** Section 5 of the paper; triangles have none. @param {Float64Array} points @param {Uint32Array} quads @param {number} triangles  how many */
export function etasOf(points, quads, triangles) {
  const eta = new Float64Array(quads.length / 4 + triangles);
  for (let f = 0; 4 * f < quads.length; ++f) {
    let worst = 0;
    for (let k = 0; k < 4; ++k) {
      const angle = angleAt(points, quads[4 * f + (k + 3) % 4], quads[4 * f + k], quads[4 * f + (k + 1) % 4]);
      worst = Math.max(worst, Math.abs(Math.PI / 2 - angle));
    }
    eta[f] = Math.max(0, 1 - 2 / Math.PI * worst);
  }
  return eta;
}

/** Eq. 2 of the paper. @param {Float64Array} points  @param {Uint32Array} triangles */
export function tauOf(points, triangles) {
  let sum = 0;
  for (let f = 0; f < triangles.length; f += 3) {
    let largest = 0;
    for (let k = 0; k < 3; ++k)
      largest = Math.max(largest, Math.abs(Math.sin(angleAt(points, triangles[f + (k + 2) % 3], triangles[f + k], triangles[f + (k + 1) % 3]))));
    sum += largest;
  }
  return triangles.length > 0 ? sum / (triangles.length / 3) : 0;
}

/** @typedef {{list: Uint32Array, corners: number}} FaceList */

/** Directed edges that have no face on their other side. @param {FaceList[]} faces  @returns {[number, number][]} */
export function rimOf(faces) {
  const edges = new Map();
  for (const { list, corners } of faces)
    for (let f = 0; f < list.length; f += corners)
      for (let k = 0; k < corners; ++k) {
        const [a, b] = [list[f + k], list[f + (k + 1) % corners]];
        if (!edges.delete(`${b} ${a}`)) edges.set(`${a} ${b}`, [a, b]);
      }
  return [...edges.values()];
}

/** The rim's loops. @param {Float64Array} points  @param {[number, number][]} rim  @returns {Point[][]} */
export function loopsOf(points, rim) {
  /** @type {Map<number, [number, number][]>} */
  const next = new Map();
  for (const edge of rim) next.set(edge[0], [...next.get(edge[0]) ?? [], edge]);
  const loops = [];
  for (const [start] of rim) {
    /** @type {Point[]} */
    const loop = [];
    for (let at = start, edge = next.get(at)?.pop(); edge !== undefined; at = edge[1], edge = next.get(at)?.pop())
      loop.push([points[2 * at], points[2 * at + 1]]);
    if (loop.length > 2) loops.push(loop);
  }
  return loops;
}

/**
 * Faces at each vertex, and how many more than its angle asks for.
 * @param {Float64Array} points  @param {FaceList[]} faces
 */
export function valencesOf(points, faces) {
  const count = points.length / 2;
  const valence = new Int32Array(count), excess = new Int32Array(count);
  const angles = new Float64Array(count);
  for (const { list, corners } of faces)
    for (let f = 0; f < list.length; f += corners)
      for (let k = 0; k < corners; ++k) {
        const at = list[f + k];
        ++valence[at];
        angles[at] += angleAt(points, list[f + (k + corners - 1) % corners], at, list[f + (k + 1) % corners]);
      }
  const onRim = new Set(rimOf(faces).flat());
  for (let v = 0; v < count; ++v) {
    if (valence[v] === 0) continue;
    const quads = onRim.has(v) ? quadsFor(angles[v]) : 4;
    excess[v] = valence[v] - quads;
  }
  return { valence, excess };
}

/** The number of quads whose corners at an angle come closest to right ones, in ratio. @param {number} angle */
function quadsFor(angle) {
  let k = 1;
  while (angle * (2 * k + 1) > Math.PI * k * (k + 1)) ++k;
  return k;
}
