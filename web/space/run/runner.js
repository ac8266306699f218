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
const mostWatching = 5000;   // of all pictures of a run together, drawing included, which may be slow
const betweenStages = 300;   // after each, of a run half as fast; all of these at speed 1
const pictureEvery = 40;  // milliseconds of meshing between two looks
const wordEvery = 400;    // the same on the way to the end, where there are no pictures
const chartsEvery = 250;  // milliseconds between two looks at what all charts have so far: it is drawn anew
const rarer = 4;         // a run that takes long is looked at after each such part of its time: drawing may be what takes long
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
  /** Straight to the end: nothing is looked at on the way. */
  #hurried = false;
  /** How fast a run is shown; 1 takes some seconds. */
  speed = 1;

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
    this.#hurried &&= !paused;
    this.#become({ paused });
    this.#release();
  }

  get hurried() { return this.#hurried; }

  /** Goes to the end as fast as it can. */
  end() {
    if (this.run.phase !== 'running') return;
    this.#hurried = true;
    this.#become({ paused: false });
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
    this.#hurried = false;
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
    const start = performance.now();
    let looked = 0;
    /** What has not been looked at on the way to the end. @type {SurfaceLayers} */
    let missed = {};
    for (let portion = 1; wanted() && session.state.stage !== 'done';) {
      if (this.run.paused) await this.#rest();
      const before = session.state, began = performance.now();
      const shown = before.stage === 'mesh' && this.#shows(watching);
      const state = await session.step(manySteps.has(before.stage) && !shown && !this.run.paused ? portion : 1);
      const over = state.stage !== before.stage, between = over || state.chart !== before.chart;
      portion = over || shown ? 1 : portionAfter(portion, performance.now() - began, this.#hurried ? wordEvery : pictureEvery);
      if (between) watching.left = pictures;
      if (between && !this.#hurried) portion = 1;
      if (over) missed = { ...missed, ...layersAfter[before.stage] };
      if (this.#looks({ over: over && state.stage, between, missed, due: performance.now() - looked > Math.max(chartsEvery, (looked - start) / rarer) })) {
        await this.#look(session, wanted, { ...missed, ...layersAfter[before.stage] });
        [looked, missed] = [performance.now(), {}];
        if (over && state.stage !== 'done') await this.#linger();
      } else if (shown && !between) await this.#lookAtCells(session, wanted, watching);
      else if (wanted()) this.#become({ state, frame: { ...this.run.frame, ...between && { cells: undefined } } });
      if (shown && !this.run.paused) watching.spent += performance.now() - began;
    }
  }

  /** Whether all that is there by now is looked at.
   * @param {{over: string | false, between: boolean, missed: SurfaceLayers, due: boolean}} now  over: the next stage, if one has ended */
  #looks({ over, between, missed, due }) {
    if (this.run.paused) return between || Object.keys(missed).length > 0;
    if (this.#hurried) return over === 'done';
    return over !== false || (between && due);
  }

  /** Whether the cells of the chart are looked at. @param {{left: number, spent: number}} watching */
  #shows({ left, spent }) {
    return this.run.paused || (!this.#hurried && left > 0 && spent < mostWatching / this.speed && this.watched());
  }

  /** What a stage has left is seen for longer by those who want it slower. */
  async #linger() {
    if (this.speed < 1 && !this.#hurried && !this.run.paused) await this.#rest(betweenStages * (1 / this.speed - 1));
  }

  /** Until it is let go on, or so long. @param {number} [milliseconds] */
  #rest(milliseconds) {
    return new Promise((resolve) => {
      this.#release = () => resolve(undefined);
      if (milliseconds !== undefined) setTimeout(resolve, milliseconds);
    });
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
    if (!cells || this.run.paused || this.#hurried) return;
    if (old?.chart === cells.chart && sameNumbers(old.uv, cells.uv)) {
      watching.left = 0;
      return;
    }
    await this.#rest((watching.left < pictures ? next : Math.min(longest, cellsFor / session.state.chartCount)) / this.speed);
    --watching.left;
  }
}

/** @param {Float64Array} a  @param {Float64Array} b */
const sameNumbers = (a, b) => a.length === b.length && a.every((x, i) => x === b[i]);

/** More steps at once while they are quick. @param {number} portion  @param {number} took  @param {number} [slow]  milliseconds */
export const portionAfter = (portion, took, slow = pictureEvery) =>
  (took > slow ? Math.max(1, Math.floor(portion / 2)) : Math.min(4096, 2 * portion));

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
