// The entry for Node, which reads the .wasm files from disk.
import { readFile } from 'node:fs/promises';

import { checkMagic, compileUrl, createOnce } from './load.js';

export { LpquadError } from './errors.js';

const own = (name) => compileFile(new URL(`./${name}.wasm`, import.meta.url));

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
  return createOnce(source, {
    own,
    from: compileAny,
    readersGlue: () => import('./readers-glue.js'),
  });
}
