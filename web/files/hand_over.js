// A file that belongs on the other page is taken there: plane or space.

/** @returns {Promise<IDBObjectStore>} */
function openStore() {
  return new Promise((resolve, reject) => {
    const opening = indexedDB.open('lpquad', 1);
    opening.onupgradeneeded = () => opening.result.createObjectStore('handed');
    opening.onsuccess = () => resolve(opening.result.transaction('handed', 'readwrite').objectStore('handed'));
    opening.onerror = () => reject(opening.error);
  });
}

/** @template T  @param {IDBRequest<T>} request  @returns {Promise<T>} */
const answer = (request) => new Promise((resolve, reject) => {
  request.onsuccess = () => resolve(request.result);
  request.onerror = () => reject(request.error);
});

/** Goes to the other page with the file. @param {File} file  @param {string} page */
export async function handOver(file, page) {
  try {
    await answer((await openStore()).put(file, 'file'));
  } catch (cause) {
    throw new Error('It belongs on the other page, Plane or Space, and this browser does not let it be handed over. Open it there.', { cause });
  }
  location.assign(`${page}#file`);
}

/** The file that was handed to this page, once. @returns {Promise<File | undefined>} */
export async function handedFile() {
  if (location.hash !== '#file') return undefined;
  history.replaceState(null, '', location.pathname + location.search);
  try {
    const store = await openStore();
    const file = await answer(/** @type {IDBRequest<File | undefined>} */ (store.get('file')));
    await answer((await openStore()).delete('file'));
    return file;
  } catch {
    return undefined;  // the browser keeps nothing for this page
  }
}
