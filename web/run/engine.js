// The mesher, always in a worker. Cancelling ends the worker: nothing answers faster. The next call
// starts a new one, with the code already compiled.
import { createLpquadWorker } from 'lpquad/worker';
import simdUrl from 'lpquad/lpquad.wasm?url';
import plainUrl from 'lpquad/lpquad-plain.wasm?url';

/** @type {Promise<WebAssembly.Module> | undefined} */
let compiled;

/** @param {string} url */
async function compileFrom(url) {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`the server answered ${response.status}`);
  // Not compileStreaming: it insists on a MIME type that many servers do not send.
  return WebAssembly.compile(await response.arrayBuffer());
}

/** Compiled once; a failure is not remembered, so that trying again may help. */
function compile() {
  compiled ??= compileFrom(simdUrl).catch(() => compileFrom(plainUrl));  // without SIMD
  compiled.catch(() => { compiled = undefined; });
  return compiled;
}

/** A worker of its own for every use that may be cancelled by itself. */
export async function createEngine() {
  return createLpquadWorker({ wasmModule: await compile() });
}
