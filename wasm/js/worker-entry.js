// The module a browser's worker runs. onmessage is set before anything is awaited: a message that
// came earlier would be lost.
import { createLpquad } from './index.js';
import { serve } from './worker-thread.js';

const handle = serve(self, createLpquad);
self.onmessage = (event) => handle(event.data);
