// The package as people get it: `npm pack`, the tarball installed into an empty project per kind of
// consumer, and the same small mesh made there - in Node, and in real browsers behind each bundler.
// usage: node tests/package/matrix.mjs [--no-next]; ends with "N passed, N failed".
import { execFile, spawn } from 'node:child_process';
import { cpSync, existsSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

import { browsers, openBrowser } from './browsers.mjs';
import { serve } from './server.mjs';

const here = dirname(fileURLToPath(import.meta.url));
const root = join(here, '../..');
const work = join(root, 'build/package');
const tools = join(here, 'node_modules/.bin');
const pageSeconds = 120, commandSeconds = 300;

const run = (command, args, cwd) => new Promise((resolve, reject) =>
  execFile(command, args, { cwd, timeout: commandSeconds * 1000, maxBuffer: 1 << 26,
    env: { ...process.env, NEXT_TELEMETRY_DISABLED: '1', NODE_ENV: undefined } },
  (error, stdout, stderr) => (error ? reject(new Error(`${error.message}\n${stdout}${stderr}`)) : resolve(stdout))));
const project = (name) => join(work, name);

let passed = 0, failed = 0;
let expected = null, expectedSurface = null;  // hashes of the two meshes
function check(name, fault) {
  fault ? ++failed : ++passed;
  console.log(fault ? `FAIL ${name}\n     ${fault.replaceAll('\n', '\n     ')}` : `ok   ${name}`);
}
async function attempt(name, work) {
  try {
    check(name, (await work()) ?? '');
  } catch (error) {
    check(name, String(error.stack ?? error));
  }
}

/** '' if every way of the consumer gave the meshes that all others got. */
function judge({ error, found = {} }) {
  if (error) return error;
  const right = (way) => `${expected} ${expected}${way === 'inline' ? '' : ` ${expectedSurface}`}`;
  const wrong = Object.entries(found).filter(([way, print]) => print !== right(way));
  if (Object.keys(found).length === 0) return 'nothing was tried';
  return wrong.map(([way, print]) => `${way}: ${print} instead of ${right(way)}`).join('\n');
}

async function install() {
  rmSync(work, { recursive: true, force: true });
  mkdirSync(work, { recursive: true });
  const [{ filename, files }] = JSON.parse(await run('npm', ['pack', '--json', '--pack-destination', work], root));
  const odd = files.map((file) => file.path).filter((path) => !/^(dist\/[\w.-]+|LICENSE|README\.md|package\.json)$/.test(path));
  check('the tarball holds the package only', odd.join(' '));
  check('the licences of what it is made of go with it', files.some((file) => file.path === 'dist/third-party.txt') ? '' : 'no');
  const tarball = join(work, filename);
  for (const name of readdirSync(join(here, 'consumers'))) {
    cpSync(join(here, 'consumers', name), project(name), { recursive: true });
    cpSync(join(here, 'common/report.js'), join(project(name), 'report.js'));
    if (!existsSync(join(project(name), 'package.json')))
      writeFileSync(join(project(name), 'package.json'), '{ "private": true, "type": "module" }\n');
  }
  // One real installation; the other projects get the same folder.
  const first = project('node-esm');
  await run('npm', ['install', '--offline', '--no-audit', '--no-fund', tarball], first);
  for (const name of readdirSync(join(here, 'consumers')).filter((other) => other !== 'node-esm'))
    cpSync(join(first, 'node_modules'), join(project(name), 'node_modules'), { recursive: true });
  return tarball;
}

async function inNode() {
  const { domain, options, surfaceFile, surfaceOptions } = await import(join(project('node-esm'), 'report.js'));
  const command = join(project('node-esm'), 'node_modules/.bin/lpquad');
  writeFileSync(join(project('node-esm'), 'domain.json'), JSON.stringify(domain));
  writeFileSync(join(project('node-esm'), 'part.obj'), surfaceFile);
  const hashOf = async (file, { size }) => {
    await run('npx', ['--offline', 'lpquad', 'mesh', file, '-o', 'mesh.msh', '--size', String(size),
      '--report', 'report.json'], project('node-esm'));
    return JSON.parse(readFileSync(join(project('node-esm'), 'report.json'))).hash;
  };
  await attempt('npx lpquad', async () => {
    expected = await hashOf('domain.json', options);
    expectedSurface = await hashOf('part.obj', surfaceOptions);
    if (!existsSync(command)) return 'no command was installed';
  });
  for (const [name, file] of [['node-esm', 'main.js'], ['node-cjs', 'main.cjs']])
    await attempt(name, async () =>
      judge({ found: JSON.parse(await run(process.execPath, [file], project(name))) }));
}

/** The examples of the README, as printed. */
async function readme() {
  const text = readFileSync(join(root, 'README.md'), 'utf8');
  const examples = [...text.matchAll(/^ *<!-- example: run by tests\/package -->\n *```js\n([\s\S]*?)```/gm)];
  await attempt('the README\'s examples', async () => {
    if (examples.length !== 2) return `there are ${examples.length}`;
    for (const [, code] of examples) {
      writeFileSync(join(project('node-esm'), 'example.js'), code);
      const said = await run(process.execPath, ['example.js'], project('node-esm'));
      if (!/^\d+ quads/.test(said)) return `it printed ${said}`;
    }
  });
}

/** Each bundler as its users call it; what it makes lies in <project>/out. */
const bundlers = {
  vite: (cwd) => run(join(tools, 'vite'), ['build', '--base=./', '--outDir=out', '--logLevel=warn'], cwd),
  webpack: async (cwd) => {
    await run(join(tools, 'webpack'), ['--mode=production', '--entry=./main.js', '--output-path=out',
      '--output-filename=main.js', '--no-devtool'], cwd);
    cpSync(join(cwd, 'index.html'), join(cwd, 'out/index.html'));
  },
  esbuild: async (cwd) => {
    await run(join(tools, 'esbuild'), ['main.js', '--bundle', '--format=esm', '--minify', '--outdir=out',
      '--loader:.wasm=file', '--log-level=warning'], cwd);
    cpSync(join(cwd, 'index.html'), join(cwd, 'out/index.html'));
  },
  rollup: async (cwd) => {
    await run(join(tools, 'rollup'), ['main.js', '--format=es', '--file=out/main.js', '--silent',
      '--plugin', `${join(here, 'node_modules/@rollup/plugin-node-resolve/dist/es/index.js')}`], cwd);
    cpSync(join(cwd, 'index.html'), join(cwd, 'out/index.html'));
  },
};

async function startViteDev(cwd) {
  const child = spawn(join(tools, 'vite'), ['--host=127.0.0.1', '--port=0', '--strictPort=false'],
    { cwd, detached: true, stdio: ['ignore', 'pipe', 'inherit'] });
  const stop = () => { try { process.kill(-child.pid); } catch { /* it is gone */ } };
  process.once('exit', stop);
  const address = await new Promise((resolve, reject) => {
    let text = '';
    child.stdout.on('data', (data) => {
      text += data;
      const found = text.replace(/\x1b\[[0-9;]*m/g, '').match(/http:\/\/127\.0\.0\.1:\d+\//);
      if (found) resolve(found[0]);
    });
    child.on('exit', () => reject(new Error(`vite ended: ${text}`)));
  });
  return { address, stop };
}

/** Next.js is as large as all other tools together, so it is a project of its own. */
async function buildNext(tarball) {
  const cwd = project('next');
  rmSync(join(cwd, 'node_modules'), { recursive: true, force: true });
  await run('npm', ['ci', '--no-audit', '--no-fund', '--prefer-offline'], cwd);
  await run('npm', ['install', '--no-save', '--no-audit', '--no-fund', '--offline', tarball], cwd);
  await run(join(cwd, 'node_modules/.bin/next'), ['build'], cwd);
}

async function inBrowsers(tarball) {
  const policy = { 'content-security-policy': "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'" };
  const sites = { page: { folder: project('page') }, 'page-worker': { folder: project('page-worker') },
    'page-csp': { folder: project('page-csp'), headers: policy } };
  for (const [name, build] of Object.entries(bundlers))
    await attempt(`${name} builds`, async () => {
      await build(project(name));
      sites[name] = { folder: join(project(name), 'out') };
    });
  if (!process.argv.includes('--no-next'))
    await attempt('next builds', async () => {
      await buildNext(tarball);
      sites.next = { folder: join(project('next'), 'out') };
      const html = readFileSync(join(project('next'), 'out/index.html'), 'utf8');
      if (!html.includes(expected)) return 'the mesh rendered on the server differs';
    });
  const server = await serve(sites);
  const dev = await startViteDev(project('vite'));
  const urls = { 'vite-dev': dev.address };
  for (const name of Object.keys(sites)) urls[name] = `${server.origin}/${name}/`;
  for (const browser of Object.keys(browsers)) {
    if (!browsers[browser].path) {
      console.log(`SKIPPED: ${browser} is not installed`);
      continue;
    }
    const names = Object.keys(urls);
    const answers = names.map((name) => server.answer(`${browser}-${name}`, pageSeconds));
    const close = openBrowser(browser, server.deck(`deck-${browser}`, names.map((name) =>
      `${urls[name]}?to=${encodeURIComponent(server.address(`${browser}-${name}`))}`)), work);
    for (const [k, name] of names.entries()) check(`${name} in ${browser}`, judge(await answers[k]));
    close();
  }
  dev.stop();
  server.close();
}

async function lint(tarball) {
  await attempt('publint', async () => {
    const said = await run(join(tools, 'publint'), ['run', tarball, '--strict'], work);
    if (!/All good/.test(said)) return said;
  });
  // There is no CommonJS build on purpose: the factory is asynchronous anyway, and import() gives it.
  await attempt('attw', async () => {
    await run(join(tools, 'attw'), [tarball, '--profile', 'esm-only', '--exclude-entrypoints', 'lpquad.wasm',
      'lpquad-plain.wasm', 'lpquad-readers.wasm', 'lpquad-surface.wasm', 'lpquad-surface-plain.wasm'], work);
  });
}

const tarball = await install();
await inNode();
await readme();
if (Number(process.versions.node.split('.')[0]) < 20) {
  console.log('SKIPPED: bundlers, browsers and linters of packages; their tools need Node 20');
} else {
  await lint(tarball);
  await inBrowsers(tarball);
}
console.log(`${passed} passed, ${failed} failed`);
process.exit(failed === 0 && passed > 0 ? 0 : 1);
