// The page without a network, its updates, and the server that comes with it.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { createServer as createListener } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { createSite } from '../../web/serve.mjs';
import { finished, folder, patience, startPlayground } from './support.mjs';

let playground;
before(async () => { playground = await startPlayground(); });
const ends = [];  // of what a failing test leaves behind
after(async () => {
  for (const end of ends) end();
  await playground.close();
});

/** Listens on a free port until the tests end; its address. */
async function listen(server) {
  await new Promise((done) => server.listen(0, '127.0.0.1', done));
  ends.push(() => {
    server.close();
    server.closeAllConnections();
  });
  return `http://127.0.0.1:${server.address().port}/`;
}

/** A page that may have a service worker. */
async function openPage() {
  const context = await playground.browser.newContext({ reducedMotion: 'reduce' });
  context.setDefaultTimeout(patience);
  return context.newPage();
}

/** Until the service worker has everything and answers for this page. */
const kept = (page) => page.evaluate(() => navigator.serviceWorker.ready.then(() =>
  navigator.serviceWorker.controller || new Promise((resolve) => navigator.serviceWorker.addEventListener('controllerchange', resolve))).then(() => true));

/** Until it holds in the page. (page.waitForFunction takes a promise for a yes.) */
async function until(page, holds) {
  for (let tries = 0; !await page.evaluate(holds); ++tries) {
    assert.ok(tries < 600, `not within half a minute: ${holds}`);
    await page.waitForTimeout(50);
  }
}

test('after the first visit the page loads and meshes without a network', async () => {
  const page = await playground.open({ offline: true });
  await finished(page);
  await kept(page);
  await page.context().setOffline(true);
  await page.goto('about:blank');
  await page.goto(`${playground.address}#preset=square&options=size:0.25`);
  await page.locator('.stage-name', { hasText: 'done: 16 quads' }).waitFor();
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test('so does the page for space', async () => {
  const page = await playground.open({ offline: true });
  await finished(page);
  await kept(page);
  await page.context().setOffline(true);
  await page.goto(`${playground.address}space.html#preset=saddle&size=0.25`);
  await page.locator('.stage-name', { hasText: /^done/ }).waitFor({ timeout: 180000 });
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test('a new version is shown at the next visit, and kept', async () => {
  const copy = mkdtempSync(join(tmpdir(), 'lpquad-site-'));
  cpSync(folder, copy, { recursive: true });
  ends.push(() => rmSync(copy, { recursive: true, force: true }));
  const address = await listen(createSite(copy)), page = await openPage();
  await page.goto(address);
  await finished(page);
  await kept(page);
  for (const [file, from, to] of [['index.html', '<h1>lpquad', '<h1>newer'], ['service_worker.js', '{"version":"', '{"version":"newer-']])
    writeFileSync(join(copy, file), readFileSync(join(copy, file), 'utf8').replace(from, to));
  const title = () => page.locator('h1').textContent();
  for (let tries = 0; await title() !== 'newer'; ++tries) {  // a network that is late is not waited for
    assert.ok(tries < 5, 'the page of the network is not shown');
    await page.reload();
  }
  await page.evaluate(() => navigator.serviceWorker.getRegistration().then((found) => found.update()));
  await until(page, () => navigator.serviceWorker.getRegistration().then((found) => found.waiting !== null));
  // It takes over once no page of the old version is open, which the browser may notice a moment late.
  const isNewer = () => caches.keys().then((names) => names.length === 1 && names[0].startsWith('lpquad-newer'));
  for (let visits = 0; !await page.evaluate(isNewer); ++visits) {
    assert.ok(visits < 20, 'the new version does not take over');
    await page.goto('about:blank');
    await page.goto(address);
    await kept(page);
  }
  await page.context().setOffline(true);
  await page.reload();
  await finished(page);
  assert.equal(await title(), 'newer');
  await page.context().close();
});

test('a network that does not answer is not waited for', async () => {
  const site = createSite(folder);
  let answers = true;
  const server = createServer((request, response) => { if (answers) site.emit('request', request, response); });
  const address = await listen(server), page = await openPage();
  await page.goto(address);
  await finished(page);
  await kept(page);
  answers = false;
  await page.reload();
  await finished(page);
  await page.context().close();
});

const script = fileURLToPath(new URL('../../web/serve.mjs', import.meta.url));

/** Its first address, and how it ended if it did. */
const serveWith = (...args) => new Promise((resolve) => {
  const child = spawn(process.execPath, [script, ...args, folder], { stdio: ['ignore', 'pipe', 'pipe'] });
  ends.push(() => child.kill());
  let said = '';
  for (const stream of [child.stdout, child.stderr]) stream.on('data', (data) => {
    said += data;
    const address = said.match(/http:\/\/localhost:\d+\//)?.[0];
    if (address && !args.includes('--once')) resolve({ address });
  });
  child.on('exit', (code) => resolve({ said, code }));
});

test('the server finds a free port, sends the right types, and stays in its folder', async () => {
  const one = await serveWith(), two = await serveWith();
  assert.notEqual(one.address, two.address);
  const ask = (path) => fetch(new URL(path, one.address.replace('localhost', '127.0.0.1')));
  const page = await ask('/');
  const wasm = readFileSync(join(folder, 'service_worker.js'), 'utf8').match(/assets\/[\w-]+\.wasm/)[0];
  for (const [path, type] of [['/', 'text/html'], ['/service_worker.js', 'text/javascript'], [wasm, 'application/wasm'],
    ['/icon.svg', 'image/svg+xml'], ['/manifest.webmanifest', 'application/manifest+json']])
    assert.ok((await ask(path)).headers.get('content-type').startsWith(type), path);
  assert.ok((await page.text()).includes('lpquad playground'));
  for (const path of ['/../package.json', '/%2e%2e/%2e%2e/package.json', '/nothing', '/%00', '/%ff', '/assets']) assert.equal((await ask(path)).status, 404, path);
});

test('the server says so when its port is taken, and can be tried and end', async () => {
  const other = createListener();
  await new Promise((done) => other.listen(0, '127.0.0.1', done));
  const taken = await serveWith('--port', String(other.address().port), '--once');
  assert.notEqual(taken.code, 0);
  assert.match(taken.said, /in use/);
  other.close();
  assert.equal((await serveWith('--once')).code, 0);
});
