// A pen that remembers what was drawn, and scenes to draw from the real mesher.
import { createLpquad } from '../../dist/node.js';
import { light } from '../../web/draw/palette.js';
import { fit } from '../../web/draw/view.js';

/** Everything of the path protocol; `bulk` offers the two operations for thousands, too. */
export function recorder({ bulk = false } = {}) {
  const calls = [];
  const pen = { fillStyle: '', strokeStyle: '', lineWidth: 1, globalAlpha: 1, lineJoin: '', lineCap: '', font: '', textAlign: '', textBaseline: '' };
  for (const name of ['beginPath', 'moveTo', 'lineTo', 'closePath', 'arc', 'fill', 'stroke', 'save', 'restore', 'setLineDash', 'fillText'])
    pen[name] = (...args) => calls.push({ name, args, fill: pen.fillStyle, stroke: pen.strokeStyle });
  if (bulk) {
    pen.fillPolygon = (corners, count, rgba) => calls.push({ name: 'fillPolygon', args: [corners.slice(0, 2 * count), rgba] });
    pen.strokeLine = (...args) => calls.push({ name: 'strokeLine', args });
  }
  return { pen, calls, count: (name) => calls.filter((call) => call.name === name).length };
}

export const circle = (x, y, radius, count) => Array.from({ length: count }, (_, i) =>
  [x + radius * Math.cos(2 * Math.PI * i / count), y + radius * Math.sin(2 * Math.PI * i / count)]);

const library = await createLpquad();
export const everything = { triangles: true, cells: true, crosses: true, sizes: true, matching: true, quads: true };

/** A finished run with all that can be seen of it; more of a scene on top. */
export function sceneOf(loops, options, more = {}) {
  const session = library.start({ loops }, options);
  while (session.state.stage !== 'done') session.step(16);
  const drawing = { regions: [{ name: '', loops }], polylines: [], points: [] };
  const scene = { drawing, frame: session.snapshot(everything), freshness: 'current', result: null, layers: new Set(), palette: light, norm: 6, ...more };
  session.dispose();
  return { scene, view: fit(drawing, 800, 600) };
}

export const square = [[0, 0], [1, 0], [1, 1], [0, 1]];
export const withLayers = (scene, ...layers) => ({ ...scene, layers: new Set(layers) });
