// A picture of a scene: its layers, in the order of painting. Pure: everything is in the arguments.
/** @import { LayerName, Pen, Scene, View } from '../types' */
import { drawBoundary } from './layers/boundary.js';
import { drawCells, drawDensity } from './layers/cells.js';
import { drawQuads, drawQuality, drawValence } from './layers/quads.js';
import { drawTriangles } from './layers/triangles.js';

/** @type {[LayerName, (pen: Pen, scene: Scene, view: View) => void][]} */
const layers = [
  ['density', drawDensity],
  ['quality', drawQuality],
  ['cells', drawCells],
  ['triangles', drawTriangles],
  ['quads', drawQuads],
  ['valence', drawValence],
  ['boundary', drawBoundary],
];

/** @param {Pen} pen  @param {Scene} scene  @param {View} view */
export function draw(pen, scene, view) {
  const pale = scene.freshness === 'preview' || scene.freshness === 'old';  // not the drawing's own
  for (const [name, drawLayer] of layers)
    if (scene.layers.has(name)) {
      pen.save();
      if (pale && name !== 'boundary') pen.globalAlpha = 0.4;
      drawLayer(pen, scene, view);
      pen.restore();
    }
}
