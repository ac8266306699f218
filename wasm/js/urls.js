// Where the .wasm files lie: beside this one. Written out in full, the form that bundlers look for.
export const urls = {
  lpquad: () => new URL('./lpquad.wasm', import.meta.url),
  'lpquad-plain': () => new URL('./lpquad-plain.wasm', import.meta.url),
  'lpquad-surface': () => new URL('./lpquad-surface.wasm', import.meta.url),
  'lpquad-surface-plain': () => new URL('./lpquad-surface-plain.wasm', import.meta.url),
  'lpquad-readers': () => new URL('./lpquad-readers.wasm', import.meta.url),
};
