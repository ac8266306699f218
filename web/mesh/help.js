// What the library's own table says about an option, as this page has it: the table is written for code and the command
// line, where an option has another name, a number stands for “automatic”, and nothing is a field.
/** @import { OptionInfo } from 'lpquad' */
import { nameOfOption } from './options.js';

/** Where the table's words are not about this page. @type {[RegExp, string][]} */
export const phrases = [
  [/^Target edge length/, 'Wanted length of their sides'],
  [/the domain's own h \((.*?) where it has none\)/, '$1'],  // an h that a file brings is in the field
  [/Rounds after these/, 'Rounds after the iterations'],
  [/^Refuse before allocating when (.*) are expected/, 'Nothing is meshed where $1 are expected'],
];

/** Whether the usual number stands for what the mesher thinks best. @param {OptionInfo} info */
export const isAutomatic = ({ name, default: usual }) => usual === -1 || (usual === 0 && ['size', 'quads', 'growth'].includes(name));

/** @param {OptionInfo} info */
export function helpInWords(info) {
  const { choices = [], default: usual } = info;
  let text = phrases.reduce((help, [theirs, ours]) => help.replace(theirs, ours), info.help);
  if (isAutomatic(info))
    text = text.replace(`; ${usual} = not asked`, '').replace(new RegExp(`(?<=; )${usual} (?:is|gives|takes) `), 'automatic: ').replace(`; ${usual} `, '; automatic ');
  for (const choice of choices) text = text.replaceAll(String(choice), wordsOf(choice));
  return text.replace(/\b[a-z]+(?:[A-Z][a-z]+)+\b/g, (name) => `“${nameOfOption(name)}”`);
}

/** A choice as its button has it. @param {unknown} choice */
export const wordsOf = (choice) => String(choice).replaceAll('-', ' ');
