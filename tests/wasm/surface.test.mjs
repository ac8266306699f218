// Surfaces through the package: files in, meshes and files out, sessions, workers.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';

import { createLpquad, createLpquadWorker, dist, errorOf, meshHash, path, rejectionOf } from './support.mjs';
import { box, boxFiles, torus } from './surfaces.mjs';

const lpquad = await createLpquad();
const remote = createLpquadWorker();
after(() => remote.terminate());
const options = { size: 0.5 };
const hashOf = async (surface, more = options) => meshHash(await lpquad.meshSurface(surface, more));
const expected = await hashOf(box);

/** Every inner edge has two quads that run along it in opposite directions, every other one is a listed edge. */
function checkConforming({ quads, edges }) {
  const sides = new Map(), key = (a, b) => a * 2 ** 26 + b;
  for (let i = 0; i < quads.length; ++i) {
    const side = key(quads[i], quads[i % 4 === 3 ? i - 3 : i + 1]);
    assert.ok(!sides.has(side));
    sides.set(side, i >> 2);
  }
  const listed = new Set();
  for (let e = 0; e < edges.length; e += 2)
    listed.add(key(edges[e], edges[e + 1])).add(key(edges[e + 1], edges[e]));
  for (const side of sides.keys()) {
    const a = Math.floor(side / 2 ** 26), b = side % 2 ** 26;
    assert.ok(sides.has(key(b, a)) || listed.has(side));
  }
}

/** Largest distance of a vertex from where it is said to lie on the surface. */
function offPlace({ points, placeTriangles, placeWeights, surface }) {
  let largest = 0;
  for (let v = 0; v < placeTriangles.length; ++v)
    for (let k = 0; k < 3; ++k) {
      let at = 0;
      for (let c = 0; c < 3; ++c)
        at += placeWeights[3 * v + c] * surface.points[3 * surface.triangles[3 * placeTriangles[v] + c] + k];
      largest = Math.max(largest, Math.abs(at - points[3 * v + k]));
    }
  return largest;
}

test('every format of surfaces is read, by name, format or content, from text or bytes', async () => {
  assert.deepEqual(Object.keys(boxFiles).map((name) => name.split('.')[1]).filter((f, i, all) => all.indexOf(f) === i).sort(),
    [...lpquad.surfaceFormats].sort());
  for (const [name, file] of Object.entries(boxFiles)) {
    const bytes = typeof file === 'string' ? new TextEncoder().encode(file) : file;
    const ways = [[bytes, { name }], [bytes, { format: name.split('.')[1] }], [bytes, {}], [bytes.buffer, { name }]];
    if (typeof file === 'string') ways.push([file, { name }]);
    for (const [source, how] of ways) {
      const surface = await lpquad.readSurface(source, how);
      assert.equal(surface.points.constructor, Float64Array);
      assert.equal(surface.triangles.constructor, Uint32Array);
      assert.equal(surface.triangles.length, 36, name);
      assert.deepEqual(surface.warnings, []);
    }
    assert.equal(await lpquad.isSurfaceFile(bytes, { name }), true, name);
    const mesh = await lpquad.meshSurface(await lpquad.readSurface(bytes, { name }), options);
    assert.deepEqual([mesh.report.quads, mesh.report.faces, mesh.report.curves], [40, 6, 12], name);
  }
  assert.equal(await lpquad.isSurfaceFile('{"loops":[]}', { name: 'plan.json' }), false);
  assert.equal(await lpquad.isSurfaceFile('<svg xmlns="http://www.w3.org/2000/svg"/>'), false);
});

test('a mesh on a surface has every member of its type', async () => {
  const mesh = await lpquad.meshSurface(box, options);
  const types = { dimension: Number, points: Float64Array, quads: Uint32Array, quadRegions: Int32Array,
    triangles: Uint32Array, triangleRegions: Int32Array, edges: Uint32Array, edgeTags: Int32Array,
    edgeRegions: Int32Array, edgeOrigins: Int32Array, taggedPoints: Uint32Array, pointTags: Int32Array,
    regions: Array, tags: Array, boundaryNodes: Number, placeTriangles: Int32Array, placeWeights: Float64Array,
    surface: Object, report: Object };
  assert.deepEqual(Object.keys(mesh).sort(), Object.keys(types).sort());
  for (const [name, type] of Object.entries(types)) assert.equal(mesh[name].constructor, type, name);
  checkConforming(mesh);
  const vertices = mesh.points.length / 3;
  assert.equal(vertices, mesh.report.vertices);
  assert.equal(mesh.placeTriangles.length, vertices);
  assert.ok(offPlace(mesh) < 1e-12);
  assert.equal(mesh.quads.length / 4, mesh.report.quads);
  assert.equal(mesh.quadRegions.length, mesh.report.quads);
  assert.deepEqual(mesh.regions, ['face 1', 'face 2', 'face 3', 'face 4', 'face 5', 'face 6']);
  assert.equal(mesh.tags.length, 12);
  assert.ok(mesh.edgeRegions.every((region) => region >= 0 && region < 6));
  assert.match(mesh.report.hash, /^[0-9a-f]{16}$/);
  assert.equal(mesh.report.options.size, 0.5);
  assert.equal(mesh.report.repairs.trianglesGiven, 12);
  assert.equal(mesh.surface.triangles.length, 36);
});

test('what interfaces the declarations name is there', async () => {
  const declared = readFileSync(dist('surface.d.ts'), 'utf8');
  const members = (name) => {
    const body = declared.match(new RegExp(`export interface ${name} [^{]*\\{([\\s\\S]*?)\\n\\}`))[1]
      .replace(/\/\*[\s\S]*?\*\//g, '');
    return [...body.matchAll(/^ {2}(\w+)\??[:(]/gm)].map((match) => match[1]);
  };
  const session = await lpquad.startSurface(box, options);
  for (const name of members('SurfaceSession')) assert.ok(session[name] !== undefined, name);
  assert.deepEqual(Object.keys(session.state).sort(), members('SurfaceProgress').sort());
  const mesh = session.finish();
  for (const name of [...members('SurfaceMesh'), ...members('SurfaceMeshResult')]) assert.ok(name in mesh, name);
  for (const name of members('SurfaceReport')) assert.ok(name in mesh.report, name);
  const layers = Object.fromEntries(members('SurfaceLayers').map((name) => [name, true]));
  const snapshot = session.snapshot(layers);
  for (const name of members('SurfaceSnapshot')) assert.ok(name in snapshot, name);
  session.dispose();
});

test('nested, flat and typed arrays are the same surface', async () => {
  const threes = (list) => Array.from({ length: list.length / 3 }, (_, i) => [...list.slice(3 * i, 3 * i + 3)]);
  for (const surface of [{ points: [...box.points], triangles: [...box.triangles] },
    { points: threes(box.points), triangles: threes(box.triangles) },
    { points: threes(box.points).map((p) => Float64Array.from(p)), triangles: Int32Array.from(box.triangles) },
    { ...box, groups: Array(12).fill(0), groupNames: ['steel'], name: 'box', warnings: [] }])
    assert.equal(await hashOf(surface), expected);
});

test('groups divide and name faces, unless told otherwise', async () => {
  const groups = Int32Array.from({ length: 12 }, (_, t) => (t < 6 ? 0 : 1));
  const mesh = await lpquad.meshSurface({ ...box, groups, groupNames: ['left', 'right'] }, options);
  assert.ok(mesh.regions.every((name) => /^(left|right) face \d$/.test(name)), mesh.regions.join());
  assert.deepEqual(mesh.surface.groupNames, ['left', 'right']);
  // A flat square in two groups: one edge between them, or none.
  const square = { points: [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0], triangles: [0, 1, 2, 0, 2, 3], groups: [0, 1] };
  // Names count, not triangles.
  const groupNames = Array.from({ length: 8 }, (_, i) => `part ${i}`);
  assert.deepEqual((await lpquad.meshSurface({ ...square, groups: [0, 7], groupNames }, options)).regions.length, 2);
  for (const [keepGroups, faces] of [[true, 2], [false, 1]])
    assert.equal((await lpquad.meshSurface(square, { size: 0.25, keepGroups })).report.faces, faces);
});

test('sizes at points make quads smaller there, and come from files', async () => {
  const sizes = Float64Array.from({ length: 8 }, (_, v) => (box.points[3 * v] === 0 ? 0.1 : 0));
  const fine = await lpquad.meshSurface({ ...box, sizes }, options);
  const even = await lpquad.meshSurface(box, options);
  assert.ok(fine.report.quads > 2 * even.report.quads, `${fine.report.quads} of ${even.report.quads}`);
  await rejectionOf('BAD_SIZE', lpquad.meshSurface({ ...box, sizes: Array(8).fill(-1) }, options));
  const text = `ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z
property float size\nelement face 1\nproperty list uchar int vertex_indices\nend_header
0 0 0 0.5\n1 0 0 0.25\n0 1 0 0\n3 0 1 2\n`;
  assert.deepEqual([...(await lpquad.readSurface(text)).sizes], [0.5, 0.25, 0]);
});

test('a wrong form is named by its path', async () => {
  const refuse = (surface) => rejectionOf('PARSE_ERROR', lpquad.meshSurface(surface));
  const cases = [[undefined, 'surface'], [null, 'surface'], ['text', 'surface'], [{}, 'surface.points'],
    [{ ...box, points: 5 }, 'surface.points'], [{ ...box, points: [0, 1] }, 'surface.points'],
    [{ ...box, points: [[0, 0, 0], [1, 0]] }, 'surface.points[1]'],
    [{ ...box, points: [[0, 0, 0], [1, 0, 'a']] }, 'surface.points[1][2]'],
    [{ ...box, points: [0, 0, '0'] }, 'surface.points[2]'],
    [{ points: box.points }, 'surface.triangles'], [{ ...box, triangles: [0, 1] }, 'surface.triangles'],
    [{ ...box, triangles: [0, 1, 8] }, 'surface.triangles[2]'], [{ ...box, triangles: [0, 1, -1] }, 'surface.triangles[2]'],
    [{ ...box, triangles: [[0, 1, 2], [0, 1, 1.5]] }, 'surface.triangles[1][2]'],
    [{ ...box, groups: [0] }, 'surface.groups'], [{ ...box, groups: Array(12).fill(2), groupNames: ['a'] }, 'surface.groups[0]'],
    [{ ...box, groups: Array(12).fill(NaN) }, 'surface.groups[0]'], [{ ...box, groupNames: [5] }, 'surface.groupNames[0]'],
    [{ ...box, bodies: Array(12).fill(12) }, 'surface.bodies[0] must be a whole number from 0 to'],
    [{ ...box, groups: Array(12).fill(12), groupNames: [] }, 'surface.groups[0] must be a whole number from 0 to'],
    [{ ...box, bodies: Array(12).fill(1), bodyNames: ['a'] }, 'surface.bodies[0] must be the index of one of the 1 names in'],
    [{ ...box, sizes: [1] }, 'surface.sizes'], [{ ...box, sizes: Array(8).fill('a') }, 'surface.sizes[0]'],
    [{ ...box, faces: [] }, 'surface.faces']];
  for (const [surface, where] of cases) {
    const { message } = await refuse(surface);
    assert.ok(message.startsWith(`${where} `), `${message} does not begin with ${where}`);
  }
  for (const value of [NaN, Infinity])
    assert.match((await rejectionOf('NON_FINITE', lpquad.meshSurface({ ...box, points: [0, 0, value] }))).message,
      /^surface\.points\[2\] /);
});

test('what cannot be meshed is said with a code, and the instance lives on', async () => {
  await rejectionOf('EMPTY', lpquad.meshSurface({ points: [], triangles: [] }));
  await rejectionOf('ZERO_AREA', lpquad.meshSurface({ points: [0, 0, 0, 1, 0, 0, 2, 0, 0], triangles: [0, 1, 2] }));
  await rejectionOf('TOO_MANY_ELEMENTS', lpquad.meshSurface(box, { size: 1e-6 }));
  await rejectionOf('BAD_SIZE', lpquad.meshSurface(box, { size: -1 }));
  assert.match((await rejectionOf('BAD_OPTION', lpquad.meshSurface(box, { siz: 1 }))).message, /'siz'.*'size'/);
  for (const wrong of [{ size: '1' }, { featureAngle: 181 }, { effort: 'none' }, { keepGroups: 1 }, { seed: 0.5 },
    { onProgress: 5 }, null, 5])
    await rejectionOf('BAD_OPTION', lpquad.meshSurface(box, wrong));
  await rejectionOf('PARSE_ERROR', lpquad.readSurface('no surface at all'));
  await rejectionOf('PARSE_ERROR', lpquad.readSurface('v 0 0 0\nf 1 2 3\n', { name: 'part.obj' }));
  await rejectionOf('PARSE_ERROR', lpquad.readSurface(5));
  await rejectionOf('BAD_OPTION', lpquad.readSurface('', { format: 'step' }));
  await rejectionOf('BAD_OPTION', lpquad.readSurface('', { form: 'stl' }));
  assert.equal(await hashOf(box), expected);
});

test('progress names the stages in order, false ends the run, and exceptions come through', async () => {
  const seen = [];
  await lpquad.meshSurface(box, { ...options, onProgress: (progress) => void seen.push(progress) });
  const order = ['features', 'field', 'charts', 'mesh', 'seams', 'shape'];
  const places = seen.map(({ stage }) => order.indexOf(stage));
  assert.ok(places.every((at, i) => at >= 0 && (i === 0 || places[i - 1] <= at)));
  assert.deepEqual(new Set(places), new Set(order.keys()));
  assert.ok(seen.every(({ tick }, i) => tick === i));
  assert.ok(seen.every(({ chart, chartCount, stage }) => chart <= chartCount && (stage !== 'seams' || chart === chartCount)));
  assert.ok(seen.every(({ share, stage }, i) => share >= 0 && share <= 1 && (stage !== seen[i - 1]?.stage || stage === 'mesh' || share >= seen[i - 1].share)));
  let left = 5;
  await rejectionOf('CANCELLED', lpquad.meshSurface(box, { ...options, onProgress: () => left-- > 0 }));
  const mine = new RangeError('mine');
  await assert.rejects(lpquad.meshSurface(box, { onProgress: () => { throw mine; } }), (error) => error === mine);
  assert.equal(await hashOf(box), expected);
});

test('seams and shape go in many ticks, between which a run ends at once', async () => {
  const tube = torus(16, 32), size = 0.25;
  const { seams = 0, shape = 0 } = await (async () => {
    const ticks = {};
    await lpquad.meshSurface(tube, { size, onProgress: ({ stage }) => { ticks[stage] = (ticks[stage] ?? 0) + 1; } });
    return ticks;
  })();
  assert.ok(seams > 4 && shape > 4, `${seams} and ${shape}`);
  for (const wanted of ['seams', 'shape'])
    await rejectionOf('CANCELLED', lpquad.meshSurface(tube, { size, onProgress: ({ stage, share }) => stage !== wanted || share < 0.5 }));
});

test('bodies that share a side are meshed apart, and counted', async () => {
  const points = Float64Array.from(box.points), next = points.map((x, i) => (i % 3 === 0 ? x + 1 : x));
  const triangles = [...box.triangles, ...box.triangles.map((v) => v + 8)];
  const boxes = { points: [...points, ...next], triangles, bodies: triangles.filter((_, i) => i % 3 === 0).map((v) => (v < 8 ? 0 : 1)),
    bodyNames: ['left', 'right'] };
  const { report, surface, quads } = await lpquad.meshSurface(boxes, options);
  assert.deepEqual(report.bodies.map(({ name, parts, borderEdges, quads: n }) => [name, parts, borderEdges, n]),
    [['left', 1, 0, 40], ['right', 1, 0, 40]]);
  assert.equal(quads.length, 4 * 80);
  assert.deepEqual([surface.bodyNames, surface.points.length], [['left', 'right'], 3 * 16]);
  assert.equal(await hashOf(boxes), await hashOf(surface));  // what was repaired is taken again
  assert.deepEqual((await lpquad.meshSurface(box, options)).report.bodies, []);
  // One point for both is two in the mesh.
  const welded = { ...boxes, triangles: triangles.map((v) => ({ 8: 1, 11: 2, 12: 5, 15: 6 })[v] ?? v) };
  assert.deepEqual((await lpquad.meshSurface(welded, options)).report.bodies, report.bodies);
  await rejectionOf('PARSE_ERROR', lpquad.meshSurface({ ...boxes, bodies: [0] }, options));
  await rejectionOf('PARSE_ERROR', lpquad.meshSurface({ ...boxes, bodyNames: ['left'] }, options));
});

/** Cells of one chart: pieces turn counter-clockwise, and as points in space they are as many. */
function checkCells({ chart, uv, points, offsets, sites, density }, { charts }) {
  assert.equal(offsets.length, sites.length + 1);
  assert.equal(uv.length, 2 * offsets.at(-1));
  assert.equal(points.length, 3 * offsets.at(-1));
  assert.ok(chart >= 0 ? charts.includes(chart) : sites.length === 0);
  assert.ok(sites.every((site) => density[site] >= 0));
  for (let i = 0; i < sites.length; ++i) {
    let twice = 0;
    for (let k = offsets[i], last = offsets[i + 1] - 1; k < offsets[i + 1]; last = k++)
      twice += uv[2 * last] * uv[2 * k + 1] - uv[2 * last + 1] * uv[2 * k];
    assert.ok(twice > -1e-12);
  }
}

test('a session shows what every stage has made, and ends where the direct call does', async () => {
  const tube = torus(16, 32);
  const session = await lpquad.startSurface(tube, { size: 0.25 });
  const all = { surface: true, features: true, sizes: true, crosses: true, charts: true, cells: true, quads: true };
  const start = session.snapshot(all);
  const triangles = tube.triangles.length / 3;
  assert.equal(start.surface.triangles.length, 3 * triangles);
  for (const [layer, member] of [['features', 'edges'], ['sizes', 'sizes'], ['crosses', 'axes'], ['charts', 'uv'], ['cells', 'sites'], ['quads', 'quads']])
    assert.equal(start[layer][member].length, 0, layer);
  while (session.state.stage !== 'mesh') session.step();
  const { features, sizes, crosses, charts, surface } = session.snapshot(all);
  assert.equal(features.faces.length, triangles);
  assert.equal(sizes.sizes.length, surface.points.length / 3);
  assert.ok(sizes.sizes.every((h) => h > 0 && h <= 0.25 * (1 + 1e-12)));
  // The indices of a torus sum to 0; the arms are of unit length and lie in their triangles.
  assert.equal(crosses.indices.reduce((sum, index) => sum + index, 0), 0);
  for (let t = 0; t < triangles; ++t) {
    const [a, b, c] = [0, 1, 2].map((k) => surface.points.subarray(3 * surface.triangles[3 * t + k], 3 * surface.triangles[3 * t + k] + 3));
    const [u, v] = [b, c].map((p) => [p[0] - a[0], p[1] - a[1], p[2] - a[2]]);
    const normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    const axis = crosses.axes.subarray(3 * t, 3 * t + 3);
    assert.ok(Math.abs(Math.hypot(...axis) - 1) < 1e-12);
    assert.ok(Math.abs(axis[0] * normal[0] + axis[1] * normal[1] + axis[2] * normal[2]) < 1e-12);
  }
  // Every triangle is in a chart, and turns the same way in its plane.
  assert.ok(charts.charts.every((chart) => chart >= 0 && chart < session.state.chartCount));
  assert.equal(charts.uv.length, 6 * triangles);
  for (let t = 0; t < triangles; ++t) {
    const [ax, ay, bx, by, cx, cy] = charts.uv.subarray(6 * t, 6 * t + 6);
    assert.ok((bx - ax) * (cy - ay) - (by - ay) * (cx - ax) > 0);
  }
  assert.ok(charts.cuts.length > 0);
  let quads = 0, cellsSeen = 0;
  while (session.state.stage === 'mesh') {
    session.step();
    const { cells } = session.snapshot({ cells: true });
    checkCells(cells, charts);
    cellsSeen += cells.sites.length;
    const now = session.snapshot({ quads: true }).quads;
    assert.ok(now.quads.length >= quads);
    assert.equal(now.eta.length, now.quads.length / 4);
    assert.equal(now.regions.length, now.eta.length);
    quads = now.quads.length;
  }
  assert.ok(quads > 0 && cellsSeen > 0);
  assert.equal(session.snapshot({ cells: true }).cells.chart, -1);
  const mesh = session.finish();
  checkConforming(mesh);
  assert.equal(mesh.report.vertices - mesh.report.quads, 0);  // V - E + F with E = 2 F
  const done = session.snapshot({ quads: true });
  assert.deepEqual(done.quads.quads, mesh.quads);
  assert.deepEqual(done.quads.points, mesh.points);
  assert.equal(done.quads.valence.reduce((sum, n) => sum + n, 0), mesh.quads.length);
  const { tick } = session.state;
  assert.equal(session.step(5).tick, tick);
  assert.equal(meshHash(mesh), await hashOf(tube, { size: 0.25 }));
  assert.match(errorOf('BAD_OPTION', () => session.step(-1)).message, /from 0 to 2147483647, not -1/);
  assert.match(errorOf('BAD_OPTION', () => session.snapshot({ matching: true })).message, /'matching'/);
  session.dispose();
  session.dispose();
  for (const use of [() => session.step(), () => session.state, () => session.finish(), () => session.snapshot()])
    assert.match(errorOf('BAD_OPTION', use).message, /disposed/);
  await rejectionOf('BAD_OPTION', lpquad.startSurface(box, { onProgress() {} }));
});

test('options are as they were at the call, and a session is told what is no function', async () => {
  const options = { size: 0.5 }, starting = lpquad.startSurface(box, options);
  options.size = 'large';
  const session = await starting;
  for (const wrong of ['x', null, 5]) errorOf('BAD_OPTION', () => session.finish(wrong));
  assert.ok(session.finish().quads.length > 0);
  session.dispose();
  await rejectionOf('BAD_OPTION', lpquad.startSurface(box, []));
});

test('a run that fails goes on failing', async () => {
  const session = await lpquad.startSurface(box, { size: 1e-6 });
  for (let i = 0; i < 2; ++i) errorOf('TOO_MANY_ELEMENTS', () => session.step());
  errorOf('TOO_MANY_ELEMENTS', () => session.finish());
  session.dispose();
});

test('every format that holds surfaces is written, the others are refused', async () => {
  const mesh = await lpquad.meshSurface(box, options);
  for (const format of lpquad.meshFormats) {
    if (lpquad.surfaceMeshFormats.includes(format)) assert.match(lpquad.writeMesh(mesh, format), /1\.5/, format);
    else errorOf('BAD_OPTION', () => lpquad.writeMesh(mesh, format));
  }
  assert.match(lpquad.writeMesh(mesh, 'inp'), /TYPE=S4/i);
  errorOf('BAD_OPTION', () => lpquad.writeMesh(mesh, 'inp', { inpElement: 'CPS4' }));
  const plain = JSON.parse(JSON.stringify(mesh, (_, v) => (ArrayBuffer.isView(v) ? [...v] : v)));
  assert.equal(lpquad.writeMesh(plain, 'msh'), lpquad.writeMesh(mesh, 'msh'));
  errorOf('PARSE_ERROR', () => lpquad.writeMesh({ ...mesh, quads: Uint32Array.of(0, 1, 2, 1000) }, 'obj'));
  errorOf('PARSE_ERROR', () => lpquad.writeMesh({ ...mesh, dimension: 4 }, 'obj'));
});

test('the command line in Node makes the same files', async () => {
  const folder = mkdtempSync(join(tmpdir(), 'lpquad-'));
  after(() => rmSync(folder, { recursive: true }));
  const file = (name) => join(folder, name);
  writeFileSync(file('box.stl'), boxFiles['binary.stl']);
  const { status, stderr } = spawnSync(process.execPath, [path('dist/cli.js'), 'mesh', file('box.stl'), '-o', file('box.msh'),
    '--size', '0.5', '--report', file('box.json')], { encoding: 'utf8' });
  assert.equal(status, 0, stderr);
  const mesh = await lpquad.meshSurface(await lpquad.readSurface(readFileSync(file('box.stl'))), options);
  assert.equal(readFileSync(file('box.msh'), 'utf8'), lpquad.writeMesh(mesh, 'msh'));
  const timeless = ({ cpuSeconds, ...report }) => report;
  assert.deepEqual(timeless(JSON.parse(readFileSync(file('box.json'), 'utf8'))), timeless(mesh.report));
});

test('both builds and lpquad/inline-surface give the same meshes; lpquad/inline says where to look', async () => {
  for (const name of ['lpquad-surface.wasm', 'lpquad-surface-plain.wasm']) {
    const other = await createLpquad({ surfaceUrl: dist(name) });
    assert.notEqual(other, lpquad);
    assert.equal(meshHash(await other.meshSurface(box, options)), expected);
  }
  const inline = await (await import(dist('inline-surface.js').href)).createLpquad();
  assert.notEqual(inline, lpquad);
  assert.equal(inline.build, 'plain');
  const read = await inline.readSurface(boxFiles['box.obj']);
  assert.equal(meshHash(await inline.meshSurface(read, options)), await hashOf(await lpquad.readSurface(boxFiles['box.obj'])));
  const small = await (await import(dist('inline.js').href)).createLpquad();
  assert.equal((await small.readSurface(boxFiles['box.obj'])).triangles.length, 36);
  assert.match((await rejectionOf('BAD_WASM', small.meshSurface(box))).message, /inline-surface/);
  const bad = await createLpquad({ surfaceUrl: dist('index.js') });
  for (let i = 0; i < 2; ++i) await rejectionOf('BAD_WASM', bad.meshSurface(box));
});

test('the worker does the same, with progress, sessions and aborts', async () => {
  const file = boxFiles['ascii.stl'];
  assert.deepEqual(await remote.readSurface(file), await lpquad.readSurface(file));
  assert.equal(await remote.isSurfaceFile(file), true);
  const seen = [];
  const mesh = await remote.meshSurface(box, options, { onProgress: (progress) => seen.push(progress) });
  const direct = await lpquad.meshSurface(box, options);
  for (const name of Object.keys(direct)) if (name !== 'report') assert.deepEqual(mesh[name], direct[name], name);
  assert.equal(mesh.report.hash, direct.report.hash);
  assert.equal(box.points.length, 24);  // what was passed is still there
  assert.equal(seen.at(-1).stage, 'done');
  assert.ok(seen.every(({ tick }, i) => i === 0 || tick > seen[i - 1].tick));
  assert.equal(await remote.writeMesh(mesh, 'vtu'), lpquad.writeMesh(direct, 'vtu'));
  await rejectionOf('BAD_OPTION', remote.meshSurface(box, { siz: 1 }));

  const session = await remote.startSurface(box, options);
  const stages = [];
  for await (const snapshot of session.run({ every: 2, layers: { charts: true, quads: true } })) {
    stages.push(snapshot.stage);
    assert.ok(snapshot.charts.uv && snapshot.quads.quads);
  }
  assert.equal(stages.at(-1), 'done');
  assert.equal(meshHash(await session.finish()), expected);
  await session.dispose();

  for (const delay of [0, 100, 300]) {
    const controller = new AbortController();
    const run = remote.meshSurface(torus(100, 200), { size: 0.01 }, { signal: controller.signal });
    run.catch(() => {});
    await new Promise((resolve) => setTimeout(resolve, delay));
    controller.abort('enough');
    assert.equal((await rejectionOf('CANCELLED', run)).cause, 'enough');
    assert.equal(meshHash(await remote.meshSurface(box, options)), expected);
  }
});
