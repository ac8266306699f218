// One run of the mesher on one project: plays, pauses, steps, goes back and forth, ends. What it
// knows is one value, `run`, replaced at every change. Whatever was started for an older project
// stops when a new one comes; nothing of it is shown as current.
/** @import { LpquadWorker, WorkerSession } from 'lpquad/worker' */
/** @import { Layers, State } from 'lpquad' */
/** @import { LayerName, Phase, Project, Run } from '../types' */
import { toCall } from '../state/project.js';
import { neededFor } from './needed.js';

/** @type {Run} */
const nothing = {
  phase: 'loading', project: null, state: null, frame: null, history: [], result: null, error: null,
};

export class Runner {
  /** @type {() => Promise<LpquadWorker>} */
  #createEngine;
  /** @type {Promise<LpquadWorker> | undefined} */
  #engine;
  /** @type {WorkerSession | null} */
  #session = null;
  /** @type {Set<(run: Run) => void>} */
  #listeners = new Set();
  #generation = 0;  // of the project; what comes back for an older one is dropped
  /** @type {Promise<unknown>} */
  #queue = Promise.resolve();  // the session does one thing at a time
  /** @type {Run} */
  run = nothing;
  /** Ticks per picture; below 1, pictures per tick. */
  speed = 1;
  /** @type {() => Project['layers']} */
  wantedLayers = () => 'auto';

  /** @param {() => Promise<LpquadWorker>} createEngine */
  constructor(createEngine) {
    this.#createEngine = createEngine;
  }

  /** @param {(run: Run) => void} listener */
  subscribe(listener) {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }

  /** @param {Partial<Run>} part */
  #become(part) {
    this.run = { ...this.run, ...part };
    for (const listener of this.#listeners) listener(this.run);
  }

  engine() {
    return (this.#engine ??= this.#createEngine());
  }

  /**
   * Starts afresh with this project and, if asked, plays.
   * @param {Project} project  @param {{play?: boolean}} [how]
   */
  async load(project, { play = true } = {}) {
    await this.#abandon();
    const generation = this.#generation;
    this.#become({ ...nothing, phase: 'starting', project, frame: this.run.frame });
    await this.#guarded(generation, async () => {
      const { domain, options } = toCall(project);
      const engine = await this.engine();
      const session = await engine.start(/** @type {any} */ (domain), options);
      if (generation !== this.#generation) return void session.dispose().catch(() => {});
      this.#session = session;
      this.#become({ phase: 'paused', state: session.state, history: [session.state], frame: null });
      await this.#look(generation);
    });
    if (play && generation === this.#generation && this.run.phase === 'paused') this.play();
  }

  /** Ends what is under way; a worker in the middle of something goes. */
  async #abandon() {
    const session = this.#session;
    const busy = this.run.phase === 'playing' || this.run.phase === 'starting';
    ++this.#generation;
    this.#session = null;
    if (busy) (await this.engine()).terminate();
    else await session?.dispose().catch(() => {});
  }

  /** Stops at once and keeps what is on the screen. */
  async cancel() {
    if (this.run.phase !== 'playing' && this.run.phase !== 'starting') return;
    await this.#abandon();
    this.#become({ phase: 'cancelled' });
  }

  /** Runs `work` for one project; its errors are shown unless the project is gone. */
  async #guarded(/** @type {number} */ generation, /** @type {() => Promise<void>} */ work) {
    try {
      await work();
    } catch (thrown) {
      if (generation !== this.#generation) return;
      const { code = 'INTERNAL', message, where = {} } = /** @type {any} */ (thrown);
      this.#become({ phase: 'failed', error: { code, message, where } });
    }
  }

  /** One thing after the other, each only if the project is still the same. */
  #enqueue(/** @type {(session: WorkerSession, generation: number) => Promise<void>} */ work) {
    const generation = this.#generation;
    const next = this.#queue.then(() => this.#guarded(generation, async () => {
      if (generation === this.#generation && this.#session) await work(this.#session, generation);
    }));
    this.#queue = next;
    return next;
  }

  /** Takes what the layers need from the session as it stands. */
  async #look(/** @type {number} */ generation) {
    const session = this.#session;
    if (session === null) return;
    const frame = await session.snapshot(neededFor(this.wantedLayers(), session.state));
    if (generation === this.#generation) this.#become({ frame, state: session.state });
  }

  /** The layers changed: look again. */
  refresh() { return this.#enqueue((_, generation) => this.#look(generation)); }

  async #advance(/** @type {WorkerSession} */ session, /** @type {number} */ ticks, /** @type {number} */ generation) {
    const state = session.state.stage === 'done' ? session.state : await session.step(ticks);
    if (generation !== this.#generation) return;
    this.#remember(state);
    await this.#look(generation);
    if (state.stage === 'done') await this.#finish(session, generation);
  }

  #remember(/** @type {State} */ state) {
    if (this.run.history.at(-1)?.tick === state.tick) return;
    const history = this.run.history.filter(({ tick }) => tick < state.tick);
    this.#become({ history: [...history, state], state });
  }

  async #finish(/** @type {WorkerSession} */ session, /** @type {number} */ generation) {
    const result = this.run.result ?? await session.finish();
    if (generation === this.#generation) this.#become({ phase: 'done', result, state: session.state });
  }

  /** @returns {Promise<void>} */
  play() {
    if (this.run.phase === 'done') return this.seek(0).then(() => this.play());
    if (this.run.phase !== 'paused') return Promise.resolve();
    this.#become({ phase: 'playing' });
    return this.#enqueue(async (session, generation) => {
      while (generation === this.#generation && this.run.phase === 'playing') {
        const { stage } = session.state;
        await this.#advance(session, stage === 'optimise' ? Math.max(1, Math.round(this.speed)) : 1, generation);
        await pause(this.speed);
      }
    });
  }

  pause() {
    if (this.run.phase === 'playing') this.#become({ phase: 'paused' });
  }

  step() {
    this.pause();
    return this.#enqueue((session, generation) => this.#advance(session, 1, generation));
  }

  /** To the end, with pictures only in between as they come. */
  end() {
    if (this.run.phase === 'playing') this.pause();
    if (this.run.phase !== 'paused') return Promise.resolve();
    this.#become({ phase: 'playing' });
    return this.#enqueue(async (session, generation) => {
      while (generation === this.#generation && this.run.phase === 'playing')
        await this.#advance(session, 16, generation);
    });
  }

  /** To the state after `tick` ticks. @param {number} tick */
  seek(tick) {
    this.pause();
    return this.#enqueue(async (session, generation) => {
      if (session.state.tick !== tick) await session.restore(tick);
      await this.#look(generation);
      if (generation !== this.#generation) return;
      if (session.state.stage === 'done') await this.#finish(session, generation);
      else this.#become({ phase: 'paused' });
    });
  }
}

/** The time a picture stands. */
function pause(/** @type {number} */ speed) {
  const milliseconds = speed < 1 ? 40 / speed : 0;
  return new Promise((resolve) => setTimeout(resolve, milliseconds));
}
