// The drawing area: two canvases, one for the mesh, one above it for what is edited; pan, zoom and
// pinch; every other pointer event goes to the tool in hand.
/** @import { Point, Scene, View } from '../types' */
import { fit, pan, toWorld, zoomAt } from '../draw/view.js';
import { Painter } from './painter.js';

/**
 * What a tool may do. Points are in the world; `pixel` is the size of a pixel there.
 * @typedef {object} Tool
 * @property {string} id
 * @property {(at: Point, event: PointerEvent, pixel: number) => boolean | void} [down]  true: the drag is the tool's
 * @property {(at: Point, event: PointerEvent, pixel: number) => void} [move]
 * @property {(at: Point, event: PointerEvent, pixel: number) => void} [up]
 * @property {(event: KeyboardEvent) => boolean} [key]  true: the key is the tool's
 * @property {() => void} [cancel]
 * @property {(context: CanvasRenderingContext2D, view: View) => void} [draw]  on the upper canvas
 * @property {string} [cursor]
 * @property {boolean} [inspects]  whether hovering and clicking tell of the mesh; without: only of the tool 'edit'
 */

/** Across and down. @type {Record<string, [number, number]>} */
const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

const margin = 24;
/** Room for the key of the colours: where it is narrow, that takes two lines. @param {number} width */
const below = (width) => (width < 500 ? 40 : margin);

const tapReach = 4;  // pixels that a finger may move in a tap

/** @param {Point} a  @param {Point} b */
const apart = ([ax, ay], [bx, by]) => Math.hypot(ax - bx, ay - by);

export class Stage {
  /** @type {View} */
  view = { scale: 1, left: 0, top: 1, width: 1, height: 1 };
  /** @type {Tool} */
  #tool = { id: 'none' };
  /** @type {Map<number, Point>} */
  #pointers = new Map();
  #dragging = /** @type {'' | 'tool' | 'pan'} */ ('');
  #dirty = { mesh: true, overlay: true };
  #scheduled = false;
  #fitted = true;  // all of the drawing is to be seen, whatever the size of the stage
  #unfinished = false;  // of a picture made in portions
  /** Drawn on the upper canvas whatever the tool. @type {((context: CanvasRenderingContext2D, view: View) => void)[]} */
  overlays = [];
  /** Told of every new view. @type {(view: View) => void} */
  looked = () => {};
  /** A click or tap that no tool took. @type {(at: Point) => void} */
  tapped = () => {};
  /** Where the last press began that may still become a tap. @type {Point | null} */
  #pressed = null;

  /**
   * @param {HTMLElement} element  holds the canvases
   * @param {() => Scene} scene  what to draw now
   */
  constructor(element, scene) {
    this.element = element;
    this.scene = scene;
    this.mesh = /** @type {HTMLCanvasElement} */ (element.querySelector('canvas'));
    this.overlay = /** @type {HTMLCanvasElement} */ (element.querySelector('canvas + canvas'));
    this.painter = new Painter(this.mesh);
    new ResizeObserver(() => this.#resize()).observe(element);
    this.overlay.addEventListener('pointerdown', (event) => this.#down(event));
    this.overlay.addEventListener('pointermove', (event) => this.#move(event));
    for (const name of /** @type {const} */ (['pointerup', 'pointercancel']))
      this.overlay.addEventListener(name, (event) => this.#up(event));
    this.overlay.addEventListener('keydown', (event) => {
      if (!event.defaultPrevented && (this.#tool.key?.(event) || this.#panByKey(event))) event.preventDefault();
    });
    this.overlay.addEventListener('wheel', (event) => this.#wheel(event), { passive: false });
    this.#resize();
  }

  get tool() { return this.#tool; }
  set tool(tool) {
    this.#tool.cancel?.();
    this.#tool = tool;
    this.overlay.style.cursor = tool.cursor ?? 'default';
    this.invalidate('overlay');
  }

  /** Size of a pixel in the world. */
  get pixel() { return 1 / this.view.scale; }

  #resize() {
    const { width, height } = this.element.getBoundingClientRect();
    if (width === 0 || height === 0) return;
    const first = this.view.width === 1;
    for (const canvas of [this.mesh, this.overlay]) {
      canvas.width = Math.round(width * devicePixelRatio);
      canvas.height = Math.round(height * devicePixelRatio);
    }
    if (first || this.#fitted) this.view = fit(this.scene().drawing, width, height, margin, below(width));
    else this.view = { ...pan(this.view, (width - this.view.width) / 2, (height - this.view.height) / 2), width, height };
    this.#dirty = { mesh: true, overlay: true };
    this.#paint();  // at once: a canvas that changed its size is empty
  }

  /** Shows all of the drawing. */
  fit() {
    const { width, height } = this.view;
    this.look(fit(this.scene().drawing, width, height, margin, below(width)));
    this.#fitted = true;
  }

  /** @param {View} view */
  look(view) {
    this.view = view;
    this.#fitted = false;
    this.looked(view);
    this.invalidate();
  }

  /** About the middle. @param {number} factor */
  zoom(factor) {
    this.look(zoomAt(this.view, factor, this.view.width / 2, this.view.height / 2));
  }

  /** Towards what an arrow points at. @param {KeyboardEvent} event  @returns {boolean} */
  #panByKey({ key, ctrlKey, metaKey, altKey }) {
    const [x, y] = arrows[key] ?? [0, 0];
    if ((x === 0 && y === 0) || ctrlKey || metaKey || altKey) return false;
    const by = 0.1 * Math.min(this.view.width, this.view.height);
    this.look(pan(this.view, -by * x, -by * y));
    return true;
  }

  /** @param {'all' | 'overlay'} [what] */
  invalidate(what = 'all') {
    this.#dirty.overlay = true;
    if (what === 'all') this.#dirty.mesh = true;
    this.#schedule();
  }

  #schedule() {
    if (this.#scheduled) return;
    this.#scheduled = true;
    requestAnimationFrame(() => this.#paint());
  }

  #paint() {
    this.#scheduled = false;
    const { mesh, overlay } = this.#dirty;
    this.#dirty = { mesh: false, overlay: false };
    if (overlay) {
      const context = this.#clear(this.overlay);
      for (const drawOverlay of this.overlays) drawOverlay(context, this.view);
      this.#tool.draw?.(context, this.view);
    }
    if (mesh || this.#unfinished) this.#unfinished = this.painter.paint(this.scene(), this.view, mesh);
    if (this.#unfinished) this.#schedule();
  }

  /** @param {HTMLCanvasElement} canvas */
  #clear(canvas) {
    const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, canvas.width, canvas.height);
    context.setTransform(devicePixelRatio, 0, 0, devicePixelRatio, 0, 0);
    return context;
  }

  /** @param {PointerEvent | WheelEvent} event @returns {Point} in pixels of the stage */
  #place(event) {
    const { left, top } = this.overlay.getBoundingClientRect();
    return [event.clientX - left, event.clientY - top];
  }

  /** @param {PointerEvent} event */
  #down(event) {
    const place = this.#place(event);
    this.overlay.setPointerCapture(event.pointerId);
    this.#pointers.set(event.pointerId, place);
    if (this.#pointers.size === 2) {  // a pinch, whatever the first finger began
      this.#tool.cancel?.();
      this.#dragging = 'pan';
      this.#pressed = null;
      return;
    }
    const panning = event.button === 1 || event.altKey;
    const taken = !panning && event.button === 0 && this.#tool.down?.(toWorld(this.view, ...place), event, this.pixel);
    this.#dragging = taken ? 'tool' : 'pan';
    this.#pressed = taken || panning || event.button !== 0 ? null : place;
  }

  /** @param {PointerEvent} event */
  #move(event) {
    const place = this.#place(event);
    const before = this.#pointers.get(event.pointerId);
    if (this.#dragging === 'pan' && before) {
      if (this.#pressed && apart(place, this.#pressed) < tapReach) return;
      this.#pressed = null;
      const others = [...this.#pointers].filter(([id]) => id !== event.pointerId).map(([, point]) => point);
      this.#pointers.set(event.pointerId, place);
      this.look(others.length > 0 ? this.#pinch(before, place, others[0]) : pan(this.view, place[0] - before[0], place[1] - before[1]));
      return;
    }
    if (before) this.#pointers.set(event.pointerId, place);
    this.#tool.move?.(toWorld(this.view, ...place), event, this.pixel);
  }

  /** @param {Point} before  @param {Point} now  @param {Point} other  the finger that rests */
  #pinch(before, now, other) {
    const moved = pan(this.view, (now[0] - before[0]) / 2, (now[1] - before[1]) / 2);
    return zoomAt(moved, Math.max(1, apart(now, other)) / Math.max(1, apart(before, other)), (now[0] + other[0]) / 2, (now[1] + other[1]) / 2);
  }

  /** @param {PointerEvent} event */
  #up(event) {
    if (!this.#pointers.delete(event.pointerId)) return;
    if (this.#dragging === 'tool') {
      if (event.type === 'pointercancel') this.#tool.cancel?.();
      else this.#tool.up?.(toWorld(this.view, ...this.#place(event)), event, this.pixel);
    }
    if (this.#pressed && event.type === 'pointerup') this.tapped(this.#pressed);
    this.#pressed = null;
    if (this.#pointers.size === 0) this.#dragging = '';
  }

  /** @param {WheelEvent} event */
  #wheel(event) {
    event.preventDefault();
    const lines = event.deltaMode === 1 ? 16 : 1;
    this.look(zoomAt(this.view, Math.exp(-0.0015 * lines * event.deltaY), ...this.#place(event)));
  }
}
