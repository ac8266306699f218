// `lpquad/worker` for browsers and bundlers.
import { checkFunction, checkWasmSource, checkWorker } from './checks.js';
import { LpquadWorker } from './client.js';

export { LpquadError } from './errors.js';

// Written out in full: this is the form that bundlers look for.
const ownWorker = () =>
  new Worker(new URL('./worker-entry.js', import.meta.url), { type: 'module', name: 'lpquad' });

/** Addresses are the page's; the worker has another base. */
function absolute(source) {
  const base = globalThis.document?.baseURI ?? globalThis.location?.href;
  const urls = ['wasmUrl', 'readersUrl', 'surfaceUrl'].filter((name) => source[name] !== undefined);
  return { ...source,
    ...Object.fromEntries(urls.map((name) => [name, new URL(source[name], base).href])) };
}

export function createLpquadWorker(options = {}) {
  checkWasmSource(options, 'createLpquadWorker', ['worker']);
  const { worker = ownWorker, ...source } = options;
  checkFunction(worker, 'worker');
  return new LpquadWorker(({ message, lost }) => {
    const thread = checkWorker(worker());
    thread.onmessage = (event) => message(event.data);
    thread.onerror = (event) => lost(`The worker failed: ${event.message ?? 'it did not load'}.`);
    thread.onmessageerror = () => lost('The worker sent something unreadable.');
    return {
      post: (data) => thread.postMessage(data),
      terminate: () => thread.terminate(),
    };
  }, absolute(source));
}
