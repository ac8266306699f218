// CAD files through occt-import-js, a package that the user installs: readCad and the command line.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { cpSync, existsSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, symlinkSync, writeFileSync }
  from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';

import { stepBoxes } from './step_boxes.mjs';
import { dist, path, random, rejectionOf } from './support.mjs';

const { cadFormats, isCadFile, readCad, surfaceAsObj } = await import(dist('cad.js').href);
const installed = existsSync(path('node_modules/occt-import-js'));
const needsOcct = { skip: installed ? false : 'SKIPPED: occt-import-js is not installed (npm ci)' };

const scratch = mkdtempSync(join(tmpdir(), 'lpquad-cad-'));
after(() => rmSync(scratch, { recursive: true }));
const file = (name, content) => {
  writeFileSync(join(scratch, name), content);
  return join(scratch, name);
};
const lpquad = (...args) => spawnSync(process.execPath, [path('dist/cli.js'), ...args], { encoding: 'utf8' });

const boxes = stepBoxes([{ name: 'plate', at: [0, 0, 0], size: [4, 2, 1] },
  { name: 'block', at: [10, 0, 0], size: [1, 1, 1] }]);

/** Stands for occt-import-js: two triangles per face, one of no face at the end. */
function fakeOcct(names, calls = []) {
  const mesh = (name) => ({
    name, brep_faces: [{ first: 0, last: 1 }, { first: 2, last: 3 }],
    attributes: { position: { array: [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0] } },
    index: { array: [0, 1, 2, 0, 2, 3, 2, 1, 0, 3, 2, 0, 0, 1, 3] },
  });
  const read = (kind) => (bytes, params) => {
    calls.push({ kind, bytes, params });
    return { success: true, meshes: names.map(mesh) };
  };
  return { ReadStepFile: read('step'), ReadIgesFile: read('iges'), ReadBrepFile: read('brep') };
}

test('formats go by endings', () => {
  assert.deepEqual(cadFormats, ['step', 'iges', 'brep']);
  for (const name of ['a.step', 'b.STP', 'c.iges', 'd.Igs', 'e.brep', 'f.brp']) assert.ok(isCadFile(name), name);
  for (const name of ['a.stl', 'step', 'a.step.obj', '']) assert.ok(!isCadFile(name), name);
});

test('triangles as OBJ are read back as they were: every bit, groups, bodies, whatever their names', async () => {
  const { createLpquad } = await import(dist('node.js').href);
  const reader = await createLpquad();
  const points = Float64Array.of(-0, 0, 1 / 3, 1e-300, 0, -0, 0, 5e20, 0.1, 1, 1, 1, 2, -0, 1, 2, 2, 2.5);
  const triangles = Uint32Array.of(0, 1, 2, 1, 0, 2, 3, 4, 5, 5, 4, 3);
  const groups = Int32Array.of(0, 1, 2, 3), bodies = Int32Array.of(0, 0, 1, 1);
  const read = (more) => reader.readSurface(surfaceAsObj({ points, triangles, ...more }), { name: 'x.obj' });
  for (const groupNames of [['a', 'b', 'c', 'd'], ['hash # tag', 'back\\', 'two\nlines\n', ''], ['a b', 'a#b', ' a\tb ', 'a b 2']])
    for (const bodyNames of [['one', 'two'], ['1 #', '1\\'], ['', '']]) {
      const again = await read({ groups, groupNames, bodies, bodyNames });
      for (let i = 0; i < points.length; ++i) assert.ok(Object.is(again.points[i], points[i]), `${again.points[i]}`);
      assert.deepEqual(again.triangles, triangles);
      assert.deepEqual(again.groups, groups);
      assert.equal(new Set(again.groupNames).size, 4);
      assert.deepEqual(again.bodies, bodies);
    }
  const bare = await read({});
  assert.deepEqual([bare.points, bare.triangles], [points, triangles]);
  const { groupNames } = await read({ groups, groupNames: ['left', 'right', 'up', 'down'] });
  assert.deepEqual(groupNames, ['left', 'right', 'up', 'down']);
});

test('faces of all bodies become groups with names that occur once', async () => {
  const surface = await readCad('', { format: 'step', occt: fakeOcct(['bolt', 'bolt', '', 'bolt 2']) });
  assert.equal(surface.points.length, 4 * 12);
  assert.equal(surface.triangles.length, 4 * 15);
  assert.deepEqual([...surface.triangles.subarray(15, 18)], [4, 5, 6]);
  assert.deepEqual([...surface.groups.subarray(0, 6)], [0, 0, 1, 1, 2, 3]);
  assert.deepEqual(surface.groupNames.slice(0, 4), ['bolt face 1', 'bolt face 2', 'bolt rest', 'bolt 2 face 1']);
  assert.ok(surface.groupNames.includes('body 3 face 1'));
  assert.equal(new Set(surface.groupNames).size, 12);
  assert.deepEqual((await readCad('', { format: 'brep', occt: fakeOcct(['']) })).groupNames,
    ['face 1', 'face 2', 'rest']);
});

test('names that occur often get the numbers that are free, each found at once', async (t) => {
  const next = random(7), texts = ['a', 'a 2', 'a 2 2', 'a 3', 'b', 'b 7'];
  const names = Array.from({ length: 300 }, () => texts[Math.floor(next() * texts.length)]);
  const expected = [];
  for (const name of names) {
    let unique = name;
    for (let count = 2; expected.includes(unique); ++count) unique = `${name} ${count}`;
    expected.push(unique);
  }
  const readNames = async (given) => (await readCad('', { format: 'brep', occt: fakeOcct(given) })).groupNames
    .filter((name) => name.endsWith(' rest')).map((name) => name.slice(0, -' rest'.length));
  assert.deepEqual(await readNames(names), expected);

  const looks = t.mock.method(Set.prototype, 'has');
  assert.equal((await readNames(Array(400).fill('bolt'))).at(-1), 'bolt 400');
  assert.ok(looks.mock.callCount() < 4 * 400, `${looks.mock.callCount()} looks`);
});

test('the size says how fine the triangles are', async () => {
  const calls = [];
  const occt = fakeOcct([''], calls);
  await readCad(new Uint8Array([1, 2]), { name: 'x.igs', size: 2, occt: async () => occt });
  assert.deepEqual(calls.pop(), { kind: 'iges', bytes: new Uint8Array([1, 2]), params: { linearUnit: 'millimeter',
    linearDeflectionType: 'absolute_value', linearDeflection: 0.01, angularDeflection: 0.2 } });
  await readCad(new ArrayBuffer(3), { name: 'x.stp', unit: 'inch', occt: Promise.resolve({ default: async () => occt }) });
  assert.equal(calls.at(-1).bytes.length, 3);
  assert.equal(calls.at(-1).params.linearUnit, 'inch');
  const usual = calls.pop().params;
  assert.equal(usual.linearDeflectionType, 'bounding_box_ratio');
  const ratioFor = async (quads) => {
    await readCad('', { format: 'brep', quads, occt });
    return calls.pop().params.linearDeflection / usual.linearDeflection;
  };
  assert.equal(await ratioFor(100), 1);
  assert.ok(Math.abs(await ratioFor(300000) - 0.1) < 1e-12);
  await readCad('', { format: 'brep', size: 2, linearDeflection: 0.5, angularDeflection: 0.1, occt });
  assert.equal(calls[0].params.linearDeflection, 0.5);
  assert.equal(calls.pop().params.angularDeflection, 0.1);
});

test('what cannot be read has a code and a sentence', async () => {
  const occt = fakeOcct([]);
  await rejectionOf('BAD_OPTION', readCad('', { name: 'x.stl', occt }));
  await rejectionOf('BAD_OPTION', readCad('', { occt }));
  await rejectionOf('EMPTY', readCad('', { format: 'step', occt }));
  for (const read of [() => ({ success: false }), () => { throw 1234; }]) {
    const refusing = { ReadStepFile: read, ReadIgesFile: read, ReadBrepFile: read };
    const refused = (code, text, format) => rejectionOf(code, readCad(text, { format, occt: refusing }));
    assert.equal((await refused('EMPTY', '', 'step')).message, 'The file is empty.');
    const starts = { step: '\n ISO-10303-21;', iges: `${' '.repeat(72)}S      1`, brep: '\nDBRep_DrawableShape\n' };
    for (const [format, start] of Object.entries(starts)) {
      const name = format.toUpperCase();
      for (const mark of ['', '\ufeff'])
        assert.equal((await refused('PARSE_ERROR', mark + start, format)).message, `The file cannot be read as ${name}.`);
      assert.match((await refused('PARSE_ERROR', '<!DOCTYPE html>', format)).message,
        new RegExp(`cannot be read as ${name}: it does not begin as ${name} files do`));
    }
  }
});

test('a STEP file is read by the installed package', needsOcct, async () => {
  const surface = await readCad(boxes, { name: 'boxes.step' });
  assert.equal(surface.triangles.length, 3 * 24);
  assert.deepEqual(surface.groupNames, ['plate', 'block'].flatMap((body) =>
    [1, 2, 3, 4, 5, 6].map((number) => `${body} face ${number}`)));
  assert.equal(Math.max(...surface.points), 11);
  await rejectionOf('PARSE_ERROR', readCad('no STEP file', { format: 'step' }));
});

/** What occt-import-js gives for a box: four points and two triangles a face; `turned` faces are turned over. */
function boxMesh([x, y, z], numbers = [0, 1, 2, 3, 4, 5], turned = false) {
  const mesh = { name: '', brep_faces: [], attributes: { position: { array: [] } }, index: { array: [] } };
  const corners = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
  numbers.forEach((number, k) => {
    for (const n of corners[number])
      mesh.attributes.position.array.push(x + (n & 1), y + (n >> 1 & 1), z + (n >> 2));
    for (const n of turned ? [0, 2, 1, 0, 3, 2] : [0, 1, 2, 0, 2, 3]) mesh.index.array.push(4 * k + n);
    mesh.brep_faces.push({ first: 2 * k, last: 2 * k + 1 });
  });
  return mesh;
}

const joined = (...meshes) => meshes.reduce((sum, { brep_faces: faces, attributes, index }) => {
  const points = sum.attributes.position.array.length / 3, triangles = sum.index.array.length / 3;
  return { name: '', attributes: { position: { array: [...sum.attributes.position.array, ...attributes.position.array] } },
    index: { array: [...sum.index.array, ...index.array.map((v) => v + points)] },
    brep_faces: [...sum.brep_faces,
      ...faces.map(({ first, last }) => ({ first: first + triangles, last: last + triangles }))] };
});

test('a shape that a compound lists again is read once', async () => {
  const read = async (...meshes) => {
    const occt = { ReadBrepFile: () => ({ success: true, meshes }) };
    const { triangles, points, bodyNames } = await readCad('', { format: 'brep', occt });
    assert.ok(Math.max(...triangles) < points.length / 3);
    return [triangles.length / 3, bodyNames.length];
  };
  const box = boxMesh([0, 0, 0]), far = boxMesh([5, 0, 0]), sheet = boxMesh([9, 0, 0], [0]);
  assert.deepEqual(await read(box, far, box), [24, 2]);
  assert.deepEqual(await read(box, far, boxMesh([0, 0, 0], [4, 2, 0, 1, 3, 5])), [24, 2]);
  // Faces beside their solid, some of them turned over, some not of one.
  assert.deepEqual(await read(box, boxMesh([0, 0, 0], [1, 3], true)), [12, 1]);
  assert.deepEqual(await read(box, joined(boxMesh([0, 0, 0], [1, 2, 3]), boxMesh([0, 0, 0], [0, 4, 5], true))), [12, 1]);
  assert.deepEqual(await read(box, joined(boxMesh([0, 0, 0], [1, 3], true), sheet)), [14, 2]);
  assert.deepEqual(await read(box, joined(box, far)), [24, 2]);
  assert.deepEqual(await read(joined(sheet, sheet)), [2, 1]);
  assert.deepEqual(await read(joined(box, box)), [12, 1]);
  // Not the same: what touches with a face, what fills a hole, what is longer and has one face in common.
  assert.deepEqual(await read(box, boxMesh([1, 0, 0])), [24, 2]);
  assert.deepEqual(await read(box, boxMesh([0, 0, 0], undefined, true)), [24, 2]);
  const longer = boxMesh([0, 0, 0]);
  longer.attributes.position.array = longer.attributes.position.array.map((c, i) => (i % 3 === 1 ? 2 * c : c));
  assert.deepEqual(await read(box, longer), [24, 2]);
});

test('a BREP compound with a solid, its shell and its faces has them once', needsOcct, async () => {
  const once = readFileSync(path('tests/fixtures/cad/box_and_cylinder.brep'), 'utf8');
  const all = '+15 0 +2 0 *';
  const faces = [39, 29, 25, 21, 19, 17, 8, 6, 4].map((n, k) => `${'+-'[k % 2]}${n} 0`).join(' ');
  assert.ok(once.includes(all));
  const expected = await readCad(once, { format: 'brep' });
  assert.equal(expected.bodyNames.length, 2);
  for (const list of [`+15 0 ${all}`, '+15 0 +2 0 +16 0 +3 0 *', `+15 0 +2 0 ${faces} *`,
    `+15 0 +16 0 ${faces} +2 0 *`])
    assert.deepEqual(await readCad(once.replace(all, list), { format: 'brep' }), expected, list);
  const loose = await readCad(once.replace(all, `${faces} ${faces} *`), { format: 'brep' });
  assert.equal(loose.triangles.length, expected.triangles.length);
});

test('an assembly whose parts are in other files is told as one', needsOcct, async () => {
  const references = (...names) => stepBoxes([]).replace('\nENDSEC;\nEND-ISO', `
#20=PRODUCT_CONTEXT('',#1,'mechanical');
#21=PRODUCT_DEFINITION_CONTEXT('part definition',#1,'design');
#22=DOCUMENT_TYPE('geometry');
#23=IDENTIFICATION_ROLE('external document id and location',$);
#24=EXTERNAL_SOURCE(IDENTIFIER(''));
${names.map((name, k) => `#${30 + 10 * k}=PRODUCT('part ${k}','part ${k}','',(#20));
#${31 + 10 * k}=PRODUCT_DEFINITION_FORMATION('','',#${30 + 10 * k});
#${32 + 10 * k}=PRODUCT_DEFINITION('design','',#${31 + 10 * k},#21);
#${33 + 10 * k}=DOCUMENT_FILE('${name}','','',#22,'',$) ;
#${34 + 10 * k}=APPLIED_EXTERNAL_IDENTIFICATION_ASSIGNMENT( '${name}',#23,#24,(#${33 + 10 * k}));
#${35 + 10 * k}=APPLIED_DOCUMENT_REFERENCE(#${33 + 10 * k},'',(#${32 + 10 * k}));`).join('\n')}
ENDSEC;\nEND-ISO`);
  const sentence = async (...names) =>
    (await rejectionOf('EMPTY', readCad(references(...names), { format: 'step' }))).message;
  assert.match(await sentence('bolt.stp', 'as1\\nut.stp'), /parts are in other files: bolt\.stp, nut\.stp\. Give/);
  assert.match(await sentence('a.stp', 'b.stp', 'c.stp', 'd.stp', 'e.stp'), /: a\.stp, b\.stp, c\.stp and 2 more\. /);
  await rejectionOf('EMPTY', readCad('', { format: 'step', occt: fakeOcct([]) }));
  const { status, stderr } = lpquad('mesh', file('as1.stp', references('rod.stp')), '-o', join(scratch, 'x.obj'));
  assert.equal(status, 3);
  assert.match(stderr, /error EMPTY: .* an assembly whose parts are in other files: rod\.stp/);
});

test('npx lpquad meshes a STEP file, its faces kept', needsOcct, () => {
  const part = file('boxes.step', boxes);
  const mesh = join(scratch, 'boxes.obj');
  const { status, stdout, stderr } = lpquad('mesh', part, '-o', mesh, '--size', '0.5');
  assert.equal(status, 0, stderr);
  assert.match(stdout, /quads 136, triangles 0/);  // 2 (8 x 4 + 8 x 2 + 4 x 2) + 6 x 4
  assert.match(stdout, /faces 12, curves 24/);
  assert.match(readFileSync(mesh, 'utf8'), /^g plate_face_1$/m);
  const checked = lpquad('check', mesh, '--surface', part);
  assert.equal(checked.status, 0, checked.stderr);
  assert.match(checked.stdout, /parts 2, borders 0, Euler number 4/);
});

const touching = stepBoxes([{ name: 'left', at: [0, 0, 0], size: [1, 1, 1] }, { name: 'right', at: [1, 0, 0], size: [2, 1, 1] }]);
test('bodies that touch stay apart: read, meshed, converted', needsOcct, async () => {
  const surface = await readCad(touching, { name: 'x.step' });
  assert.deepEqual(surface.bodyNames, ['left', 'right']);
  assert.deepEqual([...surface.bodies], [...Array(12).fill(0), ...Array(12).fill(1)]);
  const part = file('touching.step', touching), mesh = join(scratch, 'touching.obj'), report = join(scratch, 'touching.json');
  const made = lpquad('mesh', part, '-o', mesh, '--size', '0.5', '--report', report);
  assert.equal(made.status, 0, made.stderr);
  assert.deepEqual(JSON.parse(readFileSync(report, 'utf8')).bodies.map(({ name, quads, parts, borderEdges }) => [name, quads, parts, borderEdges]),
    [['left', 24, 1, 0], ['right', 40, 1, 0]]);
  const checked = lpquad('check', mesh, '--surface', part);
  assert.equal(checked.status, 0, checked.stdout + checked.stderr);
  assert.match(checked.stdout, /parts 2, borders 0, Euler number 4/);
  const triangles = join(scratch, 'touching triangles.obj');
  assert.match(lpquad('convert', part, '-o', triangles).stdout, /parts 2, border edges 0, bodies 2/);
  assert.equal(lpquad('check', mesh, '--surface', triangles).status, 0);
});

test('npx lpquad converts, so that the native program can read it', needsOcct, () => {
  const out = join(scratch, 'triangles.obj');
  const { status, stdout, stderr } = lpquad('convert', file('two.stp', boxes), '-o', out);
  assert.equal(status, 0, stderr);
  assert.match(stdout, /triangles 24, vertices 16, groups 12, parts 2, border edges 0/);
  assert.match(readFileSync(out, 'utf8'), /^g block_face_6$/m);
});

test('broken and missing files are named as they were given', needsOcct, () => {
  const broken = file('broken.step', 'ISO-10303-21;');
  const { status, stderr } = lpquad('mesh', broken, '-o', join(scratch, 'x.obj'));
  assert.equal(status, 3);
  assert.equal(stderr, `${broken}: error PARSE_ERROR: The file cannot be read as STEP.\n`);
  const missing = lpquad('mesh', join(scratch, 'missing.igs'), '-o', join(scratch, 'x.obj'));
  assert.equal(missing.status, 3);
  assert.match(missing.stderr, /IO_ERROR/);
});

// A copy of the package in a place of its own, where nothing is beside it.
test('without occt-import-js a sentence says what to install', () => {
  const home = join(scratch, 'alone');
  mkdirSync(home);
  cpSync(path('dist'), join(home, 'dist'), { recursive: true });
  writeFileSync(join(home, 'package.json'), '{"type": "module"}');
  const call = () => spawnSync(process.execPath, [join(home, 'dist/cli.js'), 'mesh', file('alone.step', boxes),
    '-o', join(scratch, 'alone.obj'), '--size', '1'], { encoding: 'utf8', cwd: home });
  const { status, stderr } = call();
  assert.equal(status, 3);
  assert.match(stderr, /error IO_ERROR: .*npm install occt-import-js/);
  const script = `import { readCad } from './dist/cad.js';
    await readCad('', { format: 'step' }).catch((error) => console.log(error.code, error.message));`;
  const { stdout } = spawnSync(process.execPath, ['--input-type=module', '-e', script], { encoding: 'utf8', cwd: home });
  assert.match(stdout, /^IO_ERROR .*npm install occt-import-js/);
  if (!installed) return;
  mkdirSync(join(home, 'node_modules'));
  symlinkSync(path('node_modules/occt-import-js'), join(home, 'node_modules/occt-import-js'));
  assert.equal(call().status, 0);
});

// Files of the benchmark data, where it lies beside the project.
const data = path('../shared/data/step');
const files = existsSync(data) ? readdirSync(data) : [];
test('STEP, IGES and BREP files of many programs are meshed',
  { skip: installed && files.length > 0 ? false : 'SKIPPED: no occt-import-js, or no benchmark data' }, async (t) => {
    for (const name of files)
      await t.test(name, () => {
        const mesh = join(scratch, 'data.obj');
        const { status, stdout, stderr } = lpquad('mesh', join(data, name), '-o', mesh);
        assert.equal(status, 0, stderr);
        assert.match(stdout, /triangles 0\n/);
        const bodies = { 'as1-tu-203.stp': 18, 'dm1-id-214.stp': 7 }[name];
        if (bodies) assert.match(stdout, new RegExp(`bodies ${bodies}\\n`));
      });
  });
