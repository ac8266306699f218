// What was dropped, folders opened: a folder itself is no file that can be read.

/** @param {DataTransfer | null} transfer  @returns {Promise<File[]>} */
export async function droppedFiles(transfer) {
  if (transfer === null) return [];
  const entries = [...transfer.items].map((item) => item.webkitGetAsEntry());  // at once: the event ends
  if (!entries.some((entry) => entry?.isDirectory)) return [...transfer.files];
  return (await Promise.all(entries.map((entry) => filesOf(entry)))).flat();
}

/** @param {FileSystemEntry | null} entry  @returns {Promise<File[]>} */
async function filesOf(entry) {
  if (entry === null) return [];
  if (entry.isFile) return [await new Promise((done, fail) => /** @type {FileSystemFileEntry} */ (entry).file(done, fail))];
  const reader = /** @type {FileSystemDirectoryEntry} */ (entry).createReader();
  /** @type {File[]} */
  const files = [];
  for (;;) {  // a hundred at a time
    const some = /** @type {FileSystemEntry[]} */ (await new Promise((done, fail) => reader.readEntries(done, fail)));
    if (some.length === 0) return files;
    files.push(...(await Promise.all(some.filter((one) => one.isFile).map(filesOf))).flat());
  }
}
