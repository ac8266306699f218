// Drawing is pure: a recorder sees what each layer draws, and that it draws nothing of what is not there.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { contours } from '../../web/draw/contours.js';
import { draw, drawing } from '../../web/draw/draw.js';
import { legendOf } from '../../web/draw/legend.js';
import { dark, light, shadesOf } from '../../web/draw/palette.js';
import { edgesOf, edgesOfRows, welded } from '../../web/draw/topology.js';
import { layerNames } from '../../web/layers/names.js';
import { circle, recorder, sceneOf, square, withLayers } from './recorder.mjs';

const plate = sceneOf([square.map(([x, y]) => [2 * x, y]), circle(1, 0.5, 0.22, 32)], { size: 0.08, method: 'paper', seeds: 'isotropic' });
const graded = sceneOf([square], { size: 0.2, sizes: [[0.2, 0.3, 0.02]] });
const all = layerNames.map(({ name }) => name);

function drawn({ scene, view }, layers, how) {
  const record = recorder(how);
  draw(record.pen, withLayers(scene, ...layers), view);
  return record;
}

function uniqueEdges(faces, corners) {
  const seen = new Set();
  for (let f = 0; f < faces.length; f += corners)
    for (let k = 0; k < corners; ++k) seen.add([faces[f + k], faces[f + (k + 1) % corners]].sort((a, b) => a - b).join());
  return seen;
}

test('lines of triangles, cells and quads are drawn once each', () => {
  const { triangles, quads } = plate.scene.frame;
  for (const how of [{}, { bulk: true }]) {
    const lines = (layer) => drawn(plate, [layer], how).count(how.bulk ? 'strokeLine' : 'lineTo');
    assert.equal(lines('triangles'), uniqueEdges(triangles.triangles, 3).size);
    assert.equal(lines('quads'), uniqueEdges(quads.quads, 4).size);
  }
  const { cells } = plate.scene.frame;
  const edges = edgesOfRows(welded(cells.points), cells.offsets, cells.points.length / 2);
  const half = new Set();
  for (let i = 0; i < edges.length; i += 2) half.add(`${edges[i]},${edges[i + 1]}`);
  assert.equal(half.size, edges.length / 2);
  assert.ok(edges.length / 2 < 0.62 * cells.points.length / 2, 'shared sides are there once');
});

test('no stroke has more lines than a software rasteriser likes', () => {
  let lines = 0;
  for (const { name } of drawn(plate, ['triangles', 'cells', 'quads']).calls) {
    if (name === 'beginPath') lines = 0;
    if (name === 'lineTo') assert.ok(++lines <= 50);
  }
});

test('areas are one polygon per element, in colours of the ramp', () => {
  const { quads, cells } = plate.scene.frame;
  for (const [layer, count, ramp] of [['quality', quads.quads.length / 4, light.ramps.quality], ['density', cells.sites.length, light.ramps.density]]) {
    const polygons = drawn(plate, [layer]).calls.filter(({ name }) => name === 'fill');
    assert.equal(polygons.length, count);
    const colours = new Set(shadesOf(ramp).css);
    assert.ok(polygons.every(({ fill }) => colours.has(fill)));
    assert.equal(drawn(plate, [layer], { bulk: true }).count('fillPolygon'), count);
  }
});

test('a better quad never has the colour of a worse one further down the ramp', () => {
  const { eta } = plate.scene.frame.quads, order = shadesOf(light.ramps.quality).css;
  const at = drawn(plate, ['quality']).calls.filter(({ name }) => name === 'fill').map(({ fill }) => order.lastIndexOf(fill));
  const sorted = [...eta.keys()].sort((a, b) => eta[a] - eta[b]).map((f) => at[f]);
  assert.ok(sorted.every((shade, i) => i === 0 || shade >= sorted[i - 1]));
});

test('each irregular vertex has a mark, with its number when there is room', () => {
  const irregular = plate.scene.frame.quads.excess.filter((excess) => excess !== 0).length;
  assert.ok(irregular > 0);
  const far = drawn({ ...plate, view: { ...plate.view, scale: plate.view.scale / 8 } }, ['valence']);
  assert.equal(far.count('fillText'), 0);
  assert.equal(drawn(plate, ['valence']).count('fill'), irregular);
  const { view } = plate;
  const near = drawn({ ...plate, view: { ...view, scale: 8 * view.scale, width: 8 * view.width, height: 8 * view.height } }, ['valence']);
  assert.equal(near.count('fillText'), irregular);
});

test('glyphs of the cross field keep their distance on the screen at any zoom', () => {
  for (const zoom of [0.5, 1, 6]) {
    const lines = drawn({ ...graded, view: { ...graded.view, scale: zoom * graded.view.scale } }, ['crosses'], { bulk: true })
      .calls.filter(({ name }) => name === 'strokeLine').map(({ args: [x0, y0, x1, y1] }) => [(x0 + x1) / 2, (y0 + y1) / 2]);
    assert.ok(lines.length > 0);
    const middles = lines.filter((_, i) => i % 2 === 0);
    for (const [i, [x, y]] of middles.entries())
      for (const [u, v] of middles.slice(i + 1)) assert.ok(Math.hypot(x - u, y - v) > 25);
  }
});

test('bands of the size field fill its triangles and lie between their levels', () => {
  const { points, triangles, sizes } = graded.scene.frame.sizes;
  const low = Math.min(...sizes), span = Math.log(Math.max(...sizes) / low);
  const heights = sizes.map((h) => 9 * Math.log(h / low) / span);
  const steps = contours(points, triangles, heights, 9);
  let step = steps.next();
  while (!step.done) step = steps.next();
  const { bands, lines } = step.value;
  const area = (flat, from, to) => {
    let twice = 0;
    for (let i = from; i < to; ++i) {
      const j = i + 1 < to ? i + 1 : from;
      twice += flat[2 * i] * flat[2 * j + 1] - flat[2 * j] * flat[2 * i + 1];
    }
    return twice / 2;
  };
  let sum = 0;
  for (let i = 0; i + 1 < bands.offsets.length; ++i) sum += area(bands.points, bands.offsets[i], bands.offsets[i + 1]);
  assert.ok(Math.abs(sum - 1) < 1e-9, String(sum));
  assert.ok(bands.band.every((band) => band < 9) && new Set(bands.band).size === 9);
  assert.ok(lines.length > 0);
});

test('nothing is drawn of what is not there', () => {
  const empty = { ...plate, scene: { ...plate.scene, frame: null } };
  const early = { ...plate, scene: { ...plate.scene, frame: { stage: 'seeds', tick: 0 } } };
  for (const { name } of layerNames)
    for (const none of [empty, early]) {
      const { calls } = drawn(none, [name]);
      if (name !== 'boundary') assert.ok(calls.every((call) => call.name === 'save' || call.name === 'restore'), name);
    }
  assert.deepEqual(drawn(plate, []).calls, []);
});

test('drawing changes nothing and gives the same again; rests do not matter', () => {
  const before = JSON.stringify(plate.scene, (_, value) => (value instanceof Set ? [...value] : value));
  const first = drawn(plate, all), again = drawn(plate, all);
  assert.deepEqual(again.calls, first.calls);
  assert.equal(JSON.stringify(plate.scene, (_, value) => (value instanceof Set ? [...value] : value)), before);
  const rested = recorder(), steps = drawing(rested.pen, withLayers(plate.scene, ...all), plate.view);
  while (!steps.next().done) recorder().pen.beginPath();
  assert.deepEqual(rested.calls, first.calls);
  assert.equal(first.count('save'), first.count('restore'));
});

test('what is out of sight costs nothing', () => {
  const { view } = plate;
  const away = { ...plate, view: { ...view, left: view.left + 100 } };
  const { calls } = drawn(away, ['triangles', 'quads', 'quality', 'valence', 'density', 'cells', 'sizes'], { bulk: true });
  assert.ok(calls.every(({ name }) => name === 'save' || name === 'restore'), calls.map(({ name }) => name).join());
});

test('a mesh of another drawing is faded, the outline is not', () => {
  const { calls } = drawn({ ...plate, scene: { ...plate.scene, freshness: 'old' } }, ['boundary', 'quads']);
  const veil = calls.findLastIndex(({ name, fill }) => name === 'fill' && fill === light.background);
  const lastQuad = calls.findLastIndex(({ name, stroke }) => name === 'stroke' && stroke === light.ink);
  const outline = calls.findIndex(({ name, stroke }) => name === 'stroke' && stroke === light.boundary);
  assert.ok(lastQuad >= 0 && lastQuad < veil && veil < outline);
});

test('unique edges by rows are those of a set', () => {
  const faces = Uint32Array.from({ length: 3000 }, (_, i) => (i * 7919) % 313);
  const found = edgesOf(faces, 3), wanted = uniqueEdges(faces, 3);
  const distinct = [...wanted].filter((edge) => new Set(edge.split(',')).size === 2);
  assert.equal(found.length / 2, distinct.length);
});

test('legends give the numbers of the scene', () => {
  const { frame } = plate.scene;
  const texts = (name) => legendOf(name, withLayers(plate.scene, name)).map((item) => item.text ?? `${item.low} ${item.of} ${item.high}`).join('; ');
  assert.match(texts('quads'), new RegExp(`^${(frame.quads.quads.length / 4).toLocaleString('en')} quads`));
  assert.match(texts('triangles'), new RegExp(`^${(frame.triangles.triangles.length / 3).toLocaleString('en')} triangles`));
  assert.match(texts('valence'), new RegExp(`${frame.quads.excess.filter((e) => e === -1).length} with one quad too few`));
  assert.match(texts('crosses'), /four|4 singularities −1: five quads meet/);
  assert.match(texts('boundary'), /2 outlines, 36 points/);
  for (const { name } of layerNames) {
    assert.ok(legendOf(name, plate.scene).length > 0, name);
    assert.ok(legendOf(name, { ...plate.scene, frame: null }).length > 0, name);
  }
});

const rgbOf = (colour) => [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16));
function luminance(rgb) {
  const [r, g, b] = rgb.map((value) => {
    const part = value / 255;
    return part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4;
  });
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}
const contrast = (a, b) => {
  const [low, high] = [luminance(a), luminance(b)].sort((x, y) => x - y);
  return (high + 0.05) / (low + 0.05);
};

test('lines and marks stand out, ramps run in lightness', () => {
  for (const palette of [light, dark]) {
    const background = rgbOf(palette.background);
    for (const colour of [palette.ink, palette.boundary, palette.accent, palette.error, ...Object.values(palette.valence)])
      assert.ok(contrast(rgbOf(colour), background) >= 4.5, `${colour} on ${palette.background}`);
    assert.ok(contrast(rgbOf(palette.faint), background) >= 3, palette.faint);
    for (const [name, ramp] of Object.entries(palette.ramps)) {
      const levels = ramp.map(luminance), rising = levels.at(-1) > levels[0];
      assert.ok(levels.every((level, i) => i === 0 || (rising ? level > levels[i - 1] : level < levels[i - 1])), name);
      assert.ok(contrast(ramp[0], ramp.at(-1)) >= 4.5, `${name}: ${contrast(ramp[0], ramp.at(-1))}`);
    }
  }
});
