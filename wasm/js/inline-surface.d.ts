/** `lpquad/inline-surface`: `lpquad/inline` with what meshes surfaces inside, too. */
export * from './index.js';
