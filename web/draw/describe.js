// An element in words and numbers, as the library gives them.
/** @import { Point, Scene, Snapshot } from '../types' */
/** @import { Element } from './hit.js' */
import { areaOfFace, cornersOfFace, middleOfFace, rowsOfKind } from './hit.js';
import { relativeDensity } from './layers/cells.js';
import { short } from './legend.js';
import { axisAt, sizesAt, weightsAt } from './sampler.js';

/** @typedef {[name: string, value: string]} Row */
/** @typedef {{title: string, rows: Row[]}} Description */

/** A row, unless there is nothing to tell. @param {string} name  @param {string | undefined} value  @returns {Row[]} */
const maybe = (name, value) => (value === undefined ? [] : [[name, value]]);

/** @param {Scene} scene  @param {Element} element  @returns {Description | null} */
export function describe(scene, element) {
  const { kind, index, at } = element;
  switch (kind) {
    case 'quad': return describeQuad(scene, index);
    case 'left-over': return { title: 'Left-over triangle', rows: faceRows(scene, 'left-over', index) };
    case 'pair': return describePair(scene, index);
    case 'cell': return describeCell(scene, index);
    case 'triangle': return describeTriangle(scene, index);
    case 'vertex': return describeVertex(scene, index);
    case 'singularity': return describeSingularity(scene, index);
    case 'edge': return describeEdge(scene, element);
    case 'place': return { title: 'Fields', rows: [['at', placed(at)], ...fieldRows(scene, at)] };
  }
}

/** @param {Point} at */
const placed = ([x, y]) => `(${short(x)}, ${short(y)})`;
/** @param {number} radians */
const degrees = (radians) => `${Math.round(radians * 1800 / Math.PI) / 10}°`;

/** Inner angles of a counter-clockwise polygon. @param {Point[]} corners */
export function anglesOf(corners) {
  return corners.map(([x, y], i) => {
    const [ax, ay] = corners[(i + corners.length - 1) % corners.length], [bx, by] = corners[(i + 1) % corners.length];
    const [ux, uy, vx, vy] = [bx - x, by - y, ax - x, ay - y];
    const angle = Math.atan2(ux * vy - uy * vx, ux * vx + uy * vy);
    return angle < 0 ? angle + 2 * Math.PI : angle;
  });
}

/** @param {Point[]} corners */
const sidesOf = (corners) => corners.map(([x, y], i) => {
  const [bx, by] = corners[(i + 1) % corners.length];
  return Math.hypot(bx - x, by - y);
});

/** @param {Scene} scene  @param {Point} at */
function targetAt({ frame }, at) {
  return frame?.sizes?.sizes.length ? sizesAt(frame.sizes)(...at) : undefined;
}

/**
 * Angles and sides.
 * @param {Scene} scene  @param {'quad' | 'left-over' | 'pair' | 'triangle'} kind  @param {number} index
 * @returns {Row[]}
 */
function faceRows(scene, kind, index) {
  const rows = rowsOfKind(scene, kind);
  if (!rows) return [];
  const corners = cornersOfFace(rows, index);
  return [['angles', anglesOf(corners).map(degrees).join('  ')], ['sides', sidesOf(corners).map(short).join('  ')]];
}

/** @param {Scene} scene  @param {number} index  @returns {Description | null} */
function describeQuad(scene, index) {
  const layer = scene.frame?.quads, rows = rowsOfKind(scene, 'quad');
  if (!layer || !rows) return null;
  const target = targetAt(scene, middleOfFace(rows, index)), size = Math.sqrt(Math.abs(areaOfFace(rows, index)));
  const corners = layer.quads.subarray(4 * index, 4 * index + 4);
  return {
    title: `Quad ${index}`,
    rows: [
      ['η', layer.eta[index].toFixed(4)], ...faceRows(scene, 'quad', index),
      ...maybe('size / wanted', target === undefined ? undefined : short(size / target)),
      ['valences', [...corners].map((v) => layer.valence[v]).join('  ')],
    ],
  };
}

/** @param {Scene} scene  @param {number} index  @returns {Description | null} */
function describePair(scene, index) {
  const layer = scene.frame?.matching;
  if (!layer) return null;
  return { title: `Triangle ${index}`, rows: [...partnerRows(layer, index), ...faceRows(scene, 'pair', index)] };
}

/** @param {NonNullable<Snapshot['matching']>} layer  @param {number} index  @returns {Row[]} */
function partnerRows({ mates, extra, costs }, index) {
  if (mates[index] < 0) return [['partner', 'none: left over']];
  return [
    ['partner', `triangle ${mates[index]}${extra[index] ? ', by an extra edge' : ''}`],
    ['cost', short(costs[index] / 1e4)],
  ];
}

/** @param {Scene} scene  @param {number} index  @returns {Description | null} */
function describeTriangle(scene, index) {
  const { triangles, matching } = scene.frame ?? {};
  if (!triangles) return null;
  const matched = matching?.triangles.length === triangles.triangles.length ? matching : undefined;
  const partner = matched ? partnerRows(matched, index) : [];
  return { title: `Triangle ${index}`, rows: [...partner, ...faceRows(scene, 'triangle', index)] };
}

/** @param {Scene} scene  @param {number} piece  @returns {Description | null} */
function describeCell(scene, piece) {
  const cells = scene.frame?.cells, rows = rowsOfKind(scene, 'cell');
  if (!cells || !rows) return null;
  const site = cells.sites[piece];
  let area = 0;
  cells.sites.forEach((of, i) => { if (of === site) area += areaOfFace(rows, i); });
  return {
    title: `Cell of point ${site}`,
    rows: [
      ['energy', short(cells.density[site] * area)], ['density', short(cells.density[site])],
      ['of a perfect square', short(relativeDensity(cells, scene.frame?.sizes, scene.norm)[site])],
      ['area', short(area)], ['corners', String(rows.offsets[piece + 1] - rows.offsets[piece])],
    ],
  };
}

/** @param {Scene} scene  @param {number} index  @returns {Description | null} */
function describeVertex(scene, index) {
  const layer = scene.frame?.quads;
  if (!layer) return null;
  const excess = layer.excess[index];
  const regular = excess === 0 ? 'regular' : `${Math.abs(excess)} too ${excess > 0 ? 'many' : 'few'}`;
  return {
    title: `Vertex ${index}`,
    rows: [
      ['valence', `${layer.valence[index]}, ${regular}`],
      ['at', placed([layer.points[2 * index], layer.points[2 * index + 1]])],
      ['lies', index < layer.boundaryNodes ? 'on the boundary' : 'inside'],
    ],
  };
}

/** @param {Scene} scene  @param {number} index  @returns {Description | null} */
function describeSingularity({ frame }, index) {
  const layer = frame?.crosses;
  if (!layer) return null;
  const turns = layer.indices[index];
  return {
    title: 'Singularity',
    rows: [['index', turns > 0 ? `+${turns}` : `−${-turns}`], ['quads meeting', String(4 - turns)],
      ['at', placed([layer.singularities[2 * index], layer.singularities[2 * index + 1]])]],
  };
}

/** @param {Scene} scene  @param {Extract<Element, {kind: 'edge'}>} element  @returns {Description} */
function describeEdge({ drawing }, { region, loop, index }) {
  const { name, loops, tags } = drawing.regions[region];
  const [ax, ay] = loops[loop][index], [bx, by] = loops[loop][(index + 1) % loops[loop].length];
  return {
    title: `Boundary edge ${index}`,
    rows: [
      ['tag', tags?.[loop]?.[index] || 'none'], ['region', name || String(region)], ['outline', String(loop)],
      ['length', short(Math.hypot(bx - ax, by - ay))],
    ],
  };
}

/** @param {Scene} scene  @param {Point} at  @returns {Row[]} */
function fieldRows(scene, at) {
  const { crosses, sizes } = scene.frame ?? {};
  const target = targetAt(scene, at);
  const together = sizes?.triangles.length && crosses?.points.length === sizes.points.length;
  const weights = together ? weightsAt(sizes)(...at) : null;
  const axis = crosses && weights && axisAt(crosses.axes, weights);
  return [
    ...maybe('wanted size', target === undefined ? undefined : short(target)),
    ...maybe('direction', axis ? `${degrees(Math.atan2(axis[1], axis[0]))} and across` : undefined),
  ];
}
