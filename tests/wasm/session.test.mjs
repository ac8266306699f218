import assert from 'node:assert/strict';
import { test } from 'node:test';

import { createLpquad, errorOf, meshHash, plate, sha256, square } from './support.mjs';

const lpquad = await createLpquad();
const options = { size: 0.1, method: 'paper', iterations: 12 };
const pointsHash = (session) => sha256(session.snapshot({ triangles: true }).triangles.points);

test('a session visits every stage and ends where the direct call does', () => {
  const session = lpquad.start(plate, options);
  const stages = [session.state.stage];
  while (session.state.stage !== 'done') {
    const before = session.state.tick;
    assert.deepEqual(session.step(), session.state);
    assert.equal(session.state.tick, before + 1);
    if (stages.at(-1) !== session.state.stage) stages.push(session.state.stage);
  }
  assert.deepEqual(stages, ['seeds', 'optimise', 'match', 'clean', 'check', 'done']);
  const mesh = session.finish();
  const direct = lpquad.meshDomain(plate, options);
  assert.equal(meshHash(mesh), meshHash(direct));
  assert.equal(mesh.report.hash, direct.report.hash);
  assert.deepEqual(Object.keys(mesh).sort(), Object.keys(direct).sort());
  // Past the end nothing moves.
  const { tick } = session.state;
  assert.equal(session.step(5).tick, tick);
  session.dispose();
});

test('going back shows exactly the same points', () => {
  const session = lpquad.start(plate, options);
  const seen = new Map([[0, pointsHash(session)]]);
  while (session.state.stage !== 'done') {
    session.step();
    seen.set(session.state.tick, pointsHash(session));
  }
  assert.ok(new Set(seen.values()).size > 12);
  const final = meshHash(session.finish());
  const order = [...seen.keys()].sort((a, b) => (a * 7) % 11 - (b * 7) % 11 || a - b);
  for (const tick of order) {
    assert.equal(session.restore(tick).tick, tick);
    assert.equal(pointsHash(session), seen.get(tick), `tick ${tick}`);
  }
  session.restore(3);
  assert.equal(meshHash(session.finish()), final);
  session.dispose();
});

test('a clone lives on by itself', () => {
  const session = lpquad.start(plate, options);
  session.step(5);
  const copy = session.clone();
  const at = pointsHash(copy);
  session.step(4);
  assert.equal(pointsHash(copy), at);
  const final = meshHash(session.finish());
  session.dispose();
  assert.equal(meshHash(copy.finish()), final);
  copy.restore(2);
  copy.dispose();
});

test('layers are consistent with each other', () => {
  const session = lpquad.start(plate, options);
  session.step(4);
  const moving = session.snapshot({ cells: true });
  assert.ok(moving.energy > 0 && Math.abs(moving.cells.energy - moving.energy) < 1e-9 * moving.energy);
  while (session.state.stage !== 'match') session.step();
  const all = { triangles: true, cells: true, crosses: true, sizes: true, matching: true, quads: true };
  const before = session.snapshot(all);
  assert.equal(before.quads.quads.length, 0);
  assert.equal(before.matching.mates.length, 0);
  const { triangles, cells, crosses, sizes } = before;
  assert.ok(triangles.points.every((x) => x >= 0 && x <= 2));
  assert.ok(triangles.triangles.every((v) => v < triangles.points.length / 2));
  assert.equal(cells.offsets.length, cells.sites.length + 1);
  assert.equal(cells.offsets.at(-1), cells.points.length / 2);
  assert.equal(cells.density.length, triangles.points.length / 2);
  // The clipped cells of all vertices tile the domain: 2 x 1 without a polygon of 24 corners.
  let area = 0;
  for (let i = 0; i + 1 < cells.offsets.length; ++i)
    for (let k = cells.offsets[i], n = cells.offsets[i + 1], last = n - 1; k < n; last = k++)
      area += (cells.points[2 * last] * cells.points[2 * k + 1] - cells.points[2 * k] * cells.points[2 * last + 1]) / 2;
  const hole = 12 * 0.04 * Math.sin((2 * Math.PI) / 24);
  assert.ok(Math.abs(area - (2 - hole)) < 1e-9, `${area}`);
  assert.ok(cells.energy > 0 && cells.energy < moving.energy);
  assert.equal(crosses.points.length, crosses.axes.length);
  for (let i = 0; i < crosses.axes.length; i += 2)
    assert.ok(Math.abs(Math.hypot(crosses.axes[i], crosses.axes[i + 1]) - 1) < 1e-9);
  assert.equal(crosses.singularities.length, 2 * crosses.indices.length);
  assert.equal(sizes.sizes.length, sizes.points.length / 2);
  assert.ok(sizes.sizes.every((h) => h > 0));

  session.step();
  const { matching, quads, ...rest } = session.snapshot({ matching: true, quads: true });
  assert.deepEqual(Object.keys(rest).sort(), Object.keys(session.state).sort());
  matching.mates.forEach((mate, t) => assert.ok(mate === -1 || matching.mates[mate] === t));
  assert.equal(quads.eta.length, quads.quads.length / 4 + quads.triangles.length / 3);
  assert.equal(quads.valence.length, quads.points.length / 2);
  session.finish();
  const { quads: done } = session.snapshot({ quads: true });
  assert.equal(quads.triangles.length, 0);
  assert.ok(done.eta.every((eta) => eta > 0 && eta <= 1 + 1e-12));
  session.dispose();
});

test('a disposed session says so, and disposing twice is nothing', () => {
  const session = lpquad.start(square, { size: 0.2 });
  session.dispose();
  session.dispose();
  for (const use of [() => session.step(), () => session.state, () => session.finish(), () => session.clone(),
    () => session.restore(0), () => session.snapshot()])
    assert.match(errorOf('BAD_OPTION', use).message, /disposed/);
  if (Symbol.dispose) {
    const other = lpquad.start(square, { size: 0.2 });
    other[Symbol.dispose]();
    errorOf('BAD_OPTION', () => other.state);
  }
});

test('wrong ticks and layers are refused, without harm', () => {
  const session = lpquad.start(square, { size: 0.2 });
  for (const ticks of [-1, 1.5, NaN, Infinity, '3', null, 2n, 2 ** 40]) {
    errorOf('BAD_OPTION', () => session.step(ticks));
    errorOf('BAD_OPTION', () => session.restore(ticks));
  }
  errorOf('BAD_OPTION', () => session.restore());
  assert.match(errorOf('BAD_OPTION', () => session.snapshot({ triangle: true })).message, /'triangle'/);
  errorOf('BAD_OPTION', () => lpquad.start(square, { onProgress: () => {} }));
  errorOf('BAD_OPTION', () => lpquad.start(square, { size: 'x' }));
  errorOf('EMPTY', () => lpquad.start({ loops: [] }));
  assert.equal(session.finish().report.quads, 25);
  session.dispose();
});

test('without memory there is no way back', () => {
  const session = lpquad.start(plate, { ...options, memory: false });
  session.step(6);
  errorOf('BAD_OPTION', () => session.restore(2));
  assert.equal(meshHash(session.finish()), meshHash(lpquad.meshDomain(plate, options)));
  session.dispose();
});

test('a caller\'s function is asked on in a session, and its exceptions come through', () => {
  let fail = false;
  const mine = new Error('mine');
  const sizeAt = (x) => {
    if (fail) throw mine;
    return 0.1 + 0.05 * x;
  };
  const session = lpquad.start(plate, { ...options, sizeAt });
  const copy = session.clone();
  const hash = meshHash(session.finish());
  assert.equal(meshHash(copy.finish()), hash);
  assert.equal(meshHash(lpquad.meshDomain(plate, { ...options, sizeAt })), hash);
  fail = true;
  assert.throws(() => lpquad.start(plate, { ...options, sizeAt }), (error) => error === mine);
  session.dispose();
  copy.dispose();
});
