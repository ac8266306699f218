import { createLpquad } from 'lpquad';
import { createLpquad as createInline } from 'lpquad/inline';
import { createLpquadWorker } from 'lpquad/worker';

import { report } from './report.js';

report({ direct: createLpquad, inline: createInline, worker: createLpquadWorker });
