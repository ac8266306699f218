import { createLpquad } from 'lpquad';
import { createLpquad as createInline } from 'lpquad/inline';
import { createLpquadWorker } from 'lpquad/worker';
import wasmUrl from 'lpquad/lpquad.wasm?url';

import { report } from './report.js';

report({ direct: createLpquad, url: () => createLpquad({ wasmUrl }), inline: createInline,
  worker: createLpquadWorker });
