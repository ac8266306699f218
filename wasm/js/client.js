// The other side of worker-thread.js: the same API as promises. A worker that does not answer a
// cancel in time is replaced, if nobody else needs it; of one that died the callers are told.
import { checkFunction, checkNames, checkOptions } from './checks.js';
import { disposed, LpquadError } from './errors.js';
import { checkAllLive } from './lists.js';

const patience = 80;  // milliseconds a cancelled run may take to notice, before its worker goes

/**
 * @typedef {object} Call  one that has no answer yet
 * @property {number} id
 * @property {Promise<any>} answer
 * @property {(value: any) => void} resolve
 * @property {(error: unknown) => void} reject
 * @property {(progress: any) => void} [onProgress]
 * @property {boolean} dropped  its caller has been told, and the worker is to end it
 * @property {object | null} waiting  what is still to be sent
 */

export class LpquadWorker {
  #spawn;
  #source;
  #worker = null;
  #ready = null;
  /** @type {Map<number, Call>} */
  #calls = new Map();
  /** Numbers of the sessions that are open in this very worker. */
  #sessions = new Set();
  #nextId = 1;

  /**
   * @param {(handlers: {message: (m: any) => void, lost: (reason: string) => void}) =>
   *   {post: (m: any) => void, terminate: () => void, busy?: (busy: boolean) => void}} spawn
   */
  constructor(spawn, source) {
    this.#spawn = spawn;
    this.#source = source;
  }

  /** Starts the worker, unless it runs; resolves to what the library says about itself. */
  ready() {
    try {
      this.#begin();
    } catch (error) {
      return Promise.reject(error);
    }
    return this.#ready;
  }

  #begin() {
    if (this.#worker !== null) return;
    const generation = {};
    const current = () => this.#worker?.generation === generation;
    const worker = this.#spawn({
      message: (message) => this.#receive(message),
      lost: (reason) => { if (current()) this.#lose(new LpquadError('WORKER_LOST', reason)); },
    });
    this.#worker = { ...worker, generation };
    this.#ready = this.#send({ op: 'create', source: this.#source }).answer;
    this.#ready.catch((error) => { if (current()) this.#lose(error); });
  }

  /** Nobody waits for what the worker does. */
  get #stuck() {
    const calls = [...this.#calls.values()];
    return this.#sessions.size === 0 && calls.some((call) => call.dropped) &&
      calls.every((call) => call.dropped || call.waiting);
  }

  #receive({ id, value, error, progress }) {
    const call = this.#calls.get(id);
    if (call === undefined) return;
    if (progress !== undefined) return this.#tell(call, progress);
    this.#calls.delete(id);
    const { session } = value ?? {};
    if (session !== undefined) this.#sessions.add(session);
    if (call.dropped && session !== undefined) this.#close(session);
    if (error !== undefined) call.reject(revived(error));
    else call.resolve(value);
    if (this.#stuck) this.#watch();
    else this.#sendWaiting();
    this.#worker?.busy?.(this.#calls.size > 0);
  }

  #tell(call, progress) {
    if (call.dropped) return;
    try {
      if (call.onProgress(progress) === false) this.#drop(call, cancelled());
    } catch (error) {
      this.#drop(call, error);
    }
  }

  #lose(error) {
    const calls = [...this.#calls.values()];
    this.#calls.clear();
    this.#sessions.clear();
    this.#end();
    for (const call of calls) call.reject(error);
  }

  #end() {
    this.#worker?.terminate();
    this.#worker = null;
    this.#ready = null;
  }

  /** What is sent is as it was at the call, whatever becomes of it afterwards. */
  #send(message, onProgress) {
    const id = this.#nextId++;
    /** @type {any} */
    const call = { id, onProgress, dropped: false, waiting: null };
    call.answer = new Promise((resolve, reject) => Object.assign(call, { resolve, reject }));
    const whole = { id, ...message, withProgress: onProgress !== undefined };
    const wait = this.#stuck;
    this.#calls.set(id, call);
    try {
      if (wait) call.waiting = structuredClone(whole);
      else this.#worker.post(whole);
    } catch (cause) {
      this.#calls.delete(id);
      call.reject(unsendable(message, cause));
    }
    this.#worker.busy?.(this.#calls.size > 0);
    return call;
  }

  #sendWaiting() {
    for (const call of this.#calls.values()) {
      if (call.waiting) this.#worker.post(call.waiting);
      call.waiting = null;
    }
  }

  /** One call, with an abort answered at once, whatever the worker does. */
  async #run(op, args, control) {
    const { signal, onProgress } = checkControl(control ?? {});
    if ('options' in args) args = { ...args, options: checkOptions(args.options) };
    if (signal?.aborted) throw cancelled(signal);
    this.#begin();
    const call = this.#send({ op, ...args }, onProgress);
    const stop = () => this.#drop(call, cancelled(signal));
    signal?.addEventListener('abort', stop, { once: true });
    try {
      return await call.answer;
    } finally {
      signal?.removeEventListener('abort', stop);
    }
  }

  /** Tells the caller, and asks the run to end. */
  #drop(call, error) {
    call.reject(error);
    if (call.dropped || !this.#calls.has(call.id)) return;
    if (call.waiting) return void this.#calls.delete(call.id);
    call.dropped = true;
    this.#worker.post({ id: call.id, op: 'cancel' });
    this.#watch();
  }

  /** A worker too busy to hear that its calls are cancelled is replaced, if nobody else needs it. */
  #watch() {
    if (!this.#stuck) return;
    const dropped = [...this.#calls.values()].filter((call) => call.dropped);
    setTimeout(() => {
      if (this.#stuck && dropped.some(({ id }) => this.#calls.has(id))) this.#replace();
    }, patience);
  }

  #replace() {
    for (const { id, dropped } of [...this.#calls.values()]) if (dropped) this.#calls.delete(id);
    this.#end();
    if (this.#calls.size === 0) return;
    try {
      this.#begin();
      this.#sendWaiting();
    } catch (error) {
      this.#lose(error);
    }
  }

  meshDomain(domain, options = {}, control = {}) {
    return this.#run('meshDomain', { domain, options }, control);
  }
  readDomain(source, options = {}) {
    return this.#run('readDomain', { bytes: source, options });
  }
  writeMesh(mesh, format, options = {}) {
    return this.#run('writeMesh', { mesh, format, options });
  }
  readSurface(source, options = {}) {
    return this.#run('readSurface', { bytes: source, options });
  }
  isSurfaceFile(source, options = {}) {
    return this.#run('isSurfaceFile', { bytes: source, options });
  }
  meshSurface(surface, options = {}, control = {}) {
    return this.#run('meshSurface', { surface, options }, control);
  }
  async start(domain, options = {}, control = {}) {
    return this.#adopt(await this.#run('start', { domain, options }, control), RemoteSession);
  }
  async startSurface(surface, options = {}, control = {}) {
    return this.#adopt(await this.#run('startSurface', { surface, options }, control), RemoteRun);
  }

  #adopt({ session, state }, Kind) {
    let open = true;
    const run = async (op, args, control) => {
      if (!open) throw disposed();
      if (!this.#sessions.has(session)) throw new LpquadError('WORKER_LOST', 'This session died with its worker.');
      return this.#run(op, { session, ...args }, control);
    };
    const close = () => {
      open = false;
      this.#close(session);
    };
    return new Kind({ run, close, adopt: (raw) => this.#adopt(raw, Kind) }, state);
  }

  /** Nobody waits for that; it comes before whatever is asked for later. */
  #close(session) {
    if (!this.#sessions.delete(session)) return;
    this.#worker.post({ id: this.#nextId++, op: 'dispose', session });
    this.#watch();
  }

  terminate() {
    if (this.#worker !== null) this.#lose(new LpquadError('WORKER_LOST', 'The worker was terminated.'));
  }
}
if (Symbol.dispose) LpquadWorker.prototype[Symbol.dispose] = LpquadWorker.prototype.terminate;

/** What runs in the worker and goes forwards: a session on a surface. */
class RemoteRun {
  #worker;
  state;
  /** Of run(). */
  get defaultLayers() { return { quads: true }; }

  /** @param {{run: Function, close: Function, adopt: Function}} worker  how to reach it */
  constructor(worker, state) {
    this.#worker = worker;
    this.state = state;
  }

  async step(count = 1, control = {}) {
    this.state = await this.#worker.run('step', { count }, control);
    return this.state;
  }
  snapshot(layers = {}) { return this.#worker.run('snapshot', { layers }); }
  async finish(control = {}) {
    const { mesh, state } = await this.#worker.run('finish', {}, control);
    this.state = state;
    return mesh;
  }

  /** Snapshots after every `every` ticks until the end: `for await (const s of session.run())`. */
  async *run(options = {}) {
    checkNames(options, ['layers', 'every', 'signal'], 'option of run');
    const { layers = this.defaultLayers, every = 1, signal } = options;
    if (every === 0) throw new LpquadError('BAD_OPTION', 'Snapshots come every tick or more, not every 0.');
    while (this.state.stage !== 'done') {
      await this.step(every, { signal });
      yield await this.snapshot(layers);
    }
  }

  async dispose() { this.#worker.close(); }
}

/** A session on a domain: it also goes back, and can be copied. */
class RemoteSession extends RemoteRun {
  #worker;

  constructor(worker, state) {
    super(worker, state);
    this.#worker = worker;
  }

  get defaultLayers() { return { triangles: true, quads: true }; }
  async restore(tick, control) {
    this.state = await this.#worker.run('restore', { tick }, control);
    return this.state;
  }
  async clone() { return this.#worker.adopt(await this.#worker.run('clone', {})); }
}
if (Symbol.asyncDispose) RemoteRun.prototype[Symbol.asyncDispose] = RemoteRun.prototype.dispose;

function checkControl(control) {
  checkNames(control, ['signal', 'onProgress'], 'control of a call');
  const { signal, onProgress } = control;
  if (onProgress !== undefined) checkFunction(onProgress, 'onProgress');
  if (signal && typeof signal.addEventListener !== 'function')
    throw new LpquadError('BAD_OPTION', 'Option signal must be an AbortSignal.');
  return control;
}

/** The error as the direct call throws it: one without a code is a fault, and plain. */
function revived({ name, code, message, where }) {
  return code === undefined ? Object.assign(new Error(message), { name }) : new LpquadError(code, message, where);
}

function cancelled(signal = undefined) {
  return new LpquadError('CANCELLED', 'The run was cancelled.', {}, signal && { cause: signal.reason });
}

/** Why a message cannot be sent, as the direct call says it where it can. */
function unsendable({ op, bytes, ...args }, cause) {
  try {
    checkAllLive(bytes, 'The file');
    for (const [name, value] of Object.entries(args)) checkAllLive(value, name);
  } catch (error) {
    return error;
  }
  return new LpquadError('BAD_OPTION', `This does not cross into a worker (${cause.message}). Functions never do: give ` +
    'sizes as samples, and onProgress and signal as the last argument.', {}, { cause });
}
