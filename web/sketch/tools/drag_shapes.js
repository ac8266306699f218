// Outlines by one drag: by hand, circles, rectangles.
/** @import { Point } from '../../types' */
/** @import { Tool } from '../../stage/stage.js' */
/** @import { Sketch } from '../sketch.js' */
import { drawDraft } from '../marks.js';
import { addLoop } from '../model/drawing.js';
import { distance } from '../model/geometry.js';
import { circle, rectangle } from '../model/shapes.js';
import { tidied } from '../model/smooth.js';

const least = 4;  // pixels; less is a click

/** @param {Sketch} sketch  @returns {Tool} */
export function freehandTool(sketch) {
  /** @type {Point[]} */
  let stroke = [];
  const forget = () => {
    stroke = [];
    sketch.stage.invalidate('overlay');
  };
  return {
    id: 'freehand', cursor: 'crosshair',
    down(at) {
      stroke = [at];
      return true;
    },
    move(at, _, pixel) {
      if (stroke.length === 0 || distance(at, stroke[stroke.length - 1]) < pixel) return;
      stroke.push(at);
      sketch.stage.invalidate('overlay');
    },
    up(_, __, pixel) {
      const loop = tidied(stroke, true, pixel);
      forget();
      if (loop.length >= 3) sketch.change('Draw an outline', addLoop(sketch.drawing, loop));
    },
    key({ key }) {
      if (key !== 'Escape' || stroke.length === 0) return false;
      forget();
      return true;
    },
    cancel: forget,
    draw: (context, view) => drawDraft(context, view, sketch, stroke, {}),
  };
}

/**
 * @param {Sketch} sketch  @param {'circle' | 'rectangle'} id
 * @param {(from: Point, to: Point) => Point[]} shape  @param {string} label  @returns {Tool}
 */
function dragTool(sketch, id, shape, label) {
  /** @type {Point | null} */
  let from = null;
  /** @type {Point[]} */
  let loop = [];
  const forget = () => {
    from = null;
    loop = [];
    sketch.snapped = null;
    sketch.stage.invalidate('overlay');
  };
  return {
    id, cursor: 'crosshair',
    down(at, event, pixel) {
      from = sketch.snap(at, event, pixel);
      return true;
    },
    move(at, event, pixel) {
      const to = sketch.snap(at, event, pixel, { anchors: from ? [from] : [] });
      if (from) loop = distance(from, to) < least * pixel ? [] : shape(from, to);
    },
    up() {
      const drawn = loop;
      forget();
      if (drawn.length === 0) return sketch.announce('Drag to draw.');
      sketch.change(label, addLoop(sketch.drawing, drawn));
    },
    key({ key }) {
      if (key !== 'Escape' || from === null) return false;
      forget();
      return true;
    },
    cancel: forget,
    draw: (context, view) => drawDraft(context, view, sketch, loop, { closed: true }),
  };
}

/** From the centre outwards. @param {Sketch} sketch */
export const circleTool = (sketch) =>
  dragTool(sketch, 'circle', (c, p) => circle(c[0], c[1], distance(c, p), sketch.circleCount), 'Draw a circle');

/** @param {Sketch} sketch */
export const rectangleTool = (sketch) => dragTool(sketch, 'rectangle', ([ax, ay], [bx, by]) =>
  ax === bx || ay === by ? [] : rectangle(Math.min(ax, bx), Math.min(ay, by), Math.max(ax, bx), Math.max(ay, by)), 'Draw a rectangle');
