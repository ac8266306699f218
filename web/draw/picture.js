// Pictures to keep: what is on the screen, as SVG or PNG.
/** @import { Scene, View } from '../types' */
import { BitmapPen } from './bitmap_pen.js';
import { draw } from './draw.js';
import { svgPen } from './svg_pen.js';

/** @param {Scene} scene  @param {View} view  @returns {string} */
export function svgPicture(scene, view) {
  const pen = svgPen();
  draw(pen, scene, view);
  return pen.text(view.width, view.height, scene.palette.background, 'Mesh by lpquad');
}

/**
 * With `scale` pixels for each of the view's.
 * @param {Scene} scene  @param {View} view  @param {number} [scale]  @returns {Promise<Blob>}
 */
export function pngPicture(scene, view, scale = 2) {
  const sheet = new BitmapPen();
  sheet.begin(view.width, view.height, scale);
  const { context, pen } = sheet;
  context.save();
  pen.fillStyle = scene.palette.background;
  context.fillRect(0, 0, view.width, view.height);
  context.restore();
  draw(pen, scene, view);
  sheet.end();
  return new Promise((resolve, reject) => sheet.canvas.toBlob(
    (blob) => (blob ? resolve(blob) : reject(new Error('The picture is too large.'))), 'image/png'));
}
