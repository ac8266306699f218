// The entry for Node, which reads the .wasm from disk.
import { readFile } from 'node:fs/promises';

import { checkMagic, compileUrl, createOnce } from './load.js';

export { LpquadError } from './errors.js';

const files = {
  simd: new URL('./lpquad.wasm', import.meta.url),
  plain: new URL('./lpquad-plain.wasm', import.meta.url),
};

async function compileFile(url) {
  return WebAssembly.compile(checkMagic(await readFile(url), url.href));
}

/** Addresses of files and paths are read from disk, others are fetched. */
function compileAny(wasmUrl) {
  const text = String(wasmUrl);
  if (/^(https?|data|blob):/.test(text)) return compileUrl(text);
  return compileFile(text.startsWith('file:') ? new URL(text) : text);
}

export function createLpquad(source = {}) {
  return createOnce(source, (build) => compileFile(files[build]), compileAny);
}
