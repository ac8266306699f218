// A curve over the iterations along which the run is scrubbed: by hovering, by dragging, by arrows.
import { h, s, setText } from '../panels/dom.js';

const width = 340, height = 96, left = 46, right = 8, top = 8, bottom = 18;

/** @typedef {{x: number, y: number}} Sample */

/** @typedef {{hover: (x: number) => void, leave: () => void, pin: (x: number) => void, turn: (key: string) => void}} Scrub */

/**
 * @param {{name: string, log?: boolean, help: string}} what
 * @param {Scrub} scrub
 */
export function createCurve({ name, log = false, help }, scrub) {
  const picture = createPicture();
  const readout = h('span', { className: 'numbers' });
  let end = 1;
  const area = createArea(name, picture.svg, scrub, () => end);
  const element = h('figure', { className: 'curve' },
    h('figcaption', { title: help }, h('span', null, name), readout), area);

  /** @param {Sample[]} given  @param {number} planned  @param {number} at */
  function show(given, planned, at) {
    const samples = given.filter(({ y }) => y > 0);
    end = Math.max(1, planned);
    const now = samples.findLast((one) => one.x <= at);
    picture.draw(samples, scales(samples, end, log), { end, at, now });
    const text = now ? now.y.toPrecision(4) : '';
    setText(readout, text);
    area.setAttribute('aria-valuemax', String(end));
    area.setAttribute('aria-valuenow', String(at));
    area.setAttribute('aria-valuetext', now ? `iteration ${now.x}: ${text}` : 'nothing yet');
  }
  return { element, show };
}

/** What is scrubbed on, a slider. @param {string} name  @param {SVGElement} svg  @param {Scrub} scrub  @param {() => number} end */
function createArea(name, svg, scrub, end) {
  /** @param {PointerEvent} event */
  function xAt(event) {
    const box = svg.getBoundingClientRect();
    const part = ((event.clientX - box.left) / box.width * width - left) / (width - left - right);
    return Math.round(Math.max(0, Math.min(1, part)) * end());
  }
  /** @param {KeyboardEvent} event */
  function turn(event) {
    if (!['ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown', 'Home', 'End'].includes(event.key)) return;
    event.preventDefault();
    scrub.turn(event.key);
  }
  return h('div', {
    role: 'slider', tabIndex: 0, className: 'curve-area', 'aria-label': `${name} by iteration`, 'aria-valuemin': '0',
    onpointermove: (/** @type {PointerEvent} */ event) => scrub.hover(xAt(event)), onpointerleave: () => scrub.leave(),
    onpointerdown: (/** @type {PointerEvent} */ event) => scrub.pin(xAt(event)), onkeydown: turn,
  }, svg);
}

/** The curve with its axes, and a mark on it. */
function createPicture() {
  const line = s('polyline', { class: 'curve-line' });
  const mark = s('line', { class: 'curve-mark', y1: top, y2: height - bottom });
  const dot = s('circle', { class: 'curve-dot', r: 4 });
  const texts = ['high', 'low', 'from', 'to'].map((kind) => s('text', { class: `curve-${kind}` }));
  const svg = s('svg', { viewBox: `0 0 ${width} ${height}`, 'aria-hidden': 'true' },
    s('path', { class: 'curve-axis', d: `M${left} ${top}V${height - bottom}H${width - right}` }),
    line, mark, dot, ...texts);

  /** @param {Sample[]} samples  @param {ReturnType<typeof scales>} scale  @param {{end: number, at: number, now?: Sample}} marked */
  function draw(samples, { low, high, x, y }, { end, at, now }) {
    line.setAttribute('points', samples.map((one) => `${x(one.x).toFixed(1)},${y(one.y).toFixed(1)}`).join(' '));
    for (const part of [mark, dot]) part.toggleAttribute('hidden', !now);
    if (now) {
      for (const side of ['x1', 'x2']) mark.setAttribute(side, String(x(at)));
      dot.setAttribute('cx', String(x(now.x)));
      dot.setAttribute('cy', String(y(now.y)));
    }
    label(texts, [
      [high, left - 4, top + 8, 'end'], [low, left - 4, height - bottom, 'end'],
      ['0', left, height - 4, 'start'], [String(end), width - right, height - 4, 'end'],
    ]);
  }
  return { svg, draw };
}

/** @param {SVGElement[]} texts  @param {[string, number, number, string][]} places */
function label(texts, places) {
  places.forEach(([text, x, y, anchor], i) => {
    setText(texts[i], text);
    const attributes = { x, y, 'text-anchor': anchor };
    for (const [key, value] of Object.entries(attributes)) texts[i].setAttribute(key, String(value));
  });
}

/** @param {Sample[]} samples  @param {number} end  @param {boolean} log */
function scales(samples, end, log) {
  const values = samples.map(({ y }) => y);
  const [least, most] = values.length > 0 ? [Math.min(...values), Math.max(...values)] : [1, 1];
  const to = log ? Math.log : (/** @type {number} */ value) => value;
  const span = to(most) - to(least) || 1;
  const x = (/** @type {number} */ value) => left + value / end * (width - left - right);
  const y = (/** @type {number} */ value) => height - bottom - (to(value) - to(least)) / span * (height - top - bottom);
  return { x, y, low: least.toPrecision(3), high: most.toPrecision(3) };
}
