// The independent judge: runs the command line on every shared domain, valid polygon (at three
// sizes) and invalid polygon, and has check2d.py look at each mesh. Ends with "N passed, N failed".
// usage: node tests/tools/referee.mjs [shared folder] [lpquad] [--only TEXT] [--jobs N]
import { mkdirSync, readdirSync, readFileSync, rmSync, statSync } from 'node:fs';
import { basename, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { run, runJobs } from './jobs.mjs';

const root = fileURLToPath(new URL('../../', import.meta.url));
const args = process.argv.slice(2);
const option = (name, fallback) => {
  const at = args.indexOf(name);
  return at < 0 ? fallback : args.splice(at, 2)[1];
};
const only = option('--only', '');
const workers = Number(option('--jobs', '2'));
const shared = args[0] ?? join(root, '..', 'shared');
const lpquad = args[1] ?? join(root, 'build/release/bin/lpquad');
const work = join(root, 'build', `referee-${process.pid}`);
const meshSeconds = 120, checkSeconds = 300;
const largestComparison = 2e12;  // bytes of the domain times bytes of the mesh
// Sizes of the polygons' meshes as shares of the diagonal: coarse, usual, fine.
const sizeShares = [1 / 12, 1 / 30, 1 / 80];

const jsonFiles = (folder) =>
  readdirSync(folder).filter((f) => f.endsWith('.json') && f !== 'INDEX.json').sort()
    .map((f) => join(folder, f));

/** The shared files were written by Python, which prints Infinity where JSON has no word for it. */
const readJson = (file) =>
  JSON.parse(readFileSync(file, 'utf8').replace(/:\s*(-?Infinity|NaN)\b/g, ':null'));

function diagonal(loops) {
  const points = loops.flat();
  const extent = [0, 1].map((k) => {
    let low = Infinity, high = -Infinity;
    for (const p of points) { low = Math.min(low, p[k]); high = Math.max(high, p[k]); }
    return high - low;
  });
  return Math.hypot(...extent);
}

/** Nodes on divided edges are rounded to doubles: what that may do to the outline and to its area. */
function roundingTolerances(loops) {
  let perimeter = 0, largest = 0;
  const areas = loops.map((loop) => {
    let twice = 0;
    loop.forEach(([x, y], k) => {
      const [u, v] = loop[(k + 1) % loop.length];
      // About the loop's first point: the products of far-off coordinates would cancel.
      twice += (x - loop[0][0]) * (v - loop[0][1]) - (u - loop[0][0]) * (y - loop[0][1]);
      perimeter += Math.hypot(u - x, v - y);
      largest = Math.max(largest, Math.abs(x), Math.abs(y));
    });
    return Math.abs(twice) / 2;
  });
  const area = 2 * Math.max(...areas) - areas.reduce((a, b) => a + b, 0);
  const rounding = largest * 2 ** -52;
  return ['--tol', String((2 * rounding) / diagonal(loops)),
    '--area-tol', String(Math.max(1e-12, (perimeter * rounding) / area))];
}

/** Meshes a domain and has the result judged; the answer is '' or what went wrong. */
async function meshAndJudge(file, name, meshOptions, checkOptions) {
  const mesh = join(work, `${name}.obj`);
  const made = await run(lpquad, ['mesh', file, '-o', mesh, '--quiet', ...meshOptions], meshSeconds);
  if (made.code !== 0) return `exit ${made.code}: ${made.text.trim()}`;
  // check2d.py compares every boundary node with every domain edge: where that takes hours, our own
  // exact check has to do.
  const tooLong = statSync(file).size * statSync(mesh).size > largestComparison;
  const judged = tooLong
    ? await run(lpquad, ['check', mesh, '--domain', file, '--quiet'], checkSeconds)
    : await run('/usr/bin/python3', [join(shared, 'tools/check2d.py'), file, mesh, '--all-quad', '-q',
        ...checkOptions], checkSeconds);
  rmSync(mesh, { force: true });
  return judged.code === 0 ? '' : judged.text.trim();
}

// Labelled bad because the hole comes first; here the loop of largest area is the outer one.
const outerIsLargest = ['jtsvalid_invalida_047'];

/** A bad polygon must be refused with its code, or, where that is allowed, meshed. */
async function refuse(file, name) {
  const { expect } = readJson(file);
  const mesh = join(work, `${name}.obj`);
  const made = await run(lpquad, ['mesh', file, '-o', mesh, '--quiet'], meshSeconds);
  rmSync(mesh, { force: true });
  const mayMesh = expect.action.includes('mesh') || outerIsLargest.includes(basename(file, '.json'));
  if (made.code === 0) return mayMesh ? '' : 'was meshed';
  if (made.code !== 3) return `exit ${made.code}: ${made.text.trim()}`;
  return made.text.includes(`error ${expect.code}:`) ? '' : `not ${expect.code}: ${made.text.trim()}`;
}

const jobs = [];
for (const file of jsonFiles(join(shared, 'domains'))) {
  const name = `domain-${basename(file, '.json')}`;
  jobs.push([name, () => meshAndJudge(file, name, ['--keep-boundary'], ['--boundary', 'exact'])]);
}
for (const file of jsonFiles(join(shared, 'data/polygons'))) {
  const { loops } = readJson(file);
  const size = diagonal(loops);
  const tolerances = roundingTolerances(loops);
  sizeShares.forEach((share, k) => {
    const name = `polygon-${basename(file, '.json')}-${k + 1}`;
    jobs.push([name, () => meshAndJudge(file, name, ['--size', String(size * share)],
      ['--boundary', 'refined', '--samples', '300', ...tolerances])]);
  });
}
for (const file of jsonFiles(join(shared, 'data/invalid'))) {
  const name = `invalid-${basename(file, '.json')}`;
  jobs.push([name, () => refuse(file, name)]);
}

mkdirSync(work, { recursive: true });
const chosen = jobs.filter(([name]) => name.includes(only));
const { passed, failed } = await runJobs(chosen, workers);
rmSync(work, { recursive: true, force: true });
console.log(`referee: ${passed} passed, ${failed} failed`);
process.exit(failed === 0 && passed > 0 ? 0 : 1);
