// From bytes, an address or a compiled module to a running instance.
import { Lpquad } from './api.js';
import { LpquadError } from './errors.js';
import createModule from './glue.js';

// (module (func (result v128) i32.const 0 i8x16.splat)): valid only where SIMD is known.
const simdProbe = new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0,
  10, 8, 1, 6, 0, 65, 0, 253, 15, 11]);

/** Whether this engine runs the SIMD build. */
export const hasSimd = () => WebAssembly.validate(simdProbe);

/** A plain reason instead of the engine's "expected magic word". */
export function checkMagic(bytes, from) {
  const start = new Uint8Array(bytes.buffer ?? bytes, bytes.byteOffset ?? 0,
    Math.min(bytes.byteLength, 4));
  if (start.length === 4 && String.fromCharCode(...start) === '\0asm') return bytes;
  const text = String.fromCharCode(...start).trimStart();
  const hint = text.startsWith('<') ? ' It looks like an HTML page, as servers send it for a ' +
    'missing file: copy lpquad.wasm there, or pass wasmUrl.' : '';
  throw new LpquadError('BAD_WASM', `What was loaded from ${from} is not WebAssembly.${hint}`);
}

export async function compileUrl(url) {
  let response;
  try {
    response = await fetch(url);
  } catch (cause) {
    throw new LpquadError('BAD_WASM', `${url} could not be loaded: ${cause.message}`, {}, { cause });
  }
  if (!response.ok)
    throw new LpquadError('BAD_WASM', `${url} could not be loaded: status ${response.status}.`);
  // Not compileStreaming: it insists on a MIME type that many servers do not send.
  return WebAssembly.compile(checkMagic(await response.arrayBuffer(), url));
}

async function instantiate(wasmModule, build) {
  const module = await new Promise((resolve, reject) => {
    createModule({
      instantiateWasm(imports, done) {
        WebAssembly.instantiate(wasmModule, imports).then(done, reject);
        return {};
      },
      printErr: (text) => console.error(text),
    }).then(resolve, reject);
  });
  return new Lpquad(module, build);
}

const instances = new Map();

/**
 * One instance per source, however often it is asked for; a failure is not remembered.
 * @param {object} source  {wasmModule} or {wasmBinary} or {wasmUrl} of the caller's, or nothing
 * @param {(build: string) => Promise<WebAssembly.Module>} compileOwn  the package's own file
 * @param {(url: string | URL) => Promise<WebAssembly.Module>} compileFrom  an address of the caller's
 */
export function createOnce(source, compileOwn, compileFrom = compileUrl) {
  const { wasmModule, wasmBinary, wasmUrl } = source;
  const key = wasmModule ?? wasmBinary ?? (wasmUrl === undefined ? '' : String(wasmUrl));
  if (!instances.has(key)) {
    const build = hasSimd() ? 'simd' : 'plain';
    const compiled = wasmModule ? Promise.resolve(wasmModule)
      : wasmBinary ? Promise.resolve().then(() =>
        WebAssembly.compile(checkMagic(wasmBinary, 'wasmBinary')))
      : wasmUrl !== undefined ? compileFrom(wasmUrl)
      : compileOwn(build);
    const instance = compiled.then((module) =>
      instantiate(module, key === '' ? build : 'custom'));
    instance.catch(() => instances.delete(key));
    instances.set(key, instance);
  }
  return instances.get(key);
}
