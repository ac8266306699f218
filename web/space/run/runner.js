// One run of the surface mesher in a worker: its knowledge is one value, `run`, replaced at every
// step and told to whoever listens.
/** @import { LpquadWorker, WorkerSurfaceSession } from 'lpquad/worker' */
/** @import { SurfaceLayers, SurfaceProgress } from 'lpquad' */
/** @import { SurfaceRun, Work } from '../types' */

/** @type {SurfaceRun} */
const nothing = { phase: 'idle', work: null, state: null, frame: {}, result: null, error: null, paused: false };

/** What can be seen first after each stage. @type {Record<string, SurfaceLayers>} */
const layersAfter = {
  features: { features: true, sizes: true }, field: { crosses: true }, charts: { charts: true }, mesh: { quads: true }, seams: { quads: true }, shape: { quads: true },
};

const pictures = 20;         // of the cells in one chart
const cellsFor = 5000;       // milliseconds for the first ones of all charts together
const longest = 500;         // for the first one of a chart
const next = 60;             // for each of the others
const mostWatching = 15000;  // of all pictures of a run together, drawing included, which may be slow
const pictureEvery = 40;  // milliseconds of meshing between two looks
const chartsEvery = 250;  // milliseconds between two looks at what all charts have so far: it is drawn anew
const manySteps = new Set(['mesh', 'seams', 'shape']);

export class SurfaceRunner {
  /** @type {SurfaceRun} */
  run = nothing;
  /** @type {Set<(run: SurfaceRun) => void>} */
  #listeners = new Set();
  /** @type {Promise<LpquadWorker> | null} */
  #engine = null;
  #generation = 0;

  /** Lets a run that waits go on. */
  #release = () => {};

  /** @param {() => Promise<LpquadWorker>} createEngine
   * @param {() => boolean} [watched]  whether charts are meshed slowly enough to see their cells */
  constructor(createEngine, watched = () => false) {
    this.createEngine = createEngine;
    this.watched = watched;
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
    this.#become({ phase: 'cancelled', paused: false });
  }

  /** Holds the run, or lets it go on. @param {boolean} [paused] */
  pause(paused = true) {
    if (this.run.phase !== 'running') return;
    this.#become({ paused });
    this.#release();
  }

  /** One tick; the run waits after it. */
  step() {
    this.pause();
  }

  #drop() {
    ++this.#generation;
    this.#release();
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
      if (wanted()) this.#become({ phase: 'done', paused: false, result, state: session.state });
    } finally {
      void session.dispose();
    }
  }

  /** @param {WorkerSurfaceSession} session  @param {() => boolean} wanted */
  async #steps(session, wanted) {
    await this.#look(session, wanted, { surface: true });
    const watching = { left: pictures, spent: 0 };
    let looked = 0;
    for (let portion = 1; wanted() && session.state.stage !== 'done';) {
      if (this.run.paused) await new Promise((resolve) => { this.#release = () => resolve(undefined); });
      const before = session.state, began = performance.now();
      const shown = before.stage === 'mesh' && (this.run.paused || (watching.left > 0 && watching.spent < mostWatching && this.watched()));
      const state = await session.step(manySteps.has(before.stage) && !shown && !this.run.paused ? portion : 1);
      const over = state.stage !== before.stage, between = over || state.chart !== before.chart;
      portion = over || shown ? 1 : portionAfter(portion, performance.now() - began);
      if (between) [watching.left, portion] = [pictures, 1];
      if (over || (between && (this.run.paused || performance.now() - looked > chartsEvery))) {
        await this.#look(session, wanted, layersAfter[before.stage] ?? {});
        looked = performance.now();
      } else if (shown && !between) await this.#lookAtCells(session, wanted, watching);
      else if (wanted()) this.#become({ state, frame: { ...this.run.frame, ...between && { cells: undefined } } });
      if (shown && !this.run.paused) watching.spent += performance.now() - began;
    }
  }

  /** @param {WorkerSurfaceSession} session  @param {() => boolean} wanted  @param {SurfaceLayers} layers */
  async #look(session, wanted, layers) {
    const seen = await session.snapshot(layers);
    if (!wanted()) return;
    const cells = seen.cells?.sites.length ? seen.cells : undefined;
    this.#become({ state: session.state, frame: { ...this.run.frame, ...seen, cells } });
  }

  /** For as long as the cells move. @param {WorkerSurfaceSession} session  @param {() => boolean} wanted
   * @param {{left: number}} watching  so many pictures of this chart */
  async #lookAtCells(session, wanted, watching) {
    const { cells: old } = this.run.frame;
    await this.#look(session, wanted, { cells: true });
    const { cells } = this.run.frame;
    if (!cells || this.run.paused) return;
    if (old?.chart === cells.chart && sameNumbers(old.uv, cells.uv)) {
      watching.left = 0;
      return;
    }
    await new Promise((resolve) => setTimeout(resolve, watching.left < pictures ? next : Math.min(longest, cellsFor / session.state.chartCount)));
    --watching.left;
  }
}

/** @param {Float64Array} a  @param {Float64Array} b */
const sameNumbers = (a, b) => a.length === b.length && a.every((x, i) => x === b[i]);

/** More steps at once while they are quick. @param {number} portion  @param {number} took */
export const portionAfter = (portion, took) =>
  (took > pictureEvery ? Math.max(1, Math.floor(portion / 2)) : Math.min(4096, 2 * portion));

/** @type {Record<SurfaceProgress['stage'], string>} */
const names = {
  features: 'finding sharp edges', field: 'solving the cross field', charts: 'mapping charts to the plane',
  mesh: 'meshing charts', seams: 'remeshing over the seams', shape: 'moving the vertices', done: 'done',
};

/** Where the run is, in words. @param {SurfaceRun} run */
export function stageInWords({ phase, state, error, paused }) {
  if (phase === 'failed') return `failed: ${error?.code ?? ''}`;
  if (phase === 'cancelled') return 'cancelled';
  if (phase === 'idle' || state === null) return phase === 'idle' ? 'nothing to mesh yet' : 'loading the mesher';
  if (phase === 'done') return 'done';
  const charts = state.stage === 'mesh' ? `: ${state.chart} of ${state.chartCount}` : '';
  return `${names[state.stage]}${charts}${paused ? ' (paused)' : ''}`;
}

/** From where to where each stage goes. @type {Record<SurfaceProgress['stage'], [number, number]>} */
const stretches = {
  features: [0, 0.05], field: [0.05, 0.15], charts: [0.15, 0.2], mesh: [0.2, 0.45], seams: [0.45, 0.8], shape: [0.8, 1], done: [1, 1],
};

/** Between 0 and 1. @param {SurfaceRun} run */
export function shareOf({ phase, state }) {
  if (phase === 'done') return 1;
  if (state === null) return 0;
  const [from, to] = stretches[state.stage];
  return from + (to - from) * state.share;
}
