// The independent judge of surfaces: runs the command line on every shared surface, valid and
// defective, at about 3000 quads, and has checksurf.py look at each mesh. Ends with
// "N passed, N failed".
// usage: node tests/tools/referee_surfaces.mjs [shared folder] [lpquad] [--only TEXT] [--jobs N]
//        [--quads N] [--list]
import { mkdirSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { basename, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { run, runJobs } from './jobs.mjs';

const root = fileURLToPath(new URL('../../', import.meta.url));
const args = process.argv.slice(2);
const option = (name, fallback) => {
  const at = args.indexOf(name);
  return at < 0 ? fallback : args.splice(at, 2)[1];
};
const list = args.includes('--list');  // every check that failed, within its budget or not
if (list) args.splice(args.indexOf('--list'), 1);
const only = option('--only', '');
const workers = Number(option('--jobs', '2'));
const quads = Number(option('--quads', '3000'));
const shared = args[0] ?? join(root, '..', 'shared');
const lpquad = args[1] ?? join(root, 'build/release/bin/lpquad');
const work = join(root, 'build', `referee-surfaces-${process.pid}`);
const meshSeconds = 120;  // of the processor, so that a busy machine does not decide
const patience = 1200, memoryKilobytes = 4 * 1024 * 1024;

// Checks that may fail on so many of all surfaces, because a size of 1/3000 of the area is larger
// than what is there to be meshed: sheets, teeth and horns thinner than a quad, features nearer to
// each other. Everything else holds on every surface.
const budget = {
  positive_corners: 3,       // a quad over a fold smaller than itself
  not_folded: 8,             // the same, by its mean normal
  input_covered: 11,         // tips and gaps smaller than a third of a quad
  features: 2,               // crossings of features nearer than a quad
  feature_gap: 2,
  area: 3,                   // of details smaller than a quad: 3.3 % are lost where 2 % may be
  borders: 1,                // a notch smaller than a quad
  no_coincident_vertex: 0,   // nodes of two curves with a gap without width between them
  edge_manifold: 1,          // circles where sheets meet, of four long chords
  topology: 1,               // parts smaller than one quad, and where chords of two curves touch
  orientation_as_input: 1,
  no_duplicate_element: 1,
};
// A defective surface may be refused, with a code; so many are.
const mostRefused = 0;
const codesOfRefusal = ['NO_VALID_MESH', 'ZERO_AREA', 'NON_FINITE', 'EMPTY', 'PARSE_ERROR'];

const failures = new Map();  // check: surfaces that fail it
const refused = [];

/** Of all faces, as triangles from their first point. */
function areaOf(file) {
  const points = [];
  let area = 0;
  for (const line of readFileSync(file, 'utf8').split('\n')) {
    const words = line.trim().split(/\s+/);
    if (words[0] === 'v') points.push(words.slice(1, 4).map(Number));
    if (words[0] !== 'f') continue;
    const [a, ...rest] = words.slice(1).map((word) => points[parseInt(word, 10) - 1]);
    for (let k = 1; k < rest.length; ++k) {
      const u = rest[k - 1].map((x, i) => x - a[i]), v = rest[k].map((x, i) => x - a[i]);
      area += Math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
        u[0] * v[1] - u[1] * v[0]) / 2;
    }
  }
  return area;
}

async function judge(file, name, defective) {
  const mesh = join(work, `${name}.msh`);
  const size = Math.sqrt(areaOf(file) / quads);
  const command = `ulimit -v ${memoryKilobytes}; ulimit -t ${meshSeconds}; exec "$@"`;
  const made = await run('bash', ['-c', command, 'bash', lpquad, 'mesh', file, '-o', mesh,
    '--msh-version', '2.2', `--size=${size}`, '--quiet'], patience);
  const error = made.text.match(/error ([A-Z_]+):/)?.[1];
  if (defective && error && made.code >= 3) {
    refused.push(name);
    return codesOfRefusal.includes(error) ? '' : made.text.trim();
  }
  if (made.code !== 0) return `exit ${made.code}: ${made.text.trim()}`;
  const judged = await run('/usr/bin/python3', [join(shared, 'tools/checksurf.py'), file, mesh,
    '--all-quad', '--size', String(size)], patience);
  rmSync(mesh, { force: true });
  if (judged.code !== 0 && judged.code !== 1) return judged.text.trim();
  const faults = [];
  for (const [line, check] of judged.text.matchAll(/^FAIL +([a-z]\w+) .*$/gm)) {
    failures.set(check, [...(failures.get(check) ?? []), name]);
    if (!(check in budget)) faults.push(line);
  }
  return faults.join('\n');
}

const jobs = [];
for (const [folder, defective] of [['surfaces', false], ['invalid_surfaces', true]])
  for (const file of readdirSync(join(shared, 'data', folder)).filter((f) => f.endsWith('.obj')).sort()) {
    const name = basename(file, '.obj');
    jobs.push([name, () => judge(join(shared, 'data', folder, file), name, defective)]);
  }

mkdirSync(work, { recursive: true });
let { passed, failed } = await runJobs(jobs.filter(([name]) => name.includes(only)), workers);
rmSync(work, { recursive: true, force: true });
const judgeBudget = (what, names, most) => {
  const within = names.length <= most;
  within ? ++passed : ++failed;
  if (!within || list)
    console.log(`${within ? 'ok  ' : 'FAIL'} ${what}: ${names.length} of at most ${most}: ${names.sort().join(' ')}`);
};
for (const [check, most] of Object.entries(budget)) judgeBudget(check, failures.get(check) ?? [], most);
judgeBudget('refused', refused, mostRefused);
console.log(`surfaces: ${passed} passed, ${failed} failed`);
process.exit(failed === 0 && passed > 0 ? 0 : 1);
