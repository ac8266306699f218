// Builds the page into build/web: static files that work from any folder of any server.
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import { offline } from './offline/plugin.js';
import { assetName, occtNotice } from './space/cad/notice.js';
import { surfacePictures } from './space/presets/pictures.js';
import { onlyWhatIsUsedOfThree } from './space/view/three_plugin.js';

const here = (/** @type {string} */ path) => fileURLToPath(new URL(path, import.meta.url));

/** The notices of what the WebAssembly files are made of. @returns {import('vite').Plugin} */
const thirdParty = () => ({
  name: 'lpquad-third-party',
  apply: 'build',
  generateBundle() {
    this.emitFile({ type: 'asset', fileName: 'assets/third-party.txt', source: readFileSync(here('../dist/third-party.txt')) });
  },
});

export default defineConfig({
  root: here('.'),
  base: './',
  publicDir: here('public'),
  resolve: {
    // The package as its users get it.
    alias: [{ find: /^lpquad\/worker$/, replacement: here('../dist/worker.js') }, { find: /^lpquad\/(.*)$/, replacement: here('../dist/$1') }],
  },
  plugins: [onlyWhatIsUsedOfThree(), thirdParty(), occtNotice(), surfacePictures(), offline()],
  // lpquad/cad looks for the package where none is handed in; the page hands in its own.
  worker: { format: 'es', rollupOptions: { external: ['occt-import-js'] } },
  build: { outDir: here('../build/web'), emptyOutDir: true, target: 'es2022', assetsInlineLimit: 0, modulePreload: false,
    rollupOptions: { input: { plane: here('index.html'), space: here('space.html') }, output: { assetFileNames: assetName } },
    chunkSizeWarningLimit: 650 },  // kB before compression: three.js is 560 of them, in one piece; tests/web/budget says what may be loaded
});
