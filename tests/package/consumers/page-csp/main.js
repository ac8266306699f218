import { createLpquad } from './node_modules/lpquad/dist/index.js';
import { createLpquad as createInline } from './node_modules/lpquad/dist/inline.js';
import { createLpquadWorker } from './node_modules/lpquad/dist/worker.js';
import { report } from './report.js';

report({ direct: createLpquad, inline: createInline, worker: createLpquadWorker });
