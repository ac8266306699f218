// What a project is called: on the screen, and as a file.
/** @import { Project } from '../types' */
import { presets } from '../sketch/presets.js';

/** @param {Project} project */
export const titleOf = ({ preset, name }) =>
  name || (presets.find(({ id }) => id === preset)?.title ?? 'Drawing');

/** Without ending; letters and digits only. @param {Project} project */
export const fileNameOf = ({ preset, name }) =>
  (preset || name).normalize('NFKD').replace(/\.[^.]*$/, '').replace(/[^\w-]+/g, '_').replace(/^_+|_+$/g, '').slice(0, 60) || 'drawing';
