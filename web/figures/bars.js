// Histograms and bars, each with its numbers as a table for those who cannot see or want them exact.
import { h, s, setText } from '../panels/dom.js';

const width = 340, height = 84, base = 66;

/** @typedef {{label: string, value: number, text?: string}} Bar */

/** The same numbers as a table, filled when it is opened. @param {string[]} heads */
function createTable(heads) {
  const rows = h('tbody', null);
  /** @type {Bar[]} */
  let shown = [];
  const fill = () => {
    if (!details.open) return;
    rows.replaceChildren(...shown.map(({ label, value, text }) =>
      h('tr', null, h('th', { scope: 'row' }, label), h('td', null, text ?? String(value)))));
  };
  const details = h('details', { className: 'as-table', ontoggle: fill }, h('summary', null, 'As a table'),
    h('table', null, h('thead', null, h('tr', null, ...heads.map((head) => h('th', { scope: 'col' }, head)))), rows));
  return { details, show: (/** @type {Bar[]} */ bars) => { shown = bars; fill(); } };
}

/** Upright bars. @param {{name: string, help: string, heads: string[]}} what */
export function createHistogram({ name, help, heads }) {
  const drawn = s('g', null), summary = h('span', { className: 'numbers' });
  const axis = s('path', { class: 'curve-axis', d: `M0 ${base + 0.5}H${width}` });
  const svg = s('svg', { viewBox: `0 0 ${width} ${height}`, role: 'img' }, drawn, axis);
  const table = createTable(heads);
  const element = h('figure', { className: 'histogram' },
    h('figcaption', { title: help }, h('span', null, name), summary), svg, table.details);
  /** @param {Bar[]} bars  @param {string} inWords */
  function show(bars, inWords) {
    drawn.replaceChildren(...uprights(bars));
    setText(summary, inWords);
    svg.setAttribute('aria-label', `${name}: ${inWords}`);
    table.show(bars);
  }
  return { element, show };
}

/** A bar is seen even of one among thousands. @param {Bar[]} bars */
function uprights(bars) {
  const most = Math.max(1, ...bars.map(({ value }) => value));
  const step = width / bars.length;
  const few = bars.length < 12;  // then each has its label below, else every fifth at its left end
  return bars.flatMap(({ label, value, text }, i) => {
    const tall = value === 0 ? 0 : Math.max(1.5, value / most * (base - 6));
    const place = { x: few ? (i + 0.5) * step : i * step, y: height - 4, 'text-anchor': few ? 'middle' : 'start' };
    const bar = s('rect', { x: i * step + 1, y: base - tall, width: step - 2, height: tall },
      s('title', null, `${label}: ${text ?? value}`));
    return few || i % 5 === 0 ? [bar, s('text', place, label)] : [bar];
  });
}

/** Lying bars with their values. @param {{name: string, help: string}} what */
export function createBars({ name, help }) {
  const list = h('ul', { className: 'bars' }), total = h('span', { className: 'numbers' });
  const element = h('figure', null, h('figcaption', { title: help }, h('span', null, name), total), list);
  /** @param {Bar[]} bars  @param {string} inWords */
  function show(bars, inWords) {
    const most = Math.max(1e-12, ...bars.map(({ value }) => value));
    setText(total, inWords);
    list.replaceChildren(...bars.map(({ label, value, text }) => {
      const bar = h('span', { className: 'bar' });
      bar.style.width = `${100 * value / most}%`;
      return h('li', null, h('span', null, label), h('span', { className: 'track' }, bar),
        h('span', { className: 'numbers' }, text ?? String(value)));
    }));
  }
  return { element, show };
}
