import assert from 'node:assert/strict';
import { test } from 'node:test';
import { findMeetings, problemsOf } from '../../web/sketch/crossings.js';
import { orient } from '../../web/sketch/model/orient.js';

const domain = (...loops) => ({ regions: [{ name: '', loops }], polylines: [], points: [] });
const square = (x, y, side) => [[x, y], [x + side, y], [x + side, y + side], [x, y + side]];

/** A generator of its own, so that failures come again. */
function random(seed) {
  let state = seed >>> 0;
  return () => ((state = (Math.imul(state, 1664525) + 1013904223) >>> 0) / 2 ** 32);
}

// Whole numbers: plain arithmetic is exact.
const side = ([ax, ay], [bx, by], [cx, cy]) => Math.sign((ax - cx) * (by - cy) - (ay - cy) * (bx - cx));
const within = (a, b, c) => side(a, b, c) === 0 && Math.min(a[0], b[0]) <= c[0] && c[0] <= Math.max(a[0], b[0])
  && Math.min(a[1], b[1]) <= c[1] && c[1] <= Math.max(a[1], b[1]);
const equal = (p, q) => p[0] === q[0] && p[1] === q[1];

/** The kind of meeting of two edges of one region, by looking at every case. */
function bruteKind([a, b], [c, d]) {
  const common = [a, b].filter((p) => equal(p, c) || equal(p, d)).length;
  if (common === 2) return 'overlap';
  if (common === 1) {
    const [p] = [a, b].filter((q) => !equal(q, c) && !equal(q, d)), [q] = [c, d].filter((r) => !equal(r, a) && !equal(r, b));
    return within(a, b, q) || within(c, d, p) ? 'overlap' : null;
  }
  const ends = [c, d].filter((p) => within(a, b, p)).length + [a, b].filter((p) => within(c, d, p)).length;
  if (ends > 1 && side(a, b, c) === 0 && side(a, b, d) === 0) return 'overlap';
  if (ends > 0) return 'touch';
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0 ? 'crossing' : null;
}

function bruteForce(loops) {
  const edges = loops.flatMap((loop, l) => loop.map((p, i) => ({ loop: l, edge: i, ends: [p, loop[(i + 1) % loop.length]] })))
    .filter(({ ends: [a, b] }) => !equal(a, b));
  const found = [];
  for (let i = 0; i < edges.length; ++i)
    for (let k = i + 1; k < edges.length; ++k) {
      const kind = bruteKind(edges[i].ends, edges[k].ends);
      if (kind) found.push(`${kind} ${edges[i].loop}.${edges[i].edge} ${edges[k].loop}.${edges[k].edge}`);
    }
  return found.sort();
}

test('finds what comparing every edge with every other finds', () => {
  const next = random(7);
  let met = 0;
  for (let round = 0; round < 400; ++round) {
    const range = 4 + Math.floor(next() * 40);
    const point = () => [Math.floor(next() * range), Math.floor(next() * range)];
    const loops = Array.from({ length: 1 + Math.floor(next() * 3) }, () => Array.from({ length: 3 + Math.floor(next() * 4) }, point));
    const expected = bruteForce(loops);
    const found = findMeetings(domain(...loops)).filter(({ kind }) => kind !== 'corner')
      .map(({ kind, one, two }) => `${kind} ${one.loop}.${one.edge} ${two.loop}.${two.edge}`).sort();
    assert.deepEqual(found, expected, JSON.stringify(loops));
    met += expected.length;
  }
  assert.ok(met > 1000);
});

test('a valid drawing has no problems, nor has one with a shared edge or a line that ends on a corner', () => {
  assert.deepEqual(problemsOf(domain(square(0, 0, 4), square(1, 1, 1))), []);
  const pair = { regions: [{ name: 'a', loops: [square(0, 0, 1)] }, { name: 'b', loops: [square(1, 0, 1)] }],
    polylines: [{ points: [[0, 0], [0.5, 0.5]], tag: '' }], points: [] };
  assert.deepEqual(problemsOf(pair), []);
  assert.deepEqual(problemsOf({ regions: [], polylines: [], points: [] }), []);
});

test('says what is wrong, where, with the code of the library', () => {
  const [bow] = problemsOf(domain([[0, 0], [1, 1], [1, 0], [0, 1]]));
  assert.equal(bow.code, 'SELF_INTERSECTION');
  assert.deepEqual(bow.where, { region: 0, loop: 0, edge: 0, otherLoop: 0, otherEdge: 2, x: 0.5, y: 0.5 });
  assert.equal(problemsOf(domain(square(0, 0, 4), square(4, 1, 1)))[0].code, 'OVERLAPPING_EDGES');
  assert.equal(problemsOf(domain(square(0, 0, 4), [[0, 2], [1, 1], [1, 3]]))[0].code, 'TOUCHING');
  assert.equal(problemsOf(domain(square(0, 0, 4), [[0, 0], [2, 1], [1, 2]]))[0].code, 'TOUCHING');
  const apart = { regions: [{ name: '', loops: [square(0, 0, 2)] }, { name: '', loops: [square(1, 1, 2)] }], polylines: [], points: [] };
  assert.equal(problemsOf(apart)[0].code, 'REGION_CONFLICT');
  const line = { ...domain(square(0, 0, 2)), polylines: [{ points: [[1, 1], [3, 1]], tag: '' }] };
  assert.equal(problemsOf(line)[0].code, 'SELF_INTERSECTION');
});

test('sides of nearly straight triples are exact', () => {
  assert.equal(Math.sign(orient(0.1, 0.1, 0.3, 0.3, 0.2, 0.2)), 0);
  const up = 0.2 + 2 ** -54 * 2;
  assert.ok(up > 0.2);
  assert.equal(Math.sign(orient(0.1, 0.1, 0.3, 0.3, 0.2, up)), 1);
  assert.equal(Math.sign(orient(0.3, 0.3, 0.1, 0.1, 0.2, up)), -1);
});

test('what is not a number is left to the library', () => {
  assert.deepEqual(findMeetings(domain([[0, 0], [NaN, 1], [1, 0], [Infinity, 2]])), []);
});

test('edges are named as the library names them', () => {
  const one = { name: 'steel', loops: [square(0, 0, 2)] }, two = { name: '', loops: [square(1, 1, 2)] };
  const named = (drawing) => problemsOf(drawing).map(({ message }) => message);
  assert.match(named({ regions: [one, two], polylines: [], points: [] })[0], /^The edge 1 of loop 0 of region 0 \(steel\) and the edge 0 of loop 0 of region 1 cross\.$/);
  assert.match(named({ regions: [one], polylines: [{ points: [[1, 1], [3, 1.2]], tag: '' }], points: [] })[0], /^The edge 1 of loop 0 and the edge 0 of polyline 0 cross\.$/);
});
