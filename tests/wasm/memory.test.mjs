import assert from 'node:assert/strict';
import { test } from 'node:test';

import { circle, errorOf, freshLpquad, meshHash, plate, random, square } from './support.mjs';

const runs = 1000;

// The heap of an instance is private; its memory is seen where it is made.
const memories = [];
const { Memory, instantiate } = WebAssembly;
assert.equal(typeof Memory, 'function');
WebAssembly.instantiate = async (...args) => {
  const result = await instantiate(...args);
  const { exports } = result.instance ?? result;
  memories.push(Object.values(exports).find((value) => value instanceof Memory));
  return result;
};
async function measured() {
  const lpquad = await freshLpquad();
  const memory = memories.at(-1);
  return { lpquad, memory, bytes: () => memory.buffer.byteLength };
}

// Small ones: what leaks does so in every run.
const domains = [[square, { size: 0.2 }], [plate, { size: 0.3, method: 'paper', iterations: 5 }],
  [{ loops: [circle(0, 0, 1, 12)] }, { keepBoundary: true }]];
const pick = (list, next) => list[Math.floor(next() * list.length)];

test(`${runs} runs in one instance leave the heap as it was`, async () => {
  const { lpquad, bytes } = await measured();
  const expected = domains.map(([domain, options]) => meshHash(lpquad.meshDomain(domain, options)));
  const after = [];
  for (let i = 0; i < runs; ++i) {
    const k = i % domains.length;
    const mesh = lpquad.meshDomain(...domains[k]);
    if (i % 50 === 0) {
      lpquad.writeMesh(mesh, 'msh');
      assert.equal(meshHash(mesh), expected[k]);
    }
    if (i % 100 === 99) after.push(bytes());
  }
  assert.equal(after.at(-1), after[0], `heap after every 100 runs: ${after}`);
});

test(`after ${runs} aborts at random moments the next run is that of a fresh instance`, async () => {
  const fresh = await freshLpquad();
  const expected = domains.map(([domain, options]) => meshHash(fresh.meshDomain(domain, options)));
  const { lpquad, bytes } = await measured();
  const next = random(20240607);
  let settled = 0;
  for (let i = 0; i < runs; ++i) {
    const [domain, options] = pick(domains, next);
    const deed = next();
    if (deed < 0.6) {  // a run stopped at some step
      let left = Math.floor(next() * 12);
      try {
        lpquad.meshDomain(domain, { ...options, onProgress: () => left-- > 0 });
      } catch (error) {
        assert.equal(error.code, 'CANCELLED');
      }
    } else if (deed < 0.9) {  // a session dropped at some tick, perhaps after looking and going back
      const session = lpquad.start(domain, options);
      session.step(Math.floor(next() * 8));
      if (next() < 0.3) session.snapshot({ triangles: true, cells: true, crosses: true, quads: true });
      if (next() < 0.3) session.restore(Math.floor(next() * 5));
      const copy = next() < 0.3 ? session.clone() : null;
      session.dispose();
      copy?.dispose();
    } else {  // bad input
      errorOf('SELF_INTERSECTION', () => lpquad.meshDomain({ loops: [[0, 0, 4, 4, 4, 0, 0, 6]] }));
      assert.throws(() => lpquad.meshDomain(domain, { ...options, sizeAt: () => { throw new Error('mine'); } }), /mine/);
    }
    if (i === 300) settled = bytes();
    if (i % 100 === 99) {
      const k = i % domains.length;
      assert.equal(meshHash(lpquad.meshDomain(...domains[k])), expected[k]);
    }
  }
  domains.forEach(([domain, options], k) => assert.equal(meshHash(lpquad.meshDomain(domain, options)), expected[k]));
  assert.equal(bytes(), settled);
});

// Real exhaustion of 4 GB takes minutes: here the memory refuses to grow, as it does when the
// system has none left.
test('running out of memory is an error, and the instance stays usable', async () => {
  const { lpquad, memory, bytes } = await measured();
  const expected = meshHash(lpquad.meshDomain(plate, { size: 0.15 }));
  let refused = 0;
  memory.grow = () => { throw new RangeError('WebAssembly.Memory.grow(): Maximum memory size exceeded'); };
  const before = bytes();
  for (const size of [0.01, 0.006, 0.004, 0.003]) {
    errorOf('OUT_OF_MEMORY', () => lpquad.meshDomain(plate, { size }));
    let session;
    errorOf('OUT_OF_MEMORY', () => {
      session = lpquad.start(plate, { size });
      session.finish();
    });
    session?.dispose();
    ++refused;
    assert.equal(meshHash(lpquad.meshDomain(plate, { size: 0.15 })), expected);
  }
  // Sessions that grow until nothing is left.
  const sessions = [];
  try {
    for (let i = 0; i < 1000; ++i) {
      sessions.push(lpquad.start(plate, { size: 0.04 }));
      sessions.at(-1).step(4);
    }
  } catch (error) {
    assert.equal(error.code, 'OUT_OF_MEMORY', error.stack);
    ++refused;
  }
  assert.equal(refused, 5);
  for (const session of sessions) session.dispose();
  assert.equal(bytes(), before);
  assert.equal(meshHash(lpquad.meshDomain(plate, { size: 0.15 })), expected);
  delete memory.grow;
  assert.ok(lpquad.meshDomain(plate, { size: 0.01 }).report.quads > 10000);
});
