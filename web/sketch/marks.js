// What is drawn over the mesh while somebody edits: handles, what is chosen, what a tool is drawing,
// what it snapped to, and in red where edges meet that must not.
/** @import { Palette, Point, View } from '../types' */
/** @import { Sketch } from './sketch.js' */
import { toScreen } from '../draw/view.js';
import { pathOf, pathsOf, vertexAt } from './model/drawing.js';
import { edgeLengths, median } from './model/geometry.js';
import { gridSizeOf } from './model/snap.js';

/** @typedef {CanvasRenderingContext2D} Context */

const handle = 3;          // pixels, half a side
const apart = 4;           // handles whose middles are closer than so many half sides are drawn smaller
const fewHandles = 4000;   // drawn; of more only those of the chosen outline

/** @param {Context} context  @param {View} view  @param {Point[]} path  @param {boolean} [closed] */
function trace(context, view, path, closed = false) {
  context.beginPath();
  path.forEach(([x, y], i) => context[i === 0 ? 'moveTo' : 'lineTo'](...toScreen(view, x, y)));
  if (closed) context.closePath();
}

/** @param {Context} context  @param {View} view  @param {Point} p  @param {number} radius */
function ring(context, view, [x, y], radius) {
  context.beginPath();
  context.arc(...toScreen(view, x, y), radius, 0, 2 * Math.PI);
}

/** @param {Sketch} sketch  @returns {Palette} */
const paletteOf = (sketch) => sketch.stage.scene().palette;

/** Half a side of the handles on a path: on crowded ones they leave the drawing to be seen. @param {View} view  @param {Point[]} points */
function handleOf(view, points) {
  if (points.length < 2) return handle;
  return Math.max(1, Math.min(handle, median(edgeLengths(points, false)) * view.scale / apart));
}

/** @param {Context} context  @param {View} view  @param {Point[]} points  @param {Palette} palette */
function drawHandles(context, view, points, palette) {
  const half = handleOf(view, points);
  context.beginPath();
  for (const [x, y] of points) {
    const [sx, sy] = toScreen(view, x, y);
    if (sx > -half && sy > -half && sx < view.width + half && sy < view.height + half)
      context.rect(Math.round(sx) - half, Math.round(sy) - half, 2 * half, 2 * half);
  }
  context.fillStyle = palette.background;
  context.strokeStyle = palette.boundary;
  context.lineWidth = 1;
  context.fill();
  context.stroke();
}

/** @param {Context} context  @param {View} view  @param {Sketch} sketch */
function drawSelected(context, view, { selected, drawing, whole }, /** @type {Palette} */ palette) {
  if (!selected) return;
  const path = pathOf(drawing, selected);
  context.strokeStyle = palette.accent;
  context.lineWidth = 3;
  const next = path[(selected.vertex + 1) % path.length];
  trace(context, view, whole ? path : [path[selected.vertex], next], whole && selected.region >= 0);
  if (whole || selected.region >= 0 || selected.vertex < path.length - 1) context.stroke();
  ring(context, view, path[selected.vertex], 6);
  context.fillStyle = palette.accent;
  context.fill();
  context.strokeStyle = palette.background;
  context.lineWidth = 2;
  context.stroke();
}

/** @param {Context} context  @param {View} view  @param {Sketch} sketch */
export function drawEditing(context, view, sketch) {
  const palette = paletteOf(sketch), { drawing, hovered, selected, store } = sketch;
  const paths = pathsOf(drawing);
  if (store.gesture !== '') {  // the picture below may be late
    context.strokeStyle = palette.boundary;
    context.lineWidth = 1.5;
    for (const { region, points } of paths) {
      trace(context, view, points, region >= 0);
      context.stroke();
    }
  }
  const count = paths.reduce((sum, { points }) => sum + points.length, 0);
  for (const { region, loop, points } of paths)
    if (count <= fewHandles || (region === selected?.region && loop === selected.loop)) drawHandles(context, view, points, palette);
  drawSelected(context, view, sketch, palette);
  const at = hovered && vertexAt(drawing, hovered);
  if (at) {
    ring(context, view, at, 7);
    context.strokeStyle = palette.accent;
    context.lineWidth = 2;
    context.stroke();
  }
  drawSnapped(context, view, sketch, palette);
}

/** @param {Context} context  @param {View} view  @param {Sketch} sketch  @param {Point[]} points  @param {{dots?: boolean, closed?: boolean}} how */
export function drawDraft(context, view, sketch, points, { dots = false, closed = false }) {
  const palette = paletteOf(sketch);
  trace(context, view, points, closed);
  if (closed) {
    context.fillStyle = palette.accent;
    context.globalAlpha = 0.12;
    context.fill();
    context.globalAlpha = 1;
  }
  context.strokeStyle = palette.accent;
  context.lineWidth = 2;
  context.lineJoin = 'round';
  context.stroke();
  if (dots) drawHandles(context, view, points, palette);
  drawSnapped(context, view, sketch, palette);
}

/** @param {Context} context  @param {View} view  @param {Sketch} sketch  @param {Palette} palette */
function drawSnapped(context, view, { snapped }, palette) {
  if (!snapped) return;
  context.strokeStyle = palette.accent;
  context.fillStyle = palette.accent;
  context.lineWidth = 1;
  context.setLineDash([4, 4]);
  for (const { from } of snapped.rays) {
    trace(context, view, [from, snapped.at]);
    context.stroke();
  }
  context.setLineDash([]);
  ring(context, view, snapped.at, 8);
  context.stroke();
  const words = snapped.to === 'angle' ? snapped.rays.map(({ degrees }) => `${Math.round((degrees + 360) % 360)}°`).join(' ') : snapped.to;
  const [x, y] = toScreen(view, ...snapped.at);
  context.font = '12px system-ui, sans-serif';
  context.lineWidth = 3;
  context.strokeStyle = palette.background;
  context.strokeText(words, x + 12, y - 8);
  context.fillText(words, x + 12, y - 8);
}

/** @param {Context} context  @param {View} view  @param {Sketch} sketch  @param {Point | null} pointer */
export function drawBrush(context, view, sketch, pointer) {
  const palette = paletteOf(sketch), { radius } = sketch.brushNow;
  const { sizes } = sketch.store.project;
  context.fillStyle = palette.accent;
  context.beginPath();
  for (const [x, y] of sizes) {
    const [sx, sy] = toScreen(view, x, y);
    context.rect(sx - 1.5, sy - 1.5, 3, 3);
  }
  context.fill();
  if (!pointer) return;
  ring(context, view, pointer, Math.max(2, radius * view.scale));
  context.strokeStyle = palette.background;
  context.lineWidth = 3;
  context.stroke();
  context.strokeStyle = sketch.brush.erase ? palette.error : palette.accent;
  context.lineWidth = 1.5;
  context.stroke();
}

/** Guides, whatever the tool. @param {Context} context  @param {View} view  @param {Sketch} sketch */
export function drawGuides(context, view, sketch) {
  const { guides } = sketch.store.project;
  if (guides.length === 0) return;
  context.strokeStyle = paletteOf(sketch).accent;
  context.lineWidth = 2;
  context.setLineDash([8, 4]);
  for (const line of guides) {
    trace(context, view, line);
    context.stroke();
  }
  context.setLineDash([]);
}

/** @param {Context} context  @param {View} view  @param {Sketch} sketch */
export function drawGrid(context, view, sketch) {
  if (!sketch.snapping.grid) return;
  const step = gridSizeOf(sketch.snapping, 1 / view.scale), gap = step * view.scale;
  if (gap < 5) return;
  context.strokeStyle = paletteOf(sketch).faint;
  context.globalAlpha = 0.3;
  context.lineWidth = 1;
  context.beginPath();
  for (let x = (Math.ceil(view.left / step) * step - view.left) * view.scale; x < view.width; x += gap) {
    context.moveTo(Math.round(x) + 0.5, 0);
    context.lineTo(Math.round(x) + 0.5, view.height);
  }
  for (let y = (view.top - Math.floor(view.top / step) * step) * view.scale; y < view.height; y += gap) {
    context.moveTo(0, Math.round(y) + 0.5);
    context.lineTo(view.width, Math.round(y) + 0.5);
  }
  context.stroke();
  context.globalAlpha = 1;
}

/** In red: the edges that meet, and where. @param {Context} context  @param {View} view  @param {Sketch} sketch */
export function drawMeetings(context, view, sketch) {
  const { meetings, drawing } = sketch;
  if (meetings.length === 0) return;
  context.strokeStyle = paletteOf(sketch).error;
  context.lineWidth = 3;
  for (const { one, two } of meetings)
    for (const { region, loop, edge } of [one, two]) {
      const path = pathOf(drawing, { region, loop });
      if (path.length === 0) continue;
      trace(context, view, [path[edge], path[(edge + 1) % path.length]]);
      context.stroke();
    }
  for (const { at } of meetings) {
    ring(context, view, at, 9);
    context.stroke();
  }
}

/** Where an error is. @param {Context} context  @param {View} view  @param {Sketch} sketch  @param {Point} at */
export function drawPlace(context, view, sketch, at) {
  const palette = paletteOf(sketch);
  ring(context, view, at, 12);
  context.strokeStyle = palette.background;
  context.lineWidth = 5;
  context.stroke();
  context.strokeStyle = palette.error;
  context.lineWidth = 2.5;
  context.stroke();
}

/** The edge in red that an error names. @param {Context} context  @param {View} view  @param {Sketch} sketch  @param {import('./model/drawing.js').Place} edge */
export function drawEdge(context, view, sketch, edge) {
  const path = pathOf(sketch.drawing, edge);
  if (path.length < 2) return;
  trace(context, view, [path[edge.vertex], path[(edge.vertex + 1) % path.length]]);
  context.strokeStyle = paletteOf(sketch).error;
  context.lineWidth = 3;
  context.stroke();
}
