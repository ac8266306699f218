import { createLpquad } from 'lpquad';
import { createLpquad as createInline } from 'lpquad/inline';
import { createLpquadWorker } from 'lpquad/worker';

import { fingerprints } from './report.js';

console.log(JSON.stringify(await fingerprints(
  { direct: createLpquad, inline: createInline, worker: createLpquadWorker })));
