// Outlines and inner lines by their points, and single inner points.
/** @import { Point } from '../../types' */
/** @import { Tool } from '../../stage/stage.js' */
/** @import { Sketch } from '../sketch.js' */
import { drawDraft } from '../marks.js';
import { addLine, addLoop, addPoint } from '../model/drawing.js';
import { distance, samePlace } from '../model/geometry.js';

/** @typedef {Tool & {addPoint: (p: Point) => void, finish: () => void, count: () => number}} PointsTool */

const twice = 350;  // milliseconds between the clicks of a double click

/** @param {Sketch} sketch  @param {boolean} closed  @returns {PointsTool} */
export function pointsTool(sketch, closed) {
  /** @type {Point[]} */
  let draft = [];
  /** @type {Point | null} */
  let pointer = null;
  let last = { time: 0, at: /** @type {Point} */ ([NaN, NaN]) };
  const least = closed ? 3 : 2;

  function become(/** @type {Point[]} */ points) {
    draft = points;
    sketch.snapped = null;
    sketch.changed();
  }

  function finish() {
    const points = draft.filter((p, i) => i === 0 || !samePlace(p, draft[i - 1]));
    if (points.length < least) return sketch.announce(`${least - points.length} more points are needed.`);
    become([]);
    sketch.change(closed ? 'Draw an outline' : 'Draw a line', closed ? addLoop(sketch.drawing, points) : addLine(sketch.drawing, points));
  }

  function add(/** @type {Point} */ p) {
    if (closed && draft.length >= least && samePlace(p, draft[0])) return finish();
    become([...draft, p]);
    sketch.announce(`Point ${draft.length}`);
  }

  const snapped = (/** @type {Point} */ at, /** @type {PointerEvent} */ event, /** @type {number} */ pixel) =>
    sketch.snap(at, event, pixel, { anchors: draft.slice(-1), more: closed && draft.length >= least ? draft.slice(0, 1) : [] });

  /** @param {KeyboardEvent} event */
  function key({ key: name, ctrlKey, metaKey }) {
    if (ctrlKey || metaKey || draft.length === 0) return false;
    if (name === 'Enter') finish();
    else if (name === 'Escape') become([]);
    else if (name === 'Backspace' || name === 'Delete') become(draft.slice(0, -1));
    else return false;
    return true;
  }

  return {
    id: closed ? 'polygon' : 'line', cursor: 'crosshair', finish, key, addPoint: add, count: () => draft.length,
    down(at, event, pixel) {
      const again = event.timeStamp - last.time < twice && distance(at, last.at) < 8 * pixel;
      last = { time: event.timeStamp, at };
      if (again && draft.length >= least) finish();
      else add(snapped(at, event, pixel));
      return true;
    },
    move(at, event, pixel) {
      pointer = snapped(at, event, pixel);
    },
    cancel: () => {
      pointer = null;
      sketch.snapped = null;
      become([]);
    },
    draw: (context, view) => drawDraft(context, view, sketch, pointer && draft.length > 0 ? [...draft, pointer] : draft, { dots: true, closed }),
  };
}

/** @param {Sketch} sketch  @returns {Tool & {addPoint: (p: Point) => void}} */
export function pointTool(sketch) {
  const add = (/** @type {Point} */ p) => sketch.change('Add an inner point', addPoint(sketch.drawing, p));
  return {
    id: 'point', cursor: 'crosshair', addPoint: add,
    down: (at, event, pixel) => {
      add(sketch.snap(at, event, pixel));
      return true;
    },
    move: (at, event, pixel) => void sketch.snap(at, event, pixel),
    cancel: () => void (sketch.snapped = null),
    draw: (context, view) => drawDraft(context, view, sketch, [], {}),
  };
}
