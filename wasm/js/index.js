// The entry for browsers and bundlers: the .wasm files lie beside this one.
import { compileUrl, createOnce } from './load.js';
import { urls } from './urls.js';

export { LpquadError } from './errors.js';

export function createLpquad(source = {}) {
  return createOnce(source, {
    own: (name) => compileUrl(urls[name]()),
    readersGlue: () => import('./readers-glue.js'),
  });
}
