// Calls of the worker that end early, cross each other, or outlive their worker. Where the order of messages
// matters, the worker is a fake one that answers when the test says so.
import assert from 'node:assert/strict';
import { EventEmitter } from 'node:events';
import { after, test } from 'node:test';

import { createLpquad, createLpquadWorker, dist, errorOf, meshHash, plate, rejectionOf, square } from './support.mjs';

const { LpquadWorker } = await import(dist('client.js'));
const { serve } = await import(dist('worker-thread.js'));
const lpquad = await createLpquad();
const options = { size: 0.1, method: 'paper', iterations: 20 };
const long = { size: 0.004, method: 'paper' };  // many seconds
const many = { size: 0.03, method: 'paper' };   // many ticks
const remote = createLpquadWorker();
after(() => remote.terminate());
const wait = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));
const turn = () => wait(0);

/** A client and its workers, of which each keeps what it was sent; they are up, and answer nothing else. */
function fakes() {
  const workers = [];
  const client = new LpquadWorker(({ message, lost }) => {
    const worker = { sent: [], ended: false, lost, answer: message, ops: () => worker.sent.map(({ op }) => op) };
    workers.push(worker);
    worker.find = (op) => worker.sent.findLast((sent) => sent.op === op);
    return {
      post(sent) {
        worker.sent.push(structuredClone(sent));
        if (sent.op === 'create') queueMicrotask(() => message({ id: sent.id, value: {} }));
      },
      terminate() { worker.ended = true; },
    };
  }, {});
  return { client, workers };
}

/** The session of a fake worker. */
async function opened(client, worker) {
  const starting = client.start(square);
  await turn();
  const { id } = worker().find('start');
  worker().answer({ id, value: { session: id, state: { tick: 0, stage: 'seeds' } } });
  return starting;
}

test('a session that was disposed of says so, as the direct one does', async () => {
  const session = await remote.start(square, options);
  const local = lpquad.start(square, options);
  local.dispose();
  await session.dispose();
  let said;
  try { local.step(); } catch (error) { said = error.message; }
  for (const use of [() => session.step(), () => session.restore(0), () => session.snapshot(), () => session.finish(),
    () => session.clone(), () => session.run().next()])
    assert.equal((await rejectionOf('BAD_OPTION', use())).message, said);
  // Also under way.
  for (const use of [(s) => s.step(1e6), (s) => s.finish()]) {
    const other = await remote.start(plate, many);
    const refused = rejectionOf('BAD_OPTION', use(other));
    await other.dispose();
    assert.equal((await refused).message, said);
  }
});

test('what onProgress throws comes out of the call, and the run ends', async () => {
  const mine = new RangeError('mine');
  let calls = 0;
  const onProgress = () => {
    ++calls;
    throw mine;
  };
  const isMine = (error) => error === mine;
  await assert.rejects(remote.meshDomain(plate, long, { onProgress }), isMine);
  const corner = { points: [[0, 0, 0], [1, 0, 0], [0, 1, 0]], triangles: [[0, 1, 2]] };
  await assert.rejects(remote.meshSurface(corner, { size: 0.1 }, { onProgress }), isMine);
  const session = await remote.start(plate, options);
  await assert.rejects(session.step(1e6, { onProgress }), isMine);
  assert.equal(meshHash(await session.finish()), meshHash(lpquad.meshDomain(plate, options)));
  await session.dispose();
  assert.equal(calls, 3);
});

test('onProgress ends a run with false, as that of the direct call does, and its session goes on', async () => {
  await rejectionOf('CANCELLED', remote.meshDomain(plate, long, { onProgress: () => false }));
  const session = await remote.start(plate, { ...options, memory: false });
  await rejectionOf('CANCELLED', session.finish({ onProgress: () => false }));
  assert.equal(meshHash(await session.finish()), meshHash(lpquad.meshDomain(plate, options)));
  await session.dispose();
});

test('a control that is none is refused', async () => {
  for (const control of [{ singal: new AbortController().signal }, 'x', [], { onprogress() {} }])
    await rejectionOf('BAD_OPTION', remote.meshDomain(square, {}, control));
  const session = await remote.start(square);
  for (const wrong of [null, 'x', { evry: 2 }]) await rejectionOf('BAD_OPTION', session.run(wrong).next());
  await rejectionOf('BAD_OPTION', session.step(1, { singal: 1 }));
  await session.dispose();
  await rejectionOf('BAD_OPTION', remote.meshDomain(square, {}, { onProgress: 5 }));
  await rejectionOf('BAD_OPTION', remote.meshDomain(square, {}, { signal: {} }));
});

test('options that an object has from another reach the worker', async () => {
  const mesh = await remote.meshDomain(square, Object.create({ size: 0.25 }));
  assert.equal(mesh.report.quads, 16);
  await rejectionOf('BAD_OPTION', remote.meshDomain(square, []));
});

test('options are judged as by the direct call, and a run that would never end is refused', async () => {
  for (const wrong of [null, 5, 'fine', [1], { memory: true }, { size: 'x' }]) {
    const { message } = errorOf('BAD_OPTION', () => lpquad.meshDomain(square, wrong));
    assert.equal((await rejectionOf('BAD_OPTION', remote.meshDomain(square, wrong))).message, message);
  }
  for (const wrong of [null, 5, 'fine', { memory: 5 }]) {
    const { message } = errorOf('BAD_OPTION', () => lpquad.start(square, wrong));
    assert.equal((await rejectionOf('BAD_OPTION', remote.start(square, wrong))).message, message);
  }
  const session = await remote.start(square);
  for (const every of [0, -1, 1.5]) await rejectionOf('BAD_OPTION', session.run({ every }).next());
  await session.dispose();
});

test('a buffer that was transferred is named, also where it does not cross', async () => {
  const gone = Float64Array.of(0, 0, 1, 0, 1, 1);
  structuredClone(gone, { transfer: [gone.buffer] });
  const named = async (words, call) => assert.match((await rejectionOf('PARSE_ERROR', call)).message, new RegExp(`^${words} .*transferred`));
  await named('The file', remote.readDomain(gone.buffer, { name: 'a.json' }));
  await named('domain\\.loops\\[0\\]', remote.meshDomain({ loops: [gone] }));
  await named('options\\.sizes', remote.meshDomain(square, { sizes: gone }));
});

test('after an abort there is no progress', async () => {
  const { client, workers } = fakes();
  const controller = new AbortController();
  let told = 0;
  const run = client.meshDomain(square, {}, { signal: controller.signal, onProgress: () => ++told });
  await turn();
  const { id } = workers[0].find('meshDomain');
  workers[0].answer({ id, progress: {} });
  controller.abort();
  await rejectionOf('CANCELLED', run);
  workers[0].answer({ id, progress: {} });
  assert.equal(told, 1);
});

test('whoever calls while a cancelled run goes on gets a fresh worker', async () => {
  const { client, workers } = fakes();
  const controller = new AbortController();
  const runs = [1, 2].map(() => client.meshDomain(square, {}, { signal: controller.signal }));
  await turn();
  controller.abort();
  for (const run of runs) await rejectionOf('CANCELLED', run);
  const domain = { loops: [[0, 0, 1, 0, 1, 1]] };
  const next = client.meshDomain(domain);
  domain.loops = [];
  const second = new AbortController();
  const dropped = client.writeMesh({}, 'obj');
  const other = client.meshDomain(square, { size: 3 }, { signal: second.signal });
  second.abort();
  await rejectionOf('CANCELLED', other);
  while (workers.length < 2) await turn();
  assert.ok(workers[0].ended);
  await turn();
  assert.deepEqual(workers[1].ops(), ['create', 'meshDomain', 'writeMesh']);
  assert.equal(workers[1].find('meshDomain').domain.loops.length, 1);
  workers[1].answer({ id: workers[1].find('meshDomain').id, value: 'mesh' });
  assert.equal(await next, 'mesh');
  const lost = rejectionOf('WORKER_LOST', dropped);
  client.terminate();
  await lost;
});

test('a cancelled run that stops in time keeps its worker, and what waited is sent', async () => {
  const { client, workers } = fakes();
  const controller = new AbortController();
  const run = client.meshDomain(square, {}, { signal: controller.signal });
  await turn();
  controller.abort();
  await rejectionOf('CANCELLED', run);
  const next = client.writeMesh({}, 'obj');
  workers[0].answer({ id: workers[0].find('meshDomain').id, error: { code: 'CANCELLED', message: '' } });
  await turn();
  workers[0].answer({ id: workers[0].find('writeMesh').id, value: 'text' });
  assert.equal(await next, 'text');
  await wait(120);
  assert.deepEqual([workers.length, workers[0].ended], [1, false]);
  // What waits ends with the worker.
  const again = new AbortController();
  void client.meshDomain(square, {}, { signal: again.signal }).catch(() => {});
  await turn();
  again.abort();
  const waiting = rejectionOf('WORKER_LOST', client.writeMesh({}, 'obj'));
  client.terminate();
  await waiting;
});

test('open sessions and other calls keep the worker of a cancelled run', async () => {
  const { client, workers } = fakes();
  const session = await opened(client, () => workers[0]);
  const controller = new AbortController();
  const run = client.meshDomain(square, {}, { signal: controller.signal });
  await turn();
  controller.abort();
  await rejectionOf('CANCELLED', run);
  const step = session.step();
  await wait(120);
  assert.deepEqual([workers.length, workers[0].ended], [1, false]);
  const { id } = workers[0].find('step');
  workers[0].answer({ id, value: { tick: 1, stage: 'seeds' } });
  assert.equal((await step).tick, 1);
  // With the last session closed nobody needs it.
  await session.dispose();
  const next = client.writeMesh({}, 'obj');
  next.catch(() => {});
  while (workers.length < 2) await turn();
  assert.ok(workers[0].ended);
  client.terminate();
});

test('a session of a worker that went does not count for the next', async () => {
  const { client, workers } = fakes();
  const old = await opened(client, () => workers[0]);
  workers[0].lost('It went.');
  const session = await opened(client, () => workers[1]);
  await old.dispose();
  assert.ok(!workers[1].ops().includes('dispose'));
  const controller = new AbortController();
  const run = client.meshDomain(square, {}, { signal: controller.signal });
  await turn();
  controller.abort();
  await rejectionOf('CANCELLED', run);
  await wait(120);
  assert.ok(!workers[1].ended);
  await rejectionOf('BAD_OPTION', old.step());
  const step = session.step();
  await turn();
  workers[1].answer({ id: workers[1].find('step').id, value: { tick: 1, stage: 'seeds' } });
  assert.equal((await step).tick, 1);
});

test('sessions of a terminated worker start none', async () => {
  const { client, workers } = fakes();
  const [one, other] = [await opened(client, () => workers[0]), await opened(client, () => workers[0])];
  client.terminate();
  await one.dispose();
  await rejectionOf('WORKER_LOST', other.step());
  await turn();
  assert.equal(workers.length, 1);
});

test('a start that was aborted leaves no session behind', async () => {
  let open = 0;
  let resume;
  const slow = {
    async startSurface() {
      await new Promise((resolve) => (resume = resolve));
      ++open;
      return { state: {}, dispose: () => --open };
    },
  };
  const client = new LpquadWorker(({ message }) => {
    const hear = serve({ postMessage: message }, async () => slow);
    return { post: hear, terminate() {} };
  }, {});
  const controller = new AbortController();
  const starting = client.startSurface({}, {}, { signal: controller.signal });
  await turn();
  controller.abort();
  await rejectionOf('CANCELLED', starting);
  resume();
  await turn();
  assert.equal(open, 0);
});

test('terminating a worker that starts does not end the next one', async () => {
  const client = createLpquadWorker();
  const ready = rejectionOf('WORKER_LOST', client.ready());
  client.terminate();
  assert.equal((await client.meshDomain(square, { size: 0.25 })).report.quads, 16);
  await ready;
  client.terminate();
});

test('a call takes what it is given as it is then, while the worker starts too', async () => {
  const client = createLpquadWorker();
  const domain = { loops: [[0, 0, 1, 0, 1, 1, 0, 1]] };
  const mesh = client.meshDomain(domain, { size: 0.25 });
  domain.loops[0][2] = 5;
  assert.equal((await mesh).report.quads, 16);
  client.terminate();
});

test('an abort while the worker starts ends that call only', async () => {
  const client = createLpquadWorker();
  const controller = new AbortController();
  const dropped = rejectionOf('CANCELLED', client.meshDomain(plate, long, { signal: controller.signal }));
  const kept = client.meshDomain(square, { size: 0.25 });
  controller.abort();
  await dropped;
  assert.equal((await kept).report.quads, 16);
  client.terminate();
});

test('a session that was finished is done, and a loop that was left can be gone on with', async () => {
  const session = await remote.start(plate, options);
  for await (const { tick } of session.run({ layers: {} })) if (tick === 3) break;
  assert.equal(session.state.tick, 3);
  assert.equal(meshHash(await session.finish()), meshHash(lpquad.meshDomain(plate, options)));
  assert.equal(session.state.stage, 'done');
  assert.equal((await session.run().next()).done, true);
  await session.dispose();
});

test('calls that cross each other in one session all come back', async () => {
  const session = await remote.start(plate, options);
  const [first, second, mesh] = await Promise.all([session.step(3), session.step(4), session.finish()]);
  assert.ok(first.tick >= 3 && second.tick >= 4);
  assert.equal(meshHash(mesh), meshHash(lpquad.meshDomain(plate, options)));
  await session.dispose();
});

test('a worker that cannot be made, or that cannot be read, is told of', async () => {
  const mine = new Error('none here');
  const none = createLpquadWorker({ worker: () => { throw mine; } });
  const isMine = (error) => error === mine;
  await assert.rejects(none.ready(), isMine);
  await assert.rejects(none.meshDomain(square), isMine);
  await rejectionOf('BAD_OPTION', createLpquadWorker({ worker: () => null }).ready());
  for (const wrong of [null, 5, [], { wasmurl: 'x' }, { worker: 5 }]) errorOf('BAD_OPTION', () => createLpquadWorker(wrong));
  const thread = Object.assign(new EventEmitter(), { postMessage() {}, terminate() {}, ref() {}, unref() {} });
  const client = createLpquadWorker({ worker: () => thread });
  const lost = rejectionOf('WORKER_LOST', client.meshDomain(square));
  thread.emit('messageerror', new Error('unreadable'));
  await lost;
});
