// A surface and its options as a program and as a command: the same mesh, bit for bit, from the file.
/** @import { OptionInfo } from 'lpquad' */
/** @import { Work } from '../types' */
import { chosen } from '../../files/code/literals.js';
import { isCadName } from './work.js';

/** @param {Work} work */
export const fileNameOf = ({ name }) => name.toLowerCase().replace(/\.[a-z0-9]+$/, '').replace(/[^a-z0-9]+/g, '-').replace(/^-|-$/g, '') || 'surface';

/** The download of the surface, beside the quads in .obj. @param {Work} work */
export const surfaceFileOf = (work) => `${fileNameOf(work)}-surface.obj`;

/** What the surface is called as a file: its own name, or that of the download. @param {Work} work */
export const sourceOf = (work) => (work.preset === undefined ? work.name : surfaceFileOf(work));

/** @param {Work} work  @param {OptionInfo[]} known */
export function toJavaScript(work, known) {
  const source = JSON.stringify(sourceOf(work));
  const options = chosenOf(work, known).map(([name, value]) => `${name}: ${JSON.stringify(value)}`);
  const isCad = isCadName(work.name);
  return `// npm install lpquad${isCad ? ' occt-import-js' : ''}${work.preset === undefined ? '' : '; the file is that of “Surface as OBJ”'}
import { readFileSync, writeFileSync } from 'node:fs';
import { createLpquad } from 'lpquad';
${isCad ? "import { readCad } from 'lpquad/cad';\n" : ''}
const lpquad = await createLpquad();
const surface = await ${isCad ? 'readCad' : 'lpquad.readSurface'}(readFileSync(${source}), { name: ${source} });
const mesh = await lpquad.meshSurface(surface, { ${options.join(', ')} });
console.log(mesh.report.hash);
writeFileSync('${fileNameOf(work)}-quads.msh', lpquad.writeMesh(mesh, 'msh'));
`;
}

/** @param {Work} work  @param {OptionInfo[]} known */
export function toCommand(work, known) {
  const flags = chosenOf(work, known).map(([name, value]) => {
    const flag = name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`);
    return typeof value === 'boolean' ? `--${value ? '' : 'no-'}${flag}` : `--${flag} ${value}`;
  });
  const quoted = `'${sourceOf(work).replaceAll("'", "'\\''")}'`;
  // Two commands: the first one's triangles do not depend on the size of the quads, as on the page.
  const triangles = surfaceFileOf(work);
  const [before, input] = isCadName(work.name) ? [`npx lpquad convert ${quoted} -o ${triangles}\n`, triangles] : ['', quoted];
  return before + ['lpquad mesh', input, '-o', `${fileNameOf(work)}-quads.msh`, ...flags].join(' ') + '\n';
}

/** @param {Work} work  @param {OptionInfo[]} known */
const chosenOf = (work, known) => chosen(/** @type {any} */ (work), known);
