// The entry for browsers and bundlers: the .wasm files lie beside this one.
import { compileUrl, createOnce } from './load.js';

export { LpquadError } from './errors.js';

// Written out in full: this is the form that bundlers look for.
const urls = {
  lpquad: () => new URL('./lpquad.wasm', import.meta.url),
  'lpquad-plain': () => new URL('./lpquad-plain.wasm', import.meta.url),
  'lpquad-readers': () => new URL('./lpquad-readers.wasm', import.meta.url),
};

export function createLpquad(source = {}) {
  return createOnce(source, {
    own: (name) => compileUrl(urls[name]()),
    readersGlue: () => import('./readers-glue.js'),
  });
}
