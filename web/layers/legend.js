// The legend of a layer as elements.
/** @import { LegendItem } from '../draw/legend.js' */
import { cornersOf } from '../draw/marks.js';
import { gradientOf } from '../draw/palette.js';
import { h, s } from '../panels/dom.js';

/** Puts the items there, unless they are there already. @param {HTMLElement} legend  @param {LegendItem[]} items */
export function showLegend(legend, items) {
  const text = JSON.stringify(items);
  if (legend.dataset.of === text) return;
  legend.dataset.of = text;
  legend.replaceChildren(...items.map(legendElement));
}

/** @param {LegendItem} item */
export function legendElement(item) {
  if (item.kind === 'ramp')
    return h('div', { className: 'legend-ramp' },
      h('div', { className: 'ramp', style: `background-image: ${gradientOf(item.ramp)}`, 'aria-hidden': 'true' }),
      h('div', { className: 'ramp-ends' },
        h('span', null, item.low), h('span', { className: 'quiet' }, item.of), h('span', null, item.high)));
  return h('div', { className: 'legend-item' }, swatch(item), h('span', null, item.text));
}

/** @param {Exclude<LegendItem, {kind: 'ramp'}>} item */
function swatch(item) {
  if (item.kind === 'text') return null;
  return s('svg', { viewBox: '-10 -10 20 20', class: 'swatch', 'aria-hidden': 'true' }, s('path', attributesOf(item)));
}

/** @param {Exclude<LegendItem, {kind: 'ramp' | 'text'}>} item  @returns {Record<string, string | number>} */
function attributesOf(item) {
  if (item.kind === 'line') return { d: 'M-9 0H9', stroke: item.colour, 'stroke-width': item.width, fill: 'none' };
  if (item.kind === 'area') return { d: 'M-8 -7H8V7H-8z', fill: item.colour };
  const d = `M${cornersOf(item.shape).map(([x, y]) => `${6.5 * x} ${6.5 * y}`).join('L')}z`;
  return item.hollow ? { d, fill: 'none', stroke: item.colour, 'stroke-width': 2.5 } : { d, fill: item.colour };
}
