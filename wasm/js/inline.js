// `lpquad/inline`: the WebAssembly inside the JavaScript, for places where no second file can be
// loaded. Larger, and without SIMD.
import base64 from './inline-wasm.js';
import { createOnce } from './load.js';

export { LpquadError } from './errors.js';

async function compileInline() {
  return WebAssembly.compile(Uint8Array.from(atob(base64), (c) => c.charCodeAt(0)));
}

export function createLpquad(source = {}) {
  return createOnce(source, compileInline);
}
