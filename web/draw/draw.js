// A picture of a scene: its layers, in the order of painting. Pure: everything is in the arguments.
/** @import { DrawLayer, LayerName, Pen, Scene, View } from '../types' */
import { drawBoundary, drawRegions } from './layers/boundary.js';
import { drawCells, drawDensity } from './layers/cells.js';
import { drawCrosses } from './layers/crosses.js';
import { drawMatching } from './layers/matching.js';
import { drawQuads, drawQuality } from './layers/quads.js';
import { drawSizes } from './layers/sizes.js';
import { drawTriangles } from './layers/triangles.js';
import { drawValence } from './layers/valence.js';

/** Areas first, then lines, then marks. @type {[LayerName, DrawLayer][]} */
const layers = [
  ['boundary', drawRegions],
  ['sizes', drawSizes],
  ['density', drawDensity],
  ['matching', drawMatching],
  ['quality', drawQuality],
  ['triangles', drawTriangles],
  ['cells', drawCells],
  ['quads', drawQuads],
  ['boundary', drawBoundary],
  ['crosses', drawCrosses],
  ['valence', drawValence],
];

/**
 * Draws in portions of a few milliseconds: a rest at every `yield`.
 * @param {Pen} pen  @param {Scene} scene  @param {View} view
 */
export function* drawing(pen, scene, view) {
  const shown = layers.filter(([name]) => scene.layers.has(name));
  if (scene.freshness === 'preview' || scene.freshness === 'old') {  // not the drawing's own: pale
    yield* paint(shown.filter(([, drawLayer]) => drawLayer !== drawBoundary), pen, scene, view);
    veil(pen, scene, view);
    yield* paint(shown.filter(([, drawLayer]) => drawLayer === drawBoundary), pen, scene, view);
  } else yield* paint(shown, pen, scene, view);
}

/** @param {typeof layers} shown  @param {Pen} pen  @param {Scene} scene  @param {View} view */
function* paint(shown, pen, scene, view) {
  for (const [, drawLayer] of shown) {
    pen.save();
    yield* drawLayer(pen, scene, view) ?? [];
    pen.restore();
    yield;
  }
}

/** Fades what is drawn so far. @param {Pen} pen  @param {Scene} scene  @param {View} view */
function veil(pen, { palette }, { width, height }) {
  pen.save();
  pen.globalAlpha = 0.6;
  pen.fillStyle = palette.background;
  pen.beginPath();
  [[0, 0], [width, 0], [width, height], [0, height]].forEach(([x, y], i) => pen[i === 0 ? 'moveTo' : 'lineTo'](x, y));
  pen.closePath();
  pen.fill();
  pen.restore();
}

/** @param {Pen} pen  @param {Scene} scene  @param {View} view */
export function draw(pen, scene, view) {
  for (const _ of drawing(pen, scene, view));
}
