// A project as the text of a file (.lpquad.json). It is JSON, and numbers come back bit for bit: the
// shortest digits do that, except for -0, which JSON.stringify would lose (and many readers with it,
// unless it has a point).
/** @import { Project } from '../types' */
import { NotAProject, project as judged } from './judge.js';

export const projectEnding = '.lpquad.json';
const version = 1;

/** @param {unknown} value  @returns {string} */
export function exactJson(value) {
  if (typeof value === 'number') return Object.is(value, -0) ? '-0.0' : JSON.stringify(value);
  if (Array.isArray(value)) return `[${value.map(exactJson).join(',')}]`;
  if (typeof value !== 'object' || value === null) return JSON.stringify(value);
  const members = Object.entries(value).filter(([, member]) => member !== undefined);
  return `{${members.map(([name, member]) => `${JSON.stringify(name)}:${exactJson(member)}`).join(',')}}`;
}

/** @param {Project} project */
export const projectText = (project) => `${exactJson({ lpquadProject: version, ...project })}\n`;

/** Whether a file's text claims to be a project. @param {string} text */
export const isProjectText = (text) => /^\s*\{\s*"lpquadProject"\s*:/.test(text);

/** @param {string} text  @returns {Project}  throws NotAProject, with the reason in words */
export function readProject(text) {
  let value;
  try {
    value = JSON.parse(text);
  } catch {
    throw new NotAProject('the file is cut off or damaged');
  }
  if (value?.lpquadProject !== version) throw new NotAProject('it was made by another version of this page');
  return judged(value);
}
