// Shapes and helpers of the tests of the package in dist/.
import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { existsSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

export const path = (relative) => fileURLToPath(new URL(`../../${relative}`, import.meta.url));
export const dist = (file) => new URL(`../../dist/${file}`, import.meta.url);
if (!existsSync(dist('lpquad.wasm'))) throw new Error('dist/ is not built: npm run build');

export const { createLpquad, LpquadError } = await import(dist('node.js').href);
export const { createLpquadWorker } = await import(dist('worker-node.js').href);

/** An instance of its own, whose memory nobody else uses. */
export const freshLpquad = async (name = 'lpquad') =>
  createLpquad({ wasmModule: await WebAssembly.compile(readFileSync(dist(`${name}.wasm`))) });

export const rectangle = (x, y, width, height = width) =>
  [[x, y], [x + width, y], [x + width, y + height], [x, y + height]];
export const square = { loops: [rectangle(0, 0, 1)] };

export function circle(x, y, radius, count) {
  return Array.from({ length: count }, (_, i) =>
    [x + radius * Math.cos((2 * Math.PI * i) / count), y + radius * Math.sin((2 * Math.PI * i) / count)]);
}
export const plate = { loops: [rectangle(0, 0, 2, 1), circle(0.7, 0.5, 0.2, 24)] };

export const sha256 = (...parts) => {
  const hash = createHash('sha256');
  for (const part of parts)
    hash.update(ArrayBuffer.isView(part) ? new Uint8Array(part.buffer, part.byteOffset, part.byteLength) : part);
  return hash.digest('hex');
};
export const meshHash = (mesh) => sha256(mesh.points, mesh.quads, mesh.triangles, mesh.edges);

/** The error of a call, which must be a LpquadError with this code. */
export function errorOf(code, call) {
  try {
    call();
  } catch (error) {
    return checkError(code, error);
  }
  assert.fail(`no ${code}`);
}
export async function rejectionOf(code, promise) {
  return promise.then(() => assert.fail(`no ${code}`), (error) => checkError(code, error));
}
function checkError(code, error) {
  if (!(error instanceof LpquadError)) throw error;
  assert.equal(error.code, code, error.message);
  assert.equal(error.name, 'LpquadError');
  assert.match(error.message, /[.!?)]$/);
  assert.equal(typeof error.where, 'object');
  return error;
}

/** xorshift32 from 0 to 1, the same on every machine. */
export function random(seed) {
  let state = seed;
  return () => {
    state ^= state << 13; state ^= state >>> 17; state ^= state << 5;
    return (state >>> 0) / 2 ** 32;
  };
}
