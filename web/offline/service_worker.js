// The page without a network. The build puts `lpquad = {version, files, later}` before this text: the files
// of the page, those that it fetches when it comes to need them, and a hash of their contents. A cache
// belongs to one version and never changes; a new version is fetched beside the old one and takes over when
// no page of the old one is open. Pages come from the network if it answers, so that a reload shows the
// newest; everything else has the hash of its content in its name and comes from the cache.

/** @typedef {{waitUntil: (done: Promise<unknown>) => void, respondWith: (answer: Promise<Response>) => void, request: Request}} WorkerEvent */
const worker = /** @type {any} */ (self);
const { version, files, later } = /** @type {{version: string, files: string[], later: string[]}} */ (worker.lpquad);
const cacheName = `lpquad-${version}`;
const home = new URL('./', location.href).href;
/** For a page of the network, in ms; a bad network would let its reader wait for a minute. */
const patience = 5000;
/** Paths of the pages; some servers leave the ending away. The others may be anybody's. */
const pages = /^(index\.html|space(\.html)?)?([?#]|$)/;

/** What an older version fetched already, if its name says that it is the same. @param {string} file */
async function fromElsewhere(file) {
  return /-[\w-]{8}\.\w+$/.test(file) ? caches.match(new URL(file, home).href) : undefined;
}

async function fetchAll() {
  const cache = await caches.open(cacheName);
  await Promise.all(files.map(async (file) => {
    const url = new URL(file, home).href;
    const response = await fromElsewhere(file) ?? await fetch(url, { cache: 'no-cache' });
    if (!response.ok) throw new Error(`${url}: status ${response.status}`);
    // A page that a redirect led to must not be kept as such: browsers refuse to show it again.
    await cache.put(url, response.redirected ? new Response(response.body, { headers: response.headers }) : response);
  }));
}

/** What the older version had come to need. */
async function takeLater() {
  const cache = await caches.open(cacheName);
  for (const file of later) {
    const found = await fromElsewhere(file);
    if (found) await cache.put(new URL(file, home).href, found);
  }
}

/** What the page has come to need. @param {string[]} urls */
async function keep(urls) {
  const cache = await caches.open(cacheName), known = new Set(later.map((file) => new URL(file, home).href));
  for (const url of urls) if (known.has(url) && !await cache.match(url)) await cache.add(url);
}

async function removeOld() {
  const names = await caches.keys();
  // Another page of the same server may have caches of its own, and a second playground as well.
  const old = names.filter((other) => other.startsWith('lpquad-') && other !== cacheName);
  for (const other of old) if (await (await caches.open(other)).match(home)) await caches.delete(other);
  await worker.clients.claim();
}

/** The page of the network, or the kept one: at once without a network, after a while with a bad one.
 * @param {Request} request  @param {Cache} cache */
async function newestPage(request, cache) {
  const page = request.url.slice(home.length).startsWith('space') ? `${home}space.html` : home;
  const kept = await cache.match(page) ?? Response.error();
  const newest = fetch(request).then((response) => (response.ok ? response : kept), () => kept);
  /** @type {Promise<Response>} */
  const late = new Promise((resolve) => { setTimeout(resolve, patience, kept); });
  return kept.ok ? Promise.race([newest, late]) : newest;
}

/** @param {Request} request */
async function answer(request) {
  const cache = await caches.open(cacheName);
  if (request.mode === 'navigate') return newestPage(request, cache);
  return await cache.match(request, { ignoreSearch: true, ignoreVary: true }) ?? fetch(request);
}

worker.addEventListener('install', (/** @type {WorkerEvent} */ event) => event.waitUntil(fetchAll().then(takeLater)));
worker.addEventListener('activate', (/** @type {WorkerEvent} */ event) => event.waitUntil(removeOld()));
worker.addEventListener('message', (/** @type {WorkerEvent & {data: {keep: string[]}}} */ event) => event.waitUntil(keep(event.data.keep)));
worker.addEventListener('fetch', (/** @type {WorkerEvent} */ event) => {
  const { method, url, mode } = event.request;
  const own = url.startsWith(home) && method === 'GET';
  if (own && (mode !== 'navigate' || pages.test(url.slice(home.length)))) event.respondWith(answer(event.request));
});
