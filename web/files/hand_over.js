// A file that belongs on the other page is taken there: plane or space.
import { answer, openStore } from '../state/database.js';

const handed = () => openStore('lpquad', 'handed');

/** Goes to the other page with the file. @param {File} file  @param {string} page  @param {AbortSignal} signal */
export async function handOver(file, page, signal) {
  try {
    await answer((await handed()).put(file, 'file'));
  } catch (cause) {
    throw new Error('It belongs on the other page, Plane or Space, and this browser does not let it be handed over. Open it there.', { cause });
  }
  signal.throwIfAborted();
  location.assign(`${page}#file`);
}

/** The file that was handed to this page, once. @returns {Promise<File | undefined>} */
export async function handedFile() {
  if (location.hash !== '#file') return undefined;
  history.replaceState(null, '', location.pathname + location.search);
  try {
    const store = await handed();
    const file = await answer(/** @type {IDBRequest<File | undefined>} */ (store.get('file')));
    await answer((await handed()).delete('file'));
    return file;
  } catch {
    return undefined;  // the browser keeps nothing for this page
  }
}
