// The entry for Node, which reads the .wasm files from disk.
import { readFile } from 'node:fs/promises';

import { LpquadError } from './errors.js';
import { compileBytes, compileUrl, createOnce } from './load.js';

export { LpquadError } from './errors.js';

const own = (name) => compileFile(new URL(`./${name}.wasm`, import.meta.url));

async function compileFile(file) {
  let bytes;
  try {
    bytes = await readFile(file);
  } catch (cause) {
    throw new LpquadError('BAD_WASM', `${file} could not be read (${cause.message}).`, {}, { cause });
  }
  return compileBytes(bytes, file);
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
