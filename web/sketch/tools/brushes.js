// Paints target sizes, and strokes that the quads follow.
/** @import { Point, Project } from '../../types' */
/** @import { Tool } from '../../stage/stage.js' */
/** @import { Sketch } from '../sketch.js' */
import { drawBrush, drawDraft } from '../marks.js';
import { distance, nearestOnSegment } from '../model/geometry.js';
import { erased, painted } from '../model/painting.js';
import { tidied } from '../model/smooth.js';

/** @typedef {Tool & {addPoint: (p: Point) => void}} BrushTool */

/** @param {Sketch} sketch  @returns {BrushTool} */
export function sizeBrush(sketch) {
  let gesture = '';
  /** @type {Point | null} */
  let pointer = null;

  function stamp(/** @type {Point} */ at, erase = sketch.brush.erase, /** @type {string | undefined} */ within = undefined) {
    const { radius, size } = sketch.brushNow;
    sketch.store.change(erase ? 'Erase sizes' : 'Paint sizes', ({ sizes }) =>
      ({ sizes: erase ? erased(sizes, at, radius) : painted(sizes, at, radius, size) }), within);
  }

  function end() {
    if (gesture !== '') sketch.store.settle();
    gesture = '';
  }

  return {
    id: 'brush', cursor: 'none', addPoint: (at) => stamp(at), up: end,
    down(at, event) {
      gesture = sketch.newGesture('paint');
      stamp(at, sketch.brush.erase !== event.shiftKey, gesture);
      return true;
    },
    move(at, event) {
      pointer = at;
      sketch.stage.invalidate('overlay');
      if (gesture !== '') stamp(at, sketch.brush.erase !== event.shiftKey, gesture);
    },
    cancel() {
      end();
      pointer = null;
    },
    draw: (context, view) => drawBrush(context, view, sketch, pointer),
  };
}

/** @param {Point[][]} guides  @param {Point} at  @param {number} within */
function withoutStrokesAt(guides, at, within) {
  const near = (/** @type {Point[]} */ line) => line.some((p, i) => i > 0 && distance(at, nearestOnSegment(at, line[i - 1], p)) < within);
  const left = guides.filter((line) => !near(line));
  return left.length === guides.length ? guides : left;
}

/** @param {Sketch} sketch  @returns {BrushTool & {finish: () => void, count: () => number}} */
export function guideTool(sketch) {
  /** @type {Point[]} */
  let stroke = [];
  let erasing = '', byHand = false;

  const become = (/** @type {Point[]} */ points) => {
    stroke = points;
    sketch.changed();
  };
  const add = (/** @type {Point[]} */ line) => {
    become([]);
    if (line.length < 2) return sketch.announce('A stroke needs two points.');
    sketch.store.change('Draw a guide', ({ guides }) => ({ guides: [...guides, line] }));
    sketch.announce('Guide added');
  };
  const erase = (/** @type {Point} */ at, /** @type {number} */ pixel) =>
    sketch.store.change('Erase guides', ({ guides }) => ({ guides: withoutStrokesAt(guides, at, 12 * pixel) }), erasing);

  return {
    id: 'guide', cursor: 'crosshair', finish: () => add(stroke), count: () => stroke.length,
    addPoint: (p) => become([...stroke, p]),
    down(at, event, pixel) {
      if (sketch.eraseGuides !== event.shiftKey) {
        erasing = sketch.newGesture('erase');
        erase(at, pixel);
      } else {
        stroke = [at];
        byHand = true;
      }
      return true;
    },
    move(at, _, pixel) {
      if (erasing !== '') return erase(at, pixel);
      if (!byHand || distance(at, stroke[stroke.length - 1]) < pixel) return;
      stroke.push(at);
      sketch.stage.invalidate('overlay');
    },
    up(_, __, pixel) {
      if (erasing !== '') sketch.store.settle();
      erasing = '';
      if (byHand && stroke.length > 2) add(tidied(stroke, false, pixel));
      else if (byHand) become([]);
      byHand = false;
    },
    key({ key }) {
      if (stroke.length === 0) return false;
      if (key === 'Enter') add(stroke);
      else if (key === 'Escape') become([]);
      else if (key === 'Backspace') become(stroke.slice(0, -1));
      else return false;
      return true;
    },
    cancel() {
      if (erasing !== '') sketch.store.settle();
      erasing = '';
      byHand = false;
      stroke = [];
    },
    draw: (context, view) => drawDraft(context, view, sketch, stroke, { dots: !byHand }),
  };
}
