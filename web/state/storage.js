// What the browser keeps for this page. It may be full, or forbidden: then nothing is kept, and
// nothing else suffers.

const prefix = 'lpquad.';

/** @param {string} name */
export function kept(name) {
  try {
    return localStorage.getItem(prefix + name);
  } catch {
    return null;
  }
}

/** Whether it was kept. @param {string} name  @param {string} text */
export function keep(name, text) {
  try {
    localStorage.setItem(prefix + name, text);
    return true;
  } catch {
    return false;
  }
}
