// The entry for browsers and bundlers: the .wasm files lie beside this one.
import { compileUrl, createOnce } from './load.js';
import { urls } from './urls.js';

export { LpquadError } from './errors.js';

const files = {
  own: (name) => compileUrl(urls[name]()),
  readersGlue: () => import('./readers-glue.js'),
  surfaceGlue: () => import('./surface-glue.js'),
};

export const createLpquad = async (source = {}) => createOnce(source, files);
