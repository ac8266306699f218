// `lpquad/inline`: the WebAssembly inside the JavaScript, for places where no second file can be
// loaded. Larger, and without SIMD.
import { compileBase64 } from './base64.js';
import { LpquadError } from './errors.js';
import wasm from './inline-wasm.js';
import { createOnce } from './load.js';
import createReaders from './readers-glue.js';

export { LpquadError } from './errors.js';

const files = {
  plain: true,
  own: (name) => compileBase64(wasm[name]),
  readersGlue: async () => ({ default: createReaders }),
  surfaceGlue: async () => {
    throw new LpquadError('BAD_WASM', 'lpquad/inline cannot mesh surfaces: import lpquad/inline-surface.');
  },
};

export const createLpquad = async (source = {}) => createOnce(source, files);
