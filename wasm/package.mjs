// Puts the npm package together: dist/ from the two WebAssembly builds and wasm/js.
// usage: node wasm/package.mjs          after building the presets wasm and wasm-plain
//        node wasm/package.mjs --check  before packing: is dist/ there, whole and of these sources?
import { chmodSync, cpSync, existsSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { dirname, join } from 'node:path';

const here = dirname(fileURLToPath(import.meta.url));
const root = join(here, '..');
const dist = join(root, 'dist');
const sources = readdirSync(join(here, 'js'));

function assemble() {
  const build = (preset, file) => join(root, 'build', preset, file);
  rmSync(dist, { recursive: true, force: true });
  mkdirSync(dist);
  for (const file of sources) cpSync(join(here, 'js', file), join(dist, file));
  chmodSync(join(dist, 'cli.js'), 0o755);

  // One glue serves both builds: they differ in instructions, not in what they import and export.
  for (const [name, from] of [['glue.js', 'lpquad.mjs'], ['readers-glue.js', 'lpquad-readers.mjs'],
    ['surface-glue.js', 'lpquad-surface.mjs']]) {
    const glue = readFileSync(build('wasm', `wasm/${from}`), 'utf8');
    if (glue !== readFileSync(build('wasm-plain', `wasm/${from}`), 'utf8'))
      throw new Error(`The glue ${from} of the two WebAssembly builds differs.`);
    writeFileSync(join(dist, name), glue);
  }
  const copies = { 'lpquad.wasm': build('wasm', 'wasm/lpquad.wasm'),
    'lpquad-plain.wasm': build('wasm-plain', 'wasm/lpquad.wasm'),
    'lpquad-readers.wasm': build('wasm-plain', 'wasm/lpquad-readers.wasm'),
    'lpquad-surface.wasm': build('wasm', 'wasm/lpquad-surface.wasm'),
    'lpquad-surface-plain.wasm': build('wasm-plain', 'wasm/lpquad-surface.wasm'),
    'cli.cjs': build('wasm-plain', 'bin/lpquad.cjs'), 'cli.wasm': build('wasm-plain', 'bin/lpquad.wasm') };
  for (const [name, from] of Object.entries(copies)) {
    cpSync(from, join(dist, name));
    chmodSync(join(dist, name), 0o644);
  }

  // The single file: everything in one module, for places where no second file can be fetched. The
  // plain build, since it cannot choose.
  const inline = (file, names) => writeFileSync(join(dist, file), `export default {\n${names.map((name) =>
    `  '${name}': '${readFileSync(join(dist, `${name}.wasm`)).toString('base64')}',\n`).join('')}};\n`);
  inline('inline-wasm.js', ['lpquad-plain', 'lpquad-readers']);
  inline('inline-surface-wasm.js', ['lpquad-surface-plain']);
}

function check() {
  const { exports, bin } = JSON.parse(readFileSync(join(root, 'package.json'), 'utf8'));
  const named = [...Object.values(exports), bin]
    .flatMap((target) => (typeof target === 'string' ? target : Object.values(target)));
  const missing = named.filter((file) => !existsSync(join(root, file)));
  const stale = sources.filter((file) => !existsSync(join(dist, file)) ||
    !readFileSync(join(dist, file)).equals(readFileSync(join(here, 'js', file))));
  if (missing.length + stale.length === 0) return;
  console.error(`dist/ is not what these sources give (${[...missing, ...stale].join(', ')}).\n` +
    'Build it first: npm run build');
  process.exitCode = 1;
}

if (process.argv.includes('--check')) check();
else assemble();
