// The other side of worker-thread.js: the same API as promises. A worker that does not answer a
// cancel in time, or that died, is replaced; callers of other runs are told.
import { LpquadError } from './errors.js';

const patience = 80;  // milliseconds a cancelled run may take to notice, before its worker goes

export class LpquadWorker {
  #spawn;
  #source;
  #worker = null;
  #calls = new Map();
  #sessions = 0;
  #nextId = 1;
  #ready = null;

  /**
   * @param {(handlers: {message: (m: any) => void, lost: (reason: string) => void}) =>
   *   {post: (m: any, transfer?: Transferable[]) => void, terminate: () => void,
   *    busy?: (busy: boolean) => void}} spawn
   */
  constructor(spawn, source) {
    this.#spawn = spawn;
    this.#source = source;
  }

  /** Starts the worker, unless it runs; resolves to what the library says about itself. */
  ready() {
    if (this.#ready === null) {
      const generation = {};
      const worker = this.#spawn({
        message: (message) => this.#receive(message),
        lost: (reason) => { if (this.#worker?.generation === generation) this.#lose(reason); },
      });
      this.#worker = { ...worker, generation };
      this.#ready = this.#send('create', { source: this.#source });
      this.#ready.catch(() => this.terminate());
    }
    return this.#ready;
  }

  #receive({ id, value, error, progress }) {
    const call = this.#calls.get(id);
    if (call === undefined) return;
    if (progress !== undefined) return call.onProgress?.(progress);
    this.#calls.delete(id);
    this.#worker?.busy?.(this.#calls.size > 0);
    if (error !== undefined) call.reject(revived(error));
    else call.resolve(value);
  }

  #lose(reason) {
    const calls = [...this.#calls.values()];
    this.#calls.clear();
    this.#worker?.terminate();
    this.#worker = null;
    this.#ready = null;
    this.#sessions = 0;
    for (const call of calls) call.reject(new LpquadError('WORKER_LOST', reason));
  }

  #send(op, args, { onProgress, transfer } = {}) {
    const id = this.#nextId++;
    return Object.assign(new Promise((resolve, reject) => {
      this.#calls.set(id, { resolve, reject, onProgress });
      this.#worker.busy?.(true);
      try {
        this.#worker.post({ id, op, ...args, withProgress: onProgress !== undefined }, transfer);
      } catch (cause) {
        this.#calls.delete(id);
        this.#worker.busy?.(this.#calls.size > 0);
        reject(new LpquadError('BAD_OPTION',
          `This does not cross into a worker (${cause.message}). Functions never do: give sizes as ` +
          'samples, and onProgress and signal as the last argument.', {}, { cause }));
      }
    }), { id });
  }

  async #call(op, args, control) {
    await this.ready();
    if (control.signal?.aborted) throw cancelled(control.signal);
    const sent = this.#send(op, args, control);
    control.id = sent.id;
    return sent;
  }

  /** One call, with an abort answered at once, whatever the worker does. */
  async #run(op, args, options = {}) {
    const control = { ...options, id: 0 };
    const { signal } = control;
    if (signal?.aborted) throw cancelled(signal);
    const work = this.#call(op, args, control);
    if (!signal) return work;
    work.catch(() => {});
    let stop;
    const aborted = new Promise((_, reject) => {
      stop = () => {
        if (this.#calls.has(control.id)) this.#cancel(control.id);
        reject(cancelled(signal));
      };
      signal.addEventListener('abort', stop, { once: true });
    });
    try {
      return await Promise.race([work, aborted]);
    } finally {
      signal.removeEventListener('abort', stop);
    }
  }

  /** Asks the run to end; a worker too busy to hear it is replaced, if nobody else needs it. */
  #cancel(id) {
    this.#worker?.post({ id, op: 'cancel' });
    setTimeout(() => {
      if (!this.#calls.has(id)) return;
      if (this.#sessions === 0 && this.#calls.size === 1) this.#lose('The run was cancelled.');
    }, patience);
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
    ++this.#sessions;
    const lost = () => { this.#sessions = Math.max(0, this.#sessions - 1); };
    const run = (op, args, control) => this.#run(op, { session, ...args }, control);
    return new Kind({ run, lost, adopt: (raw) => this.#adopt(raw, Kind) }, state);
  }

  terminate() {
    if (this.#worker !== null) this.#lose('The worker was terminated.');
  }
}
if (Symbol.dispose) LpquadWorker.prototype[Symbol.dispose] = LpquadWorker.prototype.terminate;

/** What runs in the worker and goes forwards: a session on a surface. */
class RemoteRun {
  #worker;
  #disposed = false;
  state;
  /** Of run(). */
  get defaultLayers() { return { quads: true }; }

  /** @param {{run: Function, lost: Function, adopt: Function}} worker  how to reach it */
  constructor(worker, state) {
    this.#worker = worker;
    this.state = state;
  }

  async step(count = 1, control = {}) {
    this.state = await this.#worker.run('step', { count }, control);
    return this.state;
  }
  snapshot(layers = {}) { return this.#worker.run('snapshot', { layers }); }
  finish(control) { return this.#worker.run('finish', {}, control); }

  /** Snapshots after every `every` ticks until the end: `for await (const s of session.run())`. */
  async *run({ layers = this.defaultLayers, every = 1, signal } = {}) {
    while (this.state.stage !== 'done') {
      await this.step(every, { signal });
      yield await this.snapshot(layers);
    }
  }

  async dispose() {
    if (this.#disposed) return;
    this.#disposed = true;
    this.#worker.lost();
    await this.#worker.run('dispose', {});
  }
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

/** The error as the direct call throws it: one without a code is a fault, and plain. */
function revived({ name, code, message, where }) {
  return code === undefined ? Object.assign(new Error(message), { name }) : new LpquadError(code, message, where);
}

function cancelled(signal) {
  return new LpquadError('CANCELLED', 'The run was cancelled.', {}, { cause: signal.reason });
}
