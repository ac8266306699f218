/**
 * `lpquad/worker-entry`: what the worker runs, for workers of your own making. Import it for its
 * effect as the first thing in the worker's module; see `createLpquadWorker({ worker })`.
 */
export {};
