// From bytes, an address or a compiled module to a running instance.
import { Lpquad } from './api.js';
import { checkNames } from './checks.js';
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
    throw new LpquadError('BAD_WASM', `${url} could not be loaded (${cause.message}).`, {}, { cause });
  }
  if (!response.ok)
    throw new LpquadError('BAD_WASM', `${url} could not be loaded: status ${response.status}.`);
  // Not compileStreaming: it insists on a MIME type that many servers do not send.
  return compileBytes(await response.arrayBuffer(), url);
}

export async function compileBytes(bytes, from) {
  try {
    return await WebAssembly.compile(checkMagic(bytes, from));
  } catch (cause) {
    if (cause instanceof LpquadError) throw cause;
    throw new LpquadError('BAD_WASM', `What was loaded from ${from} is cut off or broken.`, {}, { cause });
  }
}

/** @returns {Promise<any>} the exports of the module with its glue */
function instantiate(createModule, wasmModule) {
  return new Promise((resolve, reject) => {
    const refuse = (cause) => reject(new LpquadError('BAD_WASM',
      'This WebAssembly is not that of this version of lpquad.', {}, { cause }));
    createModule({
      instantiateWasm(imports, done) {
        WebAssembly.instantiate(wasmModule, imports).then(done).catch(refuse);
        return {};
      },
      printErr: (text) => console.error(text),
    }).then(resolve, refuse);
  });
}

/** Calls `make` once, and again only after a failure. */
function once(make) {
  let promise = null;
  return () => {
    promise ??= make().catch((error) => {
      promise = null;
      throw error;
    });
    return promise;
  };
}

const byAddress = new Map(), byObject = new WeakMap();

/** Where the instance of this source is kept, and under which key. */
function place({ wasmModule, wasmBinary, wasmUrl = '', readersUrl = '' }) {
  const object = wasmModule ?? wasmBinary;
  return object ? [byObject, object] : [byAddress, `${wasmUrl} ${readersUrl}`];
}

function checkSource(source) {
  checkNames(source, ['wasmUrl', 'wasmBinary', 'wasmModule', 'readersUrl'], 'source of createLpquad');
  const { wasmModule, wasmBinary } = source;
  if (wasmModule !== undefined && !(wasmModule instanceof WebAssembly.Module))
    throw new LpquadError('BAD_WASM', 'wasmModule must be a WebAssembly.Module.');
  if (wasmBinary !== undefined && !(wasmBinary instanceof ArrayBuffer) && !ArrayBuffer.isView(wasmBinary))
    throw new LpquadError('BAD_WASM', 'wasmBinary must be an ArrayBuffer or a Uint8Array.');
}

/**
 * One instance per source, however often it is asked for; a failure is not remembered.
 * @param {import('./index.js').WasmSource} source  of the caller's
 * @param {object} files  how this entry finds the package's own files
 * @param {(name: string) => Promise<WebAssembly.Module>} files.own  lpquad, -plain, -readers
 * @param {(url: string | URL) => Promise<WebAssembly.Module>} [files.from]  the caller's addresses
 * @param {() => Promise<{default: Function}>} files.readersGlue
 */
export async function createOnce(source, { own, from = compileUrl, readersGlue }) {
  checkSource(source);
  const { wasmModule, wasmBinary, wasmUrl, readersUrl } = source;
  const [instances, key] = place(source);
  if (!instances.has(key)) {
    const build = wasmModule || wasmBinary || wasmUrl !== undefined ? 'custom'
      : hasSimd() ? 'simd' : 'plain';
    const compile = async () => {
      if (wasmModule) return wasmModule;
      if (wasmBinary) return compileBytes(wasmBinary, 'wasmBinary');
      if (wasmUrl !== undefined) return from(wasmUrl);
      return own(build === 'simd' ? 'lpquad' : 'lpquad-plain');
    };
    const readers = once(async () => {
      const glue = await readersGlue();
      const compiled = readersUrl === undefined ? own('lpquad-readers') : from(readersUrl);
      return instantiate(glue.default, await compiled);
    });
    instances.set(key, once(async () =>
      new Lpquad(await instantiate(createModule, await compile()), build, readers)));
  }
  return instances.get(key)();
}
