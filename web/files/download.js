// Text or bytes as a file of the reader's.
import { h } from '../panels/dom.js';

/** @param {string} name  @param {BlobPart} content  @param {string} [type] */
export function download(name, content, type = 'text/plain') {
  const address = URL.createObjectURL(new Blob([content], { type }));
  h('a', { href: address, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(address), 60_000);
}

/** Whether the text is in the clipboard now; browsers may refuse. @param {string} text */
export async function copy(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    return false;
  }
}
