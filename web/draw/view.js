// Between the world, where y points up, and the screen.
/** @import { Drawing, Point, View } from '../types' */

/** @param {View} view  @param {number} x  @param {number} y  @returns {Point} */
export const toScreen = (view, x, y) => [(x - view.left) * view.scale, (view.top - y) * view.scale];

/** @param {View} view  @param {number} x  @param {number} y  @returns {Point} */
export const toWorld = (view, x, y) => [view.left + x / view.scale, view.top - y / view.scale];

/** Keeps the world point under (x, y) there.
 * @param {View} view  @param {number} factor  @param {number} x  @param {number} y  @returns {View} */
export function zoomAt(view, factor, x, y) {
  const [wx, wy] = toWorld(view, x, y);
  const scale = view.scale * factor;
  return { ...view, scale, left: wx - x / scale, top: wy + y / scale };
}

/** @param {View} view  @param {number} dx  @param {number} dy  in pixels  @returns {View} */
export const pan = (view, dx, dy) =>
  ({ ...view, left: view.left - dx / view.scale, top: view.top + dy / view.scale });

/** @param {Drawing} drawing */
export function boundsOf(drawing) {
  let [left, bottom, right, top] = [Infinity, Infinity, -Infinity, -Infinity];
  for (const { loops } of drawing.regions)
    for (const loop of loops)
      for (const [x, y] of loop) {
        left = Math.min(left, x);
        right = Math.max(right, x);
        bottom = Math.min(bottom, y);
        top = Math.max(top, y);
      }
  return left <= right ? { left, bottom, right, top } : { left: 0, bottom: 0, right: 1, top: 1 };
}

/** The view of a size that shows all of the drawing. @param {Drawing} drawing @returns {View} */
export function fit(drawing, /** @type {number} */ width, /** @type {number} */ height, margin = 24, below = margin) {
  const { left, bottom, right, top } = boundsOf(drawing);
  const across = Math.max(right - left, 1e-300), along = Math.max(top - bottom, 1e-300);
  const scale = Math.min(Math.max(1, width - 2 * margin) / across, Math.max(1, height - margin - below) / along);
  return {
    scale, width, height,
    left: (left + right - width / scale) / 2,
    top: (bottom + top + (height + margin - below) / scale) / 2,
  };
}
