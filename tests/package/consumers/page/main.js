import { createLpquad } from './node_modules/lpquad/dist/index.js';
import { createLpquad as createInline } from './node_modules/lpquad/dist/inline.js';
import { report } from './report.js';

const wasmUrl = 'node_modules/lpquad/dist/lpquad-plain.wasm';  // relative to the page
report({ direct: createLpquad, url: () => createLpquad({ wasmUrl }), inline: createInline });
