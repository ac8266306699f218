// Reading a file: what takes long enough to be noticed is said, and can be given up.
/** @import { LpquadWorker } from 'lpquad/worker' */
/** @import { App } from '../app' */
import { createEngine } from '../run/engine.js';

const noticed = 300;  // milliseconds

/**
 * Does what reads a file, in place of what reads another; null: it was given up. `progress` says how far it is.
 * @typedef {<T>(name: string, read: (signal: AbortSignal, progress: (words: string) => void) => Promise<T>) => Promise<T | null>} Reading
 */

/** @param {Pick<App, 'actions' | 'announce' | 'notify'>} page  @returns {Reading} */
export function createReading({ actions, announce, notify }) {
  /** @type {AbortController | null} */
  let now = null;
  const stop = () => {
    now?.abort();
    announce('Reading cancelled');
  };
  actions.add({ id: 'file.cancel', label: 'Cancel reading', keys: ['Escape'], enabled: () => now !== null, run: stop });

  return async (name, read) => {
    now?.abort();  // of two files that are opened the second is wanted
    const mine = now = new AbortController(), { signal } = mine;
    let away = () => {};
    const progress = (/** @type {string} */ words) => { if (!signal.aborted) away = notify(words, stop); };
    const late = setTimeout(progress, noticed, `Reading ${name} …`);
    /** @type {Promise<null>} */
    const given = new Promise((resolve) => signal.addEventListener('abort', () => resolve(null)));
    try {
      return await Promise.race([given, read(signal, progress)]);
    } catch (error) {
      if (signal.aborted) return null;
      throw error;
    } finally {
      clearTimeout(late);
      if (now === mine) now = null;
      away();
    }
  };
}

/** In a worker of its own, so that nothing that a file contains can hold up the page or a run; it ends with the signal.
 * @template T  @param {AbortSignal} signal  @param {(engine: LpquadWorker) => Promise<T>} read */
export async function besideThePage(signal, read) {
  const engine = await createEngine();
  const end = () => engine.terminate();
  signal.addEventListener('abort', end);
  try {
    signal.throwIfAborted();
    return await read(engine);
  } finally {
    end();
  }
}
