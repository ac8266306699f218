// The entry for browsers and bundlers: the .wasm lies beside this file.
import { compileUrl, createOnce } from './load.js';

export { LpquadError } from './errors.js';

// Written out in full: this is the form that bundlers look for.
const urls = {
  simd: () => new URL('./lpquad.wasm', import.meta.url),
  plain: () => new URL('./lpquad-plain.wasm', import.meta.url),
};

export function createLpquad(source = {}) {
  return createOnce(source, (build) => compileUrl(urls[build]()));
}
