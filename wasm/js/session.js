// Runs that somebody looks at: on domains and on surfaces.
import { checkFunction, checkWhole } from './checks.js';
import { LpquadError, unwrap } from './errors.js';
import { Handle } from './handle.js';

/** Layers a snapshot can hold, by name. */
const layerNames = ['triangles', 'cells', 'crosses', 'sizes', 'matching', 'quads'];
const surfaceLayerNames = ['surface', 'features', 'sizes', 'crosses', 'charts', 'cells', 'quads'];

export function meshResult(raw) {
  const { report, ...mesh } = unwrap(raw);
  return { ...mesh, report: JSON.parse(report) };
}

/** Runs a core call; what a function of the caller's threw meanwhile goes on its way. */
export function call(thrown, work) {
  const raw = work();
  if (thrown.length > 0) throw thrown[0];
  return raw;
}

export class Session {
  #handle;
  #thrown;

  constructor(native, thrown) {
    this.#handle = new Handle(native);
    this.#thrown = thrown;
  }

  #move(work) {
    this.#thrown.length = 0;
    return unwrap(call(this.#thrown, work));
  }

  get state() { return this.#handle.live.state(); }
  step(ticks = 1) {
    checkWhole(ticks, 'The number of ticks');
    return this.#move(() => this.#handle.live.step(ticks));
  }
  restore(tick) {
    checkWhole(tick, 'The tick to restore');
    return this.#move(() => this.#handle.live.restore(tick));
  }

  finish() {
    while (this.state.stage !== 'done') this.step(1000);
    return meshResult(this.#handle.live.result());
  }

  snapshot(layers = {}) { return this.#handle.snapshot(layers, layerNames); }
  clone() { return new Session(unwrap(this.#handle.live.clone()).session, this.#thrown); }
  dispose() { this.#handle.dispose(); }
}

/** Goes forwards only: what its stages made stays to be looked at. */
export class SurfaceSession {
  #handle;

  constructor(native) { this.#handle = new Handle(native); }

  get state() { return this.#handle.live.state(); }
  step(ticks = 1) {
    checkWhole(ticks, 'The number of ticks');
    return unwrap(this.#handle.live.step(ticks));
  }

  /** `onProgress` is asked before every tick. */
  finish(onProgress = undefined) {
    if (onProgress !== undefined) checkFunction(onProgress, 'onProgress');
    for (let state = this.state; state.stage !== 'done'; state = this.step(onProgress ? 1 : 1000))
      if (onProgress && onProgress(state) === false)
        throw new LpquadError('CANCELLED', 'The run was cancelled.');
    return meshResult(this.#handle.live.result());
  }

  snapshot(layers = {}) { return this.#handle.snapshot(layers, surfaceLayerNames); }
  dispose() { this.#handle.dispose(); }
}

// Where the engine knows explicit resource management: `using session = lpquad.start(…)`.
if (Symbol.dispose)
  for (const { prototype } of [Session, SurfaceSession]) prototype[Symbol.dispose] = prototype.dispose;
