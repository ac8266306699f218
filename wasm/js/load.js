// From bytes, an address or a compiled module to a running instance.
import { Lpquad } from './api.js';
import { checkWasmSource } from './checks.js';
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

/** Per entry (the inline ones have other files), then per module that was given, if one was. */
const kept = new WeakMap();

function within(map, key, make) {
  if (!map.has(key)) map.set(key, make());
  return map.get(key);
}

/** The instance of this source, made once. */
function instanceOf(files, { wasmModule, wasmBinary, ...addresses }, make) {
  const instances = within(within(kept, files, () => new WeakMap()), wasmModule ?? wasmBinary ?? files, () => new Map());
  const { wasmUrl = '', readersUrl = '', surfaceUrl = '' } = addresses;
  return within(instances, [wasmUrl, readersUrl, surfaceUrl].join('\n'), () => once(make));
}

/**
 * One instance per source, however often it is asked for; a failure is not remembered.
 * @param {import('./index.js').WasmSource} source  of the caller's
 * @param {object} files  how this entry finds the package's own files; one object per entry
 * @param {(name: string) => Promise<WebAssembly.Module>} files.own  of the files in urls.js
 * @param {(url: string | URL) => Promise<WebAssembly.Module>} [files.from]  the caller's addresses
 * @param {() => Promise<{default: Function}>} files.readersGlue
 * @param {() => Promise<{default: Function}>} files.surfaceGlue
 * @param {boolean} [files.plain]  there is no build with SIMD
 */
export async function createOnce(source, files) {
  checkWasmSource(source, 'createLpquad');
  const own = { ...source };
  return instanceOf(files, own, () => create(own, files))();
}

async function create({ wasmModule, wasmBinary, wasmUrl, readersUrl, surfaceUrl }, files) {
  const { own, from = compileUrl } = files;
  const simd = !files.plain && hasSimd();
  const ending = simd ? '' : '-plain';
  const compile = async () => {
    if (wasmModule) return wasmModule;
    if (wasmBinary) return compileBytes(wasmBinary, 'wasmBinary');
    return wasmUrl !== undefined ? from(wasmUrl) : own(`lpquad${ending}`);
  };
  // What is needed later, if at all.
  const later = (glue, url, name) => once(async () => {
    const { default: createLater } = await glue();
    return instantiate(createLater, await (url === undefined ? own(name) : from(url)));
  });
  const custom = wasmModule || wasmBinary || wasmUrl !== undefined;
  const build = custom ? 'custom' : simd ? 'simd' : 'plain';
  return new Lpquad(await instantiate(createModule, await compile()), build, {
    readers: later(files.readersGlue, readersUrl, 'lpquad-readers'),
    surfaces: later(files.surfaceGlue, surfaceUrl, `lpquad-surface${ending}`),
  });
}
