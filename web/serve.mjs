// Serves the built playground, a folder of static files, to the browsers of this machine.
// usage: node web/serve.mjs [--port N] [--once] [FOLDER]   (--once: looks whether it works, and ends)
import { createReadStream, statSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join, normalize, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

const types = {
  '.html': 'text/html; charset=utf-8', '.js': 'text/javascript; charset=utf-8', '.css': 'text/css; charset=utf-8',
  '.wasm': 'application/wasm', '.json': 'application/json', '.svg': 'image/svg+xml', '.png': 'image/png',
  '.webmanifest': 'application/manifest+json', '.map': 'application/json',
};
const usualPort = 8080, portsTried = 20;

/** @param {string} folder */
export function createSite(folder) {
  return createServer((request, response) => {
    let path = '';
    try {
      path = decodeURIComponent(new URL(request.url ?? '/', 'http://localhost').pathname);
    } catch { /* answered as not found */ }
    // normalize() of an absolute path cannot climb above its root.
    const file = join(folder, normalize(path.endsWith('/') ? `${path}index.html` : path));
    if (path === '' || path.includes('\0') || !statSync(file, { throwIfNoEntry: false })?.isFile())
      return void response.writeHead(404, { 'content-type': 'text/plain' }).end('Not found\n');
    response.writeHead(200, { 'content-type': types[extname(file)] ?? 'application/octet-stream', 'cache-control': 'no-cache' });
    if (request.method === 'HEAD') response.end();
    else createReadStream(file).pipe(response);
  });
}

/** Listens on the port, or, where it may choose, on the next free one. */
function listen(server, port, tries) {
  return new Promise((done, fail) => {
    server.once('error', (error) => {
      if (error.code === 'EADDRINUSE' && tries > 1) listen(server, port + 1, tries - 1).then(done, fail);
      else fail(error);
    });
    server.listen(port, '127.0.0.1', () => done(server.address().port));
  });
}

async function main(args) {
  const once = args.includes('--once');
  const at = args.indexOf('--port');
  const port = at < 0 ? usualPort : Number(args[at + 1]);
  const folder = args.find((arg, k) => !arg.startsWith('--') && (at < 0 || k !== at + 1));
  const site = resolve(folder ?? fileURLToPath(new URL('../build/web', import.meta.url)));
  const server = createSite(site);
  const address = `http://localhost:${await listen(server, port, at < 0 ? portsTried : 1)}/`;
  console.log(`\nThe playground:  ${address}${once ? '' : '   (Ctrl+C ends it)'}`);
  if (!once) return;
  const page = await (await fetch(address.replace('localhost', '127.0.0.1'))).text();
  server.close();
  if (!page.includes('<title>lpquad playground</title>')) throw new Error(`${site} is not the playground.`);
}

if (process.argv[1] === fileURLToPath(import.meta.url))
  main(process.argv.slice(2)).catch((error) => {
    console.error(error.code === 'EADDRINUSE' ? 'This port is in use: choose another with --port.' : error.message);
    process.exitCode = 1;
  });
