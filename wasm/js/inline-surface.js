// `lpquad/inline-surface`: lpquad/inline with what meshes surfaces, which doubles it.
import { compileBase64 } from './base64.js';
import surfaceWasm from './inline-surface-wasm.js';
import wasm from './inline-wasm.js';
import { createOnce } from './load.js';
import createReaders from './readers-glue.js';
import createSurfaces from './surface-glue.js';

export { LpquadError } from './errors.js';

const files = {
  plain: true,
  own: (name) => compileBase64({ ...wasm, ...surfaceWasm }[name]),
  readersGlue: async () => ({ default: createReaders }),
  surfaceGlue: async () => ({ default: createSurfaces }),
};

export const createLpquad = async (source = {}) => createOnce(source, files);
