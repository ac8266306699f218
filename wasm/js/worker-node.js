// `lpquad/worker` for Node.
import { Worker } from 'node:worker_threads';

import { checkFunction, checkWasmSource, checkWorker } from './checks.js';
import { LpquadWorker } from './client.js';

export { LpquadError } from './errors.js';

const ownWorker = () => new Worker(new URL('./worker-entry-node.js', import.meta.url));

/** A URL object does not cross into a worker. */
const asText = (source) => Object.fromEntries(Object.entries(source)
  .map(([name, value]) => [name, value instanceof URL ? value.href : value]));

export function createLpquadWorker(options = {}) {
  checkWasmSource(options, 'createLpquadWorker', ['worker']);
  const { worker = ownWorker, ...source } = options;
  checkFunction(worker, 'worker');
  return new LpquadWorker(({ message, lost }) => {
    const thread = checkWorker(worker());
    thread.on('message', message);
    thread.on('error', (error) => lost(`The worker failed: ${error.message}.`));
    thread.on('messageerror', () => lost('The worker sent something unreadable.'));
    thread.on('exit', () => lost('The worker ended.'));
    return {
      post: (data) => thread.postMessage(data),
      terminate: () => void thread.terminate(),
      // An idle worker does not keep the program alive.
      busy: (busy) => (busy ? thread.ref() : thread.unref()),
    };
  }, asText(source));
}
