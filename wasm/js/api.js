// The public API over one instance of the module. Every value that leaves is a copy.
import { packDomain } from './domain.js';
import { LpquadError, unwrap } from './errors.js';
import { splitOptions } from './fields.js';
import { checkFunction, checkMesh, checkNames, checkOptions, checkSource } from './checks.js';
import { call, meshResult, Session, SurfaceSession } from './session.js';
import { packSurface } from './surface.js';

export class Lpquad {
  #module;
  #readers;
  #surfaces;

  /** @param {{readers: () => Promise<any>, surfaces: () => Promise<any>}} later  loads what reads
   *    files and what meshes surfaces, once */
  constructor(module, build, later) {
    this.#module = module;
    this.#readers = later.readers;
    this.#surfaces = later.surfaces;
    Object.assign(this, { build, ...JSON.parse(module.describe()) });
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
    const { memory = true, ...rest } = checkOptions(options);
    if (typeof memory !== 'boolean') throw new LpquadError('BAD_OPTION', 'Option memory must be true or false.');
    const { table, fields, thrown, onProgress } = splitOptions(rest);
    if (onProgress !== undefined) throw noProgress();
    const packed = packDomain(domain);
    const raw = call(thrown, () => this.#module.start(packed, table, fields, memory));
    return new Session(unwrap(raw).session, thrown);
  }

  async readDomain(source, options = {}) {
    const { bytes, name, format } = fileOf(source, options, 'readDomain');
    const { text, warnings } = unwrap((await this.#readers()).readDomain(bytes, format, name));
    return { ...JSON.parse(text), warnings: JSON.parse(warnings) };
  }

  async readSurface(source, options = {}) {
    const { bytes, name, format } = fileOf(source, options, 'readSurface');
    const surface = unwrap((await this.#readers()).readSurface(bytes, format, name));
    return { ...surface, warnings: JSON.parse(surface.warnings) };
  }

  async isSurfaceFile(source, options = {}) {
    const { bytes, name } = fileOf(source, options, 'isSurfaceFile', ['name']);
    return (await this.#readers()).isSurfaceFile(bytes, name);
  }

  async meshSurface(surface, options) {
    const { onProgress, ...table } = checkOptions(options);
    if (onProgress !== undefined) checkFunction(onProgress, 'onProgress');
    const session = await this.startSurface(surface, table);
    try {
      return session.finish(onProgress);
    } finally {
      session.dispose();
    }
  }

  async startSurface(surface, options) {
    const table = checkOptions(options);
    if (table.onProgress !== undefined) throw noProgress();
    const packed = packSurface(surface);
    return new SurfaceSession(unwrap((await this.#surfaces()).start(packed, table)).session);
  }

  writeMesh(mesh, format, options) {
    checkMesh(mesh);
    return unwrap(this.#module.writeMesh(mesh, String(format), checkOptions(options))).text;
  }
}

const noProgress = () =>
  new LpquadError('BAD_OPTION', 'A session has no onProgress: step() returns its state.');

function fileOf(source, options, of, known = ['name', 'format']) {
  const bytes = checkSource(source);
  checkNames(options, known, `option of ${of}`);
  const { name = '', format = '' } = options;
  return { bytes, name: String(name), format: String(format) };
}
