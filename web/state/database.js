// What is too large for the browser's storage of texts goes to its database.

/** One store, in a database of its own: two pages may have it open. @param {string} database  @param {string} name  @returns {Promise<IDBObjectStore>} */
export function openStore(database, name) {
  return new Promise((resolve, reject) => {
    const opening = indexedDB.open(database, 1);
    opening.onupgradeneeded = () => opening.result.createObjectStore(name);
    opening.onsuccess = () => resolve(opening.result.transaction(name, 'readwrite').objectStore(name));
    opening.onerror = () => reject(opening.error);
  });
}

/** @template T  @param {IDBRequest<T>} request  @returns {Promise<T>} */
export const answer = (request) => new Promise((resolve, reject) => {
  request.onsuccess = () => resolve(request.result);
  request.onerror = () => reject(request.error);
});
