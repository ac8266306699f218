// One run of the surface mesher in a worker: its knowledge is one value, `run`, replaced at every
// step and told to whoever listens.
/** @import { LpquadWorker } from 'lpquad/worker' */
/** @import { SurfaceLayers, SurfaceProgress } from 'lpquad' */
/** @import { SurfaceRun, Work } from '../types' */

/** @type {SurfaceRun} */
const nothing = { phase: 'idle', work: null, state: null, frame: {}, result: null, error: null };

/** What can be seen first after each stage. @type {Record<string, SurfaceLayers>} */
const layersAfter = {
  features: { features: true, sizes: true }, field: { crosses: true }, charts: { charts: true }, mesh: { quads: true }, seams: { quads: true },
};

const pictureEvery = 40;  // milliseconds of meshing between two looks

export class SurfaceRunner {
  /** @type {SurfaceRun} */
  run = nothing;
  /** @type {Set<(run: SurfaceRun) => void>} */
  #listeners = new Set();
  /** @type {Promise<LpquadWorker> | null} */
  #engine = null;
  #generation = 0;

  /** @param {() => Promise<LpquadWorker>} createEngine */
  constructor(createEngine) {
    this.createEngine = createEngine;
  }

  /** The worker; another one after it was ended. */
  engine() {
    const engine = this.#engine ??= this.createEngine();
    engine.catch(() => { if (this.#engine === engine) this.#engine = null; });
    return engine;
  }

  /** @param {(run: SurfaceRun) => void} listener  @returns {() => void} ends it */
  subscribe(listener) {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }

  /** @param {Partial<SurfaceRun>} change */
  #become(change) {
    this.run = { ...this.run, ...change };
    for (const listener of this.#listeners) listener(this.run);
  }

  /** Ends the run under way: the worker goes, nothing answers faster. */
  cancel() {
    if (this.run.phase !== 'running') return;
    this.#drop();
    this.#become({ phase: 'cancelled' });
  }

  #drop() {
    ++this.#generation;
    const engine = this.#engine;
    this.#engine = null;
    engine?.then((worker) => worker.terminate(), () => {});
  }

  /** Meshes; a run under way is given up. @param {Work} work */
  async start(work) {
    if (this.run.phase === 'running') this.#drop();
    const mine = ++this.#generation;
    this.#become({ ...nothing, phase: 'running', work });
    try {
      await this.#mesh(work, () => mine === this.#generation);
    } catch (thrown) {
      const { code = 'INTERNAL', message } = /** @type {any} */ (thrown);
      if (mine === this.#generation) this.#become({ phase: 'failed', error: { code, message } });
    }
  }

  /** @param {Work} work  @param {() => boolean} wanted */
  async #mesh(work, wanted) {
    const session = await (await this.engine()).startSurface(work.surface, work.options);
    try {
      await this.#steps(session, wanted);
      if (!wanted()) return;
      const result = await session.finish();
      if (wanted()) this.#become({ phase: 'done', result, state: session.state });
    } finally {
      void session.dispose();
    }
  }

  /** @param {import('lpquad/worker').WorkerSurfaceSession} session  @param {() => boolean} wanted */
  async #steps(session, wanted) {
    const look = async (/** @type {SurfaceLayers} */ layers) => {
      const seen = await session.snapshot(layers);
      if (wanted()) this.#become({ state: session.state, frame: { ...this.run.frame, ...seen } });
    };
    await look({ surface: true });
    for (let portion = 1; wanted() && session.state.stage !== 'done';) {
      const before = session.state, began = performance.now();
      const state = await session.step(before.stage === 'mesh' ? portion : 1);
      const over = state.stage !== before.stage;
      if (over) portion = 1;
      else portion = portionAfter(portion, performance.now() - began);
      if (over || state.chart !== before.chart) await look(layersAfter[before.stage] ?? {});
      else if (wanted()) this.#become({ state });
    }
  }
}

/** More steps at once while they are quick. @param {number} portion  @param {number} took */
export const portionAfter = (portion, took) =>
  (took > pictureEvery ? Math.max(1, Math.floor(portion / 2)) : Math.min(4096, 2 * portion));

/** @type {Record<SurfaceProgress['stage'], string>} */
const names = {
  features: 'finding sharp edges', field: 'solving the cross field', charts: 'mapping charts to the plane',
  mesh: 'meshing charts', seams: 'remeshing over the seams', done: 'done',
};

/** Where the run is, in words. @param {SurfaceRun} run */
export function stageInWords({ phase, state, error }) {
  if (phase === 'failed') return `failed: ${error?.code ?? ''}`;
  if (phase === 'cancelled') return 'cancelled';
  if (phase === 'idle' || state === null) return phase === 'idle' ? 'nothing to mesh yet' : 'loading the mesher';
  if (phase === 'done') return 'done';
  const charts = state.stage === 'mesh' ? `: ${state.chart} of ${state.chartCount}` : '';
  return `${names[state.stage]}${charts}`;
}

/** Between 0 and 1. @param {SurfaceRun} run */
export function shareOf({ phase, state }) {
  if (phase === 'done') return 1;
  if (state === null) return 0;
  const before = { features: 0, field: 0.05, charts: 0.15, mesh: 0.25, seams: 0.75, done: 1 }[state.stage];
  return state.stage === 'mesh' && state.chartCount > 0 ? before + 0.5 * state.chart / state.chartCount : before;
}
