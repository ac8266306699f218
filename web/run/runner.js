// One run of the mesher on one project. What is known of it is one value, `run`, replaced at every
// change. What is asked for is one value too, `#wish`: asking changes it at once, and a single loop
// makes it true step by step. So anything may be asked for at any moment, and the latest wins.
// Whatever was begun for an older project is dropped; nothing of it is shown as current.
/** @import { LpquadWorker, WorkerSession } from 'lpquad/worker' */
/** @import { Progress, State } from 'lpquad' */
/** @import { Project, Run } from '../types' */
import { toCall } from '../state/project.js';
import { remembered } from './history.js';
import { neededFor } from './needed.js';
import { nextPicture, Pace } from './pace.js';
import { Workplace } from './workplace.js';

/** @type {Run} */
const nothing = {
  phase: 'loading', project: null, state: null, frame: null, frameOf: null, history: [], result: null, error: null,
};

/**
 * @typedef {object} Wish
 * @property {number | null} tick  to be at first
 * @property {'' | 'play' | 'end'} going  then: stay, go on as a film, go on to the end
 * @property {boolean} look  a picture is to be taken
 */

const chunk = 8;         // ticks between which a long way can be left
const firstLook = 800;   // milliseconds on the way to the end before pictures are taken,
const nextLook = 200;    // and between them,
const calmLook = 2000;   // so that nothing seems to move

export class Runner {
  #workplace;
  /** @type {WorkerSession | null} */
  #session = null;
  #reached = 0;      // ticks, by the session
  #generation = 0;   // of sessions; what comes back for an older one is dropped
  #lives = 0;        // how often a lost worker is replaced
  /** @type {Promise<void> | null} */
  #driving = null;
  /** @type {Wish} */
  #wish = { tick: null, going: '', look: false };
  /** @type {() => Promise<WorkerSession>} */
  #open = () => Promise.reject(new Error('Nothing to run.'));
  #lookAt = 0;       // time of the next picture on the way to the end
  #pace;
  /** @type {Set<(run: Run) => void>} */
  #listeners = new Set();
  /** @type {Run} */
  run = nothing;
  /** How fast a run plays; 1 takes some seconds. */
  speed = 1;
  /** Few pictures on the way to the end, and far apart: motion is unwanted. */
  still = false;
  /** @type {() => Project['layers']} */
  wantedLayers = () => 'auto';

  /**
   * @param {() => Promise<LpquadWorker>} createEngine
   * @param {{pace?: Pace, picture?: () => Promise<unknown>}} [how]
   */
  constructor(createEngine, { pace = new Pace(), picture = nextPicture } = {}) {
    this.#workplace = new Workplace(createEngine);
    this.#pace = pace;
    this.picture = picture;
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

  /** The worker; after a failure, another one. */
  engine() { return this.#workplace.engine(); }

  /** Under way, or about to be. */
  get going() { return this.#wish.going !== ''; }
  get busy() { return this.#driving !== null; }

  /**
   * Starts afresh with this project. Ends when there is nothing left to do.
   * @param {Project} project
   * @param {{going?: Wish['going'], keep?: boolean, open?: () => Promise<WorkerSession>}} [how]
   *   `keep` the old picture until there is a new one; `open` gives a session, recorded perhaps
   */
  load(project, { going = 'play', keep = true, open } = {}) {
    this.#abandon();
    this.#open = open ?? (() => this.#start(project));
    this.#lives = 2;
    this.#wish = { tick: null, going, look: going !== 'end' };
    this.#lookAt = this.#pace.now() + firstLook;
    const { frame, frameOf } = keep ? this.run : nothing;
    this.#become({ ...nothing, phase: this.#workplace.ready ? 'starting' : 'loading', project, frame, frameOf });
    return this.#drive();
  }

  /** @param {Project} project */
  async #start(project) {
    const { domain, options } = toCall(project);
    const engine = await this.engine();
    await engine.ready();
    if (this.run.phase === 'loading') this.#become({ phase: 'starting' });
    return engine.start(/** @type {any} */ (domain), options);
  }

  /** Instead of a run of a project that the mesher is not called with. @param {Project} project
   * @param {NonNullable<Run['error']>} error  @param {{keep?: boolean}} [how]  `keep` the old picture */
  refuse(project, error, { keep = true } = {}) {
    this.#abandon();
    this.#open = () => Promise.reject(Object.assign(new Error(error.message), error));
    const { frame, frameOf } = keep ? this.run : nothing;
    this.#become({ ...nothing, phase: 'failed', project, frame, frameOf, error });
  }

  /** Leaves the session; a worker in the middle of something goes if it does not finish soon. */
  #abandon() {
    const [session, driving] = [this.#session, this.#driving];
    ++this.#generation;
    this.#session = null;
    this.#driving = null;
    this.#wish = { tick: null, going: '', look: false };
    if (driving) this.#workplace.leave(driving, session);
    else session?.dispose?.().catch(() => {});
  }

  /** Stops at once and keeps what is on the screen. */
  cancel() {
    if (!this.busy) return;
    this.#abandon();
    this.#become({ phase: 'cancelled' });
  }

  /** Forgets everything and ends the worker, for now. */
  close() {
    this.#abandon();
    this.#workplace.close();
    this.#open = () => Promise.reject(new Error('Nothing to run.'));
    this.#become({ ...nothing });
  }

  /** Makes the wish true, unless that is under way. @returns {Promise<void>} */
  #drive() {
    const driving = this.#driving ?? this.#loop(this.#generation);
    this.#driving = driving;
    return driving;
  }

  /** @param {number} generation @returns {Promise<void>} */
  async #loop(generation) {
    await null;  // #driving is set before anything happens
    const current = () => generation === this.#generation;
    try {
      if (this.#session === null) await this.#begin(current);
      while (current() && this.#next !== 'rest') await this.#do(/** @type {any} */ (this.#session), current);
    } catch (thrown) {
      if (!current()) return;
      if (this.#survives(/** @type {any} */ (thrown))) return this.#loop(generation);
      return this.#fail(/** @type {any} */ (thrown));
    }
    if (current()) this.#rest();
  }

  /** @param {() => boolean} current */
  async #begin(current) {
    await this.#workplace.free;
    if (!current()) return;
    const session = await this.#open();
    if (!current()) return void session.dispose?.().catch(() => {});
    this.#pace.begin();
    this.#session = session;
    this.#reached = session.state.tick;
    this.#become({ phase: this.going ? 'playing' : 'paused', error: null, ...this.#seen(session.state) });
  }

  /** What the wish wants next. */
  get #next() {
    const { tick, going, look } = this.#wish;
    const { state } = /** @type {WorkerSession} */ (this.#session);
    const done = state.stage === 'done';
    if (tick !== null && tick !== state.tick && !(done && tick > state.tick)) return 'travel';
    if (done && this.run.result === null) return 'finish';
    if (look) return 'look';
    return going === '' || done ? 'rest' : going;
  }

  /** @param {WorkerSession} session  @param {() => boolean} current @returns {Promise<void>} */
  #do(session, current) {
    const next = this.#next;
    if (next === 'travel') return this.#travel(session, /** @type {number} */ (this.#wish.tick), current);
    this.#wish.tick = null;
    if (next === 'finish') return this.#finish(session, current);
    if (next === 'look') return this.#look(session, current);
    return next === 'play' ? this.#play(session, current) : this.#hurry(session, current);
  }

  /** Nothing is left to do. What is told here may ask for more. */
  #rest() {
    this.#driving = null;
    this.#wish = { tick: null, going: '', look: false };
    const phase = this.#session?.state.stage === 'done' ? 'done' : 'paused';
    if (this.run.phase !== phase) this.#become({ phase });
  }

  /** @param {WorkerSession} session  @param {number} tick  @param {() => boolean} current */
  async #travel(session, tick, current) {
    if (tick <= this.#reached) await session.restore(tick);
    else await this.#step(session, Math.min(chunk, tick - session.state.tick), current);
    if (!current()) return;
    if (session.state.tick === tick || session.state.stage === 'done') await this.#look(session, current);
    else this.#become(this.#seen(session.state));
  }

  /** The next picture of the film, when it is due. @param {WorkerSession} session  @param {() => boolean} current */
  async #play(session, current) {
    await this.picture();
    if (!current() || this.#next !== 'play') return;
    const due = this.#pace.take(session.state, this.speed);
    if (due === 0) return;
    await this.#step(session, due, current);
    if (current()) await this.#look(session, current);
  }

  /** Some way to the end. @param {WorkerSession} session  @param {() => boolean} current */
  async #hurry(session, current) {
    await this.#step(session, session.state.stage === 'optimise' ? chunk : 1, current);
    if (!current()) return;
    const { stage } = session.state;
    const first = this.run.frame === null && stage !== 'seeds';  // an empty stage tells nothing
    if (stage === 'done' || first || this.#pace.now() > this.#lookAt) await this.#look(session, current);
    else this.#become(this.#seen(session.state));
  }

  /** @param {WorkerSession} session  @param {number} ticks  @param {() => boolean} current */
  async #step(session, ticks, current) {
    // Not all of a state; 0 is what is not known.
    const onProgress = (/** @type {Progress & {tick: number}} */ progress) => {
      const state = { gradientNorm: 0, tau: 0, ...progress };
      if (current()) this.run = { ...this.run, history: remembered(this.run.history, state) };
    };
    await session.step(ticks, { onProgress });
    if (current()) this.#reached = Math.max(this.#reached, session.state.tick);
  }

  /** @param {State} state  @returns {Partial<Run>} */
  #seen(state) {
    return { state, history: remembered(this.run.history, state) };
  }

  /** Takes what the layers need from the session as it stands.
   * @param {WorkerSession} session  @param {() => boolean} current */
  async #look(session, current) {
    this.#wish.look = false;
    const { state } = session;
    const frame = await session.snapshot(neededFor(this.wantedLayers(), state));
    if (!current()) return;
    this.#lookAt = this.#pace.now() + (this.still ? calmLook : nextLook);
    this.#become({ frame, frameOf: this.run.project, ...this.#seen(state) });
  }

  /** @param {WorkerSession} session  @param {() => boolean} current */
  async #finish(session, current) {
    const result = await session.finish();
    if (current()) this.#become({ result });
  }

  /** A lost worker is replaced, and the run goes on where it was. @param {{code?: string}} thrown */
  #survives({ code }) {
    if (code !== 'WORKER_LOST' || this.#lives-- <= 0) return false;
    this.#session = null;
    this.#wish.tick ??= this.run.state?.tick ?? null;
    this.#wish.look = true;
    return true;
  }

  /** @param {{code?: string, message: string, where?: object}} thrown */
  #fail({ code = 'INTERNAL', message, where = {} }) {
    this.#session?.dispose?.().catch(() => {});
    this.#session = null;
    this.#driving = null;
    this.#wish = { tick: null, going: '', look: false };
    this.#become({ phase: 'failed', error: { code, message, where } });
  }

  /** @param {Partial<Wish>} wish */
  #ask(wish) {
    if (this.run.project === null) return Promise.resolve();
    const ended = this.#session === null && !this.busy;  // cancelled or failed: from there again
    if (ended) this.#lives = 1;
    this.#wish = { ...this.#wish, ...(ended && { tick: this.run.state?.tick ?? null, look: true }), ...wish };
    const phase = this.#session === null ? 'starting' : this.going ? 'playing' : 'paused';
    if (this.run.phase !== phase && !(phase === 'starting' && this.run.phase === 'loading')) this.#become({ phase });
    return this.#drive();
  }

  /** The layers changed: look again. */
  refresh() {
    if (this.#session === null && !this.busy) return Promise.resolve();
    this.#wish.look = true;
    return this.#drive();
  }

  /** Shows the rest as a film; from the start if this is the end. */
  play() {
    this.#pace.begin();
    return this.#ask({ going: 'play', ...(this.#atEnd && { tick: 0 }) });
  }

  pause() {
    if (this.going) void this.#ask({ going: '' });
  }

  /** To the end, with pictures only if that takes long. */
  end() {
    this.#lookAt = this.#pace.now() + firstLook;
    return this.#atEnd ? Promise.resolve() : this.#ask({ going: 'end' });
  }

  step() { return this.#atEnd ? Promise.resolve() : this.seek(this.#destined + 1); }
  back() { return this.seek(Math.max(0, this.#destined - 1)); }
  reset() { return this.seek(0); }

  /** To the state after `tick` ticks. @param {number} tick */
  seek(tick) {
    return this.#ask({ tick, going: '' });
  }

  get #destined() { return this.#wish.tick ?? this.#session?.state.tick ?? this.run.state?.tick ?? 0; }
  get #atEnd() { return this.#wish.tick === null && this.run.state?.stage === 'done' && this.run.phase !== 'failed'; }
}
