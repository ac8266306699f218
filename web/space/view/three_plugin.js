// For the build: of three.js only what is used. Its own build is one piece in which that cannot be told, its
// sources can; but their shaders have comments, which are taken out. Its licence goes with it.
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const folder = new URL('../../../node_modules/three/', import.meta.url);

/** @param {string} shader */
const withoutComments = (shader) => shader.replace(/\/\*[^]*?\*\/|\/\/.*/g, '').replace(/\s*\n\s*/g, '\n');

/** @returns {import('vite').Plugin} */
export function onlyWhatIsUsedOfThree() {
  return {
    name: 'lpquad-three',
    apply: 'build',
    enforce: 'pre',
    resolveId: (source) => (source === 'three' ? fileURLToPath(new URL('src/Three.js', folder)) : null),
    transform: (code, id) => (id.endsWith('.glsl.js') ? { code: withoutComments(code), map: null } : null),
    generateBundle() {
      this.emitFile({ type: 'asset', fileName: 'assets/three.LICENSE.txt', source: readFileSync(new URL('LICENSE', folder)) });
    },
  };
}
