// The preview of a drag and the pace of a film, with a pretended mesher and clock.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { shownOf } from '../../web/run/follow.js';
import { dwellOf, Pace } from '../../web/run/pace.js';
import { Preview } from '../../web/run/preview.js';
import { expectedTicks, stageName } from '../../web/run/words.js';
import { presets } from '../../web/sketch/presets.js';

const [{ project: plate }] = presets;
const sized = (size) => ({ ...plate, options: { size } });

/** A mesher that finishes when it is told to. */
function slowEngine() {
  const begun = [];
  let running = 0;
  const engine = {
    most: 0, begun,
    async ready() {},
    start: (domain, { size }) => new Promise((resolve, reject) => {
      engine.most = Math.max(engine.most, ++running);
      const session = {
        state: { stage: 'clean' },
        async step() { this.state = { stage: 'done' }; },
        snapshot: async () => ({ size, stage: 'clean', quads: {} }),
        async dispose() { --running; },
      };
      begun.push({ size, finish: () => resolve(session), fail: () => { --running; reject(new Error('no')); } });
    }),
  };
  return engine;
}
const ticks = async (count = 20) => { for (let i = 0; i < count; ++i) await new Promise(setImmediate); };

test('previews are made one at a time, of the newest', async () => {
  const engine = slowEngine();
  const preview = new Preview(async () => engine);
  for (const size of [0.5, 0.6, 0.7, 0.8]) preview.ask(sized(size));
  await ticks();
  engine.begun[0].finish();
  await ticks();
  assert.equal(preview.shown.frame.size, 0.5);
  assert.deepEqual(engine.begun.map(({ size }) => size), [0.5, 0.8]);
  engine.begun[1].fail();  // the old one stays
  await ticks();
  assert.equal(preview.shown.frame.size, 0.5);
  preview.ask(sized(0.9));
  await ticks();
  preview.clear();
  engine.begun[2].finish();
  await ticks();
  assert.equal(preview.shown.frame, null);
  assert.equal(engine.most, 1);
});

test('only the mesh of the drawing itself is shown as current', () => {
  const frame = { stage: 'done' }, result = { report: {} }, other = sized(0.2);
  const run = { frame, frameOf: plate, result, state: frame };
  const none = { project: null, frame: null }, preview = { project: other, frame: { stage: 'clean' } };
  assert.deepEqual([shownOf(plate, run, none).freshness, shownOf(plate, run, none).result], ['current', result]);
  assert.equal(shownOf({ ...plate, layers: ['quads'] }, run, preview).freshness, 'current');
  assert.deepEqual([shownOf(other, run, none).freshness, shownOf(other, run, none).result], ['old', null]);
  assert.deepEqual([shownOf(other, run, preview).freshness, shownOf(other, run, preview).frame], ['preview', preview.frame]);
  assert.equal(shownOf(plate, { ...run, frame: { stage: 'match' } }, none).result, null);
});

test('a film takes some seconds, whatever the iterations, the speed and the frames', () => {
  const states = (iterations) => [
    { stage: 'seeds' }, ...Array.from({ length: iterations + 1 }, (_, iteration) => ({ stage: 'optimise', iteration })),
    ...['match', 'clean', 'patch', 'smooth', 'check'].map((stage) => ({ stage })),
  ].map((state) => ({ iteration: 0, maxIterations: iterations, ...state }));
  for (const [iterations, speed, frame] of [[80, 1, 16], [300, 1, 16], [80, 4, 16], [80, 1, 120], [20, 1, 7]]) {
    let time = 0, at = 0;
    const all = states(iterations), pace = new Pace(() => time);
    pace.begin();
    while (at < all.length - 1 && time < 60000) {
      time += frame;
      at = Math.min(all.length - 1, at + pace.take(all[at], speed));
    }
    const seconds = time / 1000 * speed;
    assert.ok(seconds > 2.5 && seconds < 6, `${iterations} iterations, speed ${speed}, ${frame} ms: ${seconds} s`);
  }
  assert.ok(dwellOf({ stage: 'optimise', iteration: 5, maxIterations: 100000 }) > 0);
});

test('stages have plain names, and the way to go is guessed from where one is', () => {
  assert.equal(stageName({ stage: 'optimise', iteration: 12, maxIterations: 80 }), 'cells settle: iteration 12 of 80');
  assert.equal(stageName({ stage: 'optimise', iteration: 0, maxIterations: 80 }), 'triangles');
  const history = [{ tick: 13, stage: 'optimise', iteration: 12, maxIterations: 80 }];
  assert.ok(expectedTicks({ history, result: null }) > 80);
  assert.equal(expectedTicks({ history: [{ tick: 90, stage: 'done' }], result: {} }), 90);
  assert.equal(expectedTicks({ history: [], result: null }), 0);
});
