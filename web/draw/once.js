// What was made of a frame, kept as long as the frame.

/**
 * What is made of an object once, by its name. Frames never change, so what was made stays true.
 * @template T @param {object} of  @param {string} name  @param {() => T} make  @returns {T}
 */
export function once(of, name, make) {
  let made = memory.get(of);
  if (made === undefined) memory.set(of, (made = new Map()));
  if (!made.has(name)) made.set(name, make());
  return made.get(name);
}
/** @type {WeakMap<object, Map<string, any>>} */
const memory = new WeakMap();

