import assert from 'node:assert/strict';
import { test } from 'node:test';
import { createLpquad } from '../../dist/node.js';
import { helpInWords, isAutomatic, phrases } from '../../web/mesh/help.js';
import { mainOptions, nameOfOption, numberOf, placeOf, problemWith, rangeInWords, sizeAt, sizeRange, valueOf, withOption, withSize } from '../../web/mesh/options.js';
import { unitBall } from '../../web/mesh/unit_ball.js';
import { coarse } from '../../web/run/preview.js';
import { areaOf } from '../../web/sketch/model/drawing.js';
import { presets } from '../../web/sketch/presets.js';

const { options: infos, surfaceOptions } = await createLpquad();
const info = (name) => infos.find((one) => one.name === name);

test('every option of the library has a name, and all that are shown first exist', () => {
  for (const name of mainOptions) assert.ok(info(name), name);
  for (const { name } of infos) assert.match(nameOfOption(name), /^[A-Z][^A-Z]*( p)?$/);
  assert.equal(nameOfOption('someNewThing'), 'Some new thing');
});

test('what the mesher refuses is refused in words, and nothing else', () => {
  for (const [name, text, words] of [
    ['norm', '', /number is needed/], ['norm', 'six', /number is needed/], ['norm', '1.9', /At least 2/], ['norm', '21', /At most 20/],
    ['norm', 'Infinity', /At most 20/], ['iterations', '2.5', /whole number/], ['iterations', '-2', /At least 0/], ['size', '-1', /At least 0/],
  ]) assert.match(problemWith(info(name), text), words);
  for (const [name, text] of [['norm', '6'], ['norm', ' 2,5 '], ['iterations', '-1'], ['size', '1e-3'], ['seed', '9007199254740991']])
    assert.equal(problemWith(info(name), text), '', `${name} ${text}`);
  assert.equal(numberOf(' 2,5 '), 2.5);
  assert.equal(numberOf('0,125'), 0.125);
  for (const text of ['1,000', '1.000', '1 000', ' 1’000 ']) assert.equal(numberOf(text, true), 1000, text);
  assert.equal(numberOf('12,345,678', true), 12345678);
  for (const text of ['1,5', '0,125', '1000,5']) assert.ok(!Number.isInteger(numberOf(text, true)), text);
  assert.ok(Number.isNaN(numberOf('1,000.000', true)));
});

test('what the page says about an option is about the page', () => {
  const all = [...infos, ...surfaceOptions];
  for (const one of all) {
    const text = helpInWords(one);
    assert.doesNotMatch(text, /\b[a-z]+[A-Z]|--|-1|domain's own/, `${one.name}: a name of the code, or a number that stands for something`);
    if (isAutomatic(one)) assert.doesNotMatch(text, new RegExp(`(^|; )${one.default}\\b`), one.name);
    for (const choice of one.choices ?? []) if (choice.includes('-')) assert.ok(!text.includes(choice), `${one.name}: ${choice}`);
    assert.ok(text.length > 0.4 * one.help.length, one.name);
    assert.doesNotMatch(rangeInWords(one), /-1|\d{5}/, one.name);
  }
  const said = (name) => helpInWords(info(name));
  assert.match(said('size'), /; automatic: about 1000 quads/);
  assert.match(said('iterations'), /; automatic: 80/);
  assert.match(said('simplify'), /not with “Keep the boundary”/);
  assert.match(helpInWords(surfaceOptions.find(({ name }) => name === 'smoothing')), /; automatic leaves it to the mesher/);
  for (const [theirs] of phrases) assert.ok(all.some(({ help }) => theirs.test(help)), `nothing to replace: ${theirs}`);
  assert.equal(helpInWords({ name: 'new', help: 'As ever.', default: 1 }), 'As ever.');
});

test('only what differs from the defaults is kept', () => {
  const norm = info('norm');
  const changed = withOption({ size: 1 }, norm, 8);
  assert.deepEqual(changed, { size: 1, norm: 8 });
  assert.equal(valueOf(changed, norm), 8);
  assert.deepEqual(withOption(changed, norm, norm.default), { size: 1 });
  assert.equal(valueOf({}, norm), norm.default);
});

test('a size and a number of quads stand in for each other', () => {
  assert.deepEqual(withOption({ size: 1, norm: 8 }, info('quads'), 500), { norm: 8, quads: 500 });
  assert.deepEqual(withOption({ quads: 500 }, info('size'), 0.1), { size: 0.1 });
  assert.deepEqual(withOption({ size: 1 }, info('quads'), 0), { size: 1 });
  assert.deepEqual(withSize({ quads: 500, norm: 8 }, 0.1), { norm: 8, size: 0.1 });
});

test('the size slider goes evenly by ratio over a range that fits the drawing', () => {
  const range = sizeRange(presets[0].project.drawing);
  for (const place of [0, 0.25, 0.5, 1]) assert.ok(Math.abs(placeOf(range, sizeAt(range, place)) - place) < 0.01);
  const ratio = sizeAt(range, 0.5) / sizeAt(range, 0.25);
  assert.ok(Math.abs(sizeAt(range, 0.75) / sizeAt(range, 0.5) - ratio) < 0.05 * ratio);
  assert.equal(placeOf(range, 1e9), 1);
  assert.match(rangeInWords(info('size')), /unit of the coordinates/);
});

test('the unit ball is where the norm is 1, whatever it is turned by', () => {
  for (const p of [2, 4, 6, 8])
    for (const [x, y] of unitBall(p)) assert.ok(Math.abs(Math.abs(x) ** p + Math.abs(y) ** p - 1) < 1e-12);
  const [straight, turned] = [unitBall(6), unitBall(6, 1)];
  straight.forEach(([x, y], i) => assert.ok(Math.abs(Math.hypot(x, y) - Math.hypot(...turned[i])) < 1e-12));
});

test('a preview asks for some hundred quads, unless less is wanted', () => {
  const [plate] = presets;
  const area = areaOf(plate.project.drawing);
  assert.ok(Math.abs(area - (2 - Math.PI * 0.22 ** 2)) < 0.01);
  const { options } = coarse(plate.project);
  assert.ok(area / options.size ** 2 >= 300 && area / options.size ** 2 <= 500);
  assert.equal(coarse({ ...plate.project, options: { size: 0.5 } }).options.size, 0.5);
  const few = coarse({ ...plate.project, options: { quads: 20 } }).options;
  assert.ok(Math.abs(area / few.size ** 2 - 20) < 0.1);
  assert.equal(few.quads, undefined);
  const painted = coarse({ ...plate.project, options: {}, sizes: [[0, 0, 0.01], [1, 1, 0.1]] });
  assert.ok(painted.sizes[0][2] >= options.size * 0.99);
  assert.equal(painted.sizes[1][2] / painted.sizes[0][2], 10);
});
