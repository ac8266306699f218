import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { Worker } from 'node:worker_threads';

import { createLpquad, createLpquadWorker, dist, LpquadError, meshHash, plate, rejectionOf, sha256, square } from './support.mjs';

const lpquad = await createLpquad();
const options = { size: 0.1, method: 'paper', iterations: 20 };
const long = { size: 0.004, method: 'paper' };  // many seconds
const generous = 5000;  // ms: says "not until the end", on whatever machine

/** The newest thread of a client, for deeds its API has no name for. */
let thread = null;
const spawn = () => (thread = new Worker(new URL('worker-entry-node.js', dist(''))));
const remote = createLpquadWorker({ worker: spawn });
after(() => remote.terminate());

async function timed(promise) {
  const start = performance.now();
  await promise;
  return performance.now() - start;
}

test('the worker says what the library says', async () => {
  const said = await remote.ready();
  for (const name of ['version', 'build', 'options', 'surfaceOptions', 'writeOptions', 'errorCodes', 'meshFormats', 'domainFormats',
    'surfaceFormats', 'surfaceMeshFormats'])
    assert.deepEqual(said[name], lpquad[name]);
});

test('every call gives what the direct call gives', async () => {
  const direct = lpquad.meshDomain(plate, options);
  const mesh = await remote.meshDomain(plate, options);
  assert.equal(meshHash(mesh), meshHash(direct));
  for (const name of Object.keys(direct)) {
    if (name === 'report') continue;
    assert.equal(mesh[name].constructor, direct[name].constructor, name);
    assert.deepEqual(mesh[name], direct[name]);
  }
  const timeless = ({ cpuSeconds, ...report }) => report;
  assert.deepEqual(timeless(mesh.report), timeless(direct.report));
  assert.equal(await remote.writeMesh(mesh, 'obj'), lpquad.writeMesh(direct, 'obj'));
  const text = JSON.stringify(plate);
  assert.deepEqual(await remote.readDomain(text, { format: 'json' }), await lpquad.readDomain(text, { format: 'json' }));
  // What was passed is still there: only results are handed over.
  const typed = { loops: [Float64Array.of(0, 0, 1, 0, 1, 1, 0, 1)] };
  await remote.meshDomain(typed, { size: 0.25, sizes: Float64Array.of(0.5, 0.5, 0.1) });
  assert.equal(typed.loops[0].length, 8);
  const guided = { size: 0.1, guides: [Float64Array.of(0.2, 0.3, 0.8, 0.6), [[0.2, 0.8], [0.4, 0.9]]] };
  assert.equal(meshHash(await remote.meshDomain(typed, guided)), meshHash(lpquad.meshDomain(typed, guided)));
  assert.equal(guided.guides[0].length, 4);
});

test('errors come back whole', async () => {
  const error = await rejectionOf('SELF_INTERSECTION', remote.meshDomain({ loops: [[0, 0, 4, 4, 4, 0, 0, 6]] }));
  assert.deepEqual({ x: error.where.x, y: error.where.y }, { x: 2.4, y: 2.4 });
  assert.match((await rejectionOf('BAD_OPTION', remote.meshDomain(square, { siz: 1 }))).message, /'size'/);
  assert.match((await rejectionOf('PARSE_ERROR', remote.meshDomain({ loops: 5 }))).message, /^domain\.loops /);
});

test('a fault of the library comes back as an error without a code', async () => {
  const { serve } = await import(dist('worker-thread.js'));
  const { LpquadWorker } = await import(dist('client.js'));
  const faulty = { writeMesh() { throw Object.assign(new TypeError('broken'), { code: 'ERR_BROKEN' }); } };
  const client = new LpquadWorker(({ message }) => {
    const hear = serve({ postMessage: message }, async () => faulty);
    return { post: hear, terminate() {} };
  }, {});
  await assert.rejects(client.writeMesh({}, 'obj'), (error) => {
    assert.ok(!(error instanceof LpquadError));
    assert.deepEqual([error.name, error.message, error.code], ['TypeError', 'broken', undefined]);
    return true;
  });
});

test('functions are refused, and the worker lives on', async () => {
  for (const name of ['sizeAt', 'angleAt', 'onProgress'])
    assert.match((await rejectionOf('BAD_OPTION', remote.meshDomain(square, { [name]: () => 1 }))).message,
      /Functions/);
  assert.equal((await remote.meshDomain(square, { size: 0.25 })).report.quads, 16);
});

test('progress arrives in order', async () => {
  const seen = [];
  await remote.meshDomain(plate, { ...options, size: 0.04 }, { onProgress: (p) => seen.push(p) });
  assert.ok(seen.length >= 2);  // the first tick alone, then as many as fit a slice
  assert.ok(seen.every((p, i) => i === 0 || p.tick > seen[i - 1].tick));
  assert.equal(seen.at(-1).stage, 'done');
  assert.deepEqual(Object.keys(seen[0]).sort(), ['energy', 'iteration', 'maxIterations', 'stage', 'tick']);
});

test('an abort is answered at once, and the worker is as good as new', async (t) => {
  const expected = meshHash(lpquad.meshDomain(plate, options));
  for (const delay of [0, 5, 60, 200]) {
    const controller = new AbortController();
    const run = remote.meshDomain(plate, long, { signal: controller.signal });
    run.catch(() => {});
    await new Promise((resolve) => setTimeout(resolve, delay));
    controller.abort('enough');
    const elapsed = await timed(rejectionOf('CANCELLED', run).then((error) => assert.equal(error.cause, 'enough')));
    t.diagnostic(`abort after ${delay} ms answered in ${elapsed.toFixed(1)} ms`);
    assert.ok(elapsed < generous);
    assert.equal(meshHash(await remote.meshDomain(plate, options)), expected);
  }
  await rejectionOf('CANCELLED', remote.meshDomain(plate, options, { signal: AbortSignal.abort() }));
});

test('an abort ends its own run only', async () => {
  const controller = new AbortController();
  const kept = remote.meshDomain(plate, options);
  const dropped = remote.meshDomain(plate, long, { signal: controller.signal });
  controller.abort();
  await rejectionOf('CANCELLED', dropped);
  assert.equal(meshHash(await kept), meshHash(lpquad.meshDomain(plate, options)));
});

test('sessions step, go back, show, copy and end', async () => {
  const session = await remote.start(plate, options);
  const local = lpquad.start(plate, options);
  assert.deepEqual(session.state, local.state);
  assert.deepEqual(await session.step(8), local.step(8));
  const points = async () => sha256((await session.snapshot({ triangles: true })).triangles.points);
  const at8 = await points();
  const copy = await session.clone();
  await session.step(6);
  assert.notEqual(await points(), at8);
  assert.equal((await session.restore(8)).tick, 8);
  assert.equal(await points(), at8);
  const expected = meshHash(local.finish());
  assert.equal(meshHash(await session.finish()), expected);
  await session.dispose();
  await session.dispose();
  assert.equal(meshHash(await copy.finish()), expected);
  await rejectionOf('BAD_OPTION', copy.step(-1));
  await rejectionOf('BAD_OPTION', copy.snapshot({ none: true }));
  await copy.dispose();
  await rejectionOf('BAD_OPTION', copy.step());
  local.dispose();
});

test('a run is an async iterator of snapshots', async () => {
  const session = await remote.start(plate, options);
  const ticks = [];
  for await (const snapshot of session.run({ layers: { triangles: true }, every: 5 })) {
    ticks.push(snapshot.tick);
    assert.ok(snapshot.triangles.points.length > 0);
    assert.equal(snapshot.quads, undefined);
  }
  assert.ok(ticks.length > 4 && ticks.every((tick, i) => i === 0 || tick > ticks[i - 1]));
  assert.equal(session.state.stage, 'done');
  await session.restore(2);
  const controller = new AbortController();
  await assert.rejects(async () => {
    for await (const snapshot of session.run({ signal: controller.signal }))
      if (snapshot.tick === 4) controller.abort();
  }, { code: 'CANCELLED' });
  // The session outlives its run.
  assert.equal(meshHash(await session.finish()), meshHash(lpquad.meshDomain(plate, options)));
  await session.dispose();
});

test('a killed worker is replaced, and whoever waited is told', async () => {
  const session = await remote.start(plate, options);
  const waiting = rejectionOf('WORKER_LOST', remote.meshDomain(plate, long));
  await new Promise((resolve) => setTimeout(resolve, 50));
  const killed = thread;
  await killed.terminate();
  await waiting;
  assert.equal((await remote.meshDomain(square, { size: 0.25 })).report.quads, 16);
  assert.notEqual(thread, killed);
  await rejectionOf('WORKER_LOST', session.step());
  await session.dispose().catch(() => {});
});

test('terminate ends what runs; the next call starts anew', async () => {
  const waiting = rejectionOf('WORKER_LOST', remote.meshDomain(plate, long));
  await new Promise((resolve) => setTimeout(resolve, 20));
  remote.terminate();
  await waiting;
  assert.equal((await remote.meshDomain(square, { size: 0.25 })).report.quads, 16);
});

test('addresses and modules reach the worker; bad ones are refused each time', async () => {
  const { readFileSync } = await import('node:fs');
  const bytes = readFileSync(dist('lpquad-plain.wasm'));
  for (const source of [{ wasmUrl: dist('lpquad-plain.wasm') }, { wasmBinary: bytes },
    { wasmModule: await WebAssembly.compile(bytes) }]) {
    const other = createLpquadWorker(source);
    assert.equal((await other.ready()).build, 'custom');
    assert.equal(meshHash(await other.meshDomain(plate, options)), meshHash(lpquad.meshDomain(plate, options)));
    other.terminate();
  }
  const bad = createLpquadWorker({ wasmUrl: dist('index.js') });
  for (let i = 0; i < 2; ++i) await rejectionOf('BAD_WASM', bad.meshDomain(square));
});
