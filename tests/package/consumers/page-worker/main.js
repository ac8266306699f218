import { createLpquadWorker } from './node_modules/lpquad/dist/worker.js';
import { report } from './report.js';

const own = () => new Worker('own-worker.js', { type: 'module' });
const wasmUrl = 'node_modules/lpquad/dist/lpquad-plain.wasm';
report({ worker: createLpquadWorker, url: () => createLpquadWorker({ wasmUrl }),
  own: () => createLpquadWorker({ worker: own }) });
