// Paints target sizes, and strokes that the quads follow.
/** @import { Point, View } from '../../types' */
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

/** @implements {Tool} */
export class GuideTool {
  id = 'guide';
  cursor = 'crosshair';
  #sketch;
  /** @type {Point[]} */
  #stroke = [];
  #erasing = '';
  #byHand = false;

  /** @param {Sketch} sketch */
  constructor(sketch) {
    this.#sketch = sketch;
  }

  count() { return this.#stroke.length; }

  /** @param {Point[]} points */
  #become(points) {
    this.#stroke = points;
    this.#sketch.changed();
  }

  /** @param {Point[]} line */
  #add(line) {
    const { announce, store } = this.#sketch;
    this.#become([]);
    if (line.length < 2) return announce('A stroke needs two points.');
    store.change('Draw a guide', ({ guides }) => ({ guides: [...guides, line] }));
    announce('Guide added');
  }

  /** @param {Point} p */
  addPoint(p) { this.#become([...this.#stroke, p]); }
  finish() { this.#add(this.#stroke); }

  /** @param {Point} at  @param {number} pixel */
  #erase(at, pixel) {
    this.#sketch.store.change('Erase guides', ({ guides }) => ({ guides: withoutStrokesAt(guides, at, 12 * pixel) }), this.#erasing);
  }

  #endErasing() {
    if (this.#erasing !== '') this.#sketch.store.settle();
    this.#erasing = '';
  }

  /** @param {Point} at  @param {PointerEvent} event  @param {number} pixel */
  down(at, event, pixel) {
    if (this.#sketch.eraseGuides !== event.shiftKey) {
      this.#erasing = this.#sketch.newGesture('erase');
      this.#erase(at, pixel);
    } else {
      this.#stroke = [at];
      this.#byHand = true;
    }
    return true;
  }

  /** @param {Point} at  @param {PointerEvent} _  @param {number} pixel */
  move(at, _, pixel) {
    if (this.#erasing !== '') return this.#erase(at, pixel);
    if (!this.#byHand || distance(at, this.#stroke[this.#stroke.length - 1]) < pixel) return;
    this.#stroke.push(at);
    this.#sketch.stage.invalidate('overlay');
  }

  /** @param {Point} _  @param {PointerEvent} __  @param {number} pixel */
  up(_, __, pixel) {
    this.#endErasing();
    if (this.#byHand && this.#stroke.length > 2) this.#add(tidied(this.#stroke, false, pixel));
    else if (this.#byHand) this.#become([]);
    this.#byHand = false;
  }

  /** @param {KeyboardEvent} event */
  key({ key }) {
    if (this.#stroke.length === 0) return false;
    if (key === 'Enter') this.finish();
    else if (key === 'Escape') this.#become([]);
    else if (key === 'Backspace') this.#become(this.#stroke.slice(0, -1));
    else return false;
    return true;
  }

  cancel() {
    this.#endErasing();
    this.#byHand = false;
    this.#stroke = [];
  }

  /** @param {CanvasRenderingContext2D} context  @param {View} view */
  draw(context, view) {
    drawDraft(context, view, this.#sketch, this.#stroke, { dots: !this.#byHand });
  }
}
