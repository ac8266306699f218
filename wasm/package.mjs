// Puts the npm package together: dist/ from the two WebAssembly builds and wasm/js.
// usage: node wasm/package.mjs   (after building the presets wasm and wasm-plain; wasm/build.sh does)
import { chmodSync, cpSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { dirname, join } from 'node:path';

const here = dirname(fileURLToPath(import.meta.url));
const root = join(here, '..');
const dist = join(root, 'dist');
const build = (preset, file) => join(root, 'build', preset, file);

rmSync(dist, { recursive: true, force: true });
mkdirSync(dist);
for (const file of readdirSync(join(here, 'js'))) cpSync(join(here, 'js', file), join(dist, file));
chmodSync(join(dist, 'cli.js'), 0o755);

// One glue serves both builds: they differ in instructions, not in what they import and export.
const glue = readFileSync(build('wasm', 'wasm/lpquad.mjs'), 'utf8');
if (glue !== readFileSync(build('wasm-plain', 'wasm/lpquad.mjs'), 'utf8'))
  throw new Error('The glue of the two WebAssembly builds differs.');
writeFileSync(join(dist, 'glue.js'), glue);
cpSync(build('wasm', 'wasm/lpquad.wasm'), join(dist, 'lpquad.wasm'));
cpSync(build('wasm-plain', 'wasm/lpquad.wasm'), join(dist, 'lpquad-plain.wasm'));
cpSync(build('wasm-plain', 'bin/lpquad.cjs'), join(dist, 'cli.cjs'));
cpSync(build('wasm-plain', 'bin/lpquad.wasm'), join(dist, 'cli.wasm'));

// The single file: everything in one module, for places where no second file can be fetched. The
// plain build, since it cannot choose.
const bytes = readFileSync(join(dist, 'lpquad-plain.wasm')).toString('base64');
writeFileSync(join(dist, 'inline-wasm.js'), `export default '${bytes}';\n`);
