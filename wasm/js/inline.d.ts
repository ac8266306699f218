/**
 * `lpquad/inline`: the same library with the WebAssembly inside the JavaScript. It reads and writes
 * surfaces, but does not mesh them; `lpquad/inline-surface` does.
 */
export * from './index.js';
