// The parts of the page for surfaces that need no page: numbers for the graphics card, charts side by
// side, surfaces by formula, links.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { createLpquad } from '../../dist/node.js';
import { light } from '../../web/draw/palette.js';
import { sourceOf, toCommand, toJavaScript } from '../../web/space/model/code.js';
import { fromFragment, presetWork, problemOf, toFragment } from '../../web/space/model/link.js';
import { areaOf, boxOf, inOrder, sizeFor } from '../../web/space/model/work.js';
import { presets, surfaceOf } from '../../web/space/presets/presets.js';
import {
  cellColours, crossLines, edgesOfQuads, gather, irregularOnFeatures, irregularVertices, meshOfCells, parts, qualityColours, trianglesOfQuads,
} from '../../web/space/view/geometry.js';
import { layOut, quadsInPlanes } from '../../web/space/view/layout.js';
import { nextChart, pick } from '../../web/space/view/planes.js';
import { portionAfter, shareOf } from '../../web/space/run/runner.js';
import { describe } from '../../web/run/words.js';
import { messageInWords, stageInWords } from '../../web/space/run/words.js';
import { bordersOf } from '../../web/space/view/borders.js';

const near = (a, b, tolerance = 1e-12) => assert.ok(Math.abs(a - b) <= tolerance, `${a} against ${b}`);

/** Points that are equal become one; how often each edge is used each way. */
function edgeUse({ points, triangles }) {
  const names = new Map();
  const name = (v) => {
    const key = [0, 1, 2].map((k) => Math.round(1e6 * points[3 * v + k])).join();
    if (!names.has(key)) names.set(key, names.size);
    return names.get(key);
  };
  const use = new Map();
  for (let t = 0; t < triangles.length; t += 3)
    for (let k = 0; k < 3; ++k) {
      const key = `${name(triangles[t + k])},${name(triangles[t + (k + 1) % 3])}`;
      use.set(key, (use.get(key) ?? 0) + 1);
    }
  return { use, vertices: names.size };
}

for (const { id, make } of presets)
  test(`preset ${id} is a manifold, oriented the same all over`, () => {
    const shape = make();
    const { use } = edgeUse(shape);
    for (const [edge, count] of use) {
      assert.equal(count, 1, `${edge} is there ${count} times in one direction`);
    }
    assert.ok(shape.points.every(Number.isFinite));
    assert.ok(areaOf(surfaceOf(shape)) > 1);
  });

test('closed presets are closed, and of the right genus', () => {
  for (const [id, euler] of [['torus', 0], ['knot', 0], ['blob', 2], ['gear', 0], ['bored', 0]]) {
    const shape = presets.find((preset) => preset.id === id).make();
    const { use, vertices } = edgeUse(shape);
    for (const edge of use.keys()) assert.ok(use.has(edge.split(',').reverse().join()), `${id}: ${edge} is a border`);
    assert.equal(vertices - use.size / 2 + shape.triangles.length / 3, euler, id);
  }
});

test('the panel is whole, with two round holes', async () => {
  const session = await (await createLpquad()).startSurface(presetWork('panel').surface, { size: 0.1 });
  session.step();
  const { surface, features } = session.snapshot({ surface: true, features: true });
  const { use, vertices } = edgeUse(surface);
  const border = features.edges.length / 2;
  assert.equal(vertices - (use.size + border) / 2 + surface.triangles.length / 3, 1 - 2);  // a disk less two
  for (const v of features.edges) {
    const [x, y] = surface.points.subarray(3 * v, 3 * v + 2);
    const rims = [[-0.6, 0, 0.3], [0.75, 0.05, 0.21]].map(([cx, cy, r]) => Math.abs(Math.hypot(x - cx, y - cy) - r));
    assert.ok(Math.min(...rims, 1.5 - Math.abs(x), 1 - Math.abs(y)) < 1e-9);
  }
  session.dispose();
});

test('a link opens to the same work', () => {
  const work = { ...presetWork('gear'), options: { size: 0.07, keepGroups: false, effort: 'high' }, layers: inOrder(['quads', 'features']) };
  const again = fromFragment(toFragment(work));
  assert.deepEqual(again.options, work.options);
  assert.deepEqual(again.layers, work.layers);
  assert.equal(again.preset, 'gear');
  assert.deepEqual(again.surface, work.surface);
  assert.equal(toFragment({ ...work, preset: undefined }), '');
  const counted = { ...work, options: { quads: 500 } };
  assert.deepEqual(fromFragment(toFragment(counted)).options, counted.options);
  assert.equal(fromFragment('#preset=nobody').preset, presets[0].id);
  assert.deepEqual(fromFragment('#preset=gear&layers=nothing.quads').layers, ['quads']);
});

test('a size gives the number of quads that it was asked for', () => {
  const square = { points: Float64Array.of(0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0), triangles: Uint32Array.of(0, 1, 2, 0, 2, 3) };
  near(areaOf(square), 4);
  near(sizeFor(square, 400), 0.1);
  let looks = 0;
  const counted = { points: square.points, get triangles() { ++looks; return square.triangles; } };
  for (let i = 0; i < 5; ++i) near(areaOf(counted), 4);
  assert.equal(looks, 1);  // whatever asks at every tick of a run
  assert.deepEqual(boxOf(square.points).middle, [1, 1, 0]);
});


test('quads are cut along their shorter diagonal', () => {
  const kite = [0, 0, 0, 2, -1, 0, 4, 0, 0, 2, 1, 0];
  assert.deepEqual([...trianglesOfQuads(kite, [0, 1, 2, 3])], [1, 2, 3, 1, 3, 0]);
  assert.deepEqual([...gather(kite, [2, 0])], [4, 0, 0, 0, 0, 0]);
});

test('every edge of the quads is drawn once', () => {
  const edges = edgesOfQuads([0, 1, 3, 4, 1, 2, 5, 3]);
  const names = new Set();
  for (let i = 0; i < edges.length; i += 2) names.add([edges[i], edges[i + 1]].sort().join());
  assert.equal(edges.length / 2, 7);
  assert.equal(names.size, 7);
});

test('irregular vertices are those off the features without four quads', () => {
  const found = irregularVertices({ valence: Int32Array.of(4, 3, 5, 2, 7, 3, 0), edges: Uint32Array.of(5, 0) });
  assert.deepEqual([...found].sort(([a], [b]) => a - b), [[-2, [3]], [-1, [1]], [1, [2]], [2, [4]]]);
});

test('a cross has four arms of the same reach in the plane of its triangle', () => {
  const lines = crossLines({ points: [0, 0, 0, 3, 0, 0, 0, 3, 0], triangles: [0, 1, 2] }, [0.6, 0.8, 0], 0.5);
  assert.equal(lines.length, 12);
  for (let i = 0; i < 12; i += 6) near(Math.hypot(lines[i] - lines[i + 3], lines[i + 1] - lines[i + 4], lines[i + 2] - lines[i + 5]), 1, 1e-6);
  near((lines[3] - lines[0]) * (lines[9] - lines[6]) + (lines[4] - lines[1]) * (lines[10] - lines[7]), 0, 1e-6);
});

test('the worst and the best quads have the ends of the ramp', () => {
  const { quality } = light.ramps;
  const [low, high] = qualityColours([0, 1], quality);
  assert.deepEqual(low.map((x) => Math.round(255 * x)), quality[0]);
  assert.deepEqual(high.map((x) => Math.round(255 * x)), quality.at(-1));
  assert.deepEqual(parts('#ff0080').map((x) => Math.round(255 * x)), [255, 0, 128]);
});

// Three charts: unit squares of two triangles, the second ten times as large.
const charts = Int32Array.of(0, 0, 1, 1, 2, 2);
const uv = Float64Array.from([0, 1, 2].flatMap((c) => {
  const s = c === 1 ? 10 : 1;
  return [5, 5, 5 + s, 5, 5 + s, 5 + s, 5, 5, 5 + s, 5 + s, 5, 5 + s];
}));

test('charts lie side by side and do not touch', () => {
  const { islands, width, height } = layOut({ charts, uv, cuts: new Uint32Array() }, 1.5);
  assert.deepEqual(islands.map(({ chart }) => chart).sort(), [0, 1, 2]);
  const boxes = islands.map(({ chart, left, top }) => ({ left, top, size: chart === 1 ? 10 : 1 }));
  for (const a of boxes) {
    assert.ok(a.left >= 0 && a.top >= 0 && a.left + a.size <= width + 1e-9 && a.top + a.size <= height + 1e-9);
    for (const b of boxes) {
      if (a === b) continue;
      const apart = a.left + a.size < b.left || b.left + b.size < a.left || a.top + a.size < b.top || b.top + b.size < a.top;
      assert.ok(apart);
    }
  }
});

test('a chart is found where it lies, and none between', () => {
  const layout = layOut({ charts, uv, cuts: new Uint32Array() }, 1.5);
  for (const { chart, left, top } of layout.islands) assert.equal(pick(uv, layout, left + 0.3, top + 0.6), chart);
  assert.equal(pick(uv, layout, -1, -1), -1);
});

test('a chart whose map is a billion times too large is drawn as large as it is in space, and found there', () => {
  const square = (x) => [x, 0, 0, x + 2, 0, 0, x + 2, 2, 0, x, 2, 0];
  const surface = { points: Float64Array.from([...square(0), ...square(3), ...square(6)]),
    triangles: Uint32Array.from([0, 4, 8].flatMap((v) => [v, v + 1, v + 2, v, v + 2, v + 3])) };
  const wild = uv.map((x, i) => (i >= 12 && i < 24 ? 1e9 * x : x));
  const layout = layOut({ charts, uv: wild, cuts: new Uint32Array() }, 1.5, surface);
  assert.ok(Math.max(layout.width, layout.height) < 3 * 2 * 1.2);
  for (const { chart, left, top, scale, shift, triangles } of layout.islands) {
    near(scale * (chart === 1 ? 1e10 : 1), 2, 1e-9);
    near(shift[0] + scale * wild[6 * triangles[0]], left, 1e-6);
    assert.equal(pick(wild, layout, left + 0.5, top + 1.2), chart);
  }
  // Where a map has no area its scale is as good as any.
  assert.ok(layOut({ charts, uv: new Float64Array(36), cuts: new Uint32Array() }, 1.5, surface).islands.every(({ scale }) => scale === 1));
});

test('the border of a chart has its outer sides, and both sides of a cut in it', () => {
  const triangles = Uint32Array.of(0, 1, 2, 0, 2, 3);
  const of = (flat, of = Int32Array.of(0, 0)) => bordersOf({ charts: of, uv: Float64Array.from(flat), cuts: new Uint32Array() }, triangles, 0);
  assert.deepEqual(of([0, 0, 1, 0, 1, 1, 0, 0, 1, 1, 0, 1]).sort(), [0, 1, 4, 5]);
  assert.deepEqual(of([0, 0, 1, 0, 1, 1, 5, 5, 6, 6, 5, 6]).sort(), [0, 1, 2, 3, 4, 5]);
  assert.deepEqual(of([0, 0, 1, 0, 1, 1, 0, 0, 1, 1, 0, 1], Int32Array.of(0, 1)).sort(), [0, 1, 2]);
});

test('arrow keys go round all charts either way, from none too', () => {
  for (const by of [1, -1]) {
    const seen = [];
    for (let k = 0, chart = -1; k < 5; ++k) seen.push(chart = nextChart(chart, by, 5));
    const round = [0, 1, 2, 3, 4];
    assert.deepEqual(seen, by > 0 ? round : round.reverse());
    assert.equal(nextChart(seen.at(-1), by, 5), seen[0]);
  }
  assert.equal(nextChart(-1, -1, 1), 0);
});

test('quads are drawn in the plane that all their corners lie in', () => {
  const mesh = {
    placeTriangles: Int32Array.of(0, 0, 0, 1, 2), placeWeights: Float64Array.of(1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 1, 0, 0),
    quads: Uint32Array.of(0, 1, 2, 3, 1, 4, 2, 3),
    surface: { triangles: Uint32Array.of(0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7, 8, 9, 10, 8, 10, 11) },
  };
  const found = quadsInPlanes({ charts, uv, cuts: new Uint32Array() }, mesh);
  assert.deepEqual([...found.keys()], [0]);
  assert.deepEqual(found.get(0), [5, 5, 6, 5, 6, 6, 5, 6]);
});

test('on the border of two charts a corner has a place in either', () => {
  // Two triangles of a square, each a chart of its own; a quad whose diagonal is the border.
  const mesh = { placeTriangles: Int32Array.of(1, 0, 1, 0), placeWeights: Float64Array.of(0.9, 0.1, 0, 0.8, 0.2, 0, 0.1, 0.9, 0, 0.2, 0.2, 0.6),
    quads: Uint32Array.of(0, 1, 3, 2), surface: { triangles: Uint32Array.of(0, 1, 2, 0, 2, 3) } };
  const flat = Float64Array.of(0, 0, 1, 0, 1, 1, 5, 0, 6, 1, 5, 1);
  const found = quadsInPlanes({ charts: Int32Array.of(0, 1), uv: flat, cuts: new Uint32Array() }, mesh);
  assert.deepEqual([...found.keys()], [0]);
  [0.1, 0.1, 0.2, 0, 0.8, 0.6, 0.9, 0.9].forEach((x, i) => near(found.get(0)[i], x));
});

test('the run is told in words and as a share', () => {
  const run = { phase: 'running', work: null, frame: {}, result: null, error: null, state: { stage: 'mesh', tick: 9, chart: 3, chartCount: 6, share: 0.5 } };
  assert.equal(stageInWords(run), 'meshing charts: 3 of 6');
  const shares = ['features', 'field', 'charts', 'mesh', 'seams', 'shape', 'done'].flatMap((stage) =>
    [0, 0.5, 1].map((share) => shareOf({ ...run, state: { ...run.state, stage, share } })));
  assert.ok(shares.every((share, i) => share <= 1 && (i === 0 || share >= shares[i - 1])));
  assert.ok(shares[4] > shares[3] && shares[16] > shares[15]);
  assert.equal(shareOf({ ...run, phase: 'done' }), 1);
  assert.equal(portionAfter(4, 10), 8);
  assert.equal(portionAfter(4, 90), 2);
  assert.equal(portionAfter(1, 90), 1);
});

test('the run says how it ended: with how many quads, or why without', () => {
  const run = { phase: 'done', state: { stage: 'done' }, result: { report: { quads: 2998 } }, error: null };
  assert.equal(stageInWords(run), 'done: 2,998 quads');
  assert.equal(stageInWords({ ...run, phase: 'running', result: null, state: { stage: 'done', share: 0 } }), 'measuring the mesh');
  assert.equal(stageInWords({ ...run, phase: 'failed', error: { code: 'TOO_MANY_ELEMENTS' } }), 'failed: this mesh would have too many elements');
  assert.equal(stageInWords({ ...run, phase: 'failed', error: { code: 'ZERO_AREA' } }), 'failed: this surface has no area');
});

test('messages of the mesher have the names of the page and numbers that people write', () => {
  const said = messageInWords('About 5.53267e+10 elements would be needed, more than the limit of 2000000. Use a larger size or raise maxElements.');
  assert.equal(said, 'About 55 billion elements would be needed, more than the limit of 2,000,000. Use a larger size or raise “Most elements”.');
  for (const same of ['The point (0.123456, 12345.678, 3) is not on it.', 'At 1234 of part-20000.stl.', 'size must be above 0.'])
    assert.equal(messageInWords(same), same);
  assert.equal(messageInWords('About 1.2e+300 elements.'), 'Far too many elements.');
  for (const same of ['The points (712345, 6175000) and (1, 2) of region 0 (myPart, 20000) touch.'])
    assert.equal(messageInWords(same), same);
});

test('the page for the plane says them the same way', () => {
  const error = { code: 'TOO_MANY_ELEMENTS', message: 'About 1.1e+14 elements would be needed, more than the limit of 10000000. Use a larger size or raise maxElements.', where: {} };
  assert.equal(describe({ error }), 'no mesh: About 110 trillion elements would be needed, more than the limit of 10,000,000. Use a larger size or raise “Most elements”.');
});

test('a link to a surface that there is not says which there are', () => {
  assert.match(problemOf('#preset=nonsense&size=1'), /no surface “nonsense”.*pressed panel, gear/);
  assert.match(problemOf('#preset=gear&layers=quads.nonsense'), /no layer “nonsense”.*surface, sharp edges/);
  for (const bad of ['size=abc', 'size=', 'size=-1', 'x=1', '__proto__=1', 'quads=1.5', 'keepGroups=7', 'method=fast', 'size=1&quads=100'])
    assert.match(problemOf(`#preset=saddle&${bad}`), /^This link could not be opened: \w.*\.$/, bad);
  for (const good of ['', '#layers=', '#preset=gear&quads=500&method=paper&keepGroups=false', '#preset=gear&layers=quads.cells', '#preset=gear', '#size=0.2', ...presets.map(({ id }) => `#preset=${id}`)]) assert.equal(problemOf(good), '');
});

test('irregular vertices on sharp edges are counted apart, those on borders not at all', () => {
  // A cube of six quads, all edges sharp: eight corners of three.
  const quads = Uint32Array.of(0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5);
  const edges = Uint32Array.from([0, 1, 2, 3, 4, 5, 6, 7, 0, 2, 1, 3, 4, 6, 5, 7, 0, 4, 1, 5, 2, 6, 3, 7]);
  const valence = new Int32Array(8).fill(3), triangles = new Uint32Array();
  assert.equal(irregularOnFeatures({ quads, triangles, edges, valence }), 8);
  assert.equal(irregularOnFeatures({ quads: quads.subarray(0, 20), triangles, edges, valence }), 4);  // an open box
  const lid = Uint32Array.of(1, 3, 7, 1, 7, 5);  // the same closed by two triangles
  assert.equal(irregularOnFeatures({ quads: quads.subarray(0, 20), triangles: lid, edges, valence }), 8);
});

test('code names the file, and options that were chosen', () => {
  const known = [{ name: 'size', default: 0 }, { name: 'featureAngle', default: 40 }, { name: 'keepGroups', default: true }];
  const work = { ...presetWork('gear'), options: { size: 0.25, featureAngle: 40, keepGroups: false } };
  assert.equal(toCommand(work, known), "lpquad mesh 'gear-surface.obj' -o gear-quads.msh --size 0.25 --no-keep-groups\n");
  assert.match(toJavaScript(work, known), /^\/\/ npm install lpquad; the file is that of “Surface as OBJ”\n[^]*readFileSync\("gear-surface\.obj"\)[^]*meshSurface\(surface, \{ size: 0\.25, keepGroups: false \}\)/);
  const file = { ...work, name: "it's part.STL", preset: undefined };
  assert.equal(sourceOf(file), "it's part.STL");
  assert.match(toCommand(file, known), /^lpquad mesh 'it'\\''s part\.STL' -o it-s-part-quads\.msh /);
});

test('cells are triangles and borders of their pieces, and squares of equal size have the least energy', () => {
  // Two squares and a slim rectangle; the energy density of a square of the side h is 2 / (2^6 7) / h².
  const quad = (x, w) => [x, 0, x + w, 0, x + w, 1, x, 1];
  const uv = Float64Array.from([...quad(0, 1), ...quad(1, 1), ...quad(2, 0.5)]);
  const square = 2 / (64 * 7);
  const cells = { chart: 0, uv, points: new Float64Array(36), offsets: Int32Array.of(0, 4, 8, 12), sites: Int32Array.of(0, 1, 2),
    density: Float64Array.of(square, square, 9 * square) };
  const { triangles, pieces, edges } = meshOfCells(cells);
  assert.equal(triangles.length, 18);
  assert.deepEqual(pieces, [0, 0, 1, 1, 2, 2]);
  assert.deepEqual(edges.slice(0, 8), [0, 1, 1, 2, 2, 3, 3, 0]);
  const [a, b, c] = cellColours(cells, light.ramps.density).map(parts);
  assert.deepEqual(a, b);
  assert.deepEqual(a.map((x) => Math.round(255 * x)), light.ramps.density[0]);
  assert.deepEqual(c.map((x) => Math.round(255 * x)), light.ramps.density.at(-1));
});
