#!/usr/bin/env node
// `npx lpquad …`: the command line program itself, compiled for Node.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';

import { isCadFile, occtMissing, readCadWith, surfaceAsObj } from './cad.js';

const createCommand = createRequire(import.meta.url)('./cli.cjs');
const wasmBinary = readFileSync(new URL('./cli.wasm', import.meta.url));

/** occt-import-js beside this package or in the folder where the command is given; nothing if it is nowhere. */
async function findOcct() {
  for (const place of [import.meta.url, join(process.cwd(), 'package.json')]) {
    const require = createRequire(place);
    let file;
    try {
      file = require.resolve('occt-import-js');
    } catch {
      continue;
    }
    return require(file)({ print: () => {}, printErr: () => {} });
  }
  return undefined;
}

/** Reads CAD files for the program, which cannot wait for promises: see core/cli/surface_input.cpp. */
function cadReader(occt) {
  let text;
  const answer = (string) => (text = new TextEncoder().encode(string)).length;
  return {
    load(bytes, name, size, quads) {
      if (occt === undefined) return -answer(`IO_ERROR ${occtMissing}`);
      try {
        return answer(surfaceAsObj(readCadWith(occt, bytes, { name, size, quads })));
      } catch (error) {
        return -answer(`${error.code} ${error.message}`);
      }
    },
    take: () => text,
  };
}

const args = process.argv.slice(2);
const occt = args.some(isCadFile) ? await findOcct() : undefined;

await createCommand({ wasmBinary, arguments: args, thisProgram: 'lpquad', cad: cadReader(occt),
  onExit: (code) => { process.exitCode = code; } });
