import assert from 'node:assert/strict';
import { test } from 'node:test';
import { createLpquad } from '../../dist/node.js';
import { problemsOf } from '../../web/sketch/crossings.js';
import { fixesFor, placeOf } from '../../web/sketch/errors/fixes.js';
import { titleOf } from '../../web/sketch/errors/words.js';
import { circle } from '../../web/sketch/model/shapes.js';
import { emptyProject, toCall } from '../../web/state/project.js';

const lib = await createLpquad();
const square = (x, y, side) => [[x, y], [x + side, y], [x + side, y + side], [x, y + side]];
const region = (...loops) => ({ name: '', loops });
const project = (drawing, options = {}, more = {}) =>
  ({ ...emptyProject, drawing: { regions: [], polylines: [], points: [], ...drawing }, options, ...more });
const one = (loops, options, more) => project({ regions: [region(...loops)] }, options, more);

/** What the page says about a project: what is seen at once, else what the mesher says. */
function problemOf(of) {
  const [seen] = problemsOf(of.drawing);
  if (seen) return seen;
  try {
    const { domain, options } = toCall(of);
    lib.meshDomain(domain, options);
    return null;
  } catch ({ code, message, where }) {
    return { code, message, where };
  }
}

const odd = [[0, 0], [1, 0], [1, 0.5], [1, 1], [0, 1]];
/** A project for every error that a drawing or its options can have. */
const faults = {
  BAD_OPTION: one([square(0, 0, 1)], { size: 0.2, norm: 1000 }),
  NON_FINITE: one([[[0, 0], [1, 0], [NaN, 0.5], [1, 1], [0, 1]]], { size: 0.2 }),
  EMPTY: project({}),
  TOO_FEW_POINTS: one([square(0, 0, 4), [[1, 1], [1, 1], [1, 1]]], { size: 1 }),
  DUPLICATE_POINT: one([[[0, 0], [0, 0], [1, 0], [1, 1], [0, 1]]], { size: 0.2, strict: true }),
  SELF_INTERSECTION: one([[[0, 0], [1, 1], [1, 0], [0, 1]]], { size: 0.2 }),
  OVERLAPPING_EDGES: one([[[0, 0], [2, 0], [2, 1], [2, 3], [2, 2], [0, 2]]], { size: 0.5 }),
  TOUCHING: one([square(0, 0, 4), [[0, 2], [1, 1.2], [1, 2.8]]], { size: 1 }),
  HOLE_OUTSIDE: one([square(0, 0, 4), square(6, 0, 1)], { size: 1 }),
  NESTED_OR_DUPLICATE_HOLE: one([square(0, 0, 9), square(2, 2, 5), square(4, 4, 1)], { size: 1 }),
  REGION_CONFLICT: project({ regions: [region(square(0, 0, 4)), region(square(1, 1, 1))] }, { size: 0.5 }),
  BAD_SIZE: one([square(0, 0, 1)], { size: 10 }),
  ODD_BOUNDARY: one([odd], { keepBoundary: true }),
  LOST_PRECISION: one([square(1e15, 1e15, 64)], { size: 2 }),
  TOO_MANY_ELEMENTS: one([square(0, 0, 1)], { size: 1e-5 }),
};

test('every error of the library has words of its own and something to do', () => {
  for (const code of [...lib.errorCodes, 'INTERNAL', 'BAD_WASM', 'WORKER_LOST', 'NOT_LOADED'])
    for (const of of [emptyProject, one([square(0, 0, 1), square(0.2, 0.2, 0.3)])])
      for (const where of [{}, { region: 0, loop: 1, edge: 2, x: 0.2, y: 0.2 }, { region: 0 }, { x: NaN, y: 1 }]) {
        assert.ok(titleOf(code).length > 10);
        if (lib.errorCodes.includes(code)) assert.notEqual(titleOf(code), titleOf('INTERNAL'));
        const fixes = fixesFor({ code, message: '', where }, of);
        assert.ok(fixes.length > 0, code);
        for (const fix of fixes) if ('change' in fix) assert.notDeepEqual(fix.change(of), {});
        placeOf({ code, message: '', where }, of);
      }
});

for (const [code, of] of Object.entries(faults))
  test(`the fixes of ${code} mend it`, () => {
    const problem = problemOf(of);
    assert.equal(problem?.code, code);
    const fixes = fixesFor(problem, of).filter((fix) => 'change' in fix);
    assert.ok(fixes.length > 0);
    for (const fix of fixes) {
      const after = problemOf({ ...of, ...fix.change(of) });
      assert.ok(after === null || after.code === 'EMPTY', `${fix.label}: ${after?.code} ${after?.message}`);
    }
  });

test('crossings of loops, regions and lines are mended too', () => {
  const cases = [
    one([square(0, 0, 4), circle(4, 2, 1, 12)], { size: 1 }),
    project({ regions: [region(square(0, 0, 2)), region(square(1, 1, 2))] }, { size: 0.5 }),
    project({ regions: [region(square(0, 0, 2))], polylines: [{ points: [[1, 1], [3, 1.2]], tag: '' }] }, { size: 0.5 }),
    project({ regions: [region(square(0, 0, 2))], points: [{ position: [5, 5], tag: '' }] }, { size: 0.5 }),
    project({ regions: [region(square(0, 0, 2))], points: [{ position: [2, 1], tag: '' }] }, { size: 0.5 }),
  ];
  for (const of of cases) {
    let now = of;
    for (let round = 0; round < 12 && problemOf(now); ++round) {
      const [fix] = fixesFor(problemOf(now), now);
      assert.ok('change' in fix, JSON.stringify(problemOf(now)));
      now = { ...now, ...fix.change(now) };
    }
    assert.equal(problemOf(now), null);
    assert.ok(now.drawing.regions.length > 0);
  }
});

test('nodes come where parts between lines are odd, until all are even', () => {
  const outline = [[0, 0], [1, 0], [2, 0], [4, 0], [4, 3], [2, 3], [0, 3]];
  const cuts = [[[1, 0], [2, 3]], [[1, 0], [0, 3]], [[2, 0], [3, 1], [2, 3]]];
  let now = project({ regions: [region(outline)], polylines: cuts.map((points) => ({ points, tag: '' })) }, { keepBoundary: true });
  let rounds = 0;
  for (; problemOf(now); ++rounds) {
    assert.equal(problemOf(now).code, 'ODD_BOUNDARY');
    assert.ok(rounds < 5);
    now = { ...now, ...fixesFor(problemOf(now), now)[0].change(now) };
  }
  assert.ok(rounds > 0);
});

test('an odd boundary is shown where the node would come', () => {
  const of = faults.ODD_BOUNDARY, problem = problemOf(of);
  assert.deepEqual(placeOf(problem, of), [0.5, 0]);
  assert.deepEqual(fixesFor(problem, of).map(({ label }) => label), ['Add a node here', 'Allow one added point', 'Allow one triangle']);
});
