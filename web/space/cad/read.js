// STEP, IGES and BREP files, read beside the page so that it stays alive.
/** @import { CadSurface } from 'lpquad/cad' */
import { urls } from './files.js';

const absolute = (/** @type {string} */ url) => new URL(url, document.baseURI).href;

/**
 * @param {File} file
 * @param {{progress: (words: string) => void, signal: AbortSignal}} how
 * @returns {Promise<CadSurface>}
 */
export async function readCadFile(file, { progress, signal }) {
  const bytes = new Uint8Array(await file.arrayBuffer());
  const worker = new Worker(new URL('./worker.js', import.meta.url), { type: 'module' });
  try {
    return await new Promise((resolve, reject) => {
      signal.addEventListener('abort', () => reject(signal.reason));
      signal.throwIfAborted();
      worker.onerror = () => reject(new Error('the reader of CAD files broke off.'));
      worker.onmessage = ({ data: { loaded, reading, surface, error } }) => {
        if (loaded) progress(`Loading the reader of CAD files: ${Math.round(loaded / 2 ** 20)} MB`);
        if (reading) progress(`Reading ${file.name}`);
        if (surface) resolve(surface);
        if (error) reject(new Error(error));
      };
      progress('Loading the reader of CAD files');
      worker.postMessage({ bytes, name: file.name, urls: { script: absolute(urls.script), wasm: absolute(urls.wasm) } }, [bytes.buffer]);
    });
  } finally {
    worker.terminate();
  }
}

/** Asks the service worker to have the reader when there is no network. */
export async function keepCadReader() {
  if (!import.meta.env.PROD || !('serviceWorker' in navigator)) return;
  const { active } = await navigator.serviceWorker.ready;
  active?.postMessage({ keep: Object.values(urls).map(absolute) });
}
