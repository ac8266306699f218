// A pen on a canvas that puts polygons and lines in bulk into a bitmap of its own, and everything
// else onto the canvas as usual. What comes later lies above.
/** @import { Bulk, Pen } from '../types' */
import { Raster } from './raster.js';

/** @typedef {CanvasRenderingContext2D} Context */

/** The canvas to draw on, with its pen. */
export class BitmapPen {
  ratio = 1;
  #used = false;  // something is in the bitmap that is not on the canvas
  #image = new ImageData(1, 1);
  #raster = new Raster(1, 1);
  #scaled = new Float64Array(64);
  #sheet = document.createElement('canvas');

  constructor() {
    this.canvas = document.createElement('canvas');
    // Drawn by the processor, at once: not recorded and drawn when the picture is needed.
    this.context = /** @type {Context} */ (this.canvas.getContext('2d', { willReadFrequently: true }));
    this.pen = this.#equip(this.context);
  }

  /**
   * A clean sheet of this size in CSS pixels, with so many pixels each.
   * @param {number} width  @param {number} height  @param {number} ratio
   */
  begin(width, height, ratio) {
    const across = Math.max(1, Math.round(width * ratio)), down = Math.max(1, Math.round(height * ratio));
    this.ratio = ratio;
    this.#used = false;
    this.canvas.width = across;  // also forgets every setting
    if (this.canvas.height !== down) this.canvas.height = down;
    if (this.#image.width !== across || this.#image.height !== down) {
      this.#image = new ImageData(across, down);
      this.#raster = new Raster(across, down, new Uint32Array(this.#image.data.buffer));
    } else this.#raster.clear();
    this.context.setTransform(ratio, 0, 0, ratio, 0, 0);
  }

  /** All of it is on the canvas then. */
  end() {
    if (!this.#used) return;
    this.#used = false;
    const { width, height } = this.#image;
    if (this.#sheet.width !== width || this.#sheet.height !== height) Object.assign(this.#sheet, { width, height });
    /** @type {Context} */ (this.#sheet.getContext('2d', { willReadFrequently: true })).putImageData(this.#image, 0, 0);
    this.context.save();
    this.context.setTransform(1, 0, 0, 1, 0, 0);
    this.context.globalAlpha = 1;
    this.context.drawImage(this.#sheet, 0, 0);
    this.context.restore();
    this.#raster.clear();
  }

  /** The context itself, with the two operations more. @param {Context} context  @returns {Pen} */
  #equip(context) {
    for (const name of /** @type {const} */ (['fill', 'stroke', 'fillText'])) {
      const plain = /** @type {(...args: any[]) => void} */ (context[name].bind(context));
      context[name] = (/** @type {any[]} */ ...args) => {
        this.end();
        plain(...args);
      };
    }
    return Object.assign(context, {
      fillPolygon: /** @type {Bulk['fillPolygon']} */ ((corners, count, rgba) => {
        this.#used = true;
        if (2 * count > this.#scaled.length) this.#scaled = new Float64Array(4 * count);
        for (let i = 0; i < 2 * count; ++i) this.#scaled[i] = this.ratio * corners[i];
        this.#raster.fillPolygon(this.#scaled, count, rgba);
      }),
      strokeLine: /** @type {Bulk['strokeLine']} */ ((x0, y0, x1, y1, width, rgba) => {
        this.#used = true;
        const r = this.ratio;
        this.#raster.strokeLine(r * x0, r * y0, r * x1, r * y1, r * width, rgba);
      }),
    });
  }
}
