// Drawings and options as they stand in source code: numbers exact, lines short, nothing said that
// is so anyway.
/** @import { OptionInfo } from 'lpquad' */
/** @import { Drawing, Project, Region } from '../../types' */

const width = 96;

/** Items with commas between, broken into lines. @param {string[]} items  @param {string} indent */
export function wrapped(items, indent) {
  const lines = [];
  let line = '';
  for (const item of items) {
    if (line !== '' && indent.length + line.length + item.length + 2 > width) {
      lines.push(line);
      line = '';
    }
    line += (line === '' ? '' : ' ') + item + ',';
  }
  return [...lines, line.replace(/,$/, '')].map((text) => indent + text).join('\n');
}

/** `open`, the items in one line or in indented lines of their own, `close`. @param {string} open @param {string[]} items @param {string} close @param {string} [indent] */
export function nested(open, items, close, indent = '') {
  const line = open + items.join(', ') + close;
  if (indent.length + line.length <= width && !line.includes('\n')) return line;
  return `${open}\n${wrapped(items, `${indent}  `)}\n${indent}${close}`;
}

/** Only what differs from the defaults. @param {Project} project  @param {OptionInfo[]} known @returns {[string, any][]} */
export function chosen({ options }, known) {
  const defaults = new Map(known.map((option) => [option.name, option.default]));
  return Object.entries(options).filter(([name, value]) => value !== undefined && value !== defaults.get(name));
}

/** @param {Region} region */
export const hasTags = ({ tags }) => tags?.some((row) => row.some(Boolean)) ?? false;

/** One region without a name, and nothing inside. @param {Drawing} drawing */
export const isPlain = ({ regions, polylines, points }) =>
  regions.length === 1 && regions[0].name === '' && polylines.length === 0 && points.length === 0;
