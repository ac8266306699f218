// The table of what differs between the two sides of a comparison.
/** @import { Comparison } from './comparisons.js' */
/** @import { Figures } from '../figures/statistics.js' */
import { h, setText, withSubscripts } from '../panels/dom.js';
import { difference, lines } from './comparisons.js';

export function createDifferences() {
  const heads = ['A', 'B'].map(() => h('th', { scope: 'col' }));
  const rows = lines.map((line) => {
    const cells = [0, 1].map(() => h('td', null));
    const by = h('td', { className: 'by' });
    return { line, cells, by, row: h('tr', null, h('th', { scope: 'row' }, line.name), ...cells, by) };
  });
  const element = h('table', { className: 'differences numbers', hidden: true },
    h('caption', { className: 'only-heard' }, 'Differences'),
    h('thead', null, h('tr', null, h('td', null), ...heads, h('th', { scope: 'col' }, 'B − A'))),
    h('tbody', null, ...rows.map(({ row }) => row)));

  /** @param {Comparison | undefined} comparison  @param {Figures[]} figures */
  function show(comparison, figures) {
    element.hidden = comparison === undefined || figures.length < 2;
    if (comparison === undefined || figures.length < 2) return;
    heads.forEach((head, i) => head.replaceChildren(...withSubscripts(`${'AB'[i]}: ${comparison.sides[i].name}`)));
    for (const { line, cells, by } of rows) {
      cells.forEach((cell, i) => {
        const value = line.of(figures[i]);
        setText(cell, value === undefined ? '–' : line.write(value));
      });
      const { text, good } = difference(line, figures[0], figures[1]);
      setText(by, text);
      by.dataset.good = String(good);
      by.title = ['worse', '', 'better'][good + 1];
    }
  }
  return { element, show };
}
