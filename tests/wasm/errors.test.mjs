import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';

import { circle, createLpquad, dist, errorOf, rectangle, rejectionOf, square } from './support.mjs';

const lpquad = await createLpquad();
const refuse = (code, domain, options) => errorOf(code, () => lpquad.meshDomain(domain, options));

test('a wrong form is named by its path', () => {
  const loop = (points) => ({ loops: [points] });
  const cases = [
    [undefined, 'domain'], [null, 'domain'], [7, 'domain'], ['text', 'domain'],
    [{}, 'domain.loops'], [{ loops: 5 }, 'domain.loops'], [loop(null), 'domain.loops[0]'],
    [loop('0 0 1 0 1 1'), 'domain.loops[0]'],
    [loop([[0, 0], [1, 0], [1, 'a']]), 'domain.loops[0][2][1]'],
    [loop([[0, 0], [1, 0, 0], [1, 1]]), 'domain.loops[0][1]'],
    [loop([[0, 0], null, [1, 1]]), 'domain.loops[0][1]'],
    [loop([0, 0, 1, 0, 1]), 'domain.loops[0]'],
    [loop([[0, 0], 1, 0, 1, 1]), 'domain.loops[0][1]'],
    [loop([0, 0, [1, 0], 1]), 'domain.loops[0][2]'],
    [loop(BigInt64Array.of(0n, 0n)), 'domain.loops[0][0]'],
    [{ ...square, hole: [] }, 'domain.hole'], [{ ...square, regions: [] }, 'domain'],
    [{ regions: {} }, 'domain.regions'], [{ regions: [square, null] }, 'domain.regions[1]'],
    [{ regions: [{ ...square, name: 5 }] }, 'domain.regions[0].name'],
    [{ regions: [{ ...square, size: 5 }] }, 'domain.regions[0].size'],
    [{ ...square, tags: 'a' }, 'domain.tags'], [{ ...square, tags: ['a'] }, 'domain.tags[0]'],
    [{ ...square, tags: [['a']] }, 'domain.tags[0]'], [{ ...square, tags: [['a', 'b', 'c']] }, 'domain.tags[0]'],
    [{ ...square, tags: [[], []] }, 'domain.tags must be a list of texts for each loop'],
    [{ loops: rectangle(0, 0, 1) }, 'domain.loops must be an array of loops,'], [[], 'domain must be an object { loops,'],
    [{ ...square, tags: [['a', 'b', 'c', 4]] }, 'domain.tags[0][3]'],
    [{ ...square, polylines: 1 }, 'domain.polylines'],
    [{ ...square, polylines: [[[0, 0]]] }, 'domain.polylines[0] must be an object { points, tag },'],
    [{ ...square, polylines: [{ points: [[0.2]] }] }, 'domain.polylines[0].points[0]'],
    [{ ...square, polylines: [{ points: [0.2, 0.2, 0.4, 0.4], tag: 1 }] }, 'domain.polylines[0].tag'],
    [{ ...square, points: 'x' }, 'domain.points'], [{ ...square, points: [3] }, 'domain.points[0]'],
    [{ ...square, points: [{ position: 3 }] }, 'domain.points[0].position'],
    [{ ...square, h: '1' }, 'domain.h'],
  ];
  for (const [domain, path] of cases) {
    const { message } = refuse('PARSE_ERROR', domain);
    assert.ok(message.startsWith(`${path} `), `${message} does not begin with ${path}`);
  }
  for (const value of [NaN, Infinity]) {
    const nested = refuse('NON_FINITE', { loops: [[[0, 0], [1, 0], [1, value]]] });
    assert.ok(nested.message.startsWith('domain.loops[0][2][1] '));
    assert.deepEqual(nested.where, { region: 0, loop: 0, edge: 2 });
    assert.deepEqual(refuse('NON_FINITE', { loops: [[0, 0, 1, 0, value, 1]] }).where, nested.where);
    refuse('NON_FINITE', { ...square, h: value });
  }
});

test('a loop whose first point is repeated has a tag per edge or per point', async () => {
  const tags = ['south', 'east', 'north', 'west'], open = square.loops[0], closed = [...open, open[0]];
  const expected = lpquad.meshDomain({ loops: [open], tags: [tags] }, { size: 0.25 });
  const read = await lpquad.readDomain(JSON.stringify({ loops: [closed], tags: [tags] }), { format: 'json' });
  for (const domain of [{ loops: [closed], tags: [tags] }, { loops: [closed.flat()], tags: [[...tags, '']] }, read]) {
    const { points, edges, edgeTags, tags: names } = lpquad.meshDomain(domain, { size: 0.25 });
    assert.deepEqual([points, edges, edgeTags, names],
      [expected.points, expected.edges, expected.edgeTags, expected.tags]);
  }
  assert.match(refuse('PARSE_ERROR', { loops: [closed], tags: [tags.slice(1)] }).message, /has edges \(4\)/);
});

test('tags that a file leaves out are empty once it is read', async () => {
  for (const [tags, given] of [[[['south', 'east']], 2], [[[], []], 0]]) {
    const read = await lpquad.readDomain(JSON.stringify({ ...square, tags }), { format: 'json' });
    assert.equal(read.warnings.length, given > 0 ? 1 : 0);
    assert.equal(new Set(lpquad.meshDomain(read, { size: 0.25 }).tags).size, given);
  }
});

/** A typed array whose buffer is somewhere else by now. */
function transferred(list) {
  structuredClone(list, { transfer: [list.buffer] });
  return list;
}

test('an array whose buffer was transferred is told from an empty one', async () => {
  const gone = transferred(Float64Array.of(0, 0, 1, 0, 1, 1));
  assert.match(refuse('PARSE_ERROR', { loops: [gone] }).message, /^domain\.loops\[0\] .*transferred/);
  assert.match(refuse('PARSE_ERROR', { ...square, seedPoints: gone }).message, /^domain\.seedPoints .*transferred/);
  assert.match(refuse('PARSE_ERROR', { ...square, sizes: gone }).message, /^domain\.sizes .*transferred/);
  for (const options of [{ sizes: gone }, { seedPoints: gone }, { guides: [gone] }])
    assert.match(refuse('BAD_OPTION', square, options).message, new RegExp(`^Option ${Object.keys(options)[0]}.*transferred`));
  const mesh = lpquad.meshDomain(square, { size: 0.5 });
  for (const name of Object.keys(mesh).filter((key) => ArrayBuffer.isView(mesh[key])))
    assert.match(errorOf('PARSE_ERROR', () => lpquad.writeMesh({ ...mesh, [name]: transferred(mesh[name].slice()) }, 'obj')).message,
      new RegExp(`^mesh\\.${name} .*transferred`));
  const bytes = transferred(Uint8Array.of(1, 2, 3)), read = [lpquad.readDomain, lpquad.readSurface, lpquad.isSurfaceFile];
  for (const call of read)
    for (const source of [bytes, bytes.buffer])
      assert.match((await rejectionOf('PARSE_ERROR', call.call(lpquad, source, { name: 'a.json' }))).message, /^The file .*transferred/);
  refuse('TOO_FEW_POINTS', { loops: [new Float64Array()] });
  assert.ok(lpquad.meshDomain({ ...square, seedPoints: new Float64Array(), source: 'a drawing', licence: 'MIT' }));
});

test('options are known by name, type and range', () => {
  assert.match(refuse('BAD_OPTION', square, { siz: 1 }).message, /'siz'.*'size'/);
  assert.match(refuse('BAD_OPTION', square, { keepBoundry: true }).message, /'keepBoundary'/);
  for (const option of lpquad.options) {
    const wrong = { number: ['1', true, null], integer: ['1', 1.5, NaN], boolean: [1, 'true', null],
      choice: ['none', 1, null] }[option.type];
    for (const value of wrong) {
      const { message } = refuse('BAD_OPTION', square, { [option.name]: value });
      assert.ok(message.startsWith(`Option ${option.name} must be `), message);
    }
    if (option.type !== 'number' && option.type !== 'integer') continue;
    for (const value of [option.min - 1, option.max < 1e300 ? 2 * option.max + 1 : Infinity])
      assert.match(refuse(option.name === 'size' ? 'BAD_SIZE' : 'BAD_OPTION', square, { [option.name]: value })
        .message, new RegExp(option.name, 'i'));
  }
  for (const options of [null, 5, 'fine', [], ['size'], Float64Array.of(1)]) refuse('BAD_OPTION', square, options);
  refuse('BAD_OPTION', square, Object.create({ siz: 1 }));
  assert.equal(lpquad.meshDomain(square, Object.create({ size: 0.25 })).report.quads, 16);
  refuse('BAD_OPTION', square, { memory: false });
  refuse('BAD_OPTION', square, { signal: new AbortController().signal });
  for (const name of ['sizeAt', 'angleAt', 'onProgress'])
    assert.match(refuse('BAD_OPTION', square, { [name]: 5 }).message, new RegExp(name));
  for (const sizes of [5, 'abc', [1, 2], [[1, 2]], [[1, 2, NaN]], [[1, 2, 3], 4], { length: 3 }])
    assert.match(refuse('BAD_OPTION', square, { sizes }).message, /sizes/);
  for (const seedPoints of [5, [1], [[1]], [[1, NaN]], [[1, 2, 3]]])
    assert.match(refuse('BAD_OPTION', square, { seedPoints }).message, /seedPoints/);
  for (const guides of [5, 'abc', null, [5], [[1, 2, 3]], [[[1, 2], [3]]], [[1, 2]], [[1, 2, 1, 2]], [[]]])
    assert.match(refuse('BAD_OPTION', square, { guides }).message, /guide/);
  assert.equal(lpquad.meshDomain(square,
    { size: 0.25, norm: undefined, sizes: undefined, guides: undefined }).report.quads, 16);
});

test('sizes, guides and seed points of a domain are judged as its other members are', () => {
  for (const sizes of [5, [[1, 2]], [1, 2], [[1, 2, NaN]]])
    assert.match(errorOf('PARSE_ERROR', () => lpquad.meshDomain({ ...square, sizes })).message, /^domain\.sizes /);
  assert.match(errorOf('PARSE_ERROR', () => lpquad.meshDomain({ ...square, guides: [[[0, 0], 1]] })).message,
    /^domain\.guides\[0\]\[1\] /);
  for (const seedPoints of [5, [1], [[1]], [[1, 2, 3]]])
    assert.match(errorOf('PARSE_ERROR', () => lpquad.meshDomain({ ...square, seedPoints })).message, /^domain\.seedPoints/);
  errorOf('NON_FINITE', () => lpquad.meshDomain({ ...square, seedPoints: [[0.5, Infinity]] }));
  const { where } = errorOf('NON_FINITE', () =>
    lpquad.meshDomain({ ...square, guides: [[0, 0, 1, 1], [[0, 0], [0, NaN]]] }));
  assert.deepEqual(where, { guide: 1, edge: 1 });
  const still = errorOf('BAD_OPTION', () => lpquad.meshDomain(square, { guides: [[0, 0, 1, 1], [0.5, 0.25, 0.5, 0.25]] }));
  assert.deepEqual(still.where, { guide: 1, x: 0.5, y: 0.25 });
});

test('every code that input can cause is given, with its place', () => {
  const box = rectangle;
  const odd = [[0, 0], [1, 0], [1, 1], [0.5, 1], [0, 1]];
  // A strip so far away that no double lies inside it, with points in a row that no quad can use.
  const coarse = [[0, 0], [1, 0], [4, 0], [4, 1], [3, 1], [2, 1], [1, 1], [0, 1]]
    .map(([x, y]) => [1e9 + x * 2 ** -23, 1e9 + y * 2 ** -23]);
  const cases = {
    BAD_SIZE: [square, { sizes: [[0.75, 0.25, -1]] }, { x: 0.75, y: 0.25 }],
    NON_FINITE: [square, { size: 0.2, angleAt: () => NaN }, ['x', 'y']],
    EMPTY: [{ loops: [] }, {}, {}],
    TOO_FEW_POINTS: [{ loops: [box(0, 0, 9), [[1, 1], [2, 2]]] }, {}, { loop: 1 }],
    DUPLICATE_POINT: [{ loops: [[[0, 0], [1, 0], [1, 0], [1, 1]]] }, { strict: true }, { edge: 1, x: 1, y: 0 }],
    ZERO_AREA: [{ loops: [[[0, 0], [1, 0], [2, 0]]] }, {}, { loop: 0 }],
    SELF_INTERSECTION: [{ loops: [[[0, 0], [4, 4], [4, 0], [0, 6]]] }, {},
      { edge: 0, otherEdge: 2, x: 2.4, y: 2.4 }],
    OVERLAPPING_EDGES: [{ loops: [box(0, 0, 4), box(0, 1, 1)] }, {}, { loop: 0, edge: 3, otherLoop: 1 }],
    TOUCHING: [{ loops: [box(0, 0, 4), [[0, 1], [1, 2], [1, 0.5]]] }, {}, { x: 0, y: 1 }],
    HOLE_OUTSIDE: [{ loops: [box(0, 0, 4), box(5, 5, 1)] }, {}, { loop: 1, x: 5, y: 5 }],
    NESTED_OR_DUPLICATE_HOLE: [{ loops: [box(0, 0, 9), box(1, 1, 4), box(2, 2, 1)] }, {}, { loop: 2 }],
    REGION_CONFLICT: [{ regions: [{ loops: [box(0, 0, 2)] }, { loops: [box(1, 1, 2)] }] }, {}, { region: 0 }],
    ODD_BOUNDARY: [{ loops: [odd] }, { keepBoundary: true }, { region: 0 }],
    LOST_PRECISION: [{ loops: [box(0, 0, 4), [[1, 1e-300], [3, 1e-300], [3, 1]]] }, {}, { x: 1 }],
    TOO_MANY_ELEMENTS: [square, { size: 0.01, maxElements: 10 }, {}],
    NO_VALID_MESH: [{ loops: [coarse] }, { keepBoundary: true }, ['x', 'y']],
    CANCELLED: [square, { onProgress: () => false }, {}],
  };
  for (const [code, [domain, options, where]] of Object.entries(cases)) {
    const error = refuse(code, domain, options);
    assert.ok(lpquad.errorCodes.includes(code));
    if (Array.isArray(where)) for (const name of where) assert.equal(typeof error.where[name], 'number');
    else for (const [name, value] of Object.entries(where)) assert.equal(error.where[name], value, `${code} ${name}`);
    // The instance is as good as before.
    assert.equal(lpquad.meshDomain(square, { size: 0.25 }).report.quads, 16);
  }
});

test('meshes that no writer could follow are refused', () => {
  const mesh = lpquad.meshDomain({ loops: [circle(0, 0, 1, 20)] }, { size: 0.3 });
  const write = (changed) => errorOf('PARSE_ERROR', () => lpquad.writeMesh({ ...mesh, ...changed }, 'obj'));
  for (const name of Object.keys(mesh).filter((key) => key !== 'report')) {
    assert.match(write({ [name]: undefined }).message, new RegExp(`mesh\\.${name} `));
    assert.match(write({ [name]: 'x' }).message, new RegExp(`mesh\\.${name} `));
  }
  write({ quads: mesh.quads.map((v) => v + 1000) });
  write({ edges: mesh.edges.map(() => 2 ** 32 - 5) });
  write({ quadRegions: mesh.quadRegions.map(() => -1) });
  write({ boundaryNodes: 1e6 });
  write({ tags: [5] });
  write({ points: mesh.points.subarray(1) });
  for (const value of [null, 5, undefined]) errorOf('PARSE_ERROR', () => lpquad.writeMesh(value, 'obj'));
  for (const value of [null, 5, 'x', []]) errorOf('BAD_OPTION', () => lpquad.writeMesh(mesh, 'msh', value));
  errorOf('BAD_OPTION', () => lpquad.writeMesh(mesh, 'stl'));
  errorOf('BAD_OPTION', () => lpquad.writeMesh(mesh, undefined));
  assert.match(errorOf('BAD_OPTION', () => lpquad.writeMesh(mesh, 'msh', { mshversion: '2.2' })).message,
    /'mshVersion'/);
  errorOf('BAD_OPTION', () => lpquad.writeMesh(mesh, 'msh', { mshVersion: 2.2 }));
});

test('numbers of a mesh that a file would not hold are named', () => {
  const mesh = lpquad.meshDomain({ ...square, points: [{ position: [0.5, 0.5], tag: 'mid' }] }, { size: 0.25 });
  const write = (code, name, value) => {
    const changed = { ...mesh, [name]: Array.from(mesh[name]) };
    changed[name][1 % mesh[name].length] = value;
    assert.match(errorOf(code, () => lpquad.writeMesh(changed, 'obj')).message, new RegExp(`^mesh\\.${name}\\[\\d\\] `));
  };
  for (const value of [NaN, Infinity]) write('NON_FINITE', 'points', value);
  for (const value of ['0.5', null, undefined, 1n]) write('PARSE_ERROR', 'points', value);
  for (const name of ['quads', 'quadRegions', 'edges', 'edgeTags', 'edgeRegions', 'edgeOrigins', 'taggedPoints', 'pointTags'])
    for (const value of [NaN, 1.5, '1', null, 2 ** 32, 1n]) write('PARSE_ERROR', name, value);
  for (const boundaryNodes of [NaN, 1.5, -1, 2 ** 32, '4'])
    assert.match(errorOf('PARSE_ERROR', () => lpquad.writeMesh({ ...mesh, boundaryNodes }, 'obj')).message, /^mesh\.boundaryNodes /);
  const plain = Object.fromEntries(Object.entries(mesh).map(([name, value]) => [name, ArrayBuffer.isView(value) ? Array.from(value) : value]));
  assert.equal(lpquad.writeMesh(plain, 'msh'), lpquad.writeMesh(mesh, 'msh'));
});

test('arrays of a mesh whose lengths do not fit are named with both', () => {
  const tagged = lpquad.meshDomain({ ...square, points: [{ position: [0.5, 0.5], tag: 'mid' }] }, { size: 0.25 });
  const mesh = { ...tagged, triangles: Uint32Array.of(0, 1, 2), triangleRegions: Int32Array.of(0) };
  assert.deepEqual([mesh.taggedPoints.length, mesh.pointTags.length], [1, 1]);
  const besides = { quadRegions: 'quads', triangleRegions: 'triangles', edgeTags: 'edges', edgeRegions: 'edges',
    edgeOrigins: 'edges', pointTags: 'taggedPoints' };
  lpquad.writeMesh(mesh, 'msh');
  for (const [name, other] of Object.entries(besides))
    for (const values of [[], mesh[name].subarray(1), [...mesh[name], 0], [...mesh[name], ...mesh[name]]]) {
      const { message } = errorOf('PARSE_ERROR', () => lpquad.writeMesh({ ...mesh, [name]: values }, 'msh'));
      assert.ok(message.startsWith(`mesh.${name} has ${values.length} entries and mesh.${other} has ${mesh[other].length},`),
        message);
    }
  for (const name of ['quads', 'triangles', 'edges']) {
    const longer = [...mesh[name], 0];
    assert.match(errorOf('PARSE_ERROR', () => lpquad.writeMesh({ ...mesh, [name]: longer }, 'msh')).message,
      new RegExp(`mesh\\.${name} has ${longer.length},`));
  }
  errorOf('PARSE_ERROR', () => lpquad.writeMesh({ ...mesh, points: new DataView(new ArrayBuffer(8)) }, 'msh'));
});

test('files that are not what they say are refused with line and byte', async () => {
  const broken = await rejectionOf('PARSE_ERROR', lpquad.readDomain('{"loops": [\n[[0, 0], [1, "x"]]]}', { format: 'json' }));
  assert.equal(broken.where.line, 2);
  assert.equal(typeof broken.where.byte, 'number');
  for (const source of [5, null, undefined, [1, 2], {}]) await rejectionOf('PARSE_ERROR', lpquad.readDomain(source));
  await rejectionOf('BAD_OPTION', lpquad.readDomain('', { format: 'doc' }));
  await rejectionOf('BAD_OPTION', lpquad.readDomain('', { fmt: 'svg' }));
});

test('what is not the library\'s WebAssembly is refused in plain words', async () => {
  const html = new TextEncoder().encode('<!doctype html>');
  const page = await rejectionOf('BAD_WASM', createLpquad({ wasmBinary: html }));
  assert.match(page.message, /HTML/);
  await rejectionOf('BAD_WASM', createLpquad({ wasmBinary: new Uint8Array() }));
  await rejectionOf('BAD_WASM', createLpquad({ wasmBinary: readFileSync(dist('lpquad.wasm')).subarray(0, 999) }));
  await rejectionOf('BAD_WASM', createLpquad({ wasmBinary: Uint8Array.of(0, 97, 115, 109, 1, 0, 0, 0) }));
  await rejectionOf('BAD_WASM', createLpquad({ wasmBinary: 'AGFzbQ==' }));
  await rejectionOf('BAD_WASM', createLpquad({ wasmModule: {} }));
  await rejectionOf('BAD_WASM', createLpquad({ wasmUrl: new URL('no/such.wasm', dist('')) }));
  await rejectionOf('BAD_WASM', createLpquad({ wasmUrl: 'data:text/html,<p>' }));
  await rejectionOf('BAD_OPTION', createLpquad({ wasmURL: 'x' }));
  await rejectionOf('BAD_OPTION', createLpquad(null));
});
