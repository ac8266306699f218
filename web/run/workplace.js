// The worker of one runner: made when it is needed, made again after a failure, and ended if what is
// no longer wanted does not finish soon.
/** @import { LpquadWorker, WorkerSession } from 'lpquad/worker' */

const patience = 50;  // milliseconds to finish in

const wait = (/** @type {number} */ milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));

export class Workplace {
  /** @type {() => Promise<LpquadWorker>} */
  #create;
  /** @type {Promise<LpquadWorker> | undefined} */
  #engine;
  /** The library was loaded. */
  ready = false;
  /** When what was left is out of the way. @type {Promise<unknown>} */
  free = Promise.resolve();

  /** @param {() => Promise<LpquadWorker>} create */
  constructor(create) {
    this.#create = create;
  }

  engine() {
    this.#engine ??= this.#create().then((engine) => {
      this.ready = true;
      return engine;
    }, (cause) => {
      this.#engine = undefined;
      const message = `The mesher could not be loaded: ${cause.message}.`;
      throw Object.assign(new Error(message, { cause }), { code: 'NOT_LOADED' });
    });
    return this.#engine;
  }

  /** What is under way, in this session if there is one yet, is not wanted any more.
   * @param {Promise<void>} work  @param {WorkerSession | null} session */
  leave(work, session) {
    this.free = Promise.all([this.free, this.#end(work, session)]);
  }

  /** @param {Promise<void>} work  @param {WorkerSession | null} session */
  async #end(work, session) {
    if (!this.ready) return;
    const engine = await this.engine();
    const late = await Promise.race([work.then(() => false), wait(patience).then(() => true)]);
    if (late) engine.terminate();
    else await session?.dispose?.().catch(() => {});
  }

  /** Ends the worker; the next call would start another. */
  close() {
    void this.#engine?.then((engine) => engine.terminate(), () => {});
  }
}
