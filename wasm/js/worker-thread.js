// Runs inside the worker: {id, op, ...} in, {id, value | error} and {id, progress} out. Long work
// advances in steps of about 20 ms, between which messages are heard; so a cancel takes effect.
import { checkWhole } from './checks.js';
import { disposed, LpquadError } from './errors.js';

const sliceMilliseconds = 20;

/**
 * @param {object} port          postMessage(message, transfer)
 * @param {(source: object) => Promise<any>} createLpquad
 * @returns {(message: any) => void}  what to call with every message
 */
export function serve(port, createLpquad) {
  const server = new Server(port, createLpquad);
  return async (message) => {
    const { id, op } = message;
    if (op === 'cancel') {
      if (server.open.has(id)) server.cancelled.add(id);
      return;
    }
    server.open.add(id);
    try {
      const value = await server.answer(op, message);
      port.postMessage({ id, value }, buffersOf(value));
    } catch (error) {
      port.postMessage({ id, error: portable(error) }, []);
    } finally {
      server.open.delete(id);
      server.cancelled.delete(id);
    }
  };
}

/** What each `op` of a message does, the message's other members being its arguments. */
const operations = {
  async create(server, { source }) {
    server.lpquad = await server.createLpquad(source);
    return { ...server.lpquad };  // what it says about itself; private members stay
  },
  meshDomain: (server, { id, domain, options, withProgress }) =>
    server.complete(id, server.lpquad.start(domain, withoutMemory(options)), withProgress),
  meshSurface: async (server, { id, surface, options, withProgress }) =>
    server.complete(id, await server.lpquad.startSurface(surface, options), withProgress),
  start: (server, { id, domain, options }) => server.keep(id, server.lpquad.start(domain, options)),
  startSurface: async (server, { id, surface, options }) =>
    server.keep(id, await server.lpquad.startSurface(surface, options)),
  async step(server, { id, session, count, withProgress }) {
    checkWhole(count, 'The number of ticks');
    const run = server.find(session);
    await server.advance(id, run, count, withProgress);
    return run.state;
  },
  restore: (server, { session, tick }) => server.find(session).restore(tick),
  snapshot: (server, { session, layers }) => server.find(session).snapshot(layers),
  async finish(server, { id, session, withProgress }) {
    const run = server.find(session);
    await server.advance(id, run, Infinity, withProgress);
    return { mesh: run.finish(), state: run.state };
  },
  clone: (server, { id, session }) => server.keep(id, server.find(session).clone()),
  dispose(server, { session }) {
    server.sessions.get(session)?.dispose();
    server.sessions.delete(session);
  },
  readSurface: ({ lpquad }, { bytes, options }) => lpquad.readSurface(bytes, options),
  isSurfaceFile: ({ lpquad }, { bytes, options }) => lpquad.isSurfaceFile(bytes, options),
  readDomain: ({ lpquad }, { bytes, options }) => lpquad.readDomain(bytes, options),
  writeMesh: ({ lpquad }, { mesh, format, options }) => lpquad.writeMesh(mesh, format, options),
};

class Server {
  sessions = new Map();
  /** Numbers of the calls that have no answer yet, and of those that are to end. */
  open = new Set();
  cancelled = new Set();
  lpquad;
  /** What was asked for meanwhile waits for it. */
  created;

  constructor(port, createLpquad) {
    this.port = port;
    this.createLpquad = createLpquad;
  }

  async answer(op, message) {
    if (op === 'create') return (this.created = operations.create(this, message));
    await this.created;
    this.checkCancelled(message.id);
    return operations[op](this, message);
  }

  checkCancelled(id) {
    if (this.cancelled.has(id)) throw new LpquadError('CANCELLED', 'The run was cancelled.');
  }

  /**
   * A session is known by the number of the call that made it: no other call ever has it, not even in the
   * next worker.
   */
  keep(id, session) {
    this.sessions.set(id, session);
    return { session: id, state: session.state };
  }

  find(number) {
    const session = this.sessions.get(number);
    if (!session) throw disposed();
    return session;
  }

  /** Ticks until the end or `count`, with progress and breaths between. */
  async advance(id, session, count, withProgress) {
    let done = 0, slice = 1;
    while (done < count && session.state.stage !== 'done') {
      this.checkCancelled(id);
      const start = performance.now();
      const { gradientNorm, tau, ...progress } = session.step(Math.min(slice, count - done));
      done += slice;
      const elapsed = performance.now() - start;
      slice = Math.max(1, Math.min(64, Math.round(slice * sliceMilliseconds / (elapsed + 1))));
      if (withProgress) this.port.postMessage({ id, progress }, []);
      await breath();
    }
  }

  /** A whole run, by a session of its own. */
  async complete(id, session, withProgress) {
    try {
      await this.advance(id, session, Infinity, withProgress);
      return session.finish();
    } finally {
      session.dispose();
    }
  }
}

/** For a session that stands for a plain call, which has no such option. */
function withoutMemory(options) {
  if (options === null || typeof options !== 'object') return options;
  if ('memory' in options) throw new LpquadError('BAD_OPTION', 'There is no option \'memory\'.');
  return { ...options, memory: false };
}

/** Lets the worker hear its messages. Not setTimeout: nested, it waits 4 ms. */
function breath() {
  return new Promise((resolve) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      resolve(undefined);
    };
    port2.postMessage(null);
  });
}

/** Results are handed over, not copied again. */
function buffersOf(value, found = new Set()) {
  if (ArrayBuffer.isView(value)) found.add(value.buffer);
  else if (value && typeof value === 'object')
    for (const member of Object.values(value)) buffersOf(member, found);
  return [...found];
}

/** Errors lose their class on the way: only those of the library have a code and a place. */
function portable(error) {
  const { name, message } = error;
  return error instanceof LpquadError ? { code: error.code, message, where: error.where } : { name, message };
}
