// The single numbers: what each is in plain words, its symbol in the paper, and how it is written.
/** @import { Figures } from './statistics.js' */
import { h, setText } from '../panels/dom.js';

/**
 * @typedef {object} Kind
 * @property {string} key
 * @property {string} name
 * @property {string} [symbol]
 * @property {string} help
 * @property {(figures: Figures) => number | undefined} of
 * @property {(value: number) => string} write
 */

const count = (/** @type {number} */ value) => value.toLocaleString('en');
const three = (/** @type {number} */ value) => value.toFixed(3);
const percent = (/** @type {number} */ value) => `${value.toFixed(1)} %`;
const digits = (/** @type {number} */ value) => value.toPrecision(4);
const ofLength = (/** @type {string} */ part) =>
  `Edge length over the length asked for: ${part} is shorter than this. 1 is as asked.`;

/** @type {Kind[]} */
const quality = [
  { key: 'etaMean', name: 'Squareness, mean', symbol: 'η', of: (f) => f.etaMean, write: three,
    help: 'How near to right angles the corners of a quad are, mean over all quads: 1 is a rectangle, 0 has a corner '
      + 'of 0° or 180°.' },
  { key: 'etaMin', name: 'Squareness, least', symbol: 'η min', of: (f) => f.etaMin, write: three,
    help: 'The squareness of the worst quad.' },
  { key: 'etaP5', name: 'Squareness, worst twentieth', symbol: 'η 5 %', of: (f) => f.etaP5, write: three,
    help: 'One quad in twenty is less square than this.' },
  { key: 'fourValentPercent', name: 'Regular vertices inside', of: (f) => f.fourValentPercent, write: percent,
    help: 'Interior vertices where four quads meet, as on a chessboard.' },
  { key: 'tau', name: 'Right angles before merging', symbol: 'τ', of: (f) => f.tau, write: three,
    help: 'How much the triangles look like halves of squares (Eq. 2 of the paper): 1 is perfect.' },
];

/** @type {Kind[]} */
const counts = [
  { key: 'quads', name: 'Quads', of: (f) => f.quads, write: count, help: 'Four-sided elements.' },
  { key: 'triangles', name: 'Triangles', of: (f) => f.triangles, write: count,
    help: 'Before the merging all, afterwards those that are left over.' },
  { key: 'vertices', name: 'Vertices', of: (f) => f.vertices, write: count, help: 'All points of the mesh.' },
  { key: 'boundaryNodes', name: 'Boundary nodes', of: (f) => f.boundaryNodes, write: count,
    help: 'Points on outlines, holes and lines.' },
  { key: 'irregular', name: 'Irregular vertices inside', of: (f) => f.irregular, write: count,
    help: 'Interior vertices where other than four quads meet. Layers marks those on the boundary, too.' },
  { key: 'singularities', name: 'Singularities', of: (f) => f.singularities, write: count,
    help: 'Points where the cross field has no direction; irregular vertices belong there.' },
];

/** @type {Kind[]} */
export const kinds = [
  ...quality, ...counts,
  { key: 'energy', name: 'Energy', symbol: 'F', of: (f) => f.energy, write: digits,
    help: 'The Lp energy of the cells, without unit: what the iterations make small.' },
  { key: 'gradientNorm', name: 'Slope of the energy', symbol: '‖g‖', of: (f) => f.gradientNorm, write: digits,
    help: 'How steeply the energy still falls, without unit.' },
  { key: 'p10', name: 'Size, shortest tenth', of: (f) => f.size?.p10, write: three,
    help: ofLength('a tenth of the edges') },
  { key: 'p50', name: 'Size, median', of: (f) => f.size?.p50, write: three, help: ofLength('half of the edges') },
  { key: 'p90', name: 'Size, longest tenth', of: (f) => f.size?.p90, write: three,
    help: ofLength('all but a tenth of the edges') },
];

/** As a list. @param {Kind[]} [shown]  all of them */
export function createNumbers(shown = kinds) {
  const rows = shown.map((kind) => {
    const value = h('dd', { className: 'numbers', 'data-figure': kind.key });
    const symbol = kind.symbol ? h('i', null, kind.symbol) : null;
    const row = h('div', { title: kind.help }, h('dt', null, kind.name, symbol && ' ', symbol), value);
    return { kind, value, row };
  });
  const element = h('dl', { className: 'numbers-list' }, ...rows.map(({ row }) => row));
  /** @param {Figures} figures */
  function show(figures) {
    for (const { kind, value, row } of rows) {
      const number = kind.of(figures);
      setText(value, number === undefined ? '–' : kind.write(number));
      row.classList.toggle('unknown', number === undefined);
      value.dataset.value = number === undefined ? '' : String(number);
    }
  }
  return { element, show };
}
