#!/usr/bin/env node
// `npx lpquad …`: the command line program itself, compiled for Node.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';

const createCommand = createRequire(import.meta.url)('./cli.cjs');
const wasmBinary = readFileSync(new URL('./cli.wasm', import.meta.url));

await createCommand({ wasmBinary, arguments: process.argv.slice(2), thisProgram: 'lpquad',
  onExit: (code) => { process.exitCode = code; } });
