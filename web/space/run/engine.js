// The mesher with surfaces, in a worker; the code for surfaces is fetched at the first one.
import { createLpquadWorker } from 'lpquad/worker';
import simdUrl from 'lpquad/lpquad.wasm?url';
import surfaceUrl from 'lpquad/lpquad-surface.wasm?url';
import { compile } from '../../run/engine.js';

export async function createEngine() {
  return createLpquadWorker({ wasmModule: await compile(), wasmUrl: simdUrl, surfaceUrl });
}
