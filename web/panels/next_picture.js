// Many changes, one picture.

/** However often it is called: once, before the next picture. @param {() => void} work */
export function atNextPicture(work) {
  let waiting = false;
  return () => {
    if (waiting) return;
    waiting = true;
    requestAnimationFrame(() => {
      waiting = false;
      work();
    });
  };
}
