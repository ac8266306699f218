// Outlines and inner lines by their points, and single inner points.
/** @import { Point, View } from '../../types' */
/** @import { Tool } from '../../stage/stage.js' */
/** @import { Sketch } from '../sketch.js' */
import { drawDraft } from '../marks.js';
import { addLine, addLoop, addPoint } from '../model/drawing.js';
import { distance, samePlace } from '../model/geometry.js';

const twice = 350;  // milliseconds between the clicks of a double click

/** @implements {Tool} */
export class PointsTool {
  cursor = 'crosshair';
  #sketch;
  #closed;
  #least;
  /** @type {Point[]} */
  #draft = [];
  /** @type {Point | null} */
  #pointer = null;
  #last = { time: 0, at: /** @type {Point} */ ([NaN, NaN]) };

  /** @param {Sketch} sketch  @param {boolean} closed */
  constructor(sketch, closed) {
    this.#sketch = sketch;
    this.#closed = closed;
    this.#least = closed ? 3 : 2;
    this.id = closed ? 'polygon' : 'line';
  }

  count() { return this.#draft.length; }

  /** @param {Point[]} points */
  #become(points) {
    this.#draft = points;
    this.#sketch.snapped = null;
    this.#sketch.changed();
  }

  finish() {
    const sketch = this.#sketch, points = this.#draft.filter((p, i) => i === 0 || !samePlace(p, this.#draft[i - 1]));
    if (points.length < this.#least) return sketch.announce(`${this.#least - points.length} more points are needed.`);
    this.#become([]);
    if (this.#closed) sketch.change('Draw an outline', addLoop(sketch.drawing, points));
    else sketch.change('Draw a line', addLine(sketch.drawing, points));
  }

  #isEnough() { return this.#draft.length >= this.#least; }

  /** @param {Point} p */
  addPoint(p) {
    if (this.#closed && this.#isEnough() && samePlace(p, this.#draft[0])) return this.finish();
    this.#become([...this.#draft, p]);
    this.#sketch.announce(`Point ${this.#draft.length}`);
  }

  /** @param {Point} at  @param {PointerEvent} event  @param {number} pixel */
  #snapped(at, event, pixel) {
    const more = this.#closed && this.#isEnough() ? this.#draft.slice(0, 1) : [];
    return this.#sketch.snap(at, event, pixel, { anchors: this.#draft.slice(-1), more });
  }

  /** @param {KeyboardEvent} event */
  key({ key: name, ctrlKey, metaKey }) {
    if (ctrlKey || metaKey || this.#draft.length === 0) return false;
    if (name === 'Enter') this.finish();
    else if (name === 'Escape') this.#become([]);
    else if (name === 'Backspace' || name === 'Delete') this.#become(this.#draft.slice(0, -1));
    else return false;
    return true;
  }

  /** @param {Point} at  @param {PointerEvent} event  @param {number} pixel */
  down(at, event, pixel) {
    const again = event.timeStamp - this.#last.time < twice && distance(at, this.#last.at) < 8 * pixel;
    this.#last = { time: event.timeStamp, at };
    if (again && this.#isEnough()) this.finish();
    else this.addPoint(this.#snapped(at, event, pixel));
    return true;
  }

  /** @param {Point} at  @param {PointerEvent} event  @param {number} pixel */
  move(at, event, pixel) {
    this.#pointer = this.#snapped(at, event, pixel);
  }

  cancel() {
    this.#pointer = null;
    this.#become([]);
  }

  /** @param {CanvasRenderingContext2D} context  @param {View} view */
  draw(context, view) {
    const next = this.#pointer && this.#draft.length > 0 ? [this.#pointer] : [];
    drawDraft(context, view, this.#sketch, [...this.#draft, ...next], { dots: true, closed: this.#closed });
  }
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
