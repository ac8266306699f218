import { parentPort } from 'node:worker_threads';

import { createLpquad } from './node.js';
import { serve } from './worker-thread.js';

parentPort.on('message', serve(parentPort, createLpquad));
