// Pictures of a scene on a canvas without ever holding up the page: a long drawing is made in
// portions on a sheet of its own, while the last finished picture is shown, moved with the view.
/** @import { Scene, View } from '../types' */
import { BitmapPen } from '../draw/bitmap_pen.js';
import { drawing } from '../draw/draw.js';

const budget = 10;  // milliseconds of a frame

export class Painter {
  #shown = new BitmapPen();
  #next = new BitmapPen();
  /** @type {View | null} */
  #shownView = null;
  /** @type {{steps: Iterator<void>, scene: Scene, view: View} | null} */
  #job = null;
  /** The latest that was asked for, done or under way. @type {{scene: Scene, view: View} | null} */
  #wanted = null;

  /** @param {HTMLCanvasElement} canvas */
  constructor(canvas) {
    this.canvas = canvas;
    this.context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
  }

  /**
   * Works for one frame. True: there is more to do in the next one.
   * @param {Scene} scene  @param {View} view  @param {boolean} changed
   */
  paint(scene, view, changed) {
    const end = performance.now() + budget;
    if (changed) this.#wanted = { scene, view };
    let finished = false;
    do {
      if (this.#job === null) {
        if (this.#wanted === null) break;
        this.#start(this.#wanted);
        this.#wanted = null;
      }
      finished = this.#work(end) || finished;
    } while (performance.now() < end);
    this.show(view);
    return this.#job !== null || this.#wanted !== null;
  }

  /** @param {{scene: Scene, view: View}} wanted */
  #start({ scene, view }) {
    this.#next.begin(view.width, view.height, devicePixelRatio);
    this.#job = { steps: drawing(this.#next.pen, scene, view), scene, view };
  }

  /** @param {number} end @returns whether the picture is finished */
  #work(end) {
    const job = this.#job;
    if (job === null) return false;
    do {
      if (!job.steps.next().done) continue;
      this.#next.end();
      [this.#shown, this.#next] = [this.#next, this.#shown];
      this.#shownView = job.view;
      this.#job = null;
      return true;
    } while (performance.now() < end);
    return false;
  }

  /** The last picture, where the view is now. @param {View} view */
  show(view) {
    const { context, canvas } = this, from = this.#shownView;
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, canvas.width, canvas.height);
    if (from === null) return;
    const zoom = view.scale / from.scale, ratio = this.#shown.ratio;
    const x = (from.left - view.left) * view.scale * ratio, y = (view.top - from.top) * view.scale * ratio;
    const same = zoom === 1 && Math.abs(x) < 1e-6 && Math.abs(y) < 1e-6;
    if (same) context.drawImage(this.#shown.canvas, 0, 0);
    else context.drawImage(this.#shown.canvas, x, y, zoom * this.#shown.canvas.width, zoom * this.#shown.canvas.height);
  }
}
