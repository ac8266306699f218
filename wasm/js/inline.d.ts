/** `lpquad/inline`: the same library with the WebAssembly inside the JavaScript. */
export * from './index.js';
