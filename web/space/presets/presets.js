// Surfaces to begin with, made by formula.
/** @import { Surface } from 'lpquad' */
/** @import { Shape } from './shapes.js' */
import { bentGrid, joined, thickRing, tube } from './shapes.js';

const full = 2 * Math.PI;

// Of radii that no middle of a cell has as its distance.
const holes = [{ x: -0.6, y: 0, r: 0.3 }, { x: 0.75, y: 0.05, r: 0.21 }];

/** A pressed panel with two holes and a swage, like a part of a car body. */
function panel() {
  const [columns, rows] = [150, 100], half = 1.5 / columns;
  const holeAt = (/** @type {number} */ x, /** @type {number} */ y) => holes.find((hole) => Math.hypot(x - hole.x, y - hole.y) < hole.r);
  /** The hole that has some of the four cells around a point, but not all. @param {number} x  @param {number} y */
  const rimAt = (x, y) => {
    const around = [[-half, -half], [half, -half], [half, half], [-half, half]].map(([a, b]) => holeAt(x + a, y + b));
    return around.includes(undefined) ? around.find(Boolean) : undefined;
  };
  /** Points on a rim are moved onto the circle. @param {number} x  @param {number} y */
  const rimmed = (x, y) => {
    const hole = rimAt(x, y);
    if (hole === undefined) return [x, y];
    const move = hole.r / Math.hypot(x - hole.x, y - hole.y);
    return [hole.x + move * (x - hole.x), hole.y + move * (y - hole.y)];
  };
  const xy = (/** @type {number} */ u, /** @type {number} */ v) => /** @type {const} */ ([3 * u - 1.5, 2 * v - 1]);
  const shape = bentGrid(columns, rows, (u, v) => {
    const [x, y] = rimmed(...xy(u, v));
    const swage = 0.06 * Math.exp(-(((y + 0.68 - 0.05 * x) / 0.1) ** 2));
    return [x, y, 0.25 * (1 - (x / 1.5) ** 2) + 0.18 * (1 - y * y) + swage];
  }, { hole: (u, v) => holeAt(...xy(u, v)) !== undefined });
  const onRim = (/** @type {number} */ p) =>
    rimAt(...xy((p % (columns + 1)) / columns, Math.floor(p / (columns + 1)) / rows)) !== undefined;
  return { ...shape, triangles: withoutFlat(shape.triangles, onRim) };
}

/** Triangles with three corners on one circle have nearly no height. @param {number[]} triangles  @param {(p: number) => boolean} onRim */
const withoutFlat = (triangles, onRim) => triangles.filter((_, i) => {
  const first = i - i % 3;
  return ![0, 1, 2].every((k) => onRim(triangles[first + k]));
});

/** @param {number} count  @param {(angle: number) => number} radius */
const outline = (count, radius) => Array.from({ length: count }, (_, i) => {
  const angle = full * i / count;
  return [radius(angle) * Math.cos(angle), radius(angle) * Math.sin(angle)];
});

/** A gear with a bore. */
function gear() {
  const teeth = 14, perTooth = 16;
  const profile = (/** @type {number} */ angle) => {
    const place = ((angle * teeth / full) % 1 + 1) % 1;
    return place < 0.45 ? 1.2 : place < 0.55 ? 1.2 - 2.5 * (place - 0.45) : place < 0.9 ? 0.95 : 0.95 + 2.5 * (place - 0.9);
  };
  return thickRing(outline(teeth * perTooth, profile), outline(teeth * perTooth, () => 0.45), 0.5, 8);
}

/** A cube with a round hole through it: four flat walls and a bore. */
function bored() {
  const square = outline(160, (angle) => {
    const turned = ((angle + Math.PI / 4) % (Math.PI / 2)) - Math.PI / 4;
    return 0.8 / Math.cos(turned);
  });
  return thickRing(square, outline(160, () => 0.42), 1.2, 10);
}

/** A pipe that bends twice, open at both ends. */
const pipe = () => tube((t) => [2.4 * t - 1.2, 0.5 * Math.tanh(6 * (t - 0.5)), 0.25 * Math.sin(full * t)], 0.22, 40, 150, false);

const torus = () => bentGrid(72, 32, (u, v) => [
  (1 + 0.38 * Math.cos(full * v)) * Math.cos(full * u), (1 + 0.38 * Math.cos(full * v)) * Math.sin(full * u), 0.38 * Math.sin(full * v),
], { wrapU: true, wrapV: true });

const knot = () => tube((t) => {
  const a = full * t;
  return [0.45 * (Math.sin(a) + 2 * Math.sin(2 * a)), 0.45 * (Math.cos(a) - 2 * Math.cos(2 * a)), -0.55 * Math.sin(3 * a)];
}, 0.25, 24, 220, true);

/** A cube blown up to a ball: no poles where triangles crowd. */
function blob() {
  const side = (/** @type {(x: number, y: number) => number[]} */ place) => bentGrid(24, 24, (u, v) => {
    const p = place(Math.tan((u - 0.5) * Math.PI / 2), Math.tan((v - 0.5) * Math.PI / 2));
    const length = Math.hypot(...p);
    const [x, y, z] = p.map((c) => c / length);
    const bump = 1 + 0.14 * Math.sin(3 * x + 1) * Math.cos(3 * y) + 0.12 * Math.sin(4 * z);
    return [bump * x, bump * y, bump * z].map((c) => Math.round(c * 1e12) / 1e12);
  });
  return joined(side((x, y) => [1, x, y]), side((x, y) => [-1, -x, y]), side((x, y) => [-x, 1, y]),
    side((x, y) => [x, -1, y]), side((x, y) => [x, y, 1]), side((x, y) => [-x, y, -1]));
}

/** A saddle with a rim. */
const saddle = () => bentGrid(60, 60, (u, v) => [2 * u - 1, 2 * v - 1, 0.6 * ((2 * u - 1) ** 2 - (2 * v - 1) ** 2)]);

/** @type {{id: string, title: string, about: string, make: () => Shape}[]} */
export const presets = [
  { id: 'panel', title: 'Pressed panel', about: 'one curved face with holes, as in the paper', make: panel },
  { id: 'gear', title: 'Gear', about: 'flat faces and sharp edges', make: gear },
  { id: 'bored', title: 'Bored block', about: 'planes and a cylinder', make: bored },
  { id: 'pipe', title: 'Bent pipe', about: 'a cylinder, cut open once', make: pipe },
  { id: 'torus', title: 'Torus', about: 'closed, with one hole', make: torus },
  { id: 'knot', title: 'Knot', about: 'closed, long and thin', make: knot },
  { id: 'blob', title: 'Blob', about: 'closed: not without irregular vertices', make: blob },
  { id: 'saddle', title: 'Saddle', about: 'curved both ways', make: saddle },
];

/** @param {Shape} shape  @returns {Surface} */
export const surfaceOf = ({ points, triangles }) => ({ points: Float64Array.from(points), triangles: Uint32Array.from(triangles) });
