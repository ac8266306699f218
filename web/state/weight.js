// How much memory a plain value takes beside another one that it grew out of. What the two share by identity is free:
// a change makes new only what it touches.

const head = 16, slot = 8;  // bytes of an object and of each of its members, about

/** Bytes that `value` takes and `other` does not. @param {unknown} value  @param {unknown} [other]  @returns {number} */
export function weightBeside(value, other) {
  if (value === other) return 0;
  if (typeof value === 'string') return 2 * value.length;
  if (typeof value !== 'object' || value === null) return 0;  // its slot is its holder's
  if (ArrayBuffer.isView(value)) return value.byteLength;
  return Array.isArray(value) ? listBeside(value, Array.isArray(other) ? other : []) : recordBeside(value, other ?? {});
}

/** Members keep their place, counted from either end: one that came or went moves all behind it.
 * @param {unknown[]} list  @param {unknown[]} other */
function listBeside(list, other) {
  const moved = other.length - list.length;
  let bytes = head + slot * list.length;
  for (let i = 0; i < list.length; ++i)
    if (list[i] !== other[i + moved]) bytes += weightBeside(list[i], other[i]);
  return bytes;
}

/** @param {object} record  @param {any} other */
function recordBeside(record, other) {
  let bytes = head;
  for (const [name, member] of Object.entries(record)) bytes += slot + weightBeside(member, other[name]);
  return bytes;
}
