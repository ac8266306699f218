// `lpquad/inline`: the WebAssembly inside the JavaScript, for places where no second file can be
// loaded. Larger, and without SIMD.
import files from './inline-wasm.js';
import { createOnce } from './load.js';
import createReaders from './readers-glue.js';

export { LpquadError } from './errors.js';

async function compileInline(name) {
  const base64 = files[name === 'lpquad' ? 'lpquad-plain' : name];
  return WebAssembly.compile(Uint8Array.from(atob(base64), (c) => c.charCodeAt(0)));
}

export function createLpquad(source = {}) {
  return createOnce(source, {
    own: compileInline,
    readersGlue: async () => ({ default: createReaders }),
  });
}
