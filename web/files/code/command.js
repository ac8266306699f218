// The project as a command: the domain's file, and what is done with it.
/** @import { OptionInfo } from 'lpquad' */
/** @import { Project } from '../../types' */
import { domainJson } from './javascript.js';
import { chosen } from './literals.js';

/** 'keepBoundary' is --keep-boundary. @param {[string, any]} option */
function flag([name, value]) {
  const text = `--${name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`)}`;
  return typeof value === 'boolean' ? text : `${text} ${value}`;
}

/** @param {Project} project  @param {OptionInfo[]} known  @param {string} file  name without ending */
export function toCommand(project, known, file) {
  const command = ['lpquad', 'mesh', `${file}.json`, '-o', `${file}.msh`, '--report', `${file}.report.json`, ...chosen(project, known).map(flag)];
  return `# npm install --global lpquad, or the native program\ncat > ${file}.json <<'END'\n${domainJson(project)}\nEND\n${command.join(' ')}\n`;
}
