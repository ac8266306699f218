// What a project is when nothing was chosen yet, and the parts of it that decide a mesh.
/** @import { Drawing, Project } from '../types' */

/** @type {Drawing} */
export const emptyDrawing = { regions: [], polylines: [], points: [] };

/** @type {Project} */
export const emptyProject = {
  preset: '', name: '', drawing: emptyDrawing, options: {}, sizes: [], guides: [], seedPoints: [],
  layers: 'auto', comparison: '',
};

/** @type {(keyof Project)[]} */
const deciding = ['drawing', 'options', 'sizes', 'guides', 'seedPoints'];

/** Whether two projects have the same mesh. @param {Project} a @param {Project} b */
export const haveSameMesh = (a, b) => deciding.every((key) => a[key] === b[key]);

/** The two arguments of the library's calls. @param {Project} project */
export function toCall({ drawing, options, sizes, guides, seedPoints }) {
  return {
    domain: drawing,
    options: {
      ...options,
      ...(sizes.length > 0 && { sizes }),
      ...(guides.length > 0 && { guides }),
      ...(seedPoints.length > 0 && { seedPoints }),
    },
  };
}
