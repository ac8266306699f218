import { createLpquad } from 'lpquad';
import { createLpquad as createInline } from 'lpquad/inline';
// The loader `file` copies these and gives their addresses.
import wasmUrl from 'lpquad/lpquad.wasm';
import readersUrl from 'lpquad/lpquad-readers.wasm';
import surfaceUrl from 'lpquad/lpquad-surface.wasm';

import { report } from './report.js';

report({ url: () => createLpquad({ wasmUrl, readersUrl, surfaceUrl }), inline: createInline });
