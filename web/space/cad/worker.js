// Reads one CAD file, in a worker of its own: occt-import-js as it was published, lpquad/cad around it.
import { readCad } from 'lpquad/cad';

const silent = () => {}, told = 2 ** 20;  // bytes between two words of progress

/** @param {string} url  @param {(bytes: number) => void} progress */
async function load(url, progress) {
  const response = await fetch(url);
  if (!response.ok || response.body === null) throw new Error(`the server answered ${response.status}`);
  const parts = [], reader = response.body.getReader();
  let bytes = 0, next = told;
  for (let part = await reader.read(); !part.done; part = await reader.read()) {
    parts.push(part.value);
    bytes += part.value.length;
    if (bytes >= next) progress(bytes);
    if (bytes >= next) next += told;
  }
  return new Uint8Array(await new Blob(parts).arrayBuffer());
}

/** The package's function. Its script is no module, but hands the function to an AMD loader where it
 * finds one. @param {string} url */
async function factoryFrom(url) {
  /** @type {any} */
  let factory;
  const define = (/** @type {unknown} */ _names, /** @type {() => unknown} */ make) => { factory = make(); };
  Object.assign(globalThis, { define: Object.assign(define, { amd: true }) });
  await import(/* @vite-ignore */ url);
  return factory;
}

/** An instance of the package. @param {{script: string, wasm: string}} urls */
async function instance({ script, wasm }) {
  try {
    const wasmBinary = await load(wasm, (loaded) => postMessage({ loaded }));
    return await (await factoryFrom(script))({ wasmBinary, print: silent, printErr: silent });
  } catch (error) {
    throw new Error(`the reader of CAD files could not be loaded (${/** @type {Error} */ (error).message}). `
      + 'It comes with the first such file, and needs the network then.');
  }
}

addEventListener('message', async ({ data: { bytes, name, urls } }) => {
  try {
    const occt = await instance(urls);
    postMessage({ reading: true });
    const surface = await readCad(bytes, { name, occt });
    postMessage({ surface }, { transfer: [surface.points.buffer, surface.triangles.buffer, surface.groups.buffer, surface.bodies.buffer] });
  } catch (error) {
    postMessage({ error: /** @type {Error} */ (error).message });
  }
});
