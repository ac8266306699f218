import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';

import { circle, createLpquad, createLpquadWorker, dist, errorOf, meshHash, path, plate, rectangle, rejectionOf, square } from './support.mjs';

const lpquad = await createLpquad();

/** Every quad turns left at every corner; each inner edge has two sides, each outer one is listed. */
function checkMesh(mesh) {
  const { points, quads, edges } = mesh;
  const sides = new Map();
  for (let q = 0; q < quads.length; q += 4)
    for (let k = 0; k < 4; ++k) {
      const [a, b, c] = [0, 1, 2].map((i) => quads[q + (k + i) % 4]);
      const cross = (points[2 * b] - points[2 * a]) * (points[2 * c + 1] - points[2 * b + 1]) -
        (points[2 * b + 1] - points[2 * a + 1]) * (points[2 * c] - points[2 * b]);
      assert.ok(cross > 0, `quad ${q / 4} is not convex`);
      const key = Math.min(a, b) * 1e6 + Math.max(a, b);
      sides.set(key, (sides.get(key) ?? 0) + 1);
    }
  const listed = new Set();
  for (let e = 0; e < edges.length; e += 2)
    listed.add(Math.min(edges[e], edges[e + 1]) * 1e6 + Math.max(edges[e], edges[e + 1]));
  for (const [key, count] of sides) assert.ok(count === 2 || (count === 1 && listed.has(key)));
  for (const key of listed) assert.ok(sides.has(key));
}

test('the factory is idempotent and says what it knows', async () => {
  assert.equal(await createLpquad(), lpquad);
  assert.equal(await createLpquad({}), lpquad);
  assert.equal(lpquad.build, 'simd');
  assert.equal(lpquad.version, JSON.parse(readFileSync(path('package.json'))).version);
  assert.match(readFileSync(path('CMakeLists.txt'), 'utf8'), new RegExp(`VERSION ${lpquad.version} `));
});

test('bytes, a compiled module and an address give the same meshes', async () => {
  const bytes = readFileSync(dist('lpquad-plain.wasm'));
  const buffer = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength);
  const expected = meshHash(lpquad.meshDomain(plate, { size: 0.1 }));
  for (const source of [{ wasmBinary: bytes }, { wasmBinary: buffer },
    { wasmModule: await WebAssembly.compile(bytes) }, { wasmUrl: dist('lpquad-plain.wasm') },
    { wasmUrl: dist('lpquad.wasm').href }, { wasmUrl: path('dist/lpquad.wasm') }]) {
    const other = await createLpquad(source);
    assert.equal(await createLpquad(source), other);
    assert.equal(other.build, 'custom');
    assert.equal(meshHash(other.meshDomain(plate, { size: 0.1 })), expected);
  }
});

test('an instance is that of all its addresses, and an address is a text or a URL', async () => {
  const wasmModule = await WebAssembly.compile(readFileSync(dist('lpquad-plain.wasm')));
  const lost = await createLpquad({ wasmModule, readersUrl: '/nowhere.wasm' }), own = await createLpquad({ wasmModule });
  assert.notEqual(lost, own);
  assert.equal(await createLpquad({ wasmModule }), own);
  assert.ok(await own.readDomain(JSON.stringify(square), { format: 'json' }));
  await rejectionOf('BAD_WASM', lost.readDomain(JSON.stringify(square), { format: 'json' }));
  for (const name of ['wasmUrl', 'readersUrl', 'surfaceUrl'])
    for (const address of [null, '', 5]) {
      assert.match((await rejectionOf('BAD_WASM', createLpquad({ [name]: address }))).message, new RegExp(`^${name} must be an address`));
      errorOf('BAD_WASM', () => createLpquadWorker({ [name]: address }));
    }
});

test('lpquad/inline gives the same meshes', async () => {
  const inline = await (await import(dist('inline.js').href)).createLpquad();
  assert.notEqual(inline, lpquad);
  assert.equal(inline.build, 'plain');
  assert.equal(meshHash(inline.meshDomain(plate, { size: 0.1 })),
    meshHash(lpquad.meshDomain(plate, { size: 0.1 })));
});

test('nested, flat and typed loops are the same domain', () => {
  const [outer, hole] = plate.loops;
  const expected = meshHash(lpquad.meshDomain(plate, { size: 0.1 }));
  for (const loops of [[outer.flat(), hole.flat()],
    [Float64Array.from(outer.flat()), Float64Array.from(hole.flat())],
    [outer.map((p) => Float64Array.from(p)), hole], [hole, [...outer].reverse()].reverse()].slice(0, 3))
    assert.equal(meshHash(lpquad.meshDomain({ loops }, { size: 0.1 })), expected);
  assert.equal(meshHash(lpquad.meshDomain({ regions: [plate] }, { size: 0.1 })), expected);
  assert.equal(meshHash(lpquad.meshDomain({ ...plate, h: 0.1 })), expected);
});

test('a mesh has every member of its type', () => {
  const mesh = lpquad.meshDomain(plate, { size: 0.1 });
  checkMesh(mesh);
  const types = { points: Float64Array, quads: Uint32Array, quadRegions: Int32Array,
    triangles: Uint32Array, triangleRegions: Int32Array, edges: Uint32Array, edgeTags: Int32Array,
    edgeRegions: Int32Array, edgeOrigins: Int32Array, taggedPoints: Uint32Array,
    pointTags: Int32Array, regions: Array, tags: Array, boundaryNodes: Number, report: Object };
  assert.deepEqual(Object.keys(mesh).sort(), Object.keys(types).sort());
  for (const [name, type] of Object.entries(types)) assert.equal(mesh[name].constructor, type, name);
  assert.equal(mesh.quadRegions.length, mesh.quads.length / 4);
  assert.equal(mesh.edgeTags.length, mesh.edges.length / 2);
  assert.equal(mesh.edgeRegions.length, mesh.edges.length);
  assert.equal(mesh.edgeOrigins.length, 3 * mesh.edgeTags.length);
  assert.equal(mesh.report.quads, mesh.quads.length / 4);
  assert.match(mesh.report.hash, /^[0-9a-f]{16}$/);
});

test('what interfaces the declarations name is there', () => {
  const declared = readFileSync(dist('index.d.ts'), 'utf8');
  const members = (name) => {
    const body = declared.match(new RegExp(`export interface ${name} [^{]*\\{([\\s\\S]*?)\\n\\}`))[1]
      .replace(/\/\*[\s\S]*?\*\//g, '');
    return [...body.matchAll(/^ {2}(\w+)\??[:(]/gm)].map((match) => match[1]);
  };
  const mesh = lpquad.meshDomain(plate, { size: 0.1 });
  for (const name of members('Mesh')) assert.ok(name in mesh, name);
  for (const name of members('Report')) assert.ok(name in mesh.report, name);
  for (const name of members('Description')) assert.ok(lpquad[name] !== undefined, name);
  for (const name of members('Lpquad')) assert.equal(typeof lpquad[name], 'function', name);
  const session = lpquad.start(plate, { size: 0.1 });
  for (const name of members('Session')) assert.ok(session[name] !== undefined, name);
  for (const name of [...members('Progress'), ...members('State')]) assert.ok(name in session.state, name);
  session.finish();
  const layers = Object.fromEntries(members('Layers').map((name) => [name, true]));
  const snapshot = session.snapshot(layers);
  for (const name of members('Snapshot')) assert.ok(name in snapshot, name);
  session.dispose();
});

test('a kept boundary comes back bit for bit', () => {
  const loop = circle(0.1, 1e5, 0.3, 40);
  const mesh = lpquad.meshDomain({ loops: [loop] }, { keepBoundary: true });
  checkMesh(mesh);
  assert.equal(mesh.boundaryNodes, 40);
  assert.deepEqual([...mesh.points.slice(0, 80)], loop.flat());
});

test('a kept boundary of odd count gets one triangle where it is allowed, and the report says where', () => {
  const odd = [[0, 0], [1, 0], [2, 0], [3, 0], [3, 1], [3, 2], [2, 2], [1, 2], [0, 2]];
  const mesh = lpquad.meshDomain({ loops: [odd] }, { keepBoundary: true, elements: 'one-triangle' });
  assert.equal(mesh.triangles.length, 3);
  assert.equal(mesh.report.triangles, 1);
  const [{ code, where }] = mesh.report.warnings;
  assert.equal(code, 'ODD_BOUNDARY');
  assert.ok(where.x > 0 && where.x < 3 && where.y > 0 && where.y < 2);
});

test('regions, tags, polylines and points reach the mesh by name', () => {
  const domain = {
    regions: [
      { name: 'steel', loops: [rectangle(0, 0, 1)], tags: [['bottom', null, 'top', undefined]] },
      { name: 'air', loops: [rectangle(1, 0, 1)], tags: [['bottom', 'outlet', '', '']] },
    ],
    polylines: [{ points: [[0.25, 0.25], [0.75, 0.25]], tag: 'crack' }],
    points: [[0.5, 0.75], { position: [1.5, 0.5], tag: 'sensor' }],
  };
  const mesh = lpquad.meshDomain(domain, { size: 0.125 });
  checkMesh(mesh);
  assert.deepEqual(mesh.regions, ['steel', 'air']);
  assert.deepEqual(new Set(mesh.quadRegions), new Set([0, 1]));
  assert.deepEqual([...mesh.tags].sort(), ['bottom', 'crack', 'outlet', 'sensor', 'top']);
  const lengthOf = (tag) => {
    let sum = 0;
    mesh.edgeTags.forEach((t, e) => {
      if (mesh.tags[t] !== tag) return;
      const [a, b] = mesh.edges.slice(2 * e, 2 * e + 2);
      sum += Math.hypot(mesh.points[2 * a] - mesh.points[2 * b], mesh.points[2 * a + 1] - mesh.points[2 * b + 1]);
    });
    return sum;
  };
  for (const [tag, expected] of [['bottom', 2], ['top', 1], ['outlet', 1], ['crack', 0.5]])
    assert.ok(Math.abs(lengthOf(tag) - expected) < 1e-12, `${tag}: ${lengthOf(tag)}`);
  assert.equal(mesh.taggedPoints.length, 1);
  const [sensor] = mesh.taggedPoints;
  assert.deepEqual([...mesh.points.slice(2 * sensor, 2 * sensor + 2)], [1.5, 0.5]);
  // Between the regions edges have one on each side.
  const between = mesh.edgeRegions.filter((r, i) => i % 2 === 0 && r >= 0 && mesh.edgeRegions[i + 1] >= 0 &&
    r !== mesh.edgeRegions[i + 1]);
  assert.ok(between.length > 0);
});

test('a start of the caller\'s own is squared up, and the run says how far it is', async () => {
  const seedPoints = [];
  for (let j = 1; j < 10; ++j)
    for (let i = 1; i < 10; ++i) seedPoints.push([(i + 0.1 * Math.sin(9 * i + 5 * j)) / 10, (j + 0.1 * Math.cos(7 * i * j)) / 10]);
  const session = lpquad.start(square, { size: 0.1, method: 'paper', seedPoints });
  const first = session.step();
  assert.ok(first.gradientNorm > 0 && first.tau > 0.9);
  const last = session.step(40);
  assert.ok(last.tau > first.tau && last.gradientNorm < first.gradientNorm);
  const mesh = session.finish();
  assert.equal(mesh.report.seeds, 81);
  assert.equal(mesh.report.lp.gradientNorm[0], first.gradientNorm);
  assert.equal(meshHash(mesh), meshHash(lpquad.meshDomain(square, { size: 0.1, method: 'paper', seedPoints: seedPoints.flat() })));
  const read = await lpquad.readDomain(JSON.stringify({ ...square, seedPoints }));
  assert.deepEqual(read.seedPoints, seedPoints);
  for (const [domain, options] of [[{ ...square, seedPoints }, {}], [{ ...square, seedPoints: Float64Array.from(seedPoints.flat()) }, {}], [read, {}],
    [{ ...square, seedPoints: [[0.5, 0.5]] }, { seedPoints }]])
    assert.equal(meshHash(lpquad.meshDomain(domain, { size: 0.1, method: 'paper', ...options })), meshHash(mesh));
  session.dispose();
});

test('sizes at points, a size function and an angle function are followed', () => {
  const coarse = lpquad.meshDomain(square, { size: 0.1 }).report.quads;
  // A fine corner, given by samples 0.1 apart.
  const samples = Array.from({ length: 25 }, (_, i) => [0.05 + 0.1 * (i % 5), 0.05 + 0.1 * Math.floor(i / 5), 0.03]);
  const nested = lpquad.meshDomain(square, { size: 0.1, sizes: samples });
  const flat = lpquad.meshDomain(square, { size: 0.1, sizes: Float64Array.from(samples.flat()) });
  assert.ok(nested.report.quads > 1.3 * coarse);
  assert.equal(meshHash(nested), meshHash(flat));
  const graded = lpquad.meshDomain(square, { sizeAt: (x) => (x < 0.5 ? 0.05 : 0.1) });
  assert.ok(graded.report.quads > coarse);
  // Everywhere but near the walls, whose direction is another.
  const turned = lpquad.meshDomain(square, { size: 0.03, angleAt: () => 0.3 });
  checkMesh(turned);
  const middle = [[0.5, 0.5], [0.5 + 1e-3 * Math.cos(0.3), 0.5 + 1e-3 * Math.sin(0.3)]];
  assert.ok(medianAngle(turned, middle, 0.4) < 4);
  assert.ok(medianAngle(lpquad.meshDomain(square, { size: 0.03 }), middle, 0.4) > 10);
  assert.ok(Math.abs(turned.report.size.p50 - 1) < 0.1);
});

/** Median angle, in degrees up to quarter turns, between a direction and the quads' sides at most r from a segment. */
function medianAngle(mesh, [[ax, ay], [bx, by]], r) {
  const [dx, dy] = [bx - ax, by - ay], angles = [];
  for (let i = 0; i < mesh.quads.length; ++i) {
    const next = i % 4 === 3 ? i - 3 : i + 1;
    const [p, q] = [mesh.quads[i], mesh.quads[next]].map((v) => mesh.points.subarray(2 * v, 2 * v + 2));
    const [x, y] = [(p[0] + q[0]) / 2 - ax, (p[1] + q[1]) / 2 - ay];
    const s = Math.min(1, Math.max(0, (x * dx + y * dy) / (dx * dx + dy * dy)));
    if (Math.hypot(x - s * dx, y - s * dy) > r) continue;
    const turn = (Math.atan2(q[1] - p[1], q[0] - p[0]) - Math.atan2(dy, dx)) * (2 / Math.PI);
    angles.push(90 * Math.abs(turn - Math.round(turn)));
  }
  return angles.sort((a, b) => a - b)[angles.length >> 1];
}

test('guides are followed, given with the call or with the domain', async () => {
  const guide = [[0.25, 0.35], [0.75, 0.65]];
  const mesh = lpquad.meshDomain(square, { size: 0.04, guides: [guide] });
  checkMesh(mesh);
  assert.ok(medianAngle(mesh, guide, 0.04) < 5);
  assert.ok(medianAngle(lpquad.meshDomain(square, { size: 0.04 }), guide, 0.04) > 20);
  const same = (domain, options) =>
    assert.equal(meshHash(lpquad.meshDomain(domain, { size: 0.04, ...options })), meshHash(mesh));
  same(square, { guides: [guide.flat()] });
  same(square, { guides: [Float64Array.from(guide.flat())] });
  same({ ...square, guides: [guide] }, {});
  same({ ...square, guides: [[[0, 0], [1, 1]]] }, { guides: [guide] });
  const domain = { ...square, guides: [guide], sizes: [[0.5, 0.5, 0.01]] };
  const read = await lpquad.readDomain(JSON.stringify(domain));
  assert.deepEqual(read.guides, domain.guides);
  assert.deepEqual(read.sizes, domain.sizes);
  assert.equal(meshHash(lpquad.meshDomain(read, { size: 0.04 })), meshHash(lpquad.meshDomain(domain, { size: 0.04 })));
  const both = { size: 0.04, guides: [guide], sizes: [0.5, 0.5, 0.01] };
  assert.equal(meshHash(lpquad.meshDomain(square, both)), meshHash(lpquad.meshDomain(read, { size: 0.04 })));
  const session = lpquad.start(square, { size: 0.04, guides: [guide] });
  assert.equal(meshHash(session.finish()), meshHash(mesh));
  session.dispose();
});

test('progress names the stages in order, and false ends the run', () => {
  const stages = [];
  lpquad.meshDomain(plate, { size: 0.1, method: 'paper', onProgress: (p) => void stages.push(p) });
  const order = ['seeds', 'optimise', 'match', 'clean', 'check', 'done'];
  const places = stages.map((p) => order.indexOf(p.stage));
  assert.ok(places.every((at, i) => at >= 0 && (i === 0 || places[i - 1] <= at)));
  const iterations = stages.filter((p) => p.stage === 'optimise').map((p) => p.iteration);
  assert.ok(iterations.length > 10 && iterations.every((at, i) => i === 0 || at > iterations[i - 1]));
  assert.ok(stages.filter((p) => p.stage === 'optimise' && p.iteration > 0).every((p) => p.energy > 0));
});

test('the caller\'s exceptions come back as they are', () => {
  const mine = new RangeError('mine');
  const throwing = () => { throw mine; };
  for (const options of [{ sizeAt: throwing }, { angleAt: throwing }, { size: 0.1, onProgress: throwing }])
    assert.throws(() => lpquad.meshDomain(square, options), (error) => error === mine);
  assert.throws(() => lpquad.start(square, { sizeAt: throwing }), (error) => error === mine);
  assert.equal(lpquad.meshDomain(square, { size: 0.1 }).report.quads, 100);
});

test('every format is written, with its options', () => {
  const mesh = lpquad.meshDomain(plate, { size: 0.2 });
  for (const format of lpquad.meshFormats) assert.ok(lpquad.writeMesh(mesh, format).length > 500, format);
  assert.match(lpquad.writeMesh(mesh, 'msh'), /^\$MeshFormat\s4\.1/);
  assert.match(lpquad.writeMesh(mesh, 'msh', { mshVersion: '2.2' }), /^\$MeshFormat\s2\.2/);
  assert.match(lpquad.writeMesh(mesh, 'inp', { inpElement: 'CPE4' }), /TYPE=CPE4/i);
  // Plain arrays, as they come out of JSON, are a mesh too.
  const plain = JSON.parse(JSON.stringify(mesh, (_, v) => (ArrayBuffer.isView(v) ? [...v] : v)));
  assert.equal(lpquad.writeMesh(plain, 'obj'), lpquad.writeMesh(mesh, 'obj'));
});

test('domains are read from text and bytes', async () => {
  const text = JSON.stringify({ regions: [{ name: 'plate', loops: plate.loops }], h: 0.1 });
  const bytes = new TextEncoder().encode(text);
  for (const source of [text, bytes, bytes.buffer]) {
    const domain = await lpquad.readDomain(source, { name: 'plate.json' });
    assert.deepEqual(domain.warnings, []);
    assert.deepEqual(domain.regions[0].loops, plate.loops);
    assert.equal(meshHash(lpquad.meshDomain(domain)), meshHash(lpquad.meshDomain({ ...plate, h: 0.1 })));
  }
  const svg = '<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0H10V10H0Z"/></svg>';
  const drawn = await lpquad.readDomain(svg, { format: 'svg' });
  assert.equal(lpquad.meshDomain(drawn, { size: 1 }).report.quads, 100);
});
