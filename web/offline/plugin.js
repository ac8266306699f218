// For the build: service_worker.js with the lists of the page's files and the hash of all of them.
import { createHash } from 'node:crypto';
import { readFileSync, readdirSync, statSync, writeFileSync } from 'node:fs';
import { join, relative, sep } from 'node:path';

/** @param {string} folder  @returns {string[]} */
const filesIn = (folder) => readdirSync(folder).flatMap((name) => {
  const path = join(folder, name);
  return statSync(path).isDirectory() ? filesIn(path) : [path];
});

// Fetched with the first CAD file, and kept from then on.
const isForLater = (/** @type {string} */ file) => file.startsWith('occt-import-js/');

/** @returns {import('vite').Plugin} */
export function offline() {
  let folder = '';
  return {
    name: 'lpquad-offline',
    apply: 'build',
    configResolved: (config) => { folder = config.build.outDir; },
    closeBundle: () => {
      const hash = createHash('sha256');
      const source = readFileSync(new URL('./service_worker.js', import.meta.url), 'utf8');
      const paths = filesIn(folder).filter((path) => !path.endsWith(`${sep}service_worker.js`)).sort();
      for (const path of paths) hash.update(path.slice(folder.length)).update(readFileSync(path));
      // './' is index.html; by its own name some servers redirect, and a redirect cannot be kept.
      const files = paths.map((path) => relative(folder, path).split(sep).join('/').replace(/^index\.html$/, './'));
      const version = hash.update(source).digest('hex').slice(0, 16);
      const lists = { version, files: files.filter((file) => !isForLater(file)), later: files.filter(isForLater) };
      writeFileSync(join(folder, 'service_worker.js'), `self.lpquad = ${JSON.stringify(lists)};\n${source}`);
    },
  };
}
