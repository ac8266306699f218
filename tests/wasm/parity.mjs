// The same bytes everywhere: meshes of domains and surfaces, and their reports, from native g++ and clang, from the command line in
// Node, from the library in Node (SIMD and plain) and in Chromium, compared by SHA-256.
// usage: node tests/wasm/parity.mjs [shared folder [domain|paper|count|restarts|surface|polygon]]; ends with "N passed, N failed".
// Needs the presets release and clang (target lpquad_command) and dist/.
import { spawn } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { basename, join } from 'node:path';

import { browsers, openBrowser } from '../package/browsers.mjs';
import { serve } from '../package/server.mjs';
import { createLpquad, createLpquadWorker, dist, path, sha256 } from './support.mjs';

const shared = process.argv[2] ?? process.env.LPQ_SHARED ?? path('../shared');
const surfaceQuads = 800;
const onlyKind = process.argv[3];
const work = path(`build/parity-${process.pid}`);
const polygonStride = 2;      // every second polygon
const nativeSeconds = 2;      // what takes longer is left out
const leastPolygons = 50;
const sizeShare = 1 / 30;     // of the diagonal
// Of the shared surfaces: sharp and smooth, open and closed, with groups, handles and defects; and a file per format.
const surfaces = ['surfaces/cad_gmsh_capot_carhood.obj', 'surfaces/cad_trimesh_featuretype.obj', 'surfaces/cgal_joint.obj',
  'surfaces/trimesh_fixed_top_ply.obj', 'surfaces/cgal_rotor.obj', 'surfaces/gc_spot.obj', 'surfaces/common_rocker-arm.obj',
  'surfaces/gpjs_small_bunny.obj', 'surfaces/libigl_3holes.obj', 'surfaces/libigl_fertility.obj', 'surfaces/od_bunny.obj',
  'surfaces/pmp_hemisphere.obj', 'surfaces/bff_box.obj', 'surfaces/cgal_mask_cone.obj', 'formats/20mm-xyz-cube.stl',
  'formats/suzanne.ply', 'formats/multibody.stl', 'formats/whitespace.off', 'formats/groups.obj', 'formats/surfaces_in_3d.asc.v41.msh'];
const browserSeconds = 900;

if (!existsSync(join(shared, 'domains'))) {
  console.log(`SKIPPED: no shared domains at ${shared}\n0 passed, 0 failed`);
  process.exit(0);
}

const run = (command, args, seconds = 120) => new Promise((resolve) => {
  const child = spawn(command, args, { timeout: seconds * 1000, killSignal: 'SIGKILL' });
  let text = '';
  for (const stream of [child.stdout, child.stderr]) stream.on('data', (data) => (text += data));
  child.on('close', (code) => resolve({ code, text }));
});

const lpquad = await createLpquad();
/** The shared files were written by Python, which prints Infinity where JSON has no word for it. */
const readDomain = (file) => {
  const { loops, h } = JSON.parse(readFileSync(file, 'utf8').replace(/:\s*(-?Infinity|NaN)\b/g, ':null'));
  return h === undefined ? { loops } : { loops, h };
};
const jsonFiles = (folder) => readdirSync(join(shared, folder))
  .filter((file) => file.endsWith('.json') && file !== 'INDEX.json').sort().map((file) => join(shared, folder, file));

function diagonal(loops) {
  const points = loops.flat();
  const extent = (k) => points.reduce((high, p) => Math.max(high, p[k]), -Infinity) -
    points.reduce((low, p) => Math.min(low, p[k]), Infinity);
  return Math.sqrt(extent(0) ** 2 + extent(1) ** 2);
}

/** The size of so many quads, with few digits. */
function sizeOf(surface, quads) {
  const { points, triangles } = surface, at = (t, k, i) => points[3 * triangles[3 * t + k] + i];
  let area = 0;
  for (let t = 0; t < triangles.length / 3; ++t) {
    const [u, v] = [1, 2].map((k) => [0, 1, 2].map((i) => at(t, k, i) - at(t, 0, i)));
    area += Math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]) / 2;
  }
  return Number(Math.sqrt(area / quads).toPrecision(3));
}

const square = (x, y, side) => [[x, y], [x + side, y], [x + side, y + side], [x, y + side]];

/** Symmetric outlines: many pairs of triangles cost the same, and what breaks the tie must not be a library's heap or sort. */
function symmetric() {
  const holes = Array.from({ length: 400 }, (_, k) => square(1 + 2 * (k % 20), 1 + 2 * Math.floor(k / 20), 1));
  let flake = square(0, 0, 1);
  for (let level = 0; level < 3; ++level)
    flake = flake.flatMap(([x, y], i) => {
      const [u, v] = flake[(i + 1) % flake.length], dx = (u - x) / 4, dy = (v - y) / 4;
      return [[x, y], [x + dx, y + dy], [x + dx + dy, y + dy - dx], [x + 2 * dx + dy, y + 2 * dy - dx],
        [x + 2 * dx, y + 2 * dy], [x + 2 * dx - dy, y + 2 * dy + dx], [x + 3 * dx - dy, y + 3 * dy + dx], [x + 3 * dx, y + 3 * dy]];
    });
  return { holes: { loops: [square(0, 0, 41), ...holes] }, flake: { loops: [flake] } };
}

async function makeCases() {
  const cases = [];
  const add = (file, kind, options) => {
    const name = `${kind}-${basename(file, '.json')}`;
    const domain = readDomain(file), plain = join(work, `${name}.json`);
    writeFileSync(plain, JSON.stringify(domain));
    cases.push({ name, kind, domain, file: plain, options: { ...options, ...(kind === 'polygon' &&
      { size: diagonal(domain.loops) * sizeShare }) } });
  };
  for (const [name, domain] of Object.entries(symmetric())) {
    const file = join(work, `${name}.json`);
    writeFileSync(file, JSON.stringify(domain));
    add(file, 'domain', {});
    add(file, 'paper', { method: 'paper' });
    add(file, 'kept', { keepBoundary: true });
  }
  for (const file of jsonFiles('domains')) add(file, 'domain', { keepBoundary: true });
  for (const name of ['platehole', 'lshape', 'hood'])
    add(join(shared, `domains/${name}.json`), 'paper', { keepBoundary: true, method: 'paper' });
  for (const name of ['hood', 'gear']) add(join(shared, `domains/${name}.json`), 'count', { quads: 3000 });
  for (const name of ['disc', 'airfoil'])
    add(join(shared, `domains/${name}.json`), 'restarts', { keepBoundary: true, seeds: 'isotropic' });
  for (const file of surfaces) {
    const name = basename(file), whole = join(shared, 'data', file);
    const surface = await lpquad.readSurface(readFileSync(whole), { name });
    cases.push({ name, kind: 'surface', file: whole, options: { size: sizeOf(surface, surfaceQuads) } });
  }
  jsonFiles('data/polygons').filter((_, i) => i % polygonStride === 0).forEach((file) => add(file, 'polygon', {}));
  return cases.filter(({ kind }) => onlyKind === undefined || kind === onlyKind);
}

const flags = (options) => Object.entries(options).flatMap(([name, value]) => {
  const flag = `--${name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`)}`;
  return value === true ? [flag] : [flag, String(value)];
});

const timeless = ({ cpuSeconds, ...report }) => JSON.stringify(report);
/** Of the mesh as text, and of its report but for the times. */
const hashes = (text, report) => `${sha256(text)} ${sha256(timeless(report))}`;

async function byCommand(command, { name, file, options }, seconds) {
  const out = join(work, `${name}-${Math.random().toString(36).slice(2)}`);
  const [program, ...args] = command;
  const { code, text } = await run(program, [...args, 'mesh', file, '-o', `${out}.msh`, '--report',
    `${out}.report.json`, '--quiet', ...flags(options)], seconds);
  if (code !== 0) return text.trim() || `stopped after ${seconds} s`;
  const result = hashes(readFileSync(`${out}.msh`), JSON.parse(readFileSync(`${out}.report.json`, 'utf8')));
  for (const ending of ['.msh', '.report.json']) rmSync(out + ending);
  return result;
}

// What the reader of a file tells is in the report of a command, in the library beside the surface.
async function byLibrary(lpquad, { name, kind, file, domain, options }) {
  try {
    const surface = kind === 'surface' ? await lpquad.readSurface(readFileSync(file), { name }) : { warnings: [] };
    const mesh = kind === 'surface' ? await lpquad.meshSurface(surface, options) : await lpquad.meshDomain(domain, options);
    const warnings = [...surface.warnings, ...mesh.report.warnings];
    return hashes(await lpquad.writeMesh(mesh, 'msh'), { ...mesh.report, warnings });
  } catch (error) {
    return `${error.code ?? ''} ${error.message}`;
  }
}

const page = `<!doctype html><link rel="icon" href="data:,"><script type="module" src="page.js"></script>`;
const script = `
import { createLpquad } from '/dist/index.js';
const to = new URLSearchParams(location.search).get('to');
const hash = async (text) => [...new Uint8Array(await crypto.subtle.digest('SHA-256', new TextEncoder().encode(text)))]
  .map((byte) => byte.toString(16).padStart(2, '0')).join('');
const found = {};
try {
  const lpquad = await createLpquad();
  for (const { name, kind, domain, options } of await (await fetch('cases.json')).json()) {
    try {
      const surface = kind === 'surface'
        ? await lpquad.readSurface(await (await fetch('surface-' + name)).arrayBuffer(), { name }) : { warnings: [] };
      const mesh = kind === 'surface' ? await lpquad.meshSurface(surface, options) : lpquad.meshDomain(domain, options);
      const { cpuSeconds, ...report } = { ...mesh.report, warnings: [...surface.warnings, ...mesh.report.warnings] };
      found[name] = (await hash(lpquad.writeMesh(mesh, 'msh'))) + ' ' + (await hash(JSON.stringify(report)));
    } catch (error) {
      found[name] = String(error);
    }
  }
  await fetch(to, { method: 'POST', body: JSON.stringify({ found }) });
} catch (error) {
  await fetch(to, { method: 'POST', body: JSON.stringify({ found, error: String(error.stack ?? error) }) });
}`;

async function inChromium(cases) {
  const folder = join(work, 'page');
  mkdirSync(folder);
  writeFileSync(join(folder, 'index.html'), page);
  writeFileSync(join(folder, 'page.js'), script);
  writeFileSync(join(folder, 'cases.json'), JSON.stringify(cases));
  for (const { name, kind, file } of cases)
    if (kind === 'surface') writeFileSync(join(folder, `surface-${name}`), readFileSync(file));
  const server = await serve({ page: { folder }, dist: { folder: path('dist') } });
  const answer = server.answer('chromium', browserSeconds);
  const close = openBrowser('chromium', `${server.origin}/page/?to=${encodeURIComponent(server.address('chromium'))}`, work);
  const { found = {}, error } = await answer;
  close();
  server.close();
  if (error) console.log(`Chromium: ${error}`);
  return found;
}

mkdirSync(work, { recursive: true });
process.once('exit', () => rmSync(work, { recursive: true, force: true, maxRetries: 5, retryDelay: 100 }));
const all = await makeCases();
const gcc = [path('build/release/bin/lpquad')], clang = [path('build/clang/bin/lpquad')];
const command = [process.execPath, path('dist/cli.js')];

// g++ first: it decides what is quick enough for all.
const expected = new Map();
let next = 0;
await Promise.all([0, 1].map(async () => {
  while (next < all.length) {
    const one = all[next++];
    expected.set(one.name, await byCommand(gcc, one, one.kind === 'polygon' ? nativeSeconds : 120));
  }
}));
const quick = (one) => /^[0-9a-f]{64} /.test(expected.get(one.name));
const cases = all.filter((one) => one.kind !== 'polygon' || quick(one));
console.log(`${cases.length} cases; ${all.length - cases.length} polygons left out that take g++ more than ${nativeSeconds} s`);

const ways = { clang: (one) => byCommand(clang, one), 'the command line in Node': (one) => byCommand(command, one) };
for (const build of ['lpquad', 'lpquad-plain']) {
  const surfaceUrl = dist(`${build.replace('lpquad', 'lpquad-surface')}.wasm`);
  const remote = createLpquadWorker({ wasmUrl: dist(`${build}.wasm`), surfaceUrl });
  ways[`${build}.wasm in Node`] = (one) => byLibrary(remote, one);
  process.once('exit', () => remote.terminate());
}
const results = Object.fromEntries(Object.keys(ways).map((way) => [way, {}]));
async function through(names) {
  for (const way of names) for (const one of cases) results[way][one.name] = await ways[way](one);
}
const names = Object.keys(ways);
const chromium = browsers.chromium.path ? inChromium(cases) : Promise.resolve(null);
await Promise.all([through(names.slice(0, 2)), through(names.slice(2))]);
const there = await chromium;
if (there) results.Chromium = there;
else console.log('SKIPPED: chromium is not installed');

let passed = 0, failed = 0;
function check(what, fault) {
  fault ? ++failed : ++passed;
  if (fault) console.log(`FAIL ${what}: ${fault}`);
}
const polygons = cases.filter(({ kind }) => kind === 'polygon').length;
check('enough polygons', onlyKind || polygons >= leastPolygons ? '' : `only ${polygons}`);
for (const one of cases) {
  check(`${one.name} with g++`, quick(one) ? '' : expected.get(one.name));
  for (const [way, found] of Object.entries(results))
    check(`${one.name} by ${way}`, found[one.name] === expected.get(one.name) ? ''
      : `${found[one.name]} instead of ${expected.get(one.name)}`);
}
console.log(`parity: ${passed} passed, ${failed} failed`);
process.exit(failed === 0 ? 0 : 1);
