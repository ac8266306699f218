// Serves folders below one address, and takes the answers of pages: POST /answer/<name>.
import { createReadStream, statSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join, normalize } from 'node:path';

const types = { '.html': 'text/html', '.js': 'text/javascript', '.mjs': 'text/javascript', '.css': 'text/css',
  '.wasm': 'application/wasm', '.json': 'application/json' };
const anyOrigin = { 'access-control-allow-origin': '*', 'access-control-allow-headers': '*' };

/** @param {Record<string, {folder: string, headers?: Record<string, string>}>} sites  by first part of the path */
export async function serve(sites) {
  const waiting = new Map(), pages = new Map();

  function file(url, response) {
    const [, site, ...rest] = decodeURIComponent(url.pathname).split('/');
    if (pages.has(site)) return response.writeHead(200, { 'content-type': 'text/html' }).end(pages.get(site));
    const path = sites[site] && join(sites[site].folder, normalize(`/${rest.join('/') || 'index.html'}`));
    if (!path || !statSync(path, { throwIfNoEntry: false })?.isFile()) return response.writeHead(404).end();
    response.writeHead(200, { 'content-type': types[extname(path)] ?? 'application/octet-stream',
      ...sites[site].headers });
    createReadStream(path).pipe(response);
  }

  function answer(name, request, response) {
    let text = '';
    request.on('data', (data) => (text += data));
    request.on('end', () => {
      waiting.get(name)?.(JSON.parse(text));
      response.writeHead(200, anyOrigin).end();
    });
  }

  const server = createServer((request, response) => {
    const url = new URL(request.url, 'http://localhost');
    if (request.method === 'OPTIONS') response.writeHead(204, anyOrigin).end();
    else if (request.method === 'POST') answer(url.pathname.split('/').at(-1), request, response);
    else file(url, response);
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  const origin = `http://127.0.0.1:${server.address().port}`;
  return {
    origin,
    address: (name) => `${origin}/answer/${name}`,
    /** The first answer under this name, or an error after so many seconds. */
    answer: (name, seconds) => new Promise((resolve) => {
      const timer = setTimeout(() => resolve({ error: `no answer within ${seconds} s` }), seconds * 1000);
      waiting.set(name, (value) => {
        clearTimeout(timer);
        waiting.delete(name);
        resolve(value);
      });
    }),
    /** A page that shows all these pages at once: one browser start for all of them. */
    deck: (name, urls) => {
      pages.set(name, `<!doctype html><link rel="icon" href="data:,">${urls.map((url) =>
        `<iframe src="${url}"></iframe>`).join('')}`);
      return `${origin}/${name}`;
    },
    close: () => {
      server.close();
      server.closeAllConnections();
    },
  };
}
