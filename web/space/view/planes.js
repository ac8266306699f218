// The charts in their planes, beside the surface: pointing at one shows it in both views.
/** @import { SpaceApp } from '../types' */
/** @import { Layout } from './layout.js' */
import { once } from '../../draw/once.js';
import { dark, light } from '../../draw/palette.js';
import { h } from '../../panels/dom.js';
import { atNextPicture } from '../../panels/next_picture.js';
import { bordersOf, nextCorner } from './borders.js';
import { cellColours, chartColour } from './geometry.js';
import { layOut, quadsInPlanes } from './layout.js';

const margin = 12;
const borderWidth = 2.5, tint = 0.3;  // of the chart that is pointed at: the lines on it stay to be read

/** @typedef {NonNullable<import('lpquad').SurfaceSnapshot['charts']>} Charts */

export class Planes {
  #app;
  #element;
  #canvas;
  #waiting = h('p', { className: 'instead quiet' }, 'The charts come here.');
  /** @type {{charts: unknown, aspect: number, layout: Layout} | null} */
  #known = null;
  /** What the picture shows. @type {unknown[]} */
  #drawn = [];
  #invalidate = atNextPicture(() => this.#paint());

  /** @param {SpaceApp} app  @param {HTMLElement} element  holds the canvas */
  constructor(app, element) {
    this.#app = app;
    this.#element = element;
    this.#canvas = /** @type {HTMLCanvasElement} */ (element.querySelector('canvas'));
    element.append(this.#waiting);
    for (const name of /** @type {const} */ (['pointermove', 'pointerdown']))
      this.#canvas.addEventListener(name, (event) => app.point(this.#chartAt(event)));
    this.#canvas.addEventListener('pointerleave', () => app.point(-1));
    this.#canvas.addEventListener('keydown', (event) => this.#key(event));
    new ResizeObserver(this.#invalidate).observe(element);
  }

  /** Most steps of a run change nothing here, and tens of thousands of triangles are slow to draw. */
  refresh() {
    const { layers, pointed, runner, themes } = this.#app;
    const { frame: { charts, cells }, result, phase } = runner.run;
    const depends = [charts ?? phase, cells, result, pointed.chart, themes.dark, layers().has('cells')];
    if (depends.every((one, i) => one === this.#drawn[i])) return;
    this.#drawn = depends;
    this.#invalidate();
  }

  /** Where the charts lie on the element now; null: there are none, or no room. */
  #place() {
    const { charts } = this.#app.runner.run.frame;
    const { width, height } = this.#element.getBoundingClientRect();
    if (charts === undefined || width === 0 || height === 0) return null;
    const layout = this.#layout(charts, (width - 2 * margin) / (height - 2 * margin));
    const scale = Math.min((width - 2 * margin) / layout.width, (height - 2 * margin) / layout.height);
    return { charts, layout, scale, left: (width - scale * layout.width) / 2, top: (height - scale * layout.height) / 2 };
  }

  /** @param {Charts} charts  @param {number} aspect */
  #layout(charts, aspect) {
    const { surface } = this.#app.runner.run.frame;
    if (this.#known?.charts !== charts || this.#known.aspect !== aspect) this.#known = { charts, aspect, layout: layOut(charts, aspect, surface) };
    return this.#known.layout;
  }

  #paint() {
    const canvas = this.#canvas;
    const { frame: { charts }, phase } = this.#app.runner.run;
    this.#waiting.hidden = charts !== undefined;
    this.#element.hidden = charts === undefined && phase !== 'running';  // a run keeps the place: the view beside it must not jump
    const { width, height } = this.#element.getBoundingClientRect();
    canvas.width = Math.round(width * devicePixelRatio);
    canvas.height = Math.round(height * devicePixelRatio);
    const context = canvas.getContext('2d');
    const now = this.#place();
    if (context === null || now === null) return;
    context.setTransform(devicePixelRatio * now.scale, 0, 0, devicePixelRatio * now.scale, devicePixelRatio * now.left, devicePixelRatio * now.top);
    context.lineWidth = 1 / now.scale;
    // Triangles of a few pixels: their lines would hide the colour of the chart.
    const triangle = now.scale * Math.sqrt(now.layout.width * now.layout.height / (now.charts.charts.length || 1));
    drawPlanes(context, now, this.#app, 0.5 * Math.min(1, triangle / 12));
  }

  /** @param {PointerEvent} event */
  #chartAt({ clientX, clientY }) {
    const now = this.#place();
    if (now === null) return -1;
    const box = this.#canvas.getBoundingClientRect();
    return pick(now.charts.uv, now.layout, (clientX - box.left - now.left) / now.scale, (clientY - box.top - now.top) / now.scale);
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    const { announce, point, pointed } = this.#app;
    const by = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
    const count = this.#known?.layout.islands.length ?? 0;
    if (by === undefined || count === 0) return;
    event.preventDefault();
    point(nextChart(pointed.chart, by, count));
    announce(`Chart ${pointed.chart + 1} of ${count}`);
  }
}

/** @param {CanvasRenderingContext2D} context  its lines are a pixel wide
 * @param {{charts: Charts, layout: Layout}} planes  @param {SpaceApp} app
 * @param {number} fade  of the lines of triangles */
function drawPlanes(context, { charts, layout }, { layers, pointed, runner, themes }, fade) {
  const palette = themes.dark ? dark : light;
  const { result, frame: { cells, surface } } = runner.run;
  const quads = result ? once(result, 'planes', () => quadsInPlanes(charts, result)) : null;
  const pixel = context.lineWidth;
  for (const { chart, triangles, scale, shift } of layout.islands) {
    context.save();
    context.translate(...shift);
    context.scale(scale, -scale);
    context.lineWidth = pixel / scale;
    context.fillStyle = `rgb(${chartColour(chart, themes.dark).map((x) => Math.round(255 * x))})`;
    context.beginPath();
    for (const t of triangles) traceLoop(context, charts.uv, 6 * t, 3);
    context.fill();
    context.strokeStyle = quads ? palette.ink : palette.faint;
    context.globalAlpha = quads ? Math.min(0.8, 3 * fade) : fade;
    context.beginPath();
    const of = quads?.get(chart) ?? [];
    if (quads) for (let q = 0; q < of.length; q += 8) traceLoop(context, of, q, 4);
    else for (const t of triangles) traceLoop(context, charts.uv, 6 * t, 3);
    context.stroke();
    if (cells?.chart === chart && layers().has('cells')) drawCells(context, cells, palette);
    if (chart === pointed.chart && surface) drawPointed(context, charts, { chart, triangles, surface }, palette.accent);
    context.restore();
  }
}

/** @param {CanvasRenderingContext2D} context  @param {Charts} charts
 * @param {{chart: number, triangles: number[], surface: import('lpquad').Surface}} island  @param {string} colour */
function drawPointed(context, charts, { chart, triangles, surface }, colour) {
  context.fillStyle = context.strokeStyle = colour;
  context.globalAlpha = tint;
  context.beginPath();
  for (const t of triangles) traceLoop(context, charts.uv, 6 * t, 3);
  context.fill();
  context.globalAlpha = 1;
  context.lineWidth *= borderWidth;
  context.beginPath();
  for (const i of bordersOf(charts, surface.triangles, chart)) {
    const next = nextCorner(i);
    context.moveTo(charts.uv[2 * i], charts.uv[2 * i + 1]);
    context.lineTo(charts.uv[2 * next], charts.uv[2 * next + 1]);
  }
  context.stroke();
}

/** @param {CanvasRenderingContext2D} context  @param {import('./geometry.js').Cells} cells  @param {import('../../types').Palette} palette */
function drawCells(context, cells, palette) {
  const { offsets, uv } = cells;
  context.globalAlpha = 1;
  context.strokeStyle = palette.faint;
  cellColours(cells, palette.ramps.density).forEach((colour, i) => {
    context.fillStyle = colour;
    context.beginPath();
    traceLoop(context, uv, 2 * offsets[i], offsets[i + 1] - offsets[i]);
    context.fill();
    context.stroke();
  });
}

/** @param {CanvasRenderingContext2D} context  @param {ArrayLike<number>} uv  @param {number} at  @param {number} corners */
function traceLoop(context, uv, at, corners) {
  // Back by a line: in Chromium closing takes longer the longer the whole path is, seconds for a chart of many triangles.
  context.moveTo(uv[at], uv[at + 1]);
  for (let k = 1; k <= corners; ++k) context.lineTo(uv[at + 2 * (k % corners)], uv[at + 2 * (k % corners) + 1]);
}

/** From chart to chart and round; from none (-1) to the first or the last. @param {number} chart  @param {number} by  1 or -1
 * @param {number} count */
export const nextChart = (chart, by, count) => (chart < 0 ? (by > 0 ? 0 : count - 1) : (chart + by + count) % count);

/** The chart at a place of the picture; -1: none. @param {ArrayLike<number>} uv  @param {Layout} layout  @param {number} x
 * @param {number} y */
export function pick(uv, { islands }, x, y) {
  for (const { chart, triangles, scale, shift } of islands)
    for (const t of triangles) {
      const side = (/** @type {number} */ k) => {
        const [i, j] = [6 * t + 2 * k, 6 * t + 2 * ((k + 1) % 3)];
        return (uv[j] - uv[i]) * ((shift[1] - y) / scale - uv[i + 1]) - (uv[j + 1] - uv[i + 1]) * ((x - shift[0]) / scale - uv[i]);
      };
      if (side(0) >= 0 && side(1) >= 0 && side(2) >= 0) return chart;
    }
  return -1;
}
