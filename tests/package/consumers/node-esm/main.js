import { createLpquad } from 'lpquad';
import { createLpquad as createInline } from 'lpquad/inline';
import { createLpquad as createInlineSurface } from 'lpquad/inline-surface';
import { createLpquadWorker } from 'lpquad/worker';

import { fingerprints } from './report.js';

console.log(JSON.stringify(await fingerprints(
  { direct: createLpquad, inline: createInline, surface: createInlineSurface, worker: createLpquadWorker })));
