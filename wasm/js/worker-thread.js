// Runs inside the worker: {id, op, ...} in, {id, value | error} and {id, progress} out. Long work
// advances in steps of about 20 ms, between which messages are heard; so a cancel takes effect.
import { checkWhole } from './checks.js';
import { LpquadError } from './errors.js';

const sliceMilliseconds = 20;

/**
 * @param {object} port          postMessage(message, transfer)
 * @param {(source: object) => Promise<any>} createLpquad
 * @returns {(message: any) => void}  what to call with every message
 */
export function serve(port, createLpquad) {
  const sessions = new Map();
  const cancelled = new Set();
  let lpquad;

  /** Ticks until the end, `count` or `stop`, with progress and breaths between. */
  async function advance(id, session, count, withProgress) {
    let done = 0, slice = 1;
    while (done < count && session.state.stage !== 'done') {
      if (cancelled.has(id)) throw new LpquadError('CANCELLED', 'The run was cancelled.');
      const start = performance.now();
      const { gradientNorm, tau, ...progress } = session.step(Math.min(slice, count - done));
      done += slice;
      const elapsed = performance.now() - start;
      slice = Math.max(1, Math.min(64, Math.round(slice * sliceMilliseconds / (elapsed + 1))));
      if (withProgress) port.postMessage({ id, progress }, []);
      await breath();
    }
  }

  /** A whole run, by a session of its own. */
  async function complete(id, session, withProgress) {
    try {
      await advance(id, session, Infinity, withProgress);
      return session.finish();
    } finally {
      session.dispose();
    }
  }

  const find = (number) => {
    const session = sessions.get(number);
    if (!session) throw new LpquadError('WORKER_LOST', 'This session died with its worker.');
    return session;
  };

  const operations = {
    async create({ source }) {
      lpquad = await createLpquad(source);
      return { ...lpquad };  // what it says about itself; private members stay
    },
    meshDomain: ({ id, domain, options, withProgress }) =>
      complete(id, lpquad.start(domain, { ...options, memory: false }), withProgress),
    meshSurface: async ({ id, surface, options, withProgress }) =>
      complete(id, await lpquad.startSurface(surface, options), withProgress),
    // A session is known by the number of the call that made it: no other call ever has it, not
    // even in the next worker.
    start({ id, domain, options }) {
      sessions.set(id, lpquad.start(domain, options));
      return { session: id, state: find(id).state };
    },
    async startSurface({ id, surface, options }) {
      sessions.set(id, await lpquad.startSurface(surface, options));
      return { session: id, state: find(id).state };
    },
    async step({ id, session, count, withProgress }) {
      checkWhole(count, 'The number of ticks');
      await advance(id, find(session), count, withProgress);
      return find(session).state;
    },
    restore: ({ session, tick }) => find(session).restore(tick),
    snapshot: ({ session, layers }) => find(session).snapshot(layers),
    async finish({ id, session, withProgress }) {
      await advance(id, find(session), Infinity, withProgress);
      return find(session).finish();
    },
    clone({ id, session }) {
      sessions.set(id, find(session).clone());
      return { session: id, state: find(id).state };
    },
    dispose({ session }) {
      sessions.get(session)?.dispose();
      sessions.delete(session);
    },
    readSurface: ({ bytes, options }) => lpquad.readSurface(bytes, options),
    isSurfaceFile: ({ bytes, options }) => lpquad.isSurfaceFile(bytes, options),
    readDomain: ({ bytes, options }) => lpquad.readDomain(bytes, options),
    writeMesh: ({ mesh, format, options }) => lpquad.writeMesh(mesh, format, options),
  };

  return async (message) => {
    const { id, op } = message;
    if (op === 'cancel') {
      cancelled.add(id);
      return;
    }
    try {
      const value = await operations[op](message);
      port.postMessage({ id, value }, buffersOf(value));
    } catch (error) {
      port.postMessage({ id, error: portable(error) }, []);
    } finally {
      cancelled.delete(id);
    }
  };
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

function portable(error) {
  return { code: error.code ?? 'INTERNAL', message: error.message, where: error.where ?? {} };
}
