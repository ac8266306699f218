// For the build: what lies in the folder occt-import-js, whose it is, and where its source is.
import { readFileSync } from 'node:fs';

export const folder = 'occt-import-js';

/** Where the build puts a file; the package's own stay apart. @param {{originalFileNames: readonly string[]}} asset */
export const assetName = ({ originalFileNames }) =>
  `${originalFileNames.some((name) => name.includes(`/${folder}/`)) ? folder : 'assets'}/[name]-[hash][extname]`;

/** @returns {import('vite').Plugin} */
export function occtNotice() {
  return {
    name: 'lpquad-occt-notice',
    apply: 'build',
    generateBundle() {
      const file = new URL('../../../node_modules/occt-import-js/package.json', import.meta.url);
      const { version, license } = JSON.parse(readFileSync(file, 'utf8'));
      this.emitFile({ type: 'asset', fileName: `${folder}/README.txt`, source: `The files in this folder are the package occt-import-js ${version}, unchanged. They are no part of lpquad:
the page fetches them when a STEP, IGES or BREP file is opened, and runs them as they are. Another
build of the package can be put in their place.

Licence: ${license} (license.occt-import-js-*.txt; license.occt-*.txt for Open CASCADE Technology, which is compiled in)
Package: https://www.npmjs.com/package/occt-import-js/v/${version}
Source:  https://github.com/kovacsv/occt-import-js/tree/${version}, with Open CASCADE Technology as its
         submodule occt: https://git.dev.opencascade.org/repos/occt.git
` });
    },
  };
}
