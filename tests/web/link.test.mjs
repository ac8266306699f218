// A project as a fragment and as a file: it comes back bit for bit, and nothing else comes in.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { createLpquad } from '../../dist/node.js';
import { presets } from '../../web/sketch/presets.js';
import * as judge from '../../web/state/judge.js';
import { fromFragment, longestLink, toFragment } from '../../web/state/link.js';
import { knownOptions, knownSurfaceOptions } from '../../web/state/options.js';
import { pack } from '../../web/state/pack.js';
import { isProjectText, projectText, readProject } from '../../web/state/project_file.js';
import { emptyProject } from '../../web/state/project.js';

const awkward = [-0, 5e-324, 1 / 3, -1.7976931348623157e308, 0.1 + 0.2, 1e21, 123456789.12345679];
const drawing = {
  regions: [{ name: 'ä “quoted”', loops: [awkward.map((x, i) => [x, awkward[(i + 3) % awkward.length]])], tags: [['a', '', 'b', '', '', '', '']] }],
  polylines: [{ points: [[0.1, -0], [1, 2]], tag: 'line' }],
  points: [{ position: [-0, 3], tag: '' }],
};
const full = {
  ...emptyProject, name: 'a & b=c+d #1', drawing, options: { size: 1 / 3, method: 'paper', strict: true, iterations: -1 },
  sizes: [[0, -0, 1e-9]], guides: [[[0, 0], [1, 1e-300]]], seedPoints: [[0.25, 0.75]], layers: ['cells', 'density'], comparison: 'norm',
};
const preset = presets[0].project;

test('a fragment brings back every part and every bit', async () => {
  const { project, place } = await fromFragment(await toFragment(full, { tick: 12, chapter: 'lloyd' }));
  assert.deepStrictEqual(project, full);  // deepStrictEqual tells -0 from 0
  assert.deepEqual(place, { tick: 12, chapter: 'lloyd' });
});

test('a file brings back every part and every bit', () => {
  const text = projectText(full);
  assert.ok(isProjectText(text));
  assert.ok(!isProjectText('{"loops": []}'));
  assert.deepStrictEqual(readProject(text), full);
});

test('presets, as they are and changed, stay below 2 kB', async () => {
  for (const { id, project } of presets) {
    const plain = await toFragment(project);
    assert.equal(plain, `#preset=${id}`);
    assert.deepStrictEqual((await fromFragment(plain)).project, project);
    const changed = { ...project, options: { ...project.options, size: 0.0712, norm: 4 }, layers: ['cells', 'quads'] };
    const fragment = await toFragment(changed, { tick: 31 });
    assert.ok(fragment.length < 300, fragment);
    assert.deepStrictEqual((await fromFragment(fragment)).project, changed);
  }
  const moved = structuredClone(preset);
  moved.preset = '';
  moved.drawing.regions[0].loops[0][0][0] -= 0.123456789;
  const fragment = await toFragment(moved);
  assert.ok(fragment.length <= 2000, `${fragment.length} characters`);
  assert.deepStrictEqual((await fromFragment(fragment)).project, moved);
});

test('options that a preset has and the project has not stay away', async () => {
  const project = { ...preset, options: {} };
  assert.deepStrictEqual((await fromFragment(await toFragment(project))).project, project);
});

test('what equals the preset is the preset\'s own object, so that nothing is meshed twice', async () => {
  const { project } = await fromFragment(`#preset=${preset.preset}&layers=cells`);
  assert.equal(project.drawing, preset.drawing);
  assert.equal(project.options, preset.options);
});

test('a fragment without a project says so', async () => {
  assert.deepEqual(await fromFragment('#chapter=lloyd'), { project: null, place: { chapter: 'lloyd' } });
  assert.deepEqual(await fromFragment(''), { project: null, place: {} });
});

test('options, layers or a comparison without a drawing are of the first preset', async () => {
  const of = async (fragment) => (await fromFragment(fragment)).project;
  assert.deepStrictEqual(await of('#comparison=lp'), { ...preset, comparison: 'lp' });
  assert.deepStrictEqual(await of('#options=size:0.1,norm:2'), { ...preset, options: { size: 0.1, norm: 2 } });
  assert.deepStrictEqual(await of('#layers=cells'), { ...preset, layers: ['cells'] });
  assert.deepEqual(await fromFragment('#options=size:0.1&tick=3'), { project: { ...preset, options: { size: 0.1 } }, place: { tick: 3 } });
  await assert.rejects(of('#options=size:-1'), judge.NotAProject);
});

test('an empty drawing comes back empty, whatever else was chosen', async () => {
  assert.equal(await toFragment(emptyProject), '#');
  for (const project of [{ ...emptyProject, options: { size: 0.1 } }, { ...emptyProject, comparison: 'lp', layers: ['quads'] }])
    assert.deepStrictEqual((await fromFragment(await toFragment(project))).project, project);
});

const packed = async (value) => `#data=${await pack(typeof value === 'string' ? value : JSON.stringify(value))}`;
const loops = (...loop) => ({ drawing: { regions: [{ name: '', loops: [loop] }] } });

test('hostile and damaged fragments are refused in words', async () => {
  const good = await toFragment(full);
  const bad = [
    '#data=', '#data=!!!', '#data=AAAA', good.slice(0, -9), '#preset=nowhere', '#preset=__proto__', '#preset=constructor', '#what=1',
    '#preset=plate&options=size:Infinity', '#preset=plate&options=size:-1', '#preset=plate&options=norm:99', '#preset=plate&options=constructor:1',
    '#preset=plate&options=__proto__:1', '#preset=plate&options=method:evil', '#preset=plate&options=iterations:1.5', '#preset=plate&options=strict:1',
    '#preset=plate&options=size', '#preset=plate&layers=cells,<b>', '#preset=plate&layers=toString', '#preset=plate&comparison=<img>', '#preset=plate&comparison=nowhere', '#chapter=nowhere', '#preset=plate&chapter=toString', '#preset=plate&tick=-1', '#preset=plate&tick=x', '#%E0%A4%A=1', '#preset=%00',
    await packed('{"drawing":'), await packed('null'), await packed('[]'), await packed({ drawing: 7 }), await packed({ drawing: { regions: {} } }),
    await packed(loops([0, 0], [1, 0], [0, null])), await packed(loops([0, 0], [1, 0], [0, 'x'])), await packed(loops([0, 0], [1, 0], [1, 2, 3])),
    await packed('{"drawing":{"regions":[{"loops":[[[0,1e999]]]}]}}'), await packed({ ...loops([0, 0]), sizes: [[0, 0, 0]] }),
    await packed({ ...loops([0, 0]), options: { size: '1' } }), await packed(`{"drawing":${'['.repeat(1e5)}`),
  ];
  for (const fragment of bad)
    await assert.rejects(fromFragment(fragment), (error) => error instanceof judge.NotAProject && error.message.length > 5, fragment);
});

test('a few bytes that stand for very many are not unpacked', async () => {
  const bomb = await pack(' '.repeat(1 << 27));
  await assert.rejects(fromFragment(`#data=${bomb}`), judge.NotAProject);
});

test('members of other names do not come in', async () => {
  const { project } = await fromFragment(await packed('{"__proto__":{"a":1},"evil":2,"drawing":{"regions":[],"evil":3}}'));
  assert.deepEqual(Object.keys(project).sort(), Object.keys(emptyProject).sort());
  assert.equal(project.a, undefined);
  assert.equal(project.drawing.evil, undefined);
});

test('a large drawing is too long for a link, and that is seen', async () => {
  const loop = Array.from({ length: 2000 }, (_, i) => [Math.cos(i / 318.31), Math.sin(i / 318.31)]);
  const project = { ...emptyProject, drawing: { regions: [{ name: '', loops: [loop] }], polylines: [], points: [] } };
  assert.ok((await toFragment(project)).length > longestLink);
});

test('the pages know the options that the library has', async () => {
  const { options, surfaceOptions } = await createLpquad();
  const told = (all) => Object.fromEntries(all.map(({ name, type, min, max, choices }) =>
    [name, { boolean: 'boolean', choice: choices, number: [min, max], integer: ['integer', min, max] }[type]]));
  assert.deepEqual(knownOptions, told(options));
  assert.deepEqual(knownSurfaceOptions, told(surfaceOptions));
});
