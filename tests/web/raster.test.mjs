// The rasteriser against plain geometry: areas, tilings without gap or overlap, smooth lines.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { packed } from '../../web/draw/palette.js';
import { Raster } from '../../web/draw/raster.js';
import { circle } from './recorder.mjs';

/** The same numbers in every run. */
function randoms(seed) {
  let state = seed;
  return () => {
    state = Math.imul(state ^ (state >>> 15), state | 1);
    state ^= state + Math.imul(state ^ (state >>> 7), state | 61);
    return ((state ^ (state >>> 14)) >>> 0) / 4294967296;
  };
}
const flat = (points) => Float64Array.from(points.flat());
const covered = (raster) => raster.pixels.reduce((sum, word) => sum + (word >>> 24) / 255, 0);
const black = packed(0, 0, 0);

test('a polygon has the pixels whose centres it holds', () => {
  const random = randoms(7);
  for (let k = 0; k < 60; ++k) {
    const star = circle(50, 50, 1, 9).map(([x, y]) => {
      const reach = 8 + 38 * random();
      return [50 + reach * (x - 50), 50 + reach * (y - 50)];
    });
    const raster = new Raster(100, 100);
    raster.fillPolygon(flat(star), star.length, black);
    const area = star.reduce((sum, [x, y], i) => {
      const [u, v] = star[(i + 1) % star.length];
      return sum + (x * v - u * y) / 2;
    }, 0);
    const perimeter = star.reduce((sum, [x, y], i) => sum + Math.hypot(x - star[(i + 1) % 9][0], y - star[(i + 1) % 9][1]), 0);
    assert.ok(Math.abs(covered(raster) - area) < 0.1 * perimeter, `${covered(raster)} ${area}`);
  }
});

test('a polygon of very many corners has them too, whether its sides are short or cross most rows', () => {
  const random = randoms(11), size = 120;
  const wavy = circle(60, 60, 1, 3000).map(([x, y], i) => [60 + (40 + 15 * Math.sin(i / 40)) * (x - 60), 60 + (40 + 15 * Math.sin(i / 40)) * (y - 60)]);
  const tangle = Array.from({ length: 700 }, () => [160 * random() - 20, 160 * random() - 20]);
  const comb = Array.from({ length: 30000 }, (_, i) => [size * i / 30000, i % 2 ? -5 : 125]);  // more crossings than are kept at once
  for (const corners of [wavy, tangle, comb]) {
    const raster = new Raster(size, size);
    raster.fillPolygon(flat(corners), corners.length, black);
    for (let k = 0; k < 400; ++k) {
      const column = Math.floor(size * random()), row = Math.floor(size * random());
      let inside = false;
      corners.forEach(([u, v], i) => {
        const [x, y] = corners.at(i - 1);
        if ((v <= row + 0.5) !== (y <= row + 0.5) && u + (row + 0.5 - v) / (y - v) * (x - u) < column + 0.5) inside = !inside;
      });
      assert.equal(raster.pixels[row * size + column] !== 0, inside, `${corners.length} corners, ${column}, ${row}`);
    }
  }
});

test('a triangulation covers every pixel exactly once, whatever the way round', () => {
  const random = randoms(3), n = 24, size = 96;
  const at = Array.from({ length: (n + 1) ** 2 }, (_, k) => {
    const i = k % (n + 1), j = Math.floor(k / (n + 1));
    const move = (t) => (t === 0 || t === n ? 0 : 0.45 * (random() - 0.5));
    return [(i + move(i)) * size / n, (j + move(j)) * size / n];
  });
  const times = new Uint8Array(size * size);
  for (let j = 0; j < n; ++j)
    for (let i = 0; i < n; ++i) {
      const a = j * (n + 1) + i, corners = [a, a + 1, a + n + 2, a + n + 1];
      for (const t of random() < 0.5 ? [[0, 1, 2], [2, 3, 0]] : [[3, 2, 1], [1, 0, 3]]) {
        const raster = new Raster(size, size);
        raster.fillPolygon(flat(t.map((k) => at[corners[k]])), 3, black);
        raster.pixels.forEach((word, p) => { if (word !== 0) ++times[p]; });
      }
    }
  assert.ok(times.every((count) => count === 1));
});

test('holes are left out, and what is outside is cut off', () => {
  const outer = [[-20, -20], [60, -20], [60, 60], [-20, 60]], hole = [[10, 10], [10, 30], [30, 30], [30, 10]];
  const raster = new Raster(40, 40);
  const joined = [...outer, outer[0], ...hole, hole[0], outer[0]];
  raster.fillPolygon(flat(joined), joined.length, black);
  assert.equal(covered(raster), 40 * 40 - 20 * 20);
});

test('a line covers its length times its width, the same both ways', () => {
  const random = randoms(11);
  for (let k = 0; k < 200; ++k) {
    const [x0, y0, x1, y1] = [random, random, random, random].map((next) => 5 + 190 * next());
    const width = 0.5 + 3 * random();
    const one = new Raster(200, 200), other = new Raster(200, 200);
    one.strokeLine(x0, y0, x1, y1, width, black);
    other.strokeLine(x1, y1, x0, y0, width, black);
    assert.deepEqual(one.pixels, other.pixels);
    const area = width * Math.hypot(x1 - x0, y1 - y0);
    assert.ok(Math.abs(covered(one) - area) < 0.05 * area + 2.5 * width, `${covered(one)} ${area}`);
  }
});

test('a line over a colour mixes with it', () => {
  const raster = new Raster(4, 4);
  raster.fillPolygon(flat([[0, 0], [4, 0], [4, 4], [0, 4]]), 4, packed(255, 255, 255));
  raster.strokeLine(0, 2, 4, 2, 1, packed(0, 0, 0));
  const row = (y) => [...raster.pixels.subarray(4 * y, 4 * y + 4)].map((word) => [word & 255, word >>> 24]);
  for (const [grey, alpha] of [...row(1), ...row(2)]) {
    assert.ok(grey > 120 && grey < 135);
    assert.equal(alpha, 255);
  }
  assert.ok(row(0).every(([grey]) => grey === 255));
});
