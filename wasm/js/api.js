// The public API over one instance of the module. Every value that leaves is a copy.
import { packDomain } from './domain.js';
import { LpquadError, unwrap } from './errors.js';
import { splitOptions } from './fields.js';
import { checkMesh, checkNames, checkSource, checkWhole } from './checks.js';

/** Layers a snapshot can hold, by name. */
const layerNames = ['triangles', 'cells', 'crosses', 'sizes', 'matching', 'quads'];

function meshResult(raw) {
  const { report, ...mesh } = unwrap(raw);
  return { ...mesh, report: JSON.parse(report) };
}

/** Runs a core call; what a function of the caller's threw meanwhile goes on its way. */
function call(thrown, work) {
  const raw = work();
  if (thrown.length > 0) throw thrown[0];
  return raw;
}

export class Session {
  #handle;
  #thrown;

  constructor(handle, thrown) {
    this.#handle = handle;
    this.#thrown = thrown;
  }

  /** @returns {any} the live handle */
  #live() {
    if (this.#handle === null)
      throw new LpquadError('BAD_OPTION', 'This session has been disposed of.');
    return this.#handle;
  }
  #move(work) {
    this.#thrown.length = 0;
    return unwrap(call(this.#thrown, work));
  }

  get state() { return this.#live().state(); }
  step(ticks = 1) {
    checkWhole(ticks, 'The number of ticks');
    return this.#move(() => this.#live().step(ticks));
  }
  restore(tick) {
    checkWhole(tick, 'The tick to restore');
    return this.#move(() => this.#live().restore(tick));
  }

  finish() {
    while (this.state.stage !== 'done') this.step(1000);
    return meshResult(this.#live().result());
  }

  snapshot(layers = {}) {
    checkNames(layers, layerNames, 'layer');
    const snapshot = this.#live().state();
    for (const name of layerNames)
      if (layers[name]) snapshot[name] = unwrap(this.#live()[name]());
    return snapshot;
  }

  clone() { return new Session(unwrap(this.#live().clone()).session, this.#thrown); }

  dispose() {
    this.#handle?.delete();
    this.#handle = null;
  }
}
// Where the engine knows explicit resource management: `using session = lpquad.start(…)`.
if (Symbol.dispose) Session.prototype[Symbol.dispose] = Session.prototype.dispose;

export class Lpquad {
  #module;
  #readers;

  /** @param {() => Promise<any>} readers  loads the module that reads files, once */
  constructor(module, build, readers) {
    this.#module = module;
    this.#readers = readers;
    const table = JSON.parse(module.describe());
    this.version = table.version;
    this.build = build;
    this.options = table.options;
    this.writeOptions = table.writeOptions;
    this.errorCodes = table.errorCodes;
    this.meshFormats = table.meshFormats;
    this.domainFormats = table.domainFormats;
  }

  meshDomain(domain, options) {
    const { table, fields, onProgress, thrown } = splitOptions(options);
    const progress = onProgress && ((stage, iteration, maxIterations, energy) => {
      try {
        return onProgress({ stage, iteration, maxIterations, energy }) !== false;
      } catch (error) {
        thrown.push(error);
        return false;
      }
    });
    const packed = packDomain(domain);
    return meshResult(call(thrown, () =>
      this.#module.meshDomain(packed, table, fields, progress ?? null)));
  }

  start(domain, options) {
    const { memory = true, ...rest } = options ?? {};
    const { table, fields, thrown, onProgress } = splitOptions(rest);
    if (onProgress !== undefined)
      throw new LpquadError('BAD_OPTION', 'A session has no onProgress: step() returns its state.');
    const packed = packDomain(domain);
    const raw = call(thrown, () => this.#module.start(packed, table, fields, memory));
    return new Session(unwrap(raw).session, thrown);
  }

  async readDomain(source, options = {}) {
    const bytes = checkSource(source);
    checkNames(options, ['name', 'format'], 'option of readDomain');
    const { name = '', format = '' } = options;
    const readers = await this.#readers();
    const { text, warnings } = unwrap(readers.readDomain(bytes, String(format), String(name)));
    return { ...JSON.parse(text), warnings: JSON.parse(warnings) };
  }

  writeMesh(mesh, format, options = {}) {
    checkMesh(mesh);
    return unwrap(this.#module.writeMesh(mesh, String(format), options)).text;
  }
}
