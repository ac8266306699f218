// Work that waits for a moment without changes: an address or a file need not follow every step of a drag,
// and Safari allows a hundred changes of the address in half a minute.

const rest = 400;  // milliseconds

/** `act`, once nothing has asked for it for a moment. @param {() => void} act */
export function whenRested(act) {
  let timer = 0;
  return () => {
    clearTimeout(timer);
    timer = window.setTimeout(act, rest);
  };
}
