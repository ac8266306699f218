import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { createLpquad } from '../../dist/node.js';
import { figuresOf, iterationOf, iteratesOf, qualityOf, reported } from '../../web/figures/statistics.js';
import { presets } from '../../web/sketch/presets.js';
import { toCall } from '../../web/state/project.js';

const lpquad = await createLpquad();
const { domain, options } = toCall(presets[0].project);

test('what is counted on the screen is what the library reports', () => {
  const session = lpquad.start(domain, options);
  const { report } = session.finish();
  const live = qualityOf(session.snapshot({ quads: true }).quads);
  const final = reported(report);
  for (const key of Object.keys(live)) assert.deepEqual(live[key], final[key], key);
  assert.equal(figuresOf({ frame: { stage: 'done' }, result: { report } }).hash, report.hash);
  session.dispose();
});

test('the curve holds what was seen, at the end all', () => {
  const session = lpquad.start(domain, { ...options, iterations: 7 });
  const history = [session.state];
  while (session.state.stage !== 'done') history.push(session.step());
  const seen = iteratesOf({ history, result: null });
  assert.deepEqual(seen.iterates.map(({ iteration }) => iteration), [0, 1, 2, 3, 4, 5, 6]);
  assert.equal(history[seen.first].iteration, 0);
  assert.equal(history[seen.first + 3].iteration, 3);
  const { report } = session.finish();
  const all = iteratesOf({ history, result: { report } });
  assert.equal(all.iterates.length, 8);
  for (const { iteration, energy, gradientNorm } of seen.iterates) {
    assert.equal(all.iterates[iteration].energy, energy);
    assert.equal(all.iterates[iteration].gradientNorm, gradientNorm);
  }
  assert.equal(iterationOf(history.at(-1), all.iterates), 7);
  assert.equal(iterationOf(history[0], all.iterates), 0);
  session.dispose();
});

test('without an L_p stage there is no curve, and no mesh has no figures', () => {
  const session = lpquad.start(domain, { size: 0.2 });
  const history = [session.state, session.step()];
  assert.deepEqual(iteratesOf({ history, result: null }).iterates, []);
  assert.deepEqual(figuresOf({ frame: null, result: null }), { final: false });
  session.dispose();
});
