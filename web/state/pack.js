// Text made short for an address: deflate, then letters, digits, - and _. What comes out of a
// stranger's link is bounded while it is unpacked: a few bytes can stand for gigabytes.

const mostBytes = 1 << 26;

/** @param {ReadableStream<Uint8Array<ArrayBuffer>>} stream  @param {number} [limit] */
async function collect(stream, limit = Infinity) {
  const chunks = [];
  let bytes = 0;
  for (const reader = stream.getReader();;) {
    const { done, value } = await reader.read();
    if (done) return new Uint8Array(await new Blob(chunks).arrayBuffer());
    if ((bytes += value.length) > limit) {
      await reader.cancel();
      throw new RangeError('too long');
    }
    chunks.push(value);
  }
}

/** @param {string} text */
export async function pack(text) {
  const packed = await collect(new Blob([text]).stream().pipeThrough(new CompressionStream('deflate-raw')));
  let binary = '';
  for (const byte of packed) binary += String.fromCharCode(byte);
  return btoa(binary).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
}

/** Throws if it is damaged. @param {string} packed */
export async function unpack(packed) {
  const binary = atob(packed.replaceAll('-', '+').replaceAll('_', '/'));
  const bytes = Uint8Array.from(binary, (letter) => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate-raw'));
  return new TextDecoder('utf-8', { fatal: true }).decode(await collect(stream, mostBytes));
}
