// What was dropped, folders opened: a folder itself is no file that can be read.

/** @param {DataTransfer | null} transfer  @returns {Promise<File[]>} */
async function droppedFiles(transfer) {
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

/** Shows that files may be dropped, and takes them. @param {HTMLElement} mark  @param {(files: File[]) => Promise<void>} open
 * @param {(thrown: unknown) => void} fail  where they cannot be read */
export function listenForDrops(mark, open, fail) {
  const hasFiles = (/** @type {DragEvent} */ { dataTransfer }) => dataTransfer?.types.includes('Files') ?? false;
  window.addEventListener('dragover', (event) => {
    event.preventDefault();  // whatever it is: the page is not left
    mark.classList.toggle('dropping', hasFiles(event));
  });
  for (const name of /** @type {const} */ (['dragleave', 'dragend', 'drop'])) window.addEventListener(name, () => mark.classList.remove('dropping'));
  window.addEventListener('drop', (event) => {
    event.preventDefault();
    if (hasFiles(event)) void droppedFiles(event.dataTransfer).then(open, fail);
  });
}
