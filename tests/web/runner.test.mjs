// The runner with the real mesher in a worker of Node, and with a pretended one for what only a
// race shows.
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { createLpquadWorker } from '../../dist/worker-node.js';
import { Pace } from '../../web/run/pace.js';
import { Runner } from '../../web/run/runner.js';
import { presets } from '../../web/sketch/presets.js';

const plate = presets[0].project;
const square = presets[1].project;
const engines = [];
after(() => engines.forEach((engine) => engine.terminate()));

/** A clock that goes a tick of the plate's run forth with every picture. */
function quick() {
  let time = 0;
  return { pace: new Pace(() => time), picture: async () => { time += 30; } };
}

async function realEngine() {
  const engine = createLpquadWorker();
  engines.push(engine);
  return engine;
}

function makeRunner(createEngine = realEngine) {
  const runner = new Runner(createEngine, quick());
  runner.wantedLayers = () => ['triangles', 'cells', 'quads'];
  return runner;
}

const pointsOf = ({ frame }) => [...(frame.triangles ?? frame.quads).points].join();
/** Waits until the run is as asked. */
const until = (runner, condition) => new Promise((resolve) => {
  const check = () => { if (condition(runner.run)) { stop(); resolve(); } };
  const stop = runner.subscribe(check);
  queueMicrotask(check);
});

test('plays from triangles to quads, with every iteration seen once and in order', async () => {
  const runner = makeRunner();
  const ticks = [];
  runner.subscribe(({ frame, frameOf }) => { if (frameOf === plate) ticks.push(frame.tick); });
  await runner.load(plate);
  const { phase, result, state, history } = runner.run;
  assert.equal(phase, 'done');
  assert.equal(state.stage, 'done');
  assert.equal(result.triangles.length, 0);
  assert.deepEqual(history.map(({ tick }) => tick), history.map((_, i) => i));
  assert.deepEqual([...ticks].sort((a, b) => a - b), ticks);
});

test('going back shows exactly the points that were there', async () => {
  const runner = makeRunner();
  await runner.load(plate, { going: '' });
  const seen = [];
  for (let tick = 0; tick < 6; ++tick) {
    await runner.step();
    seen.push(pointsOf(runner.run));
  }
  await runner.end();
  for (const tick of [3, 6, 1, 2]) {
    await runner.seek(tick);
    assert.equal(runner.run.frame.tick, tick);
    assert.equal(pointsOf(runner.run), seen[tick - 1]);
    assert.equal(runner.run.phase, 'paused');
  }
  await runner.back();
  assert.equal(runner.run.state.tick, 1);
  await runner.reset();
  assert.equal(runner.run.state.tick, 0);
});

test('the end is the same whichever way it was reached', async () => {
  const [straight, winding] = [makeRunner(), makeRunner()];
  await straight.load(plate, { going: 'end' });
  await winding.load(plate, { going: '' });
  await winding.seek(40);
  await winding.seek(7);
  await winding.step();
  await winding.seek(10000);  // beyond the end
  assert.equal(winding.run.phase, 'done');
  assert.equal(winding.run.result.report.hash, straight.run.result.report.hash);
});

/** Ticks of the pictures that a run to the end takes, by a clock that goes so many milliseconds forth whenever it is read. */
async function looksOf(still, milliseconds) {
  let time = 0;
  const runner = new Runner(realEngine, { pace: new Pace(() => time += milliseconds) }), frames = new Map();
  runner.still = still;
  runner.subscribe(({ frame }) => { if (frame) frames.set(frame.tick, frame); });
  await runner.load(plate, { going: 'end' });
  return [...frames.values()];
}

for (const still of [false, true])
  test(`a stage without a picture gets the triangulation first, and a quick run no other: ${still ? 'still' : 'moving'}`, async () => {
    const [first, last, ...more] = await looksOf(still, 0);
    assert.deepEqual([first.stage, first.iteration, last.stage], ['optimise', 0, 'done']);
    assert.deepEqual(more, []);
  });

test('where motion is unwanted a slow run is seen at a few states, far fewer than else', async () => {
  const [moving, still] = [await looksOf(false, 300), await looksOf(true, 300)];
  assert.ok(still.length > 2, `${still.length} pictures`);
  assert.ok(moving.length >= 2 * still.length, `${moving.length} and ${still.length} pictures`);
});

test('of many places sought at once the last is where it ends', async () => {
  const runner = makeRunner();
  await runner.load(plate, { going: 'end' });
  let pictures = 0;
  runner.subscribe(() => ++pictures);
  for (let tick = 60; tick >= 20; --tick) void runner.seek(tick);
  await runner.seek(33);
  assert.equal(runner.run.frame.tick, 33);
  assert.ok(pictures < 20, `${pictures} changes for 42 places`);
});

test('cancel is answered at once, and play goes on from there', async () => {
  const runner = makeRunner();
  void runner.load(plate);
  await until(runner, ({ state }) => state?.tick >= 5);
  runner.cancel();
  assert.equal(runner.run.phase, 'cancelled');
  const { frame, state } = runner.run;
  await new Promise((resolve) => setTimeout(resolve, 200));
  assert.equal(runner.run.phase, 'cancelled');
  assert.equal(runner.run.frame, frame);
  await runner.step();
  assert.equal(runner.run.state.tick, state.tick + 1);
  await runner.play();
  assert.equal(runner.run.phase, 'done');
});

test('a long stage is cancelled without waiting for it', async () => {
  const runner = makeRunner();
  const long = { ...square, options: { size: 0.004 } };
  void runner.load(long, { going: 'end' });
  await until(runner, ({ state }) => state !== null);
  runner.cancel();
  assert.equal(runner.run.phase, 'cancelled');
  await runner.load(square, { going: 'end' });  // the worker is free again
  assert.equal(runner.run.phase, 'done');
  assert.equal(runner.run.project, square);
});

test('a newer project wins, however quickly it came', async () => {
  const runner = makeRunner();
  const stray = [];
  runner.subscribe(({ project, result, frame, frameOf }) => {
    if (result && frame?.stage === 'done' && frameOf !== project) stray.push(project);
  });
  const sizes = [0.2, 0.15, 0.12, 0.1, 0.09];
  const last = sizes.map((size) => runner.load({ ...square, options: { size } }, { going: 'end' })).at(-1);
  await last;
  assert.equal(runner.run.project.options.size, 0.09);
  assert.equal(runner.run.phase, 'done');
  assert.equal(runner.run.result.report.options.size, 0.09);
  assert.deepEqual(stray, []);
});

test('a worker that dies is replaced, and the run goes on', async () => {
  const runner = makeRunner();
  void runner.load(plate);
  await until(runner, ({ state }) => state?.tick >= 10);
  engines.at(-1).terminate();
  await until(runner, ({ phase }) => phase === 'done' || phase === 'failed');
  assert.equal(runner.run.phase, 'done');
  engines.at(-1).terminate();  // while idle
  await runner.seek(12);
  assert.equal(runner.run.frame.tick, 12);
});

test('an error is told with its place, and the next project runs', async () => {
  const runner = makeRunner();
  const bow = { ...square, drawing: { ...square.drawing, regions: [{ name: '', loops: [[[0, 0], [1, 1], [1, 0], [0, 1]]] }] } };
  await runner.load(bow);
  assert.equal(runner.run.phase, 'failed');
  assert.equal(runner.run.error.code, 'SELF_INTERSECTION');
  assert.ok('x' in runner.run.error.where);
  await runner.load(square, { going: 'end' });
  assert.equal(runner.run.phase, 'done');
  assert.equal(runner.run.error, null);
});

test('anything in any order at any moment ends well', async () => {
  const runner = makeRunner();
  let random = 7;
  const next = (count) => (random = random * 48271 % 2147483647) % count;
  const deeds = ['play', 'pause', 'step', 'back', 'end', 'reset', 'cancel', 'refresh'];
  void runner.load(square);
  for (let i = 0; i < 150; ++i) {
    const deed = next(11);
    if (deed < deeds.length) void runner[deeds[deed]]();
    else if (deed === 8) void runner.seek(next(12));
    else if (deed === 9) void runner.load({ ...square, options: { size: 0.1 + 0.01 * next(5) } }, { going: ['', 'play', 'end'][next(3)] });
    if (next(3) > 0) await new Promise((resolve) => setTimeout(resolve, next(30)));
    assert.notEqual(runner.run.phase, 'failed', runner.run.error?.message);
  }
  const project = { ...square, options: { size: 0.11 } };
  await runner.load(project, { going: 'end' });
  assert.equal(runner.run.phase, 'done');
  assert.equal(runner.run.frameOf, project);
  assert.equal(runner.run.frame.stage, 'done');
});

test('what comes back late for an older project is dropped', async () => {
  const waiting = [];
  const session = (name) => ({
    state: { stage: 'optimise', tick: 0, iteration: 0, maxIterations: 5, energy: 1 },
    async step() { return this.state; },
    async restore() { return this.state; },
    snapshot: () => new Promise((resolve) => waiting.push(() => resolve({ name, ...session(name).state }))),
    async dispose() {},
  });
  const engine = { async ready() {}, terminate() {}, start: async (domain, { size }) => session(size) };
  const runner = makeRunner(async () => engine);
  const [old, fresh] = [1, 2].map((size) => ({ ...square, options: { size } }));
  const first = runner.load(old, { going: '' });
  while (waiting.length < 1) await new Promise(setImmediate);
  const second = runner.load(fresh, { going: '' });
  while (waiting.length < 2) await new Promise((resolve) => setTimeout(resolve, 5));
  waiting[1]();
  await second;
  waiting[0]();
  await first;
  assert.equal(runner.run.frame.name, 2);
  assert.equal(runner.run.frameOf, fresh);
});

test('a mesher that cannot be loaded is tried again when asked', async () => {
  let tries = 0;
  const runner = makeRunner(async () => {
    if (++tries === 1) throw new Error('no network');
    return realEngine();
  });
  await runner.load(square, { going: 'end' });
  assert.equal(runner.run.error.code, 'NOT_LOADED');
  await runner.end();
  assert.equal(runner.run.phase, 'done');
});

test('a project with known faults never reaches the mesher', async () => {
  const runner = makeRunner(async () => assert.fail('called'));
  const error = { code: 'SELF_INTERSECTION', message: 'Two edges cross.', where: { x: 1, y: 2 } };
  runner.refuse(square, error);
  assert.equal(runner.run.error, error);
  await runner.play();
  assert.equal(runner.run.phase, 'failed');
  assert.deepEqual(runner.run.error.where, error.where);
});
