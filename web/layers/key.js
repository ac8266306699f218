// On the stage, below what is drawn: what its colours and marks mean. The legends in short, without their numbers.
/** @import { LegendItem } from '../draw/legend.js' */
import { h } from '../panels/dom.js';
import { showLegend } from './legend.js';

/** @param {HTMLElement} canvas  the last: cards and notices lie above the key
 * @returns {(layers: {title: string, items: LegendItem[]}[]) => void} shows the key of the layers that are on */
export function createKey(canvas) {
  const key = h('div', { className: 'key', role: 'note', 'aria-label': 'Key' });
  canvas.after(key);
  return (layers) => showLegend(key, layers.flatMap(({ title, items }) => items.flatMap((item) => inShort(item, title))));
}

/** None of what tells only how many there are. @param {LegendItem} item  @param {string} title  @returns {LegendItem[]} */
function inShort(item, title) {
  if (item.kind === 'ramp') return [{ ...item, of: item.key ?? title }];
  return item.key === undefined ? [] : [{ ...item, text: item.key }];
}
