// What lies at a point: the grid against looking at everything; neighbours; and what is told of them.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { anglesOf, describe } from '../../web/draw/describe.js';
import { holds } from '../../web/draw/grid.js';
import { areaOfFace, centred, cornersOfFace, elementAt, faceAt, middleOfFace, neighbourOf, rowsOfKind } from '../../web/draw/hit.js';
import { circle, sceneOf, square, withLayers } from './recorder.mjs';

const plate = sceneOf([square.map(([x, y]) => [2 * x, y]), circle(1, 0.5, 0.22, 32)], { size: 0.08, method: 'paper', seeds: 'isotropic' });
const layerOf = { quad: 'quads', pair: 'matching', cell: 'cells', triangle: 'triangles' };
const grid = (n) => Array.from({ length: n * n }, (_, k) => [-0.1 + 2.2 * ((k % n) + 0.37) / n, -0.1 + 1.2 * (Math.floor(k / n) + 0.61) / n]);

test('the face at a point is the one found by looking at all', () => {
  for (const [kind, layer] of Object.entries(layerOf)) {
    const scene = withLayers(plate.scene, layer), rows = rowsOfKind(scene, kind);
    for (const at of grid(60)) {
      let wanted = -1;
      for (let f = 0; f + 1 < rows.offsets.length && wanted < 0; ++f) if (holds(rows, f, ...at)) wanted = f;
      assert.equal(faceAt(scene, at)?.index ?? -1, wanted, `${kind} at ${at}`);
    }
  }
});

test('every quad is found at its middle, and what is told is what the library says', () => {
  const scene = withLayers(plate.scene, 'quads'), { quads } = plate.scene.frame, rows = rowsOfKind(scene, 'quad');
  for (let f = 0; 4 * f < quads.quads.length; ++f) {
    const at = middleOfFace(rows, f);
    if (faceAt(scene, at)?.index !== f) continue;  // the mean of the corners of a concave one may lie outside
    const told = Object.fromEntries(describe(scene, faceAt(scene, at)).rows);
    assert.equal(told['η'], quads.eta[f].toFixed(4));
    assert.equal(told.valences, [...quads.quads.subarray(4 * f, 4 * f + 4)].map((v) => quads.valence[v]).join('  '));
    const angles = anglesOf(cornersOfFace(rows, f));
    assert.ok(Math.abs(angles.reduce((sum, angle) => sum + angle, 0) - 2 * Math.PI) < 1e-9);
    const eta = Math.max(0, 1 - 2 / Math.PI * Math.max(...angles.map((angle) => Math.abs(Math.PI / 2 - angle))));
    assert.ok(Math.abs(eta - quads.eta[f]) < 1e-6, `${eta} ${quads.eta[f]}`);
    assert.ok(Number(told['size / wanted']) > 0.1 && Number(told['size / wanted']) < 4);
  }
});

test('energies of the cells sum up to that of the run', () => {
  const scene = withLayers(plate.scene, 'cells'), { cells } = plate.scene.frame, rows = rowsOfKind(scene, 'cell');
  let sum = 0;
  for (let i = 0; i < cells.sites.length; ++i) sum += cells.density[cells.sites[i]] * areaOfFace(rows, i);
  assert.ok(Math.abs(sum / cells.energy - 1) < 1e-9);
});

test('a triangle tells its partner and what the pair costs', () => {
  const scene = withLayers(plate.scene, 'triangles'), { matching } = plate.scene.frame;
  const told = Object.fromEntries(describe(scene, { kind: 'triangle', index: 5, at: [0, 0] }).rows);
  assert.match(told.partner, new RegExp(`triangle ${matching.mates[5]}`));
  assert.ok(Math.abs(Number(told.cost) - matching.costs[5] / 1e4) <= 0.005 * Math.abs(matching.costs[5] / 1e4));
});

test('marks come before lines, lines before faces', () => {
  const { quads, crosses } = plate.scene.frame;
  const irregular = quads.excess.findIndex((excess, v) => excess !== 0 && v >= quads.boundaryNodes);
  const at = [quads.points[2 * irregular], quads.points[2 * irregular + 1]];
  const pixel = 1 / plate.view.scale;
  assert.deepEqual(elementAt(withLayers(plate.scene, 'quads', 'valence'), at, pixel), { kind: 'vertex', index: irregular, at });
  assert.equal(elementAt(withLayers(plate.scene, 'crosses'), [...crosses.singularities.slice(0, 2)], pixel).kind, 'singularity');
  assert.equal(elementAt(withLayers(plate.scene, 'boundary', 'triangles'), [0.5, pixel], pixel).kind, 'edge');
  assert.equal(elementAt(withLayers(plate.scene, 'triangles'), [0.5, pixel], pixel).kind, 'triangle');
  assert.equal(elementAt(withLayers(plate.scene, 'sizes'), [0.5, 0.5], pixel).kind, 'place');
  assert.equal(elementAt(withLayers(plate.scene), [0.5, 0.5], pixel), null);
  assert.equal(elementAt({ ...plate.scene, frame: null, layers: new Set(['quads', 'crosses', 'sizes', 'cells']) }, [0.5, 0.5], pixel), null);
});

test('the tag of an edge is told', () => {
  const drawing = { regions: [{ name: 'steel', loops: [square], tags: [['', 'inlet', '', '']] }], polylines: [], points: [] };
  const scene = { ...withLayers(plate.scene, 'boundary'), drawing };
  const told = Object.fromEntries(describe(scene, elementAt(scene, [1, 0.4], 0.01)).rows);
  assert.equal(told.tag, 'inlet');
  assert.equal(told.region, 'steel');
});

test('one walks right through the mesh and round a hole', () => {
  for (const [kind, layer] of Object.entries(layerOf)) {
    const scene = withLayers(plate.scene, layer);
    let element = centred(scene, faceAt(scene, [0.05, 0.5])), steps = 0;
    assert.equal(element.kind, kind);
    for (let next; (next = neighbourOf(scene, element, 1, 0)) && steps < 500; ++steps) {
      assert.notEqual(next.index, element.index);
      element = next;
    }
    assert.ok(element.at[0] > 1.85, `${kind} ended at ${element.at} after ${steps}`);
  }
  const scene = withLayers(plate.scene, 'quads'), { points } = plate.scene.frame.quads;
  const start = points.findIndex((_, i) => i % 2 === 0 && Math.hypot(points[i] - 0.3, points[i + 1] - 0.5) < 0.06) / 2;
  const next = neighbourOf(scene, { kind: 'vertex', index: start, at: [points[2 * start], points[2 * start + 1]] }, 0, 1);
  assert.ok(next && next.kind === 'vertex' && next.at[1] > points[2 * start + 1]);
});
