// The single numbers: what each is in plain words, its symbol in the paper, and how it is written.
/** @import { Figures } from './statistics.js' */
import { h, setText } from '../panels/dom.js';

/** @typedef {{key: string, name: string, symbol?: string, help: string, of: (figures: Figures) => number | undefined, write: (value: number) => string}} Kind */

const count = (/** @type {number} */ value) => value.toLocaleString('en');
const three = (/** @type {number} */ value) => value.toFixed(3);
const percent = (/** @type {number} */ value) => `${value.toFixed(1)} %`;

/** @type {Kind[]} */
export const kinds = [
  { key: 'etaMean', name: 'Squareness, mean', symbol: 'η', help: 'How near to a right angle the corners of a quad are: 1 is a rectangle, 0 has a corner of 0° or 180°. Mean over all quads.', of: (f) => f.etaMean, write: three },
  { key: 'etaMin', name: 'Squareness, least', symbol: 'η min', help: 'The squareness of the worst quad.', of: (f) => f.etaMin, write: three },
  { key: 'etaP5', name: 'Squareness, worst twentieth', symbol: 'η 5 %', help: 'One quad in twenty is less square than this.', of: (f) => f.etaP5, write: three },
  { key: 'fourValentPercent', name: 'Regular vertices', help: 'Interior vertices where four quads meet, as on a chessboard.', of: (f) => f.fourValentPercent, write: percent },
  { key: 'tau', name: 'Right angles before merging', symbol: 'τ', help: 'How much the triangles look like halves of squares (Eq. 2 of the paper): 1 is perfect.', of: (f) => f.tau, write: three },
  { key: 'quads', name: 'Quads', help: 'Four-sided elements.', of: (f) => f.quads, write: count },
  { key: 'triangles', name: 'Triangles', help: 'Before the merging all, afterwards those that are left over.', of: (f) => f.triangles, write: count },
  { key: 'vertices', name: 'Vertices', help: 'All points of the mesh.', of: (f) => f.vertices, write: count },
  { key: 'boundaryNodes', name: 'Boundary nodes', help: 'Points on outlines, holes and lines.', of: (f) => f.boundaryNodes, write: count },
  { key: 'irregular', name: 'Irregular vertices', help: 'Interior vertices where other than four quads meet.', of: (f) => f.irregular, write: count },
  { key: 'singularities', name: 'Singularities', help: 'Points where the cross field has no direction; irregular vertices belong there.', of: (f) => f.singularities, write: count },
  { key: 'energy', name: 'Energy', symbol: 'E', help: 'The L_p energy of the cells, without unit: what the iterations make small.', of: (f) => f.energy, write: (v) => v.toPrecision(5) },
  { key: 'gradientNorm', name: 'Slope of the energy', symbol: '‖g‖', help: 'How steeply the energy still falls, without unit.', of: (f) => f.gradientNorm, write: (v) => v.toPrecision(4) },
  { key: 'p10', name: 'Size, shortest tenth', help: 'Edge length over the length asked for: a tenth of the edges is below this. 1 is as asked.', of: (f) => f.size?.p10, write: three },
  { key: 'p50', name: 'Size, median', help: 'Edge length over the length asked for: half of the edges is below this. 1 is as asked.', of: (f) => f.size?.p50, write: three },
  { key: 'p90', name: 'Size, longest tenth', help: 'Edge length over the length asked for: a tenth of the edges is above this. 1 is as asked.', of: (f) => f.size?.p90, write: three },
];

/** All of them as a list. */
export function createNumbers() {
  const rows = kinds.map((kind) => {
    const value = h('dd', { className: 'numbers', 'data-figure': kind.key });
    const row = h('div', { title: kind.help }, h('dt', null, kind.name, kind.symbol ? h('i', null, ` ${kind.symbol}`) : null), value);
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
