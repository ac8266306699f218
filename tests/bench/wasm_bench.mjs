// WebAssembly against native, about 10,000 quads: median ratios of CPU time over paired runs, and the
// time from opening a page to the mesh in Chromium. Prints; judges nothing.
// usage: node tests/bench/wasm_bench.mjs [pairs]   (after the preset release and npm run build)
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

import { browsers, openBrowser } from '../package/browsers.mjs';
import { serve } from '../package/server.mjs';
import { circle, freshLpquad, path, rectangle } from '../wasm/support.mjs';

const pairs = Number(process.argv[2] ?? 5);
const work = path(`build/bench-${process.pid}`);
const domain = { loops: [rectangle(0, 0, 2, 1), circle(0.7, 0.5, 0.2, 96)] };
const median = (values) => values.sort((a, b) => a - b)[values.length >> 1];
const sum = (times) => Object.values(times).reduce((a, b) => a + b, 0);

mkdirSync(work, { recursive: true });
process.once('exit', () => rmSync(work, { recursive: true, force: true, maxRetries: 5, retryDelay: 100 }));
writeFileSync(join(work, 'domain.json'), JSON.stringify(domain));

function native(options) {
  execFileSync(path('build/release/bin/lpquad'), ['mesh', join(work, 'domain.json'), '-o', join(work, 'mesh.obj'),
    '--report', join(work, 'report.json'), '--quiet', '--size', String(options.size), '--method', options.method]);
  return sum(JSON.parse(readFileSync(join(work, 'report.json'))).cpuSeconds);
}

function wasm(lpquad, options) {
  const before = process.cpuUsage();
  lpquad.meshDomain(domain, options);
  const { user, system } = process.cpuUsage(before);
  return (user + system) / 1e6;
}

const script = `
import { createLpquad } from '/dist/index.js';
const { domain, options } = await (await fetch('case.json')).json();
const times = [];
for (let i = 0; i < 3; ++i) {
  const start = i === 0 ? 0 : performance.now();  // the first from the opening of the page on
  (await createLpquad()).meshDomain(domain, options);
  times.push((performance.now() - start) / 1000);
}
fetch(new URLSearchParams(location.search).get('to'), { method: 'POST', body: JSON.stringify({ times }) });`;

async function inChromium(options) {
  writeFileSync(join(work, 'index.html'), '<!doctype html><link rel="icon" href="data:,"><script type="module" src="page.js"></script>');
  writeFileSync(join(work, 'page.js'), script);
  writeFileSync(join(work, 'case.json'), JSON.stringify({ domain, options }));
  const server = await serve({ page: { folder: work }, dist: { folder: path('dist') } });
  const answer = server.answer('chromium', 300);
  const close = openBrowser('chromium', `${server.origin}/page/?to=${encodeURIComponent(server.address('chromium'))}`, work);
  const { times, error } = await answer;
  close();
  server.close();
  return error ?? `${times[0].toFixed(2)} s from opening the page, then ${times.slice(1).map((t) => t.toFixed(2)).join(' and ')} s`;
}

const builds = { simd: await freshLpquad('lpquad'), plain: await freshLpquad('lpquad-plain') };
for (const method of ['best', 'paper']) {
  const options = { size: 0.01354, method };
  let quads = 0;
  for (const lpquad of Object.values(builds)) quads = lpquad.meshDomain(domain, options).report.quads;  // warm
  const times = { native: [], simd: [], plain: [] }, ratios = { simd: [], plain: [] };
  for (let i = 0; i < pairs; ++i) {
    times.native.push(native(options));
    for (const [name, lpquad] of Object.entries(builds)) {
      times[name].push(wasm(lpquad, options));
      ratios[name].push(times[name].at(-1) / times.native.at(-1));
    }
  }
  console.log(`--method ${method}, ${quads} quads: native ${median(times.native).toFixed(2)} s; ` +
    Object.entries(ratios).map(([name, list]) => `${name} ${median(times[name]).toFixed(2)} s, ` +
      `${median(list).toFixed(2)} x native`).join('; '));
  if (browsers.chromium.path) console.log(`  Chromium: ${await inChromium(options)}`);
}
