// The entry for Node, which reads the .wasm files from disk.
import { readFile } from 'node:fs/promises';

import { LpquadError } from './errors.js';
import { compileBytes, compileUrl, createOnce } from './load.js';
import { urls } from './urls.js';

export { LpquadError } from './errors.js';

// Such bundlers turn the place of the file into an address of the site.
const outside = ' In a bundle for a server, leave lpquad out of it: for Next.js, ' +
  "serverExternalPackages: ['lpquad'].";

async function compileFile(file, hint = '') {
  let bytes;
  try {
    bytes = await readFile(file);
  } catch (cause) {
    throw new LpquadError('BAD_WASM', `${file} could not be read (${cause.message}).${hint}`, {}, { cause });
  }
  return compileBytes(bytes, file);
}

/** Addresses of files and paths are read from disk, others are fetched. */
function compileAny(wasmUrl) {
  const text = String(wasmUrl);
  if (/^(https?|data|blob):/.test(text)) return compileUrl(text);
  return compileFile(text.startsWith('file:') ? new URL(text) : text);
}

const files = {
  own: (name) => compileFile(urls[name](), outside),
  from: compileAny,
  readersGlue: () => import('./readers-glue.js'),
  surfaceGlue: () => import('./surface-glue.js'),
};

export const createLpquad = async (source = {}) => createOnce(source, files);
